// The settings that trade accuracy for time, and which of their values are worth a try.
#pragma once
#include <string>
#include <vector>

namespace nicol {

enum class Knob { base, wavelengths, depth, cut_off, samples, adaptive, precision, effects, combined };

const char* knob_name(Knob knob);

// Everything about a render that trades accuracy for time.
struct AccuracySetting {
  std::vector<double> lambda_nm;
  int max_trace_level = 5;
  double adc_bailout = 0;
  int samples = 1;           // of every pixel
  double sample_error = 0;   // > 0: further samples where they matter, until this error of sampling
  bool real_double = false;
  std::string without;       // an effect of host/effects.hpp; "": none

  bool operator==(const AccuracySetting& other) const;
};

struct KnobValue {
  Knob knob = Knob::base;
  std::string text;  // "10 nm"
  AccuracySetting setting;
};

// Other values of one knob, the others as in `base`, the most accurate first; for samples and adaptive the cheapest
// first, up to most_samples. Wavelengths keep both ends: the step is a whole part or a multiple of the base's, so that
// wavelengths are common; none for fewer than three wavelengths or unequal steps. Effects are not listed here.
std::vector<KnobValue> knob_values(Knob knob, const AccuracySetting& base, int most_samples,
                                   double reference_step_nm);

// Finer, deeper and in double: what the values above are held against. `sample_error` as asked for; the step of
// wavelength is halved to reference_step_nm or less, at least once, to at most 401 wavelengths.
AccuracySetting reference_setting(const AccuracySetting& base, double sample_error, double reference_step_nm);

// The same with the next finer cut-off: a reference that has converged does not differ from it.
AccuracySetting beyond_reference(const AccuracySetting& reference);

// "380:780:20", or a list with commas.
std::string wavelengths_text(const std::vector<double>& lambda_nm);

// 0 where the steps are unequal, or for a lone wavelength.
double equal_step_nm(const std::vector<double>& lambda_nm);

}  // namespace nicol
