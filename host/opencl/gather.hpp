// Puts what a launch wrote into the picture.
#pragma once
#include <cstdint>
#include <vector>

#include "host/opencl/tiles.hpp"
#include "host/output/frame.hpp"
#include "host/pack.hpp"

namespace nicol {

// How work-items, lanes, pixels and channels correspond (see kernels/trace.cl).
struct ItemLayout {
  int lanes = 1;
  int channels = 1, blocks = 1;      // blocks: of `lanes` channels
  bool over_pixels = false;          // lanes hold neighbouring pixels instead of neighbouring channels
  std::int64_t pixels = 0;

  int pixels_per_unit() const { return over_pixels ? lanes : 1; }
  std::int64_t items_per_unit() const { return over_pixels ? channels : blocks; }
  std::int64_t units() const { return (pixels + pixels_per_unit() - 1) / pixels_per_unit(); }
  std::int64_t items() const { return units() * items_per_unit(); }
};

// In PackedScene::features.
std::uint32_t lanes_over_pixels_bit();

ItemLayout item_layout(const PackedScene& scene, int lanes);

// An empty picture. Throws DeviceError if it does not fit into memory.
Frame make_frame(const PackedScene& scene, const std::vector<double>& lambda_nm, const std::vector<double>& weight_nm);

class Gather {
 public:
  Gather(const PackedScene& scene, const ItemLayout& layout, int samples, Frame& frame);

  // Sums over the tile's samples; all tiles of the same units follow one another, samples ascending.
  template <class Real>
  void add(const Tile& tile, const Real* sums);

  // Pixels of rows that are not whole become zero; counts the cut-off weights. To be called once at the end.
  void finish();

  double cut_off_mean = 0, cut_off_worst = 0;

 private:
  template <class Real>
  void scatter(const Tile& tile, const Real* sums);
  template <class Real>
  void scatter_run(std::int64_t first_pixel, int count, const std::int64_t* pixel_at, const Real* sums);

  const PackedScene& scene_;
  ItemLayout layout_;
  int samples_;
  Frame& frame_;
  std::vector<std::int64_t> channel_at_;
  std::vector<double> sums_;              // where the samples of a pixel need several launches
  std::vector<std::int64_t> row_pixels_;  // done, per row
};

}  // namespace nicol
