#include "host/preview/picture_sink.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "host/optics/colour.hpp"

namespace nicol::preview {
namespace {

// Shares of a wavelength in linear R, G, B and in Y.
std::vector<std::array<float, 4>> display_weights(const Frame& frame) {
  std::vector<std::array<float, 4>> weights;
  for (std::size_t w = 0; w < frame.lambda_nm.size(); ++w) {
    auto xyz = colour_matching(frame.lambda_nm[w]);
    for (double& component : xyz) component *= frame.weight_nm[w];
    const auto rgb = linear_srgb(xyz);
    weights.push_back({static_cast<float>(rgb[0]), static_cast<float>(rgb[1]), static_cast<float>(rgb[2]), static_cast<float>(xyz[1])});
  }
  return weights;
}

}  // namespace

void PictureSink::expect(const std::int32_t* pixels, std::size_t count, int samples, int step) {
  pixels_ = pixels;
  count_ = count;
  samples_ = samples;
  step_ = step;
}

// Running means: new = old + (frame - old) m/(n + m), and what is shown of them.
void PictureSink::mix_in(const Frame& frame) {
  Frame& to = picture_.frame;
  const auto weights = display_weights(to);
  std::vector<float> part(count_), rgb(3 * count_), stokes_y(4 * count_);
  std::vector<unsigned char> had(count_);
  for (std::size_t i = 0; i < count_; ++i) {
    const auto p = static_cast<std::size_t>(pixels_[i]);
    had[i] = to.samples[p] > 0;
    to.samples[p] += static_cast<std::uint32_t>(samples_);
    part[i] = static_cast<float>(samples_) / static_cast<float>(to.samples[p]);
    to.cut_off[p] += (frame.cut_off[i] - to.cut_off[p]) * part[i];
  }
  for (std::size_t w = 0; w < weights.size(); ++w) {
    for (std::size_t s = 0; s < 4; ++s) {
      float* plane = to.component(static_cast<int>(s), w);
      const float* values = frame.component(static_cast<int>(s), w);
      double change2 = 0;
      for (std::size_t i = 0; i < count_; ++i) {
        float& mean = plane[pixels_[i]];
        const float change = (values[i] - (had[i] ? mean : 0)) * part[i];
        mean = had[i] ? mean + change : values[i];
        if (had[i]) change2 += static_cast<double>(change) * static_cast<double>(change);
        stokes_y[4 * i + s] += weights[w][3] * mean;
        if (s == 0)
          for (std::size_t k = 0; k < 3; ++k) rgb[3 * i + k] += weights[w][k] * mean;
      }
      change2_ += change2;
    }
  }
  for (std::size_t i = 0; i < count_; ++i) {
    const auto p = static_cast<std::size_t>(pixels_[i]);
    std::copy_n(&rgb[3 * i], 3, &picture_.rgb[3 * p]);
    std::copy_n(&stokes_y[4 * i], 4, &picture_.stokes_y[4 * p]);
  }
}

void PictureSink::fill_blocks() {
  const int width = picture_.frame.width, height = picture_.frame.height;
  for (std::size_t i = 0; i < count_; ++i) {
    const int x0 = pixels_[i] % width, y0 = pixels_[i] / width;
    const auto from = static_cast<std::size_t>(pixels_[i]);
    for (int y = y0; y < std::min(y0 + step_, height); ++y)
      for (int x = x0; x < std::min(x0 + step_, width); ++x) {
        const std::size_t p = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
        if (p == from) continue;
        std::copy_n(&picture_.rgb[3 * from], 3, &picture_.rgb[3 * p]);
        std::copy_n(&picture_.stokes_y[4 * from], 4, &picture_.stokes_y[4 * p]);
      }
  }
}

void PictureSink::write(const Frame& frame) {
  const std::lock_guard<std::mutex> held(lock_);
  if (std::exchange(anew_, false)) forget(picture_);
  mix_in(frame);
  if (step_ > 1) fill_blocks();
  ++picture_.version;
}

void PictureSink::write_whole(Frame&& frame) {
  std::vector<std::int32_t> all(frame.plane());
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = static_cast<std::int32_t>(i);
  const std::lock_guard<std::mutex> held(lock_);
  const std::vector<std::uint32_t> samples = std::move(frame.samples);
  picture_.frame.samples.assign(frame.plane(), 0);
  expect(all.data(), all.size(), 1, 1);
  mix_in(frame);
  if (!samples.empty()) picture_.frame.samples = samples;
  picture_.frame.sample_error = std::move(frame.sample_error);
  picture_.step = 1;
  ++picture_.version;
}

double PictureSink::take_change2() {
  const double change2 = change2_;
  change2_ = 0;
  return change2;
}

double mean_radiance_of(const Picture& picture) {
  const Frame& frame = picture.frame;
  std::vector<std::size_t> traced;
  for (std::size_t p = 0; p < frame.plane(); ++p)
    if (frame.samples[p] > 0) traced.push_back(p);
  double sum = 0;
  for (std::size_t w = 0; w < frame.lambda_nm.size(); ++w) {
    const float* plane = frame.component(0, w);
    for (const std::size_t p : traced) sum += static_cast<double>(plane[p]);
  }
  const std::size_t count = traced.size() * frame.lambda_nm.size();
  return count > 0 ? sum / static_cast<double>(count) : 0;
}

}  // namespace nicol::preview
