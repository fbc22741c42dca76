#include "host/opencl/fragment_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>
#include <vector>

#include "host/opencl/errors.hpp"
#include "host/opencl/fragment_probe.hpp"

namespace nicol {
namespace {

using Number = std::complex<double>;

constexpr double refused_above = 1e-3, rounding_float = 3e-5, rounding_double = 1e-9;
constexpr std::size_t most_wavelengths = 12;
constexpr int azimuths = 12;
constexpr double degree = 3.14159265358979323846 / 180;
constexpr std::size_t element_values = FragmentProbe::element_values, element_answers = FragmentProbe::element_answers;
constexpr std::size_t surface_values = FragmentProbe::surface_values, surface_answers = FragmentProbe::surface_answers;

// What is asked and where that is: `values` for the kernel, and for messages.
template <std::size_t Count>
struct Problem {
  std::array<double, Count> values{};
  double lambda_nm = 0, angle_deg = 0;
  int azimuth = 0, side = 1;
};
using ElementProblem = Problem<element_values>;
using SurfaceProblem = Problem<surface_values>;

std::vector<double> angles_deg() {
  std::vector<double> angles;
  for (int angle = 0; angle < 90; angle += 5) angles.push_back(angle);
  angles.push_back(89);
  return angles;
}

// Up to most_wavelengths of them, both ends among them.
std::vector<std::size_t> chosen_wavelengths(std::size_t count) {
  std::vector<std::size_t> chosen;
  const std::size_t wanted = std::min(count, most_wavelengths);
  for (std::size_t i = 0; i < wanted; ++i) chosen.push_back(wanted == 1 ? 0 : i * (count - 1) / (wanted - 1));
  return chosen;
}

class Check {
 public:
  Check(Device& device, const SceneFragments& scene, const SceneFragments::Use& use, const KernelOptions& options)
      : device_(device), scene_(scene), use_(use), fragment_(*use.fragment), options_(options) {}

  std::string run() {
    if (fragment_.needs_fp64 && !device_.about.has_fp64)
      refuse(fmt::format("needs double precision, which {} has not", device_.about.name));
    probe_.emplace(build());
    if (fragment_.kind == Fragment::Kind::element)
      check_element();
    else
      check_surface();
    return warnings_;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw FragmentError(fmt::format("{}: plugin '{}' {}", use_.place, fragment_.name, what));
  }

  FragmentProbe build() const {
    try {
      return FragmentProbe(device_, use_.fragment, use_.values, options_);
    } catch (const DeviceError& error) {
      refuse("does not build:\n" + own_messages(error.what()));
    }
  }

  // The compiler's lines about the fragment's own text, else about the call of its function; everything if there is neither.
  std::string own_messages(const std::string& log) const {
    std::istringstream lines(log);
    std::string line, own, call;
    while (std::getline(lines, line)) {
      const std::size_t at = line.find(fragment_.file + ":");
      if (at != std::string::npos) own += line.substr(at) + "\n";
      const std::size_t called = line.find("scene_fragments.h:"), words = line.find(": ", std::min(called, line.size()));
      if (words != std::string::npos && call.empty())
        call = fmt::format("{}: its function '{}' is not of the form that kernels/fragment.h asks for: {}", fragment_.file, fragment_.name,
                           line.substr(words + 2));
    }
    if (!own.empty()) own.pop_back();
    return !own.empty() ? own : !call.empty() ? call : log;
  }

  // `Answers` complex numbers for each problem.
  template <std::size_t Answers, std::size_t Values>
  std::vector<std::array<Number, Answers>> ask(const std::vector<Problem<Values>>& problems, int from_inside = 0) {
    std::vector<double> values;
    for (const Problem<Values>& problem : problems) values.insert(values.end(), problem.values.begin(), problem.values.end());
    const std::vector<Number> numbers = probe_->ask(values, Values, Answers, from_inside);
    std::vector<std::array<Number, Answers>> answers(problems.size());
    for (std::size_t i = 0; i < problems.size(); ++i)
      for (std::size_t a = 0; a < Answers; ++a) answers[i][a] = numbers[i * Answers + a];
    return answers;
  }

  // The worst of one kind of fault; beside_rounding: with each made less by how much rounding there is greater.
  struct Worst {
    double off = 0, beside_rounding = 0;
    std::string where;
    template <class P>
    void meet(double value, const P& problem, const std::string& extra, double rounding = 1) {
      beside_rounding = std::max(beside_rounding, value / rounding);
      if (!(value > off)) return;
      off = value;
      where = fmt::format("{:.6g} nm, {:g} deg{}", problem.lambda_nm, problem.angle_deg, extra);
    }
  };

  // refused, told as a warning, or within rounding.
  void tell(const Worst& worst, const std::string& what) {
    if (worst.off > refused_above) refuse(what + " at " + worst.where);
    if (worst.beside_rounding > (options_.real_double ? rounding_double : rounding_float))
      warnings_ += fmt::format("{}: plugin '{}' {} at {}\n", use_.place, fragment_.name, what, worst.where);
  }
  void tell_all(const Worst& gain, const Worst& loss, const Worst& one_way) {
    tell(gain, fmt::format("gains {:.3g} % of the light", 100 * gain.off));
    if (fragment_.lossless) tell(loss, fmt::format("loses {:.3g} % of the light, and its manifest says that it is lossless,", 100 * loss.off));
    if (fragment_.reciprocal)
      tell(one_way, fmt::format("is not reciprocal (its manifest may say so): light that goes back finds amplitudes that are off by {:.3g}", one_way.off));
  }

