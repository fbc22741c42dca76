// What ranks say to one another. Rank 0 to another: the scene, a pass, tiles; back: that it is ready, and sums of tiles.
#pragma once
#include <cstdint>

#include "host/mpi/bytes.hpp"
#include "host/opencl/executor.hpp"

namespace nicol {

enum class Message : int {
  job = 1,   // epoch, a packed scene and how it is traced
  pass,      // epoch, samples, pixels
  tile,      // TileOrder
  drop,      // epoch: what was ordered before it is void
  job_end,
  end,
  ready,     // epoch; the kernel is there: at this place, on this device, with tiles of so many units
  traced,    // TracedHead, then the sums
  failed,    // epoch, whether it was a shortage, text
  alive,     // nothing else to say for a while
  bye        // the last word after an end
};

struct TileOrder {
  std::int64_t epoch = 0, most_units = 0;
  Tile tile;
};

struct TracedHead {
  std::int64_t epoch = 0;
  Tile tile;
  double seconds = 0;
  Counters counted{};
};
static_assert(sizeof(TracedHead) % sizeof(double) == 0, "the sums behind it are aligned");

// A job as it travels: what an executor needs of scene and options. device: see device_of_rank().
struct JobMessage {
  std::int64_t epoch = 0;
  std::string build, device;
  PackedScene scene;
  RenderOptions options;
};

Parcel job_parcel(std::int64_t epoch, const std::string& build, const std::string& device, const PackedScene& scene,
                  const RenderOptions& options, int lanes);

// Only the build where that is another.
JobMessage read_job(const Parcel& bytes, const std::string& build);

}  // namespace nicol
