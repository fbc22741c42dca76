#include "host/opencl/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <new>

#include "host/opencl/device.hpp"
#include "kernels/abi.h"

namespace nicol {
namespace {

// What the system says is free, in bytes; huge if it does not say.
double free_memory_bytes() {
  std::ifstream in("/proc/meminfo");
  std::string name, unit;
  for (double kib = 0; in >> name >> kib; std::getline(in, unit))
    if (name == "MemAvailable:") return kib * 1024;
  return 1e30;
}

}  // namespace

std::uint32_t lanes_over_pixels_bit() {
  enum : std::uint32_t {
#define FEATURE(name, bit, meaning) bit_of_##name = std::uint32_t{1} << bit,
#include "kernels/features.def"
#undef FEATURE
  };
  return bit_of_lanes_over_pixels;
}

ItemLayout item_layout(const PackedScene& scene, int lanes) {
  ItemLayout layout;
  layout.lanes = lanes;
  layout.channels = scene.channels;
  layout.blocks = scene.stride / lanes;
  layout.over_pixels = (scene.features & lanes_over_pixels_bit()) != 0;
  layout.pixels = static_cast<std::int64_t>(scene.width) * scene.height;
  return layout;
}

Frame make_frame(const PackedScene& scene, const std::vector<double>& lambda_nm,
                 const std::vector<double>& weight_nm) {
  Frame frame;
  frame.width = scene.width;
  frame.height = scene.height;
  frame.lambda_nm = lambda_nm;
  frame.weight_nm = weight_nm;
  const double floats_per_pixel = 4 * static_cast<double>(lambda_nm.size()) + 1;
  const double bytes = static_cast<double>(frame.plane()) * floats_per_pixel * sizeof(float);
  const auto too_large = [&](const std::string& there) {
    return DeviceError(fmt::format("a picture of {} x {} pixels and {} wavelengths needs {:.1f} GB of memory; {}. Take "
                                   "fewer pixels or wavelengths", scene.width, scene.height, lambda_nm.size(),
                                   bytes / 1e9, there));
  };
  const double free_bytes = free_memory_bytes();
  if (bytes > free_bytes) throw too_large(fmt::format("{:.1f} GB are free", free_bytes / 1e9));
  try {
    frame.stokes.resize(frame.plane() * 4 * lambda_nm.size());
    frame.cut_off.resize(frame.plane());
    frame.row_done.resize(static_cast<std::size_t>(scene.height));
  } catch (const std::bad_alloc&) {
    throw too_large("the system gives less");
  }
  return frame;
}

Gather::Gather(const PackedScene& scene, const ItemLayout& layout, int samples, Frame& frame)
    : scene_(scene), layout_(layout), samples_(samples), frame_(frame),
      row_pixels_(static_cast<std::size_t>(scene.height)) {
  const std::int64_t item = OUT_COMPONENTS * layout.lanes;
  for (int c = 0; c < layout.channels; ++c)
    channel_at_.push_back(layout.over_pixels ? c * item : c / layout.lanes * item + c % layout.lanes);
}

template <class Real>
void Gather::add(const Tile& tile, const Real* sums) {
  if (samples_ <= TileSchedule::samples_per_launch) return scatter(tile, sums);
  const std::size_t size =
      static_cast<std::size_t>(tile.unit_count * layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes);
  if (tile.sample_begin == 0) sums_.assign(size, 0.0);
  for (std::size_t i = 0; i < size; ++i) sums_[i] += static_cast<double>(sums[i]);
  if (tile.sample_end == samples_) scatter(tile, sums_.data());
}

template <class Real>
void Gather::scatter(const Tile& tile, const Real* sums) {
  constexpr int run = 64;   // pixels: what they read stays in the cache while plane after plane is written
  const int per_unit = layout_.pixels_per_unit();
  const std::int64_t unit_size = layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes;
  const std::int64_t first = tile.first_unit * per_unit;
  const std::int64_t end = std::min((tile.first_unit + tile.unit_count) * per_unit, layout_.pixels);
  std::int64_t pixel_at[run];
  for (std::int64_t p = first; p < end; p += run) {
    const int count = static_cast<int>(std::min<std::int64_t>(run, end - p));
    for (int i = 0; i < count; ++i)
      pixel_at[i] = (p + i - first) / per_unit * unit_size + (p + i - first) % per_unit;
    scatter_run(p, count, pixel_at, sums);
  }
  for (std::int64_t p = first; p < end;) {
    const std::int64_t row = p / frame_.width, row_end = std::min((row + 1) * frame_.width, end);
    row_pixels_[static_cast<std::size_t>(row)] += row_end - p;
    p = row_end;
  }
}

template <class Real>
void Gather::scatter_run(std::int64_t first_pixel, int count, const std::int64_t* pixel_at, const Real* sums) {
  const double scale = 1.0 / samples_;
  const std::size_t wavelengths = frame_.lambda_nm.size(), channels = channel_at_.size();
  for (int s = 0; s < 4; ++s) {
    for (std::size_t w = 0; w < wavelengths; ++w) {
      float* to = frame_.component(OUT_STOKES + s, w) + first_pixel;
      if (scene_.mixing.empty()) {
        const Real* from = sums + s * layout_.lanes + channel_at_[w];
        for (int i = 0; i < count; ++i) to[i] = static_cast<float>(static_cast<double>(from[pixel_at[i]]) * scale);
        continue;
      }
      for (int i = 0; i < count; ++i) {
        double mixed = 0;
        for (std::size_t c = 0; c < channels; ++c)
          mixed += scene_.mixing[c * wavelengths + w] *
                   static_cast<double>(sums[pixel_at[i] + s * layout_.lanes + channel_at_[c]]);
        to[i] = static_cast<float>(mixed * scale);
      }
    }
  }
  for (int i = 0; i < count; ++i) {
    double cut_off = 0;
    for (std::int64_t at : channel_at_)
      cut_off += static_cast<double>(sums[pixel_at[i] + OUT_CUT_OFF * layout_.lanes + at]);
    frame_.cut_off[static_cast<std::size_t>(first_pixel + i)] =
        static_cast<float>(cut_off * scale / static_cast<double>(channels));
  }
}

void Gather::finish() {
  const std::size_t width = static_cast<std::size_t>(frame_.width);
  for (std::size_t row = 0; row < row_pixels_.size(); ++row) {
    const bool done = row_pixels_[row] == frame_.width;
    frame_.row_done[row] = done;
    frame_.rows_done += done;
    const auto cut_off = frame_.cut_off.begin() + static_cast<std::ptrdiff_t>(row * width);
    if (done) {
      for (auto c = cut_off; c != cut_off + frame_.width; ++c) {
        cut_off_mean += static_cast<double>(*c);
        cut_off_worst = std::max(cut_off_worst, static_cast<double>(*c));
      }
    } else if (row_pixels_[row] > 0) {
      for (std::size_t plane = 0; plane < 4 * frame_.lambda_nm.size(); ++plane)
        std::fill_n(frame_.stokes.data() + plane * frame_.plane() + row * width, width, 0.0f);
      std::fill_n(cut_off, width, 0.0f);
    }
  }
  if (frame_.rows_done > 0) cut_off_mean /= static_cast<double>(frame_.rows_done) * frame_.width;
}

template void Gather::add(const Tile&, const float*);
template void Gather::add(const Tile&, const double*);

}  // namespace nicol
