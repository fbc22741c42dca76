// Puts what launches wrote into the picture, pass by pass.
#pragma once
#include <cstdint>
#include <map>
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
  std::int64_t pixels = 0;           // of the picture, or those listed

  int pixels_per_unit() const { return over_pixels ? lanes : 1; }
  std::int64_t items_per_unit() const { return over_pixels ? channels : blocks; }
  std::int64_t units() const { return (pixels + pixels_per_unit() - 1) / pixels_per_unit(); }
  std::int64_t items() const { return units() * items_per_unit(); }
};

// In PackedScene::features.
std::uint32_t lanes_over_pixels_bit();
std::uint32_t path_signatures_bit();

// listed: how many pixels of the scene's picture are wanted, 0: all.
ItemLayout item_layout(const PackedScene& scene, int lanes, std::int64_t listed = 0);

// An empty picture. Throws DeviceError if it does not fit into memory.
Frame make_frame(const PackedScene& scene, int width, int height, const std::vector<double>& lambda_nm,
                 const std::vector<double>& weight_nm);

class Gather {
 public:
  Gather(const PackedScene& scene, int lanes, Frame& frame);

  // What follows belongs to these pixels of the frame (null: all), samples [begin, end) of each.
  void begin_pass(const std::vector<std::int32_t>* pixels, int begin, int end);

  // Sums over the tile's samples. Units come in any order; all samples of a range of units come in tiles of just these units, ascending.
  template <class Real>
  void add(const Tile& tile, const Real* sums);

  // The samples so far of the units from first_unit on will come again.
  void forget(std::int64_t first_unit);

  // The tile's pixels of the frame.
  std::vector<std::int32_t> pixels_of(const Tile& tile) const;

  // Estimates the error of pixel sampling from what is there, into frame.sample_error (scene with path_signatures only).
  void estimate_errors();

  // Part of the pixels that edges cross or touch, after estimate_errors().
  double part_at_edges() const;

  // Pixels of rows that are not whole become zero; counts the cut-off weights. To be called once at the end.
  void finish();

  double cut_off_mean = 0, cut_off_worst = 0;
  // Uniform samples: RMS of half the difference of the picture's halves (pairs of samples in turn), in units of radiance.
  double halves_rms = 0;

 private:
  template <class Real>
  void scatter(const Tile& tile, const Real* sums);
  template <class Real>
  void scatter_run(std::int64_t first, int count, const std::int64_t* pixel_at, const Real* sums);
  template <class Real>
  void note_spread(std::size_t pixel, const Real* sums, double change2);
  std::size_t pixel_of(std::int64_t place) const {
    return static_cast<std::size_t>(listed_ ? (*listed_)[static_cast<std::size_t>(place)] : place);
  }
  std::vector<unsigned char> other_neighbours(std::size_t channel) const;
  void add_first_errors(std::size_t w, const std::vector<unsigned char>& others, std::vector<double>& sum) const;
  void first_errors();
  void smooth_first_errors();
  bool rough_at(std::size_t pixel) const;
  double error_of(std::size_t pixel) const;
  void calibrate();
  double deviation2(std::size_t pixel) const;

  const PackedScene& scene_;
  ItemLayout layout_;
  Frame& frame_;
  const std::vector<std::int32_t>* listed_ = nullptr;
  int begin_ = 0, end_ = 1;
  std::vector<std::int64_t> channel_at_;
  std::map<std::int64_t, std::vector<double>> sums_;   // by first unit, where the samples of a pixel need several launches
  std::vector<double> spare_;             // the memory of sums that are done
  std::vector<std::int64_t> row_pixels_;  // done, per row
  // path_signatures only
  bool spread_ = false;
  std::vector<std::int32_t> signature_;   // [channel][pixel]; -1: samples differ
  std::vector<double> square_;            // [pixel]: sum over samples of |S|^2, mean over wavelengths; of shared channels [channel][pixel]
  std::vector<double> channel_sum_;       // shared channels: [channel][S0..S3][pixel]
  std::vector<float> prior_;              // [pixel]: the error estimated from the first samples
  std::vector<unsigned char> edge_;       // [pixel]: a sample of it or of a neighbour met something else
  std::vector<float> step_;               // [pixel]: of this pass, half the change that it brought
  double law_ = 0.8;                      // error = law * standard deviation * n^-3/4
  double halves_sum_ = 0;
};

}  // namespace nicol
