// A few thousand pixels of a picture, spread evenly over it, rendered once more in other ways: what they differ by is what the
// picture is off by, for a small part of its time.
#pragma once
#include <cstdint>
#include <vector>

#include "host/accuracy/picture_error.hpp"
#include "host/opencl/render.hpp"
#include "host/scene.hpp"
#include "host/solids/solids.hpp"

namespace nicol::engine {

// What is done otherwise than in the picture.
struct Variant {
  bool real_double = false;
  double adc_bailout = 0;   // 0: the scene's
  int max_trace_level = 0;  // 0: the scene's
  int samples = 1;
};

struct SpotPicture {
  Frame frame;          // one row
  RenderReport report;
};

class SpotCheck {
 public:
  // The scene as it is rendered, for a picture of this size; `kernel` as the picture's.
  SpotCheck(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height, Device& device,
            const KernelOptions& kernel, int pixels);
  SpotPicture render(const Variant& variant) const;
  int pixels() const { return static_cast<int>(pixels_.size()); }

  // Looked at between tiles.
  const std::atomic<bool>* cancel = nullptr;

 private:
  Scene scene_;
  const Geometry& geometry_;
  std::uint32_t features_;
  int width_, height_;
  Device& device_;
  KernelOptions kernel_;
  std::vector<std::int32_t> pixels_;
};

// `count` pixels of the picture, ascending, no two alike; spread by the R2 sequence of samples.hpp.
std::vector<std::int32_t> spread_pixels(int width, int height, int count);

}  // namespace nicol::engine
