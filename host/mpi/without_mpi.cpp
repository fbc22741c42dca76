// What a nicol without MPI has in place of ranks.
#include <fmt/format.h>

#include "host/mpi/ranks.hpp"

namespace nicol {

std::unique_ptr<Ranks> join_ranks(const std::string&) {
  if (ranks_started() < 2) return nullptr;
  throw RanksError(fmt::format("this nicol is built without MPI: {} ranks would each render the whole picture; install libopenmpi-dev "
                               "and build again, or start it by itself with --part", ranks_started()));
}

}  // namespace nicol
