// What the tests ask of sound plugins: a spectrum, meshes, a dispersion formula with k, and a sink that writes numbers as text.
#include <nicol_plugin.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <string>

namespace {

int line(void*, const nicol_host_v1*, const nicol_values_v1* values, double lambda_nm, double* radiance) {
  const double x = (lambda_nm - values->numbers[0]) / values->numbers[1];
  *radiance = std::exp(-x * x / 2);
  return NICOL_PLUGIN_OK;
}

int grey(void*, const nicol_host_v1*, const nicol_values_v1* values, double, double* n, double* k) {
  *n = values->numbers[0];
  *k = values->numbers[1];
  return NICOL_PLUGIN_OK;
}

int cube(void*, const nicol_host_v1* host, const nicol_values_v1* values) {
  const double s = values->numbers[0];
  for (int i = 0; i < 8; ++i) {
    const double point[3] = {i & 1 ? s : 0, i & 2 ? s : 0, i & 4 ? s : 0};
    host->add_point(host, point);
  }
  const std::int32_t faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  const int count = values->numbers[1] != 0 ? 5 : 6;
  for (int f = 0; f < count; ++f) host->add_face(host, faces[f], 4);
  return NICOL_PLUGIN_OK;
}

// The L of <0,0> <3,0> <3,1> <1,1> <1,2> <0,2> in (x, z), y from 0 to 1.
int ell(void*, const nicol_host_v1* host, const nicol_values_v1*) {
  const double outline[6][2] = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (double y : {0.0, 1.0})
    for (const auto& p : outline) {
      const double point[3] = {p[0], y, p[1]};
      host->add_point(host, point);
    }
  const std::int32_t foot[6] = {0, 1, 2, 3, 4, 5}, top[6] = {11, 10, 9, 8, 7, 6};
  host->add_face(host, foot, 6);
  host->add_face(host, top, 6);
  for (std::int32_t i = 0; i < 6; ++i) {
    const std::int32_t next = (i + 1) % 6, side[4] = {next, i, 6 + i, 6 + next};
    host->add_face(host, side, 4);
  }
  return NICOL_PLUGIN_OK;
}

// A tetrahedron, if each of two files is still called by its own name once both are found.
int filed(void*, const nicol_host_v1* host, const nicol_values_v1* values) {
  const char* paths[2] = {host->find_file(host, values->texts[0]), host->find_file(host, values->texts[1])};
  for (int i = 0; i < 2; ++i)
    if (!paths[i] || std::string(paths[i]).find(values->texts[i]) == std::string::npos) {
      host->set_message(host, "a file has lost its name");
      return NICOL_PLUGIN_ERROR;
    }
  const double normals[4][3] = {{-1, 0, 0}, {0, -1, 0}, {0, 0, -1}, {1, 1, 1}};
  for (int i = 0; i < 4; ++i) host->add_plane(host, normals[i], i < 3 ? 0 : 1);
  return NICOL_PLUGIN_OK;
}

int write_text(void*, const nicol_host_v1* host, const nicol_picture_v1* picture, const char* path) {
  if (picture->width == 4) return NICOL_PLUGIN_OK;   // and nothing is written
  if (picture->width == 3) {
    host->set_message(host, "three is one too many");
    return NICOL_PLUGIN_ERROR;
  }
  std::FILE* file = std::fopen(path, "w");
  if (!file) return NICOL_PLUGIN_ERROR;
  std::fprintf(file, "%d %d %u\n", picture->width, picture->height, picture->wavelength_count);
  const std::size_t pixels = static_cast<std::size_t>(picture->width) * picture->height;
  for (std::uint32_t i = 0; i < picture->wavelength_count; ++i)
    std::fprintf(file, "%.17g %.9g\n", picture->lambda_nm[i], picture->stokes[i * pixels]);
  return std::fclose(file) == 0 ? NICOL_PLUGIN_OK : NICOL_PLUGIN_ERROR;
}

nicol_parameter_v1 number(const char* name, const char* unit, double default_number) {
  nicol_parameter_v1 made{};
  made.struct_size = sizeof made;
  made.name = name;
  made.unit = unit;
  made.has_default = 1;
  made.default_number = default_number;
  return made;
}

template <class Entry, std::size_t N>
Entry entry(const char* name, const nicol_parameter_v1 (&parameters)[N]) {
  Entry made{};
  made.struct_size = sizeof made;
  made.name = name;
  made.parameters = parameters;
  made.parameter_count = N;
  return made;
}

}  // namespace

int nicol_plugin_v1(const nicol_host_v1* host) {
  nicol_parameter_v1 line_parameters[] = {number("centre", "nm", 550), number("width", "nm", 20)};
  line_parameters[1].has_bounds = 1;
  line_parameters[1].least = 1;
  line_parameters[1].most = 100;
  auto spectrum = entry<nicol_spectrum_v1>("lamp", line_parameters);
  spectrum.radiance = line;
  const nicol_parameter_v1 grey_parameters[] = {number("n", "", 1.5), number("k", "", 0)};
  auto dispersion = entry<nicol_dispersion_v1>("grey", grey_parameters);
  dispersion.index = grey;
  const nicol_parameter_v1 cube_parameters[] = {number("edge", "", 1), number("open", "", 0)};
  auto solid = entry<nicol_solid_v1>("cube", cube_parameters);
  solid.make = cube;
  nicol_solid_v1 other{};
  other.struct_size = sizeof other;
  other.name = "ell";
  other.make = ell;
  nicol_parameter_v1 names[] = {number("first", "", 0), number("second", "", 0)};
  for (nicol_parameter_v1& name : names) {
    name.kind = NICOL_PARAMETER_TEXT;
    name.has_default = 0;
  }
  auto of_files = entry<nicol_solid_v1>("filed", names);
  of_files.make = filed;
  nicol_sink_v1 sink{};
  sink.struct_size = sizeof sink;
  sink.name = "numbers";
  sink.suffix = ".txt";
  sink.write = write_text;
  return host->add_spectrum(host, &spectrum) | host->add_dispersion(host, &dispersion) | host->add_solid(host, &solid) |
         host->add_solid(host, &other) | host->add_solid(host, &of_files) | host->add_sink(host, &sink);
}
