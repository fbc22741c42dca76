#include "host/opencl/gather.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

enum : std::uint32_t {
#define FEATURE(name, bit, meaning) bit_of_##name = std::uint32_t{1} << bit,
#include "kernels/features.def"
#undef FEATURE
};

}  // namespace

std::uint32_t lanes_over_pixels_bit() { return bit_of_lanes_over_pixels; }
std::uint32_t path_signatures_bit() { return bit_of_path_signatures; }

ItemLayout item_layout(const PackedScene& scene, int lanes, std::int64_t listed) {
  ItemLayout layout;
  layout.lanes = lanes;
  layout.channels = scene.channels;
  layout.blocks = scene.stride / lanes;
  layout.over_pixels = (scene.features & lanes_over_pixels_bit()) != 0;
  layout.pixels = listed > 0 ? listed : static_cast<std::int64_t>(scene.width) * scene.height;
  return layout;
}

Frame make_frame(const PackedScene& scene, int width, int height, const std::vector<double>& lambda_nm,
                 const std::vector<double>& weight_nm) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.lambda_nm = lambda_nm;
  frame.weight_nm = weight_nm;
  const bool spread = (scene.features & path_signatures_bit()) != 0;
  const double floats_per_pixel =
      4 * static_cast<double>(lambda_nm.size()) + 1 + (spread ? 6 + static_cast<double>(scene.channels) : 0);
  const double bytes = static_cast<double>(frame.plane()) * floats_per_pixel * sizeof(float);
  const auto too_large = [&](const std::string& there) {
    return DeviceError(fmt::format("a picture of {} x {} pixels and {} wavelengths needs {:.1f} GB of memory; {}. Take "
                                   "fewer pixels or wavelengths", width, height, lambda_nm.size(),
                                   bytes / 1e9, there));
  };
  const double free_bytes = free_memory_bytes();
  if (bytes > free_bytes) throw too_large(fmt::format("{:.1f} GB are free", free_bytes / 1e9));
  try {
    frame.stokes.resize(frame.plane() * 4 * lambda_nm.size());
    frame.cut_off.resize(frame.plane());
    frame.row_done.resize(static_cast<std::size_t>(height));
    if (spread) frame.samples.resize(frame.plane());
  } catch (const std::bad_alloc&) {
    throw too_large("the system gives less");
  }
  return frame;
}

Gather::Gather(const PackedScene& scene, int lanes, Frame& frame)
    : scene_(scene), layout_(item_layout(scene, lanes)), frame_(frame),
      row_pixels_(static_cast<std::size_t>(frame.height)),
      spread_((scene.features & path_signatures_bit()) != 0) {
  const std::int64_t item = OUT_COMPONENTS * layout_.lanes;
  for (int c = 0; c < layout_.channels; ++c)
    channel_at_.push_back(layout_.over_pixels ? c * item : c / layout_.lanes * item + c % layout_.lanes);
  if (!spread_) return;
  signature_.assign(frame.plane() * channel_at_.size(), -1);
  square_.assign(frame.plane() * (scene.mixing.empty() ? 1 : channel_at_.size()), 0);
  if (!scene.mixing.empty()) channel_sum_.assign(frame.plane() * channel_at_.size() * 4, 0);
  step_.assign(frame.plane(), 0);
}

void Gather::begin_pass(const std::vector<std::int32_t>* pixels, int begin, int end) {
  listed_ = pixels;
  begin_ = begin;
  end_ = end;
  sums_.clear();
  layout_.pixels = pixels ? static_cast<std::int64_t>(pixels->size()) : static_cast<std::int64_t>(frame_.plane());
}

template <class Real>
void Gather::add(const Tile& tile, const Real* sums) {
  const int samples = end_ - begin_;
  if (samples <= TileSchedule::samples_per_launch) return scatter(tile, sums);
  const std::size_t size =
      static_cast<std::size_t>(tile.unit_count * layout_.items_per_unit() * OUT_COMPONENTS * layout_.lanes);
  std::vector<double>& so_far = sums_[tile.first_unit];
  if (tile.sample_begin == 0) {
    if (so_far.empty()) so_far.swap(spare_);
    so_far.assign(size, 0.0);
  }
  const std::size_t item = static_cast<std::size_t>(OUT_COMPONENTS * layout_.lanes);
  for (std::size_t i = 0; i < size; ++i) {
    const bool is_signature = i % item / static_cast<std::size_t>(layout_.lanes) == OUT_SIGNATURE;
    const double value = static_cast<double>(sums[i]);
    if (!is_signature) so_far[i] += value;
    else so_far[i] = tile.sample_begin == 0 || so_far[i] == value ? value : -1;
  }
  if (tile.sample_end < samples) return;
  scatter(tile, so_far.data());
  spare_.swap(so_far);
  sums_.erase(tile.first_unit);
}

void Gather::forget(std::int64_t first_unit) { sums_.erase(first_unit); }

std::vector<std::int32_t> Gather::pixels_of(const Tile& tile) const {
  const int per_unit = layout_.pixels_per_unit();
  std::vector<std::int32_t> pixels;
  for (std::int64_t p = tile.first_unit * per_unit; p < std::min((tile.first_unit + tile.unit_count) * per_unit, layout_.pixels); ++p)
    pixels.push_back(static_cast<std::int32_t>(pixel_of(p)));
  return pixels;
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
  if (begin_ > 0) return;
  for (std::int64_t p = first; p < end;) {
    const std::int64_t row = p / frame_.width, row_end = std::min((row + 1) * frame_.width, end);
    row_pixels_[static_cast<std::size_t>(row)] += row_end - p;
    p = row_end;
  }
}

