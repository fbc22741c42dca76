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

// visit(schema) for each block.
template <class Visit>
void each_schema(const Visit& visit) {
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
  visit(settings_schema(context, settings));
  visit(wavelengths_schema(context, lambda_nm));
  visit(camera_schema(context, camera));
  visit(polarizer_schema(context, polarizer));
  visit(luminous_schema(context, luminous));
  RawSurface surface;
  visit(surface_schema(context, surface));
  visit(spectrum_schema(context, spectrum));
  visit(interior_schema(context, medium));
  visit(index_schema(context, "index", index));
  visit(rotation_schema(context, rotation));
  visit(absorption_schema(context, "absorption", absorption));
  visit(gyration_schema(context, gyration));
  visit(optic_frame_schema(context, optic_frame));
  for (const std::string& kind : object_names()) {
    RawObject object;
    visit(object_schema(context, kind.c_str(), object));
  }
  RawTwin twin;
  visit(twin_schema(context, twin));
  RawGem::Tier tier;
  visit(gem_facet_schema(context, tier));
  visit(expect_schema(context, expectation));
}

}  // namespace

std::string vocabulary() {
  std::string out;
  each_schema([&](const Schema& schema) { print(out, schema); });
  return out;
}

bool is_word(const std::string& text) {
  sdl::Symbols symbols;
  bool found = symbols.intern(text) < static_cast<sdl::Symbol>(sdl::Keyword::count);
  each_schema([&](const Schema& schema) {
    found = found || text == schema.block ||
            std::any_of(schema.rules.begin(), schema.rules.end(), [&](const Rule& rule) { return text == rule.name; });
  });
  return found;
}

}  // namespace nicol
