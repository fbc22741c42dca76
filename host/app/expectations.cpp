// See expectations.hpp.
#include "host/app/expectations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "host/app/chord.hpp"
#include "host/optics/colour.hpp"
#include "host/pack.hpp"

namespace nicol::app {
namespace {

// Places are seen with the pixels of a picture of the usual size.
constexpr int pixels_across = 512;

constexpr double rad_per_deg = 3.14159265358979323846 / 180;

// What stops a number from being measured, told with the expectation.
struct Unmeasurable : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Bench {
 public:
  Bench(const LoadedScene& loaded, Device& device, const KernelOptions& kernel)
      : scene_(loaded.scene),
        geometry_(loaded.geometry),
        features_(loaded.features.mask),
        device_(device),
        kernel_(kernel) {}

  std::vector<double> measure(const Expectation& expectation) {
    using Quantity = Expectation::Quantity;
    switch (expectation.quantity) {
      case Quantity::relative_radiance:
        return {relative_stokes(expectation)[0]};
      case Quantity::stokes:
        return relative_stokes(expectation);
      case Quantity::xyz:
        return to_vector(pixel_xyz(expectation));
      case Quantity::rgb:
        return pixel_rgb(expectation);
      case Quantity::chromaticity:
        return chromaticity(expectation);
      case Quantity::rotation_deg:
        return {chord_rotation_deg(expectation)};
      case Quantity::malus_xyz:
        return malus_xyz(expectation);
    }
    throw Unmeasurable("an unknown quantity");
  }

 private:
  static std::vector<double> to_vector(const std::array<double, 3>& a) {
    return {a.begin(), a.end()};
  }

  std::size_t lambda_index(double lambda_nm) const {
    constexpr double same_nm = 1e-6;
    for (std::size_t i = 0; i < scene_.lambda_nm.size(); ++i)
      if (std::fabs(scene_.lambda_nm[i] - lambda_nm) < same_nm) return i;
    throw Unmeasurable(fmt::format("{:g} nm is not among the scene's wavelengths", lambda_nm));
  }

  const Emission& first_emission() const {
    if (scene_.emissions.empty()) throw Unmeasurable("nothing in the scene shines");
    return scene_.emissions.front();
  }

  const Frame& frame_at(const std::array<double, 2>& place) {
    const auto known = frames_.find(place);
    if (known != frames_.end()) return known->second;
    const PackedScene packed =
        pack(scene_, geometry_, features_, 1, 1, lanes_on(device_, kernel_), pixels_across);
    RenderOptions options;
    options.kernel = kernel_;
    options.positions = {place};
    RenderReport report;
    Frame frame = render(device_, packed, scene_.lambda_nm, scene_.weight_nm, options, report);
    frame.exposure = scene_.settings.exposure;
    if (report.nan_count > 0) throw Unmeasurable("a path's light was not a number");
    return frames_.emplace(place, std::move(frame)).first->second;
  }

  std::vector<double> relative_stokes(const Expectation& expectation) {
    const std::size_t lambda = lambda_index(expectation.lambda_nm);
    const double whole = first_emission().radiance[lambda];
    if (!(whole > 0))
      throw Unmeasurable(fmt::format("the first light is dark at {:g} nm", expectation.lambda_nm));
    const Frame& frame = frame_at(expectation.at);
    std::vector<double> stokes;
    for (int s = 0; s < 4; ++s) stokes.push_back(frame.component(s, lambda)[0] / whole);
    return stokes;
  }

  std::array<double, 3> pixel_xyz(const Expectation& expectation) {
    const Observer observer(scene_.lambda_nm, scene_.weight_nm);
    return observer.xyz(
        frame_at(expectation.at).component(0, 0));  // one pixel: its wavelengths are neighbours
  }

  std::vector<double> pixel_rgb(const Expectation& expectation) {
    const std::vector<float> rgb = linear_rgb(frame_at(expectation.at));
    return {rgb.begin(), rgb.end()};
  }

  std::vector<double> chromaticity(const Expectation& expectation) {
    const std::array<double, 3> xyz = pixel_xyz(expectation);
    const double sum = std::accumulate(xyz.begin(), xyz.end(), 0.0);
    if (!(sum > 0)) throw Unmeasurable("the place is dark");
    return {xyz[0] / sum, xyz[1] / sum};
  }

  double chord_rotation_deg(const Expectation& expectation) const {
    const std::size_t lambda = lambda_index(expectation.lambda_nm);
    const auto chord = first_chord(scene_, geometry_, expectation.at, lambda);
    if (!chord) throw Unmeasurable("the camera's ray meets no solid there");
    const Samples& rotation = scene_.media[geometry_.cells[chord->cell].medium].rotation_deg_per_mm;
    return rotation.empty() ? 0 : rotation[lambda] * chord->length_mm;
  }

  // Crossed or parallel polars around an active plate pass cos^2 of its rotation (Malus 1809),
  // wavelength by wavelength; here of the first light.
  std::vector<double> malus_xyz(const Expectation& expectation) const {
    const Medium& medium = scene_.media[expectation.medium];
    std::vector<double> radiance = first_emission().radiance;
    for (std::size_t i = 0; i < radiance.size(); ++i) {
      const double cosine =
          std::cos(medium.rotation_deg_per_mm[i] * expectation.length_mm * rad_per_deg);
      radiance[i] *= cosine * cosine;
    }
    return to_vector(Observer(scene_.lambda_nm, scene_.weight_nm).xyz(radiance.data()));
  }

  const Scene& scene_;
  const Geometry& geometry_;
  std::uint32_t features_;
  Device& device_;
  KernelOptions kernel_;
  std::map<std::array<double, 2>, Frame> frames_;
};

}  // namespace

const char* quantity_name(Expectation::Quantity quantity) {
  using Quantity = Expectation::Quantity;
  switch (quantity) {
    case Quantity::relative_radiance:
      return "relative_radiance";
    case Quantity::stokes:
      return "stokes";
    case Quantity::xyz:
      return "xyz";
    case Quantity::rgb:
      return "rgb";
    case Quantity::chromaticity:
      return "chromaticity";
    case Quantity::rotation_deg:
      return "rotation_deg";
    case Quantity::malus_xyz:
      return "malus_xyz";
  }
  return "";
}

Outcome compare(const Expectation& expectation, std::vector<double> value) {
  Outcome outcome;
  outcome.value = std::move(value);
  if (outcome.value.size() != expectation.value.size()) {
    outcome.reason = fmt::format("{} numbers expected, {} measured", expectation.value.size(),
                                 outcome.value.size());
    return outcome;
  }
  outcome.pass = true;
  for (std::size_t i = 0; i < outcome.value.size(); ++i) {
    const double expected = expectation.value[i];
    const double allowed =
        expectation.relative ? expectation.tolerance * std::fabs(expected) : expectation.tolerance;
    outcome.difference.push_back(outcome.value[i] - expected);
    if (!(std::fabs(outcome.difference[i]) <= allowed)) outcome.pass = false;
  }
  return outcome;
}

std::vector<Outcome> evaluate_expectations(const LoadedScene& loaded, Device& device,
                                           const KernelOptions& kernel) {
  Bench bench(loaded, device, kernel);
  std::vector<Outcome> outcomes;
  for (const Expectation& expectation : loaded.scene.expectations) {
    try {
      outcomes.push_back(compare(expectation, bench.measure(expectation)));
    } catch (const Unmeasurable& reason) {
      outcomes.push_back({{}, {}, false, reason.what()});
    }
  }
  return outcomes;
}

}  // namespace nicol::app