// The mean over all samples so far takes in that of this pass.
template <class Real>
void Gather::scatter_run(std::int64_t first, int count, const std::int64_t* pixel_at, const Real* sums) {
  const std::size_t wavelengths = frame_.lambda_nm.size(), channels = channel_at_.size();
  const double scale = 1.0 / (end_ - begin_), share = static_cast<double>(end_ - begin_) / end_;
  std::vector<double> change2(static_cast<std::size_t>(count));
  for (int s = 0; s < 4; ++s) {
    for (std::size_t w = 0; w < wavelengths; ++w) {
      float* to = frame_.component(OUT_STOKES + s, w);
      for (int i = 0; i < count; ++i) {
        double value = 0;
        if (scene_.mixing.empty()) {
          value = static_cast<double>(sums[pixel_at[i] + s * layout_.lanes + channel_at_[w]]);
        } else {
          for (std::size_t c = 0; c < channels; ++c)
            value += scene_.mixing[c * wavelengths + w] *
                     static_cast<double>(sums[pixel_at[i] + s * layout_.lanes + channel_at_[c]]);
        }
        value *= scale;
        float& mean = to[pixel_of(first + i)];
        if (begin_ > 0) {
          const double change = value - static_cast<double>(mean);
          change2[static_cast<std::size_t>(i)] += change * change;
          value = static_cast<double>(mean) + share * change;
        }
        mean = static_cast<float>(value);
      }
    }
  }
  for (int i = 0; i < count; ++i) {
    const std::size_t pixel = pixel_of(first + i);
    // The mean of the channels' own values in single precision: pictures of some wavelengths each come to the same.
    double cut_off = 0;
    for (std::size_t c = 0; c < channels; ++c) {
      const auto sum = static_cast<double>(sums[pixel_at[i] + OUT_CUT_OFF * layout_.lanes + channel_at_[c]]);
      const auto own = static_cast<float>(scale * sum);
      if (!frame_.channel_cut_off.empty()) frame_.channel_cut_off[c * frame_.plane() + pixel] = own;
      cut_off += static_cast<double>(own);
    }
    cut_off /= static_cast<double>(channels);
    float& mean = frame_.cut_off[pixel];
    mean = static_cast<float>(begin_ > 0 ? static_cast<double>(mean) + share * (cut_off - static_cast<double>(mean)) : cut_off);
    note_spread(pixel, sums + pixel_at[i], change2[static_cast<std::size_t>(i)] / static_cast<double>(wavelengths));
  }
}

template <class Real>
void Gather::note_spread(std::size_t pixel, const Real* sums, double change2) {
  const std::size_t wavelengths = frame_.lambda_nm.size(), channels = channel_at_.size();
  const int samples = end_ - begin_;
  const int odd = (samples - 1) / 4 * 2 + std::min((samples - 1) % 4, 2);  // of pairs with the sign -
  if (begin_ == 0 && samples > 1) {
    for (std::size_t w = 0; w < wavelengths; ++w) {
      double all = 0, halves = 0;
      for (std::size_t c = 0; c < channels; ++c) {
        const double part = scene_.mixing.empty() ? (c == w ? 1.0 : 0.0) : scene_.mixing[c * wavelengths + w];
        if (part == 0) continue;
        all += part * static_cast<double>(sums[channel_at_[c]]);
        halves += part * static_cast<double>(sums[OUT_HALVES * layout_.lanes + channel_at_[c]]);
      }
      const double difference = (all + halves) / 2 / (samples - odd) - (all - halves) / 2 / odd;
      halves_sum_ += difference * difference / 4;
    }
  }
  if (!spread_) return;
  frame_.samples[pixel] = static_cast<std::uint32_t>(end_);
  const double before = begin_, now = samples;
  step_[pixel] = static_cast<float>(std::sqrt(change2) * std::sqrt(before * now) / (before + now));
  for (std::size_t c = 0; c < channels; ++c) {
    const auto value = static_cast<std::int32_t>(sums[OUT_SIGNATURE * layout_.lanes + channel_at_[c]]);
    std::int32_t& signature = signature_[c * frame_.plane() + pixel];
    signature = begin_ == 0 || signature == value ? value : -1;
    const double square = static_cast<double>(sums[OUT_SQUARE * layout_.lanes + channel_at_[c]]);
    if (scene_.mixing.empty()) {
      square_[pixel] += square / static_cast<double>(wavelengths);
      continue;
    }
    square_[c * frame_.plane() + pixel] += square;
    for (int s = 0; s < 4; ++s)
      channel_sum_[(c * 4 + s) * frame_.plane() + pixel] += static_cast<double>(sums[s * layout_.lanes + channel_at_[c]]);
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
  const double pixels = static_cast<double>(frame_.rows_done) * frame_.width;
  if (frame_.rows_done > 0) cut_off_mean /= pixels;
  if (pixels > 0) halves_rms = std::sqrt(halves_sum_ / pixels / static_cast<double>(frame_.lambda_nm.size()));
}

template void Gather::add(const Tile&, const float*);
template void Gather::add(const Tile&, const double*);

}  // namespace nicol
