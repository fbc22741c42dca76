// Where tiles are traced: a device of this process, or one behind another process. The renderer deals tiles to several of them.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "host/opencl/device.hpp"
#include "host/opencl/gather.hpp"
#include "host/opencl/render.hpp"
#include "host/opencl/tiles.hpp"
#include "kernels/abi.h"

namespace nicol {

using Counters = std::array<std::uint32_t, COUNTERS>;

// Smaller tiles may do.
struct ShortageError : DeviceError {
  using DeviceError::DeviceError;
};

// A tile that has come back. sums: as Gather wants them, until release().
struct TracedTile {
  Tile tile;
  const void* sums = nullptr;
  Counters counted{};
  double seconds = 0;   // that it took there; 0: not known
};

// Tiles come back in the order in which they were submitted. All calls come from one thread, and none but collect() waits for a tile.
// They throw DeviceError (complete with the device's name): then drop() still works, and what was in flight has to be traced elsewhere.
class TileExecutor {
 public:
  virtual ~TileExecutor() = default;
  virtual std::string name() const = 0;             // of the device; "" until it has started
  virtual std::string place() const { return ""; }  // "rank 3 on node7"; "": this process
  virtual bool here() const { return true; }       // in this process: collect() may be called before ready()
  virtual bool started() { return true; }          // takes passes and tiles
  // listed: pixels of the scene's picture, empty: all. Samples [begin, end) of each.
  virtual void begin_pass(const std::vector<std::int32_t>& listed, int begin, int end) = 0;
  virtual std::int64_t units_that_fit() const = 0; // in a tile of this pass
  virtual int room() const = 0;                    // tiles that it takes now
  virtual int in_flight() const = 0;
  // Of at most most_units, in this pass so far.
  virtual void submit(const Tile& tile, std::int64_t most_units) = 0;
  virtual bool ready() = 0;                        // the oldest tile has come back
  virtual TracedTile collect() = 0;                // that tile
  virtual void release() = 0;                      // its sums are not needed any more
  virtual void drop() = 0;                         // what is in flight is given up
};

// Executors beyond the devices of this process, for one render.
class ExecutorSource {
 public:
  virtual ~ExecutorSource() = default;
  virtual std::vector<std::unique_ptr<TileExecutor>> executors(const PackedScene& scene, const RenderOptions& options, int lanes) = 0;
};

// The device's executor for this scene: builds or loads the kernel, waits for the device, and holds it as long as it lives. Throws DeviceError.
std::unique_ptr<TileExecutor> open_executor(Device& device, const PackedScene& scene, const RenderOptions& options, BuildReport& build);

// All executors of a render: the devices here, then those of other processes. A further device that does not get ready is done without.
// Fills report.build and notes. Throws DeviceError.
std::vector<std::unique_ptr<TileExecutor>> open_executors(Device& device, const PackedScene& scene, const RenderOptions& options,
                                                          RenderReport& report);

// Samples that every pixel gets.
int first_samples(const RenderOptions& options);

}  // namespace nicol
