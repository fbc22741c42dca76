// Tiles on an OpenCL device: in flight on its two queues, so that it always has the next one.
#pragma once
#include <mutex>
#include <optional>

#include "host/opencl/device_impl.hpp"
#include "host/opencl/executor.hpp"
#include "host/opencl/program.hpp"

namespace nicol {

class DeviceExecutor : public TileExecutor {
 public:
  DeviceExecutor(Device& device, const PackedScene& scene, const RenderOptions& options, std::shared_ptr<const Kernel> kernel, int lanes);
  ~DeviceExecutor() override;   // keeps the kernel's binary

  std::string name() const override { return device_.about.name; }
  void begin_pass(const std::vector<std::int32_t>& listed, int begin, int end) override;
  std::int64_t units_that_fit() const override;
  int room() const override { return 2 - in_flight(); }
  int in_flight() const override { return static_cast<int>(slots_[0].tile.has_value()) + static_cast<int>(slots_[1].tile.has_value()); }
  void submit(const Tile& tile, std::int64_t most_units) override;
  bool ready() override;
  TracedTile collect() override;
  void release() override;
  void drop() override;

 private:
  // A launch in flight, on the queue of the same index.
  struct Slot {
    cl::Buffer out, counters;
    std::size_t out_bytes = 0;
    void* mapped = nullptr;
    cl::Event done;
    std::unique_ptr<Counters> counted = std::make_unique<Counters>();
    std::optional<Tile> tile;
  };

  template <class Work>
  auto told(Work work) const;
  void allocate(Slot& slot, std::int64_t units);
  void launch(int index, const Tile& tile);
  std::size_t bytes_of(std::int64_t units) const {
    return static_cast<std::size_t>(units * layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes) * scalar_bytes_;
  }

  Device& device_;
  const std::shared_ptr<const Kernel> kernel_;
  const bool save_later_;
  std::optional<Turn> turn_;
  const PackedScene& scene_;
  ItemLayout layout_;   // of the pass
  const std::size_t scalar_bytes_;
  cl::Buffer ints_, reals_, tables_, sample_points_, listed_;
  std::int64_t listed_count_ = 0;
  int begin_ = 0;
  std::array<Slot, 2> slots_;
  int next_ = 0;                 // slot of the next tile
  std::optional<int> collected_; // slot whose sums are being read
};

}  // namespace nicol
