// global_settings { }: scale, wavelengths, depth of the tree of rays, and what the picture is
// multiplied by.
#include <algorithm>
#include <cmath>
#include <memory>

#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"

namespace nicol {

namespace {

std::optional<double> positive(Context& context, const Args& args, const char* what) {
  if (args.numbers[0] > 0) return args.numbers[0];
  context.error(args.where, std::string("'") + what + "' must be greater than 0, " +
                                to_text(args.numbers[0]) + " found instead");
  return std::nullopt;
}

std::optional<int> integer(Context& context, const Args& args, const char* what, int low,
                           int high) {
  const double number = args.numbers[0];
  if (number == std::floor(number) && number >= low && number <= high)
    return static_cast<int>(number);
  context.error(args.where, std::string("'") + what + "' must be a whole number from " +
                                std::to_string(low) + " to " + std::to_string(high) + ", " +
                                to_text(number) + " found instead");
  return std::nullopt;
}

void append_range(Context& context, Location where, double from, double to, double step,
                  std::vector<double>& lambda_nm) {
  if (!(step > 0) || !(to >= from)) {
    context.error(where, "wavelengths run from the shorter to the longer by a step greater than 0");
    return;
  }
  const double count = std::floor((to - from) / step + 1e-9) + 1;
  if (count > static_cast<double>(context.limits.wavelengths)) {
    context.error(where,
                  "more than " + std::to_string(context.limits.wavelengths) + " wavelengths");
    return;
  }
  for (int i = 0; i < static_cast<int>(count); ++i) lambda_nm.push_back(from + i * step);
}

void bind_wavelengths(Context& context, const sdl::Block& block, std::vector<double>& lambda_nm) {
  lambda_nm.clear();
  const std::size_t errors_before = context.error_count();
  read_block(context, block, wavelengths_schema(context, lambda_nm));
  std::sort(lambda_nm.begin(), lambda_nm.end());
  if (lambda_nm.size() > context.limits.wavelengths)
    context.error(block.where,
                  "more than " + std::to_string(context.limits.wavelengths) + " wavelengths");
  if (std::adjacent_find(lambda_nm.begin(), lambda_nm.end()) != lambda_nm.end())
    context.error(block.where, "the same wavelength is given twice");
  if (!lambda_nm.empty() && lambda_nm.front() <= 0)
    context.error(block.where, "wavelengths (nm) must be greater than 0");
  if (lambda_nm.empty() && context.error_count() == errors_before)
    context.error(block.where, "Expected 'from', 'to' and 'step', or a list of wavelengths in nm");
  if (context.error_count() != errors_before)
    lambda_nm.clear();  // the default serves for what follows
}

const char* const accepted = "%s is accepted, but means nothing to nicol";

}  // namespace

Schema wavelengths_schema(Context& context, std::vector<double>& lambda_nm) {
  struct Range {
    double from = 0, to = 0;
  };
  auto range = std::make_shared<Range>();
  std::vector<double>* list = &lambda_nm;
  Context* c = &context;
  return {"wavelengths",
          {{"from", "n", [=](const Args& a) { range->from = a.numbers[0]; }, "nm, the first"},
           {"to", "n", [=](const Args& a) { range->to = a.numbers[0]; }, "nm, the last"},
           {"step", "n",
            [=](const Args& a) {
              append_range(*c, a.where, range->from, range->to, a.numbers[0], *list);
            },
            "nm, between neighbours; written after `from` and `to`"},
           {"", "N",
            [=](const Args& a) { list->insert(list->end(), a.numbers.begin(), a.numbers.end()); },
            "a list of wavelengths in nm"}},
          {}};
}

// A relative error: 0 < x < 1.
std::optional<double> target(Context& context, const Args& a, const std::string& name) {
  if (a.numbers[0] > 0 && a.numbers[0] < 1) return a.numbers[0];
  context.error(a.where, "'" + name + "' must lie between 0 and 1 (0.001 is 0.1 %)");
  return {};
}

Schema settings_schema(Context& context, RawSettings& raw) {
  Context* c = &context;
  RawSettings* r = &raw;
  Settings* s = &context.scene.settings;
  const auto nothing = [](const Args&) {};
  return {
      "global_settings",
      {{"mm_per_unit", "n",
        [=](const Args& a) { s->mm_per_unit = positive(*c, a, "mm_per_unit").value_or(10); },
        "millimetres of one scene unit (POV-Ray's default: 10)"},
       {"max_trace_level", "n",
        [=](const Args& a) {
          s->max_trace_level = integer(*c, a, "max_trace_level", 1, 4096).value_or(5);
        },
        "how many faces a path may meet (5)"},
       {"adc_bailout", "n",
        [=](const Args& a) {
          if (a.numbers[0] < 0) c->error(a.where, "'adc_bailout' must not be negative");
          else s->adc_bailout = a.numbers[0];
        },
        "the weight under which a path is cut off (1/255)"},
       {"wavelengths", "{}", [=](const Args& a) { bind_wavelengths(*c, *a.block, r->lambda_nm); },
        "what is computed (from 380 to 780 step 20)"},
       {"samples", "n",
        [=](const Args& a) { s->samples = integer(*c, a, "samples", 1, 65536).value_or(1); },
        "rays per pixel (1)"},
       {"error", "n", [=](const Args& a) { s->error = target(*c, a, "error").value_or(0); },
        "RMS error of the picture relative to its mean radiance: the settings that keep it are picked"},
       {"sample_error", "n",
        [=](const Args& a) { s->sample_error = target(*c, a, "sample_error").value_or(0); },
        "the same of pixel sampling alone: samples go where they matter"},
       {"exposure", "n",
        [=](const Args& a) { s->exposure = positive(*c, a, "exposure").value_or(1); },
        "factor on the colours of the picture, not on its spectra (1)"},
       {"polarization", "b", [=](const Args& a) { s->polarization = a.numbers[0] != 0; },
        "off: intensities only"},
       {"coherence", "b", [=](const Args& a) { s->coherence = a.numbers[0] != 0; },
        "off: the two waves of a crystal never add as amplitudes (on)"},
       {"conical_rays", "n",
        [=](const Args& a) {
          s->conical_rays = integer(*c, a, "conical_rays", 0, 4096).value_or(0);
        },
        "azimuths that sample the cone at a binormal, per sample (0)"},
       {"conical_spread", "n",
        [=](const Args& a) {
          s->conical_spread_rad = radians(positive(*c, a, "conical_spread").value_or(0));
        },
        "degrees: half the angle of the bundle that a ray stands for (that of a pixel)"},
       {"assumed_gamma", "*", nothing, "accepted: nicol computes with spectra"}},
      {{accepted,
        false,
        {"ambient_light", "hf_gray_16", "irid_wavelength", "charset", "max_intersections",
         "number_of_waves", "noise_generator", "radiosity", "photons", "subsurface", "ascii",
         "utf8", "sys"}},
       {"", false, {"srgb"}}}};
}

void finish_settings(Context& context, const RawSettings& raw) {
  const BindOptions& wanted = context.options;
  Settings& s = context.scene.settings;
  s.max_trace_level = wanted.max_trace_level.value_or(s.max_trace_level);
  s.adc_bailout = wanted.adc_bailout.value_or(s.adc_bailout);
  s.samples = wanted.samples.value_or(s.samples);
  s.error = wanted.error.value_or(s.error);
  s.sample_error = wanted.sample_error.value_or(s.sample_error);
  s.exposure = wanted.exposure.value_or(s.exposure);
  s.polarization = wanted.polarization.value_or(s.polarization);
  std::vector<double>& lambda_nm = context.scene.lambda_nm;
  lambda_nm = wanted.lambda_nm.empty() ? raw.lambda_nm : wanted.lambda_nm;
  if (lambda_nm.empty())
    for (int nm = 380; nm <= 780; nm += 20) lambda_nm.push_back(nm);
  std::sort(lambda_nm.begin(), lambda_nm.end());
  context.scene.weight_nm = wavelength_weights(lambda_nm);
}

}  // namespace nicol