  template <class P, std::size_t Count>
  void check_finite(const P& problem, const std::array<Number, Count>& answer) const {
    for (const Number& a : answer)
      if (!std::isfinite(a.real()) || !std::isfinite(a.imag()))
        refuse(fmt::format("gives numbers that are not finite at {:.6g} nm, {:g} deg", problem.lambda_nm, problem.angle_deg));
  }

  std::vector<ElementProblem> element_problems(const std::vector<double>& angles) const {
    std::vector<ElementProblem> problems;
    for (const FragmentMedia& media : use_.media)
      for (const std::size_t w : chosen_wavelengths(scene_.lambda_nm.size()))
        for (const double angle : angles)
          for (int azimuth = 0; azimuth < azimuths; ++azimuth)
            for (const int side : {1, -1}) {
              const double sine = std::sin(angle * degree), turn = azimuth * 360.0 / azimuths * degree;
              ElementProblem p;
              p.lambda_nm = scene_.lambda_nm[w];
              p.values = {p.lambda_nm, media.n1[w], sine * std::cos(turn), sine * std::sin(turn), side * std::cos(angle * degree)};
              p.angle_deg = angle;
              p.azimuth = azimuth;
              p.side = side;
              problems.push_back(p);
            }
    return problems;
  }

  // The most and the least that light of any polarization keeps: eigenvalues of t^H t + r^H r.
  static std::array<double, 2> shares(const std::array<Number, element_answers>& m) {
    double ss = 0, pp = 0;
    Number sp = 0;
    for (const std::size_t at : {0, 4}) {   // ss sp ps pp
      ss += std::norm(m[at]) + std::norm(m[at + 2]);
      pp += std::norm(m[at + 1]) + std::norm(m[at + 3]);
      sp += std::conj(m[at]) * m[at + 1] + std::conj(m[at + 2]) * m[at + 3];
    }
    const double middle = (ss + pp) / 2, spread = std::sqrt((ss - pp) * (ss - pp) / 4 + std::norm(sp));
    return {middle - spread, middle + spread};
  }

  // How far b is from Q a^T Q.
  static double not_reversed(const Number* a, const Number* b) {
    return std::max({std::abs(b[0] - a[0]), std::abs(b[1] + a[2]), std::abs(b[2] + a[1]), std::abs(b[3] - a[3])});
  }

  void check_element() {
    const std::vector<ElementProblem> problems = element_problems(angles_deg());
    if (problems.empty()) return;
    auto answers = ask<element_answers>(problems);
    Worst gain, loss, one_way;
    for (std::size_t i = 0; i < problems.size(); ++i) {
      check_finite(problems[i], answers[i]);
      if (!fragment_.reflects) std::fill(answers[i].begin() + 4, answers[i].end(), Number{});
    }
    for (std::size_t i = 0; i < problems.size(); ++i) {
      const ElementProblem& p = problems[i];
      const std::string place = fmt::format(", azimuth {:g} deg{}", p.azimuth * 360.0 / azimuths, p.side > 0 ? "" : ", from the normal's side");
      const auto [least, most] = shares(answers[i]);
      gain.meet(most - 1, p, place);
      loss.meet(1 - least, p, place);
      // the azimuths and sides of one angle stand together
      const std::size_t group = i - i % (2 * azimuths);
      const std::size_t opposite = group + 2 * static_cast<std::size_t>((p.azimuth + azimuths / 2) % azimuths);
      const std::size_t same_side = p.side > 0 ? 0 : 1;
      one_way.meet(not_reversed(&answers[i][0], &answers[opposite + 1 - same_side][0]), p, place);
      one_way.meet(not_reversed(&answers[i][4], &answers[opposite + same_side][4]), p, place + ", reflected");
    }
    tell_all(gain, loss, one_way);
  }

  static SurfaceProblem surface_problem(double lambda_nm, double n1, double k1, double n2, double k2, double angle_deg, double cosine) {
    SurfaceProblem p;
    p.lambda_nm = lambda_nm;
    p.angle_deg = angle_deg;
    p.values = {lambda_nm, n1, k1, n2, k2, cosine};
    return p;
  }

  // The media that touch, and where they absorb the same ones without: only beside those is it known what a face has to keep.
  std::vector<FragmentMedia> media_and_clear_ones() const {
    const auto absorbs = [](const std::vector<double>& k) { return std::any_of(k.begin(), k.end(), [](double v) { return v != 0; }); };
    std::vector<FragmentMedia> media = use_.media;
    for (const FragmentMedia& m : use_.media) {
      if (!absorbs(m.k1) && !absorbs(m.k2)) continue;
      media.push_back(m);
      for (auto* k : {&media.back().k1, &media.back().k2}) std::fill(k->begin(), k->end(), 0.0);
    }
    return media;
  }

