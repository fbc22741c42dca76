// The tables of the language, printed from the very rules that read it.
#include <algorithm>

#include "host/bind/bind.hpp"
#include "host/bind/crystal.hpp"
#include "sdl/symbols.hpp"

namespace nicol {

namespace {

std::string arguments(const Rule& rule) {
  if (std::string(rule.kinds) == "{}") return " { }";
  std::string text;
  for (const char* kind = rule.kinds; *kind; ++kind) {
    switch (*kind) {
      case 'n':
        text += " number";
        break;
      case 'b':
        text += " [on|off]";
        break;
      case 'v':
        text += " <x,y,z>";
        break;
      case 'd':
        text += " <x,y,z>|a|b|c";
        break;
      case 'm':
        text += " <12 numbers>";
        break;
      case 'p':
        text += " <x,y>";
        break;
      case 't':
        text += " <vector>";
        break;
      case 'c':
        text += " rgb <r,g,b>";
        break;
      case 's':
        text += " \"text\"";
        break;
      case 'w':
        text += " word";
        break;
      case 'N':
        text += " numbers...";
        break;
      case 'V':
        text += " <x,y,z>...";
        break;
      case '*':
        text += " values...";
        break;
      case 'P':
        text += " <x,z>...";
        break;
      default:
        break;
    }
  }
  return text;
}

void print(std::string& out, const Schema& schema) {
  out += "\n### " + std::string(schema.block) + "\n| word | meaning |\n|---|---|\n";
  for (const Rule& rule : schema.rules) {
    std::string left = rule.name + arguments(rule);
    if (!left.empty() && left[0] == ' ') left.erase(0, 1);
    for (std::size_t bar = left.find('|'); bar != std::string::npos; bar = left.find('|', bar + 2))
      left.insert(bar, "\\");
    out += "| `" + left + "` | " + rule.help + " |\n";
  }
}

}  // namespace

std::string vocabulary() {
  Scene scene;
  const BindOptions options;
  const sdl::Sources sources;
  sdl::Diagnostics diagnostics(sources);
  Context context(scene, options, diagnostics);
  RawSettings settings;
  RawCamera camera;
  RawPolarizer polarizer;
  RawLuminous luminous;
  RawMedium medium;
  RawExpectation expectation;
  SpectrumFormula spectrum;
  IndexFormula index;
  RotationFormula rotation;
  RawAbsorption absorption;
  RawGyration gyration;
  RawOpticFrame optic_frame;
  std::vector<double> lambda_nm;
  std::string out;
  print(out, settings_schema(context, settings));
  print(out, wavelengths_schema(context, lambda_nm));
  print(out, camera_schema(context, camera));
  print(out, polarizer_schema(context, polarizer));
  print(out, luminous_schema(context, luminous));
  RawSurface surface;
  print(out, surface_schema(context, surface));
  print(out, spectrum_schema(context, spectrum));
  print(out, interior_schema(context, medium));
  print(out, index_schema(context, "index", index));
  print(out, rotation_schema(context, rotation));
  print(out, absorption_schema(context, "absorption", absorption));
  print(out, gyration_schema(context, gyration));
  print(out, optic_frame_schema(context, optic_frame));
  for (const std::string& kind : object_names()) {
    RawObject object;
    print(out, object_schema(context, kind.c_str(), object));
  }
  RawTwin twin;
  print(out, twin_schema(context, twin));
  RawGem::Tier tier;
  print(out, gem_facet_schema(context, tier));
  print(out, expect_schema(context, expectation));
  return out;
}

bool is_reserved_word(const std::string& text) {
  sdl::Symbols symbols;
  const std::vector<std::string> objects = object_names();
  return symbols.intern(text) < static_cast<sdl::Symbol>(sdl::Keyword::count) ||
         std::find(objects.begin(), objects.end(), text) != objects.end();
}

}  // namespace nicol
