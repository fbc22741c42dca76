// A crystal as a two-circle reflecting goniometer sees it: for each face its azimuth phi, its polar distance rho, and how far it lies from
// the centre. Brings a solid (solid { plugin { "goniometer" file "quartz.gon" } }) and an importer (nicol render quartz.gon).
// Angles as V. Goldschmidt (Index der Krystallformen der Mineralien, 1886) counts them: rho from the pole of c, phi from the pole of
// (010) towards that of (100). In the right-handed axes of a crystal (Z along c, Y along b*) the normal is
//   X = sin rho sin phi, Y = sin rho cos phi, Z = cos rho.
// Lines: `face NAME PHI RHO DISTANCE` (degrees, mm), `ordinary N`, `extraordinary N` (for the importer), `#` before a comment.
// Test: tests/plugins/plugins_test.py against the same crystal written with crystal { facet }.
#include <nicol_plugin.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

struct Face {
  std::string name;
  double normal[3];  // X, Y, Z of the crystal
  double distance_mm;
};

struct Measurement {
  std::vector<Face> faces;
  double ordinary = 1.5, extraordinary = 0;  // 0: isotropic
};

double number_of(std::istringstream& words, const char* what) {
  double value = 0;
  if (words >> value && std::isfinite(value)) return value;
  throw std::runtime_error(std::string("expected ") + what);
}

Face face_of(std::istringstream& words) {
  Face face;
  if (!(words >> face.name)) throw std::runtime_error("expected the name of a face");
  const double degree = std::acos(-1.0) / 180;
  const double phi = number_of(words, "phi in degrees") * degree;
  const double rho_deg = number_of(words, "rho in degrees"), rho = rho_deg * degree;
  face.distance_mm = number_of(words, "a distance in mm");
  if (rho_deg < 0 || rho_deg > 180) throw std::runtime_error("rho lies between 0 and 180 degrees");
  if (!(face.distance_mm > 0)) throw std::runtime_error("a distance is greater than 0");
  face.normal[0] = std::sin(rho) * std::sin(phi);
  face.normal[1] = std::sin(rho) * std::cos(phi);
  face.normal[2] = std::cos(rho);
  return face;
}

void read_line(const std::string& line, Measurement& measured) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::string word, more;
  if (!(words >> word)) return;
  if (word == "face") measured.faces.push_back(face_of(words));
  else if (word == "ordinary") measured.ordinary = number_of(words, "a refractive index");
  else if (word == "extraordinary") measured.extraordinary = number_of(words, "a refractive index");
  else throw std::runtime_error("unknown word '" + word + "'; known are face, ordinary, extraordinary");
  if (words >> more) throw std::runtime_error("unexpected '" + more + "'");
}

// Throws std::runtime_error that names the file and its line.
Measurement read(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error(path + " cannot be read");
  Measurement measured;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    try {
      read_line(line, measured);
    } catch (const std::runtime_error& error) {
      throw std::runtime_error(path + " line " + std::to_string(number) + ": " + error.what());
    }
  }
  if (measured.faces.empty()) throw std::runtime_error(path + " has no face");
  return measured;
}

// A crystal's X towards the viewer, Y to the right, Z up: in a scene's axes (Y, Z, -X).
int make_solid(void*, const nicol_host_v1* host, const nicol_values_v1* values) {
  try {
    const char* path = host->find_file(host, values->texts[0]);
    if (!path) throw std::runtime_error(std::string("cannot find file '") + values->texts[0] + "'");
    const double scale = values->numbers[0];
    for (const Face& face : read(path).faces) {
      const double normal[3] = {face.normal[1], face.normal[2], -face.normal[0]};
      host->add_plane(host, normal, scale * face.distance_mm);
    }
    return NICOL_PLUGIN_OK;
  } catch (const std::exception& error) {
    host->set_message(host, error.what());
    return NICOL_PLUGIN_ERROR;
  }
}

std::string text_of(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

// The crystal before a light wall, seen from the front; in mm.
std::string scene_of(const Measurement& measured) {
  double size = 0;
  for (const Face& face : measured.faces) size = std::fmax(size, face.distance_mm);
  std::string scene = "#version unofficial 3.7;\nglobal_settings { mm_per_unit 1  max_trace_level 12  adc_bailout 2e-3 }\n#declare Size = " +
                      text_of(size) +
                      ";\ncamera { location <2, 1.5, -6>*Size  look_at 0  right x*image_width/image_height  angle 30 }\nbackground { rgb 0.1 }\n"
                      "polygon { 5, <-1, -1, 0>, <1, -1, 0>, <1, 1, 0>, <-1, 1, 0>, <-1, -1, 0>\n"
                      "  scale 4*Size translate 4*Size*z luminous { spectrum { d65 } } }\ncrystal {\n";
  for (const Face& face : measured.faces)
    scene += "  facet <" + text_of(face.normal[0]) + ", " + text_of(face.normal[1]) + ", " + text_of(face.normal[2]) + ">, " +
             text_of(face.distance_mm) + "  // " + face.name + "\n";
  scene += measured.extraordinary > 0 ? "  interior { ordinary { constant " + text_of(measured.ordinary) +
                                            " } extraordinary { constant " + text_of(measured.extraordinary) + " } } }\n"
                                      : "  interior { ior " + text_of(measured.ordinary) + " } }\n";
  return scene;
}

int import_file(void*, const nicol_host_v1* host, const char* path) {
  try {
    const std::string scene = scene_of(read(path));
    return host->set_text(host, scene.data(), scene.size());
  } catch (const std::exception& error) {
    host->set_message(host, error.what());
    return NICOL_PLUGIN_ERROR;
  }
}

}  // namespace

int nicol_plugin_v1(const nicol_host_v1* host) {
  nicol_parameter_v1 parameters[2]{};
  parameters[0].struct_size = sizeof parameters[0];
  parameters[0].kind = NICOL_PARAMETER_TEXT;
  parameters[0].name = "file";
  parameters[0].meaning = "the angles, found as #include finds files";
  parameters[1].struct_size = sizeof parameters[1];
  parameters[1].name = "scale";
  parameters[1].meaning = "scene units for a mm of the file";
  parameters[1].has_default = 1;
  parameters[1].default_number = 1;
  parameters[1].has_bounds = 1;
  parameters[1].least = 1e-9;
  parameters[1].most = 1e9;
  nicol_solid_v1 solid{};
  solid.struct_size = sizeof solid;
  solid.flags = NICOL_PLUGIN_THREAD_SAFE;
  solid.name = "goniometer";
  solid.meaning = "a crystal from the angles and distances of its faces";
  solid.parameters = parameters;
  solid.parameter_count = 2;
  solid.make = make_solid;
  if (host->add_solid(host, &solid) != NICOL_PLUGIN_OK) return NICOL_PLUGIN_ERROR;
  nicol_importer_v1 importer{};
  importer.struct_size = sizeof importer;
  importer.flags = NICOL_PLUGIN_THREAD_SAFE;
  importer.name = "goniometer";
  importer.meaning = "a file of angles as a scene of one crystal before a light";
  importer.suffix = ".gon";
  importer.read = import_file;
  return host->add_importer(host, &importer);
}
