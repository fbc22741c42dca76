// How far a pixel's mean over its samples is from that over the pixel, estimated.
//
// One sample: where all eight neighbours have its signature, light changes smoothly and the centre misses (f_xx + f_yy)/24; where one has
// not, an edge runs between the two centres: with the step d somewhere in there, the error is 0.29 d (RMS) if it is in this pixel.
// More samples: the standard deviation within the pixel times law n^-3/4, the law taken from how much the last pass has changed.
// With the first estimate as one sample more, because a sliver may lie between all samples.
#include <algorithm>
#include <cmath>

#include "host/opencl/gather.hpp"
#include "host/opencl/sampling_plan.hpp"

namespace nicol {
namespace {

constexpr double edge_share = 0.3;
constexpr double least_law = 0.8, most_law = 4, lasting = 0.75;  // 0.8: a straight edge anywhere in the pixel

double square_of(float v) { return static_cast<double>(v) * static_cast<double>(v); }

constexpr int neighbours[8][2] = {{-1, -1}, {0, -1}, {1, -1}, {-1, 0}, {1, 0}, {-1, 1}, {0, 1}, {1, 1}};

// Second difference along a line of pixels, at its ends that of the next one inside.
double bend_of(const float* f, std::size_t at, std::size_t length, std::ptrdiff_t step) {
  if (at == 0) f += step;
  if (at + 1 == length) f -= step;
  return static_cast<double>(f[-step]) + static_cast<double>(f[step]) - 2.0 * static_cast<double>(*f);
}

}  // namespace

// Which neighbours in the picture met something else than the pixel: a bit for each of `neighbours`.
std::vector<unsigned char> Gather::other_neighbours(std::size_t channel) const {
  const int width = frame_.width, height = frame_.height;
  std::vector<unsigned char> others(frame_.plane());
  for (int k = 0; k < 8; ++k) {
    const int dx = neighbours[k][0], dy = neighbours[k][1];
    for (int y = std::max(0, -dy); y < height - std::max(0, dy); ++y) {
      const std::int32_t* own = signature_.data() + channel * frame_.plane() + static_cast<std::size_t>(y) * width;
      const std::int32_t* other = own + dy * width + dx;
      unsigned char* to = others.data() + static_cast<std::size_t>(y) * width;
      for (int x = std::max(0, -dx); x < width - std::max(0, dx); ++x)
        to[x] = static_cast<unsigned char>(to[x] | ((own[x] != other[x] || own[x] < 0) << k));
    }
  }
  return others;
}

// Square of the error of the first samples at one wavelength, added to `sum`.
void Gather::add_first_errors(std::size_t w, const std::vector<unsigned char>& others, std::vector<double>& sum) const {
  const std::size_t width = static_cast<std::size_t>(frame_.width), plane = frame_.plane();
  const auto step_to = [&](std::size_t i, std::size_t n) {
    double length2 = 0;
    for (int s = 0; s < 4; ++s) {
      const double d = static_cast<double>(frame_.component(s, w)[n] - frame_.component(s, w)[i]);
      length2 += d * d;
    }
    return length2;
  };
  for (std::size_t i = 0; i < plane; ++i) {
    double step2 = 0;  // the largest to a neighbour that met something else
    for (int k = 0; k < 8 && others[i] != 0; ++k)
      if (others[i] >> k & 1)
        step2 = std::max(step2, step_to(i, i + static_cast<std::size_t>(neighbours[k][1] * frame_.width + neighbours[k][0])));
    double smooth2 = 0;
    for (int s = 0; s < 4; ++s) {
      const float* f = frame_.component(s, w) + i;
      double bend = 0;
      if (width >= 3) bend += std::fabs(bend_of(f, i % width, width, 1));
      if (plane / width >= 3) bend += std::fabs(bend_of(f, i / width, plane / width, static_cast<std::ptrdiff_t>(width)));
      smooth2 += bend * bend / (24.0 * 24.0);
    }
    sum[i] += std::max(edge_share * edge_share * step2, smooth2);
  }
}

void Gather::first_errors() {
  const std::size_t wavelengths = frame_.lambda_nm.size(), channels = channel_at_.size();
  edge_.assign(frame_.plane(), 0);
  std::vector<double> sum(frame_.plane());
  std::vector<unsigned char> any;
  for (std::size_t c = 0; c < channels; ++c) {
    const auto others = other_neighbours(c);
    if (any.empty()) any.resize(others.size());
    for (std::size_t i = 0; i < others.size(); ++i) any[i] |= others[i];
    if (scene_.mixing.empty()) add_first_errors(c, others, sum);
  }
  if (!scene_.mixing.empty())
    for (std::size_t w = 0; w < wavelengths; ++w) add_first_errors(w, any, sum);
  for (std::size_t i = 0; i < any.size(); ++i) edge_[i] = any[i] != 0;
  prior_.resize(sum.size());
  for (std::size_t i = 0; i < sum.size(); ++i)
    prior_[i] = static_cast<float>(std::sqrt(sum[i] / static_cast<double>(wavelengths)));
  smooth_first_errors();
  frame_.sample_error = prior_;
}

// A second difference or a step may vanish by chance where light varies faster than pixels: a pixel is no better than its
// neighbours of the same kind, at edges or away from them, are on average.
void Gather::smooth_first_errors() {
  const int width = frame_.width, height = frame_.height;
  const std::vector<float> own = prior_;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * width + x;
      double sum = 0;
      int count = 0;
      for (const auto& [dx, dy] : neighbours) {
        const std::size_t n = i + static_cast<std::size_t>(dy * width + dx);
        if (x + dx < 0 || x + dx >= width || y + dy < 0 || y + dy >= height || edge_[n] != edge_[i]) continue;
        sum += static_cast<double>(own[n]);
        ++count;
      }
      if (count > 0) prior_[i] = std::max(prior_[i], static_cast<float>(sum / count));
    }
}

