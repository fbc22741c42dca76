// `nicol explain --media`: see media_table.hpp.
//
// Biaxial media have two optic axes in the plane of the smallest and the largest index, at V from
// that of the largest; light along them turns by pi g(s)/(n_beta lambda) (host/optics/crystal.hpp).
// 2V is the acute angle; the sign is + where it lies about gamma.
// Test: tests/app/media_table_test.cpp.
#include "host/app/media_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "host/engine/loaded_scene.hpp"
#include "host/engine/plugins.hpp"
#include "host/bind/bind.hpp"
#include "host/optics/crystal.hpp"

namespace nicol::app {
namespace {

using Symmetry = Medium::Symmetry;
constexpr double pi = 3.14159265358979323846, mm_per_nm = 1e-6;
constexpr double visible_from_nm = 400, visible_to_nm = 700, visible_step_nm = 10;

// The axes of a medium by their indices: smallest, middle, largest.
std::array<int, 3> sorted_axes(const Medium& m, std::size_t at) {
  std::array<int, 3> axes{0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return m.n[a][at] < m.n[b][at]; });
  return axes;
}

bool turns(const Medium& m) {
  const auto any = [](const Samples& s) {
    return std::any_of(s.begin(), s.end(), [](double v) { return v != 0; });
  };
  return any(m.rotation_deg_per_mm) || std::any_of(m.gyration.begin(), m.gyration.end(), any);
}

double v_from_gamma_deg(const Medium& m, std::size_t at) {
  return optic_axis_from_gamma_deg(m.n[0][at], m.n[1][at], m.n[2][at]);
}

std::string kind_of(const Medium& m, std::size_t at) {
  std::string kind = "isotropic";
  if (m.symmetry == Symmetry::uniaxial)
    kind = m.n[2][at] == m.n[0][at]  ? "uniaxial"
           : m.n[2][at] > m.n[0][at] ? "uniaxial +"
                                     : "uniaxial -";
  if (m.symmetry == Symmetry::biaxial)
    kind = v_from_gamma_deg(m, at) < 45 ? "biaxial +" : "biaxial -";
  return turns(m) ? kind + ", active" : kind;
}

std::string indices_of(const Medium& m, std::size_t at) {
  if (m.symmetry == Symmetry::isotropic) return fmt::format("{:.4f}", m.n[0][at]);
  if (m.symmetry == Symmetry::uniaxial) return fmt::format("{:.4f} {:.4f}", m.n[0][at], m.n[2][at]);
  return fmt::format("{:.4f} {:.4f} {:.4f}", m.n[0][at], m.n[1][at], m.n[2][at]);
}

std::string birefringence_of(const Medium& m, std::size_t at) {
  if (m.symmetry == Symmetry::isotropic) return "";
  const auto axes = sorted_axes(m, at);
  return fmt::format("{:.4f}", m.n[axes[2]][at] - m.n[axes[0]][at]);
}

std::string two_v_of(const Medium& m, std::size_t at) {
  if (m.symmetry != Symmetry::biaxial) return "";
  const double two_v_deg = 2 * v_from_gamma_deg(m, at);
  return fmt::format("{:.1f}", std::min(two_v_deg, 180 - two_v_deg));
}

// Along the two optic axes of a biaxial medium, deg/mm.
std::array<double, 2> biaxial_rotations(const Medium& m, double lambda_nm, std::size_t at) {
  GyrationTensor g{};
  for (std::size_t i = 0; i < g.size(); ++i) g[i] = m.gyration[i][at];
  const auto axes = sorted_axes(m, at);
  const double v_rad = v_from_gamma_deg(m, at) * pi / 180;
  std::array<double, 2> rotations{};
  for (int side : {0, 1}) {
    std::array<double, 3> s{};
    s[axes[0]] = (side == 0 ? 1 : -1) * std::sin(v_rad);
    s[axes[2]] = std::cos(v_rad);
    rotations[side] = rotation_of_gyration(gyration_along(g, s), m.n[axes[1]][at], lambda_nm);
  }
  return rotations;
}

std::string rotation_of(const Medium& m, double lambda_nm, std::size_t at) {
  if (!turns(m)) return "";
  if (m.symmetry == Symmetry::isotropic) return fmt::format("{:.2f}", m.rotation_deg_per_mm[at]);
  if (m.symmetry == Symmetry::uniaxial)
    return fmt::format("{:.2f}", rotation_of_gyration(m.gyration[2][at], m.n[0][at], lambda_nm));
  const auto [one, other] = biaxial_rotations(m, lambda_nm, at);
  return fmt::format("{:.2f} {:.2f}", one, other);
}

// Per axis, at the visible wavelength at which the medium absorbs most: "2.80 1.40 at 550 nm".
std::string absorption_of(const Medium& m, const std::vector<double>& lambda_nm) {
  double most = 0;
  std::size_t where = 0;
  const auto per_mm = [&](int axis, std::size_t i) {
    return 4 * pi * m.k[axis][i] / (lambda_nm[i] * mm_per_nm);
  };
  for (std::size_t i = 0; i < lambda_nm.size(); ++i)
    for (int axis = 0; axis < 3; ++axis)
      if (per_mm(axis, i) > most) most = per_mm(axis, where = i);
  if (most == 0) return "";
  const auto text = [&](int axis) { return fmt::format("{:.3g}", per_mm(axis, where)); };
  const std::string place = fmt::format(" at {:g} nm", lambda_nm[where]);
  if (m.symmetry == Symmetry::isotropic) return text(0) + place;
  if (m.symmetry == Symmetry::uniaxial) return text(0) + " " + text(2) + place;
  return text(0) + " " + text(1) + " " + text(2) + place;
}

// The visible, and the wavelength asked for.
std::vector<double> table_wavelengths(double lambda_nm) {
  std::vector<double> list{lambda_nm};
  for (double nm = visible_from_nm; nm <= visible_to_nm; nm += visible_step_nm)
    if (nm != lambda_nm) list.push_back(nm);
  std::sort(list.begin(), list.end());
  return list;
}

std::string read_text(const std::string& path) {
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path))
    throw UsageError(fmt::format("cannot read '{}'", path));
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string standard_library(const sdl::Options& options) {
  for (const std::string& folder : options.library_paths)
    if (std::filesystem::is_regular_file(folder + "/minerals.inc")) return folder + "/minerals.inc";
  throw UsageError("minerals.inc is not in the include folders");
}

