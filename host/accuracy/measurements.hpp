// What settings cost and what error they leave: the Pareto front, the cheapest for a target, and what to combine.
#pragma once
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "host/accuracy/knobs.hpp"
#include "host/accuracy/picture_error.hpp"

namespace nicol {

// One setting, rendered once or more.
struct Measurement {
  Knob knob = Knob::base;
  std::string text;
  AccuracySetting setting;
  PictureError error;           // against the reference
  double alone = NAN;           // RMS error of this knob alone: against the same picture with the knob at its best
  std::vector<double> seconds;  // of each rendering
  double samples_mean = 1;      // a pixel

  double fastest() const;       // of no rendering: NaN
  double median() const;
  double slowest() const;
};

// What everything is held against, and how good it is itself: parts of its RMS error, relative.
struct Reference {
  AccuracySetting setting;
  double seconds = 0, samples_mean = 0;
  double sampling = 0;          // estimate of its own samples
  double spectral = 0;          // by every second wavelength; 0 where it has the scene's own list
  double cut_off = 0;           // against a finer cut-off and twice the depth, one sample a pixel
  double own_error() const { return std::sqrt(sampling * sampling + spectral * spectral + cut_off * cut_off); }
};

// What a command line can ask for: everything but effects left out, of which it knows polarization.
bool has_command(const AccuracySetting& setting);

// Indices of the settings that no other beats in both median time and RMS error, by rising time; only those that
// a command line can ask for and that were rendered. Of equals the first.
std::vector<std::size_t> pareto_front(const std::vector<Measurement>& measurements);

struct Target {
  enum class Measure { rms, ciede_mean, ciede_95 };
  Measure measure = Measure::rms;
  double limit = 0;
  std::string text;  // "1 % RMS"
};

// 1 %, 0.1 %, 0.01 % RMS; CIEDE2000 below 1 for the mean and for 95 % of the pixels.
std::vector<Target> usual_targets();

double measured(const PictureError& error, Target::Measure measure);

// The fastest setting that keeps a target, of those that a command line can ask for; none, where no setting does or
// the reference is not good enough to tell (an RMS target below its own error).
std::optional<std::size_t> cheapest(const std::vector<Measurement>& measurements, const Target& target,
                                    double own_error);

// RMS error that a knob alone makes.
using KnobErrors = std::map<Knob, double>;

// Settings that change several knobs at once, each turned as far as the error that it alone makes allows: for targets
// of RMS error down to `least`. None that were measured already. `base_alone`: of the base; a knob that it lacks stays.
std::vector<AccuracySetting> combined_settings(const std::vector<Measurement>& measurements,
                                               const KnobErrors& base_alone, double least);

}  // namespace nicol