// Light varies within the pixel by much more than from it to its neighbours' means: fringes finer than pixels.
bool Gather::rough_at(std::size_t pixel) const {
  constexpr double much_more = 4;
  const std::size_t width = static_cast<std::size_t>(frame_.width), plane = frame_.plane();
  double ramp2 = 0;  // variance of a ramp that goes as the neighbours do
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w)
    for (int s = 0; s < 4; ++s) {
      const float* f = frame_.component(s, w);
      const auto slope = [&](std::size_t back, std::size_t forth) {
        return forth == back ? 0.0
                             : static_cast<double>(f[forth] - f[back]) * (forth - back == 1 || forth - back == width ? 1.0 : 0.5);
      };
      const double across = slope(pixel % width > 0 ? pixel - 1 : pixel, pixel % width + 1 < width ? pixel + 1 : pixel);
      const double down = slope(pixel >= width ? pixel - width : pixel, pixel + width < plane ? pixel + width : pixel);
      ramp2 += (across * across + down * down) / 12;
    }
  ramp2 /= static_cast<double>(frame_.lambda_nm.size());
  return deviation2(pixel) / frame_.samples[pixel] > much_more * ramp2;
}

// The law from the pixels whose samples have just become more: the change is what the mean had been off, and is now.
void Gather::calibrate() {
  constexpr int enough = 64;
  double change2 = 0, predicted2 = 0;
  int pixels = 0;
  for (std::size_t i = 0; i < step_.size(); ++i) {
    if (!(step_[i] > 0) || frame_.samples[i] < 11 || !edge_[i]) continue;
    change2 += static_cast<double>(step_[i]) * static_cast<double>(step_[i]);
    const double predicted = static_cast<double>(frame_.sample_error[i]) / law_;
    predicted2 += predicted * predicted;
    ++pixels;
  }
  // Edges along the rows of pixels are all off alike, by more or by less than the law at any one count: what was seen lasts a while.
  if (pixels >= enough && predicted2 > 0)
    law_ = std::clamp(std::max(std::sqrt(change2 / predicted2), lasting * law_), least_law, most_law);
}

// Sum over the pixel's samples of the Stokes vector's squared distance from its mean, mean over wavelengths.
double Gather::deviation2(std::size_t pixel) const {
  constexpr double rounding = 4e-7;  // of squares in single precision
  const double n = frame_.samples[pixel];
  const std::size_t wavelengths = frame_.lambda_nm.size(), channels = channel_at_.size();
  if (scene_.mixing.empty()) {
    double mean2 = 0;
    for (int s = 0; s < 4; ++s)
      for (std::size_t w = 0; w < wavelengths; ++w) mean2 += square_of(frame_.component(s, w)[pixel]);
    return std::max(0.0, square_[pixel] * (1 - rounding) - n * mean2 / static_cast<double>(wavelengths));
  }
  std::vector<double> deviation(channels);
  for (std::size_t c = 0; c < channels; ++c) {
    double sum2 = 0;
    for (int s = 0; s < 4; ++s) sum2 += std::pow(channel_sum_[(c * 4 + s) * frame_.plane() + pixel], 2);
    deviation[c] = std::sqrt(std::max(0.0, square_[c * frame_.plane() + pixel] * (1 - rounding) - sum2 / n));
  }
  double sum = 0;
  for (std::size_t w = 0; w < wavelengths; ++w) {
    double of_all = 0;
    for (std::size_t c = 0; c < channels; ++c) of_all += std::fabs(scene_.mixing[c * wavelengths + w]) * deviation[c];
    sum += of_all * of_all;
  }
  return sum / static_cast<double>(wavelengths);
}

double Gather::error_of(std::size_t pixel) const {
  const double n = frame_.samples[pixel], prior = static_cast<double>(prior_[pixel]);
  if (n <= 1) return prior;
  if (!edge_[pixel]) return prior / n;
  return law_ * std::sqrt((deviation2(pixel) + prior * prior) / n) * std::pow(n, -0.75);
}

double Gather::part_at_edges() const {
  return static_cast<double>(std::count(edge_.begin(), edge_.end(), 1)) / static_cast<double>(std::max<std::size_t>(1, edge_.size()));
}

void Gather::estimate_errors() {
  if (!spread_) return;
  if (prior_.empty()) first_errors();
  std::vector<std::size_t> changed;
  for (std::size_t i = 0; i < step_.size(); ++i)
    if (step_[i] > 0) changed.push_back(i);
  for (const std::size_t i : changed) {
    for (std::size_t c = 0; c < channel_at_.size() && !edge_[i]; ++c) edge_[i] = signature_[c * frame_.plane() + i] < 0;
    if (!edge_[i] && frame_.samples[i] > 1) edge_[i] = rough_at(i);
    frame_.sample_error[i] = static_cast<float>(error_of(i));
  }
  const double before = law_;
  calibrate();
  for (std::size_t i = 0; i < step_.size(); ++i)
    if (edge_[i] && frame_.samples[i] > 1) frame_.sample_error[i] *= static_cast<float>(law_ / before);
  for (const std::size_t i : changed) step_[i] = 0;
}

}  // namespace nicol
