// Several processes that mpirun has started render one picture: rank 0 is the command line, the others trace tiles for it.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>

#include "host/opencl/executor.hpp"

namespace nicol {

// The message is complete.
struct RanksError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// This process among those.
class Ranks {
 public:
  virtual ~Ranks() = default;
  virtual int rank() const = 0;
  virtual int count() const = 0;
  virtual int on_node() const = 0;      // number among those of the same machine, from 0
  // Rank 0: what the user may want to know of how mpirun has placed the ranks; "": nothing.
  virtual std::string advice() const = 0;
  // Rank 0: executors on all other ranks that are still there. `device`: as --device says it; each rank takes one of these.
  virtual ExecutorSource& others(const std::string& device) = 0;
  // The others: trace for rank 0 until it ends, and tell it what goes wrong.
  virtual int serve() = 0;
  // Rank 0, last of all: ends the others. code: the program's exit code.
  virtual void end(int code) = 0;
};

// How many processes mpirun (of Open MPI, or one that speaks PMI) has started; 1 without it.
int ranks_started();

// Null where this process is alone. `build`: what must be alike in all of them. Throws RanksError where nicol is built without MPI.
std::unique_ptr<Ranks> join_ranks(const std::string& build);

// The device of `wanted` (see choose_devices()) for the rank of this number on its machine: they take them in turn. As open_device() wants it.
std::string device_of_rank(const std::string& wanted, int on_node);

}  // namespace nicol