struct NamedMedium {
  std::string name;
  Medium medium;
};

// Binds what was parsed at the wavelengths of the table; empty, and told, if there are errors.
std::optional<Scene> bound(sdl::Result& parsed, const BindOptions& wanted) {
  drop_expectations(parsed.document);
  Scene scene = bind(parsed.document, wanted, parsed.diagnostics);
  if (!parsed.diagnostics.failed()) return scene;
  for (const sdl::Diagnostic& diagnostic : parsed.diagnostics.all())
    if (diagnostic.severity == sdl::Severity::error)
      fmt::print(stderr, "{}", parsed.diagnostics.text(diagnostic));
  return std::nullopt;
}

// A box of each medium that the library declares.
std::optional<std::vector<NamedMedium>> media_of_library(const std::string& path,
                                                         sdl::Options options,
                                                         const BindOptions& wanted) {
  const std::vector<std::string> names = declared_interiors(read_text(path));
  if (names.empty()) throw UsageError(fmt::format("'{}' declares no interior", path));
  const std::filesystem::path file(path);
  options.library_paths.insert(options.library_paths.begin(), file.parent_path().string());
  std::string text = fmt::format("#include \"{}\"\n", file.filename().string());
  for (const std::string& name : names)
    text += fmt::format("box {{ 0, 1 interior {{ {} }} }}\n", name);
  sdl::Result parsed;
  sdl::parse_text(path, text, options, parsed);
  const auto scene = bound(parsed, wanted);
  if (!scene) return std::nullopt;
  std::vector<NamedMedium> media;
  for (std::size_t i = 0; i < names.size(); ++i)
    media.push_back({names[i], scene->media[*scene->objects[i].medium]});
  return media;
}

