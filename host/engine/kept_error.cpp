#include "host/engine/kept_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/engine/spot_check.hpp"

namespace nicol::engine {
namespace {

constexpr double of_sampling = 0.7, of_step = 0.45, of_cut_off = 0.35, of_rounding = 0.3;
constexpr int pixels = 1024;
constexpr int first_levels = 64, most_levels = 4096;
constexpr int most_halvings = 4;
constexpr double coarsest_adc = 1e-2, finest_adc = 1e-9;

class Choice {
 public:
  Choice(std::unique_ptr<LoadedScene>& loaded, const PictureOptions& command, Device& device, double error,
         const std::atomic<bool>& cancel)
      : loaded_(loaded), command_(command), device_(device), error_(error), cancel_(cancel),
        kernel_(kernel_options(command.device)) {
    chosen_.real_double = kernel_.real_double;
  }

  ChosenSettings run() {
    Settings& s = loaded_->scene.settings;
    s.max_trace_level = first_levels;
    s.adc_bailout = coarsest_adc;
    choose_wavelengths();
    choose_cut_off();
    choose_depth();
    choose_real();
    Settings& settings = loaded_->scene.settings;
    settings.samples = 1;
    settings.sample_error = of_sampling * error_;
    chosen_.text = fmt::format("adc_bailout {:g}, max_trace_level {}, {} wavelength{}, {}, sampling to {:.2g} %",
                               settings.adc_bailout, settings.max_trace_level, loaded_->scene.lambda_nm.size(),
                               loaded_->scene.lambda_nm.size() == 1 ? "" : "s", chosen_.real_double ? "double" : "float",
                               100 * settings.sample_error);
    return chosen_;
  }

 private:
  bool stopped() const { return cancel_.load(); }

  SpotPicture spot(const Variant& variant) {
    KernelOptions kernel = kernel_;
    SpotCheck check(loaded_->scene, loaded_->geometry, loaded_->features.mask, command_.options.width,
                    command_.options.height, device_, kernel, pixels);
    check.cancel = &cancel_;
    SpotPicture picture = check.render(variant);
    chosen_.seconds += picture.report.seconds + picture.report.build.seconds;
    return picture;
  }

  // The step of wavelength is halved until it is fine enough.
  void choose_wavelengths() {
    for (int halving = 0;; ++halving) {
      Variant variant;
      variant.adc_bailout = 1e-3;
      const SpectralStep step = spectral_step(spot(variant).frame);
      const std::vector<double>& lambda_nm = loaded_->scene.lambda_nm;
      if (stopped() || lambda_nm.size() == 1) return;
      if (!step.known) return miss(fmt::format("the error of the step of wavelength is not known: {}", step.reason));
      if (step.xyz_rms <= of_step * error_) return;
      if (!command_.options.wavelengths.empty() || halving == most_halvings)
        return miss(fmt::format("{} wavelengths leave an error of {:.2g} % in the colours", lambda_nm.size(), 100 * step.xyz_rms));
      SceneOptions finer = command_.options;
      finer.wavelengths = fmt::format("{}:{}:{}", lambda_nm.front(), lambda_nm.back(), (lambda_nm[1] - lambda_nm[0]) / 2);
      const Settings settings = loaded_->scene.settings;
      std::string told;
      auto again = load_scene(command_.scene, finer, Expectations::where_they_apply, &told);
      if (!again) return miss("the scene has errors at other wavelengths:\n" + told);
      again->scene.settings = settings;
      loaded_ = std::move(again);
    }
  }

  void choose_cut_off() {
    double adc = coarsest_adc;
    SpotPicture picture = spot(at(adc));
    while (!stopped()) {
      const double finer = adc / 10;
      SpotPicture better = spot(at(finer));
      const double off = picture_error(picture.frame, better.frame).rms();
      if (!(off > of_cut_off * error_) || finer < finest_adc) {
        if (off > of_cut_off * error_) miss(fmt::format("adc_bailout {:g} still leaves {:.2g} %", adc, 100 * off));
        break;
      }
      adc = finer;
      picture = std::move(better);
    }
    loaded_->scene.settings.adc_bailout = adc;
  }

  // The weights of most paths end them long before: deeper costs nothing then.
  void choose_depth() {
    int& levels = loaded_->scene.settings.max_trace_level;
    SpotPicture picture = spot({});
    while (!stopped()) {
      Variant deeper;
      deeper.max_trace_level = 4 * levels;
      SpotPicture better = spot(deeper);
      const double off = picture_error(picture.frame, better.frame).rms();
      if (!(off > of_cut_off * error_ / 2)) return;
      if (deeper.max_trace_level > most_levels)
        return miss(fmt::format("{} faces deep, {:.2g} % is still to come", levels, 100 * off));
      levels = deeper.max_trace_level;
      picture = std::move(better);
    }
  }

  void choose_real() {
    if (chosen_.real_double || stopped()) return;
    if (!info(device_).has_fp64) {
      chosen_.reason = "rounding is not known: this device has no fp64";
      return;
    }
    Variant exact;
    exact.real_double = true;
    const double off = picture_error(spot({}).frame, spot(exact).frame).rms();
    if (off > of_rounding * error_) chosen_.real_double = true;
  }

  static Variant at(double adc) {
    Variant variant;
    variant.adc_bailout = adc;
    return variant;
  }

  void miss(const std::string& reason) {
    chosen_.reachable = false;
    if (!chosen_.reason.empty()) chosen_.reason += "; ";
    chosen_.reason += reason;
  }

  std::unique_ptr<LoadedScene>& loaded_;
  const PictureOptions& command_;
  Device& device_;
  double error_;
  const std::atomic<bool>& cancel_;
  KernelOptions kernel_;
  ChosenSettings chosen_;
};

}  // namespace

ChosenSettings choose_settings(std::unique_ptr<LoadedScene>& loaded, const PictureOptions& command, Device& device,
                               double error, const std::atomic<bool>& cancel) {
  return Choice(loaded, command, device, error, cancel).run();
}

}  // namespace nicol::engine