  // From outside at the grid's angles, from inside at those of the same tangential wave vectors (where there are any), then from inside at
  // the grid's.
  void check_surface() {
    std::vector<SurfaceProblem> outside, inside;
    for (const FragmentMedia& m : media_and_clear_ones())   // 1 inside, 2 outside
      for (const std::size_t w : chosen_wavelengths(scene_.lambda_nm.size()))
        for (const double angle : angles_deg()) {
          const double cosine = std::cos(angle * degree), n_in = m.n1[w], n_out = m.n2[w], lambda_nm = scene_.lambda_nm[w];
          outside.push_back(surface_problem(lambda_nm, n_out, m.k2[w], n_in, m.k1[w], angle, cosine));
          const double p2 = n_out * n_out * cosine * cosine + (n_in - n_out) * (n_in + n_out);
          inside.push_back(surface_problem(lambda_nm, n_in, m.k1[w], n_out, m.k2[w], angle, p2 > 0 ? std::sqrt(p2) / n_in : cosine));
        }
    if (outside.empty()) return;
    const std::size_t pairs = outside.size();
    for (std::size_t i = 0; i < pairs; ++i) {
      inside.push_back(inside[i]);
      inside.back().values[5] = std::cos(inside[i].angle_deg * degree);
    }
    const auto from_outside = ask<surface_answers>(outside, 0), from_inside = ask<surface_answers>(inside, 1);
    Worst gain, loss, one_way;
    for (std::size_t i = 0; i < pairs; ++i) check_face(outside[i], from_outside[i], "", gain, loss);
    for (std::size_t i = 0; i < inside.size(); ++i) {
      if (i >= pairs || reaches_inside(outside[i])) check_face(inside[i], from_inside[i], i < pairs ? " outside" : " inside", gain, loss);
      if (i >= pairs || !reaches_inside(outside[i]) || outside[i].values[2] != 0 || outside[i].values[4] != 0) continue;
      // from inside, the cosine outside is the root of a difference: off by rounding over itself
      for (const std::size_t t : {2, 3})
        one_way.meet(std::abs(from_outside[i][t] - from_inside[i][t]), outside[i], "", 1 / outside[i].values[5]);
    }
    tell_all(gain, loss, one_way);
  }

  static bool reaches_inside(const SurfaceProblem& p) {
    return p.values[1] * p.values[1] * (p.values[5] * p.values[5] - 1) + p.values[3] * p.values[3] > 0;
  }

  void check_face(const SurfaceProblem& p, const std::array<Number, surface_answers>& a, const std::string& place, Worst& gain,
                  Worst& loss) const {
    check_finite(p, a);
    if (p.values[2] != 0) return;   // light comes in an absorbing medium
    for (const std::size_t wave : {0, 1}) {
      const double kept = std::norm(a[wave]) + std::norm(a[wave + 2]);
      gain.meet(kept - 1, p, place);
      loss.meet(1 - kept, p, place);
    }
  }

  Device& device_;
  const SceneFragments& scene_;
  const SceneFragments::Use& use_;
  const Fragment& fragment_;
  const KernelOptions& options_;
  std::optional<FragmentProbe> probe_;
  std::string warnings_;
};

// All that decides what a check finds.
std::string identity_of(const Device& device, const SceneFragments& scene, const SceneFragments::Use& use, const KernelOptions& options) {
  std::string key = fmt::format("{} {} {} {} {}\n{}\n{}\n", device.about.index, device.about.name, device.about.driver,
                                lanes_on(device, options), options.real_double, use.place, kernel_text({use.fragment}));
  const auto put = [&key](const std::vector<double>& values) {
    for (const double v : values) key += fmt::format("{:.17g} ", v);
    key += ';';
  };
  put(use.values);
  put(scene.lambda_nm);
  for (const FragmentMedia& m : use.media)
    for (const auto* values : {&m.n1, &m.k1, &m.n2, &m.k2}) put(*values);
  return key + fmt::format("{}{}{}{}", use.fragment->reflects, use.fragment->reciprocal, use.fragment->lossless, use.fragment->needs_fp64);
}

}  // namespace

std::string check_fragments(Device& device, const SceneFragments& fragments, const KernelOptions& options) {
  static std::mutex lock;
  static std::map<std::string, std::string> found;   // warnings of those that passed
  std::string warnings;
  for (const SceneFragments::Use& use : fragments.uses) {
    if (use.media.empty()) continue;   // nothing in the scene has it
    const std::string identity = identity_of(device, fragments, use, options);
    {
      const std::lock_guard<std::mutex> held(lock);
      const auto known = found.find(identity);
      if (known != found.end()) {
        warnings += known->second;
        continue;
      }
    }
    try {
      const std::string told = Check(device, fragments, use, options).run();
      warnings += told;
      const std::lock_guard<std::mutex> held(lock);
      found[identity] = told;
    } catch (const cl::Error& error) {
      throw FragmentError(fmt::format("{}: plugin '{}': {}", use.place, use.fragment->name, error_message(error, device.about.name)));
    }
  }
  return warnings;
}

}  // namespace nicol