std::optional<std::vector<NamedMedium>> media_of_scene(const std::string& path,
                                                       const sdl::Options& options,
                                                       const BindOptions& wanted) {
  sdl::Result parsed;
  sdl::parse_file(path, options, parsed);
  const auto scene = bound(parsed, wanted);
  if (!scene) return std::nullopt;
  std::vector<NamedMedium> media;
  for (const Medium& medium : scene->media) media.push_back({medium.name, medium});
  return media;
}

using Cells = std::vector<std::string>;

Cells cells_of(const MediumRow& r) {
  return {r.name,     r.kind,       r.indices, r.birefringence, r.two_v,
          r.rotation, r.absorption, r.range,   r.source};
}

// Columns as wide as their widest cell; those that are empty throughout are left out.
void print_table(const Cells& heads, const std::vector<Cells>& rows) {
  std::vector<std::size_t> width(heads.size(), 0);
  for (const Cells& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  for (std::size_t i = 0; i < heads.size(); ++i)
    if (width[i] > 0) width[i] = std::max(width[i], heads[i].size());
  const auto print = [&](const Cells& row) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      if (width[i] > 0) line += fmt::format("{:<{}}  ", row[i], width[i]);
    fmt::print("{}\n", line.substr(0, line.find_last_not_of(' ') + 1));
  };
  print(heads);
  for (const Cells& row : rows) print(row);
}

}  // namespace

std::vector<std::string> declared_interiors(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::replace(line.begin(), line.end(), '{', ' ');
    std::istringstream words(line);
    std::string declare, name, equals, kind;
    words >> declare >> name >> equals >> kind;
    if (declare == "#declare" && equals == "=" && kind == "interior") names.push_back(name);
  }
  return names;
}

MediumRow describe(const Medium& medium, const std::vector<double>& lambda_nm, std::size_t at) {
  MediumRow row;
  row.name = medium.name;
  row.kind = kind_of(medium, at);
  row.indices = indices_of(medium, at);
  row.birefringence = birefringence_of(medium, at);
  row.two_v = two_v_of(medium, at);
  row.rotation = rotation_of(medium, lambda_nm[at], at);
  row.absorption = absorption_of(medium, lambda_nm);
  if (medium.range_nm[1] > 0)
    row.range = fmt::format("{:g} to {:g}", medium.range_nm[0], medium.range_nm[1]);
  row.source = medium.source;
  return row;
}

int print_media(const ExplainCommand& command) {
  const sdl::Options options = parse_options(command.options);
  BindOptions wanted;
  wanted.path = command.scene;
  wanted.library_paths = options.library_paths;
  wanted.lambda_nm = table_wavelengths(command.lambda_nm);
  load_plugins(command.options);
  plugins::Finder finder = plugin_finder(command.options);
  wanted.plugins = &finder;
  const std::string path = command.scene.empty() ? standard_library(options) : command.scene;
  const bool library = std::filesystem::path(path).extension() == ".inc";
  const auto media =
      library ? media_of_library(path, options, wanted) : media_of_scene(path, options, wanted);
  if (!media) return exit_error;
  const auto& list = wanted.lambda_nm;
  const auto at = static_cast<std::size_t>(
      std::find(list.begin(), list.end(), command.lambda_nm) - list.begin());
  std::vector<Cells> rows;
  for (const NamedMedium& named : *media) {
    MediumRow row = describe(named.medium, list, at);
    row.name = named.name;
    const Cells cells = cells_of(row);  // a crystal that lies in several ways is one row
    if (std::find(rows.begin(), rows.end(), cells) == rows.end()) rows.push_back(cells);
  }
  print_table({"medium", "class", fmt::format("n at {:g} nm", command.lambda_nm), "birefr.",
               "2V deg", "rotation deg/mm", "absorption 1/mm", "range nm", "source"},
              rows);
  return exit_done;
}

}  // namespace nicol::app
