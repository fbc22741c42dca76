// plugin { } in a scene, with a stand-in for what plugins bring.
#include "bound.hpp"
#include "host/plugins/source.hpp"

using namespace nicol;
using plugins::Parameter;
using plugins::Values;

namespace {

Parameter number(const char* name, std::optional<double> otherwise) {
  Parameter made;
  made.name = name;
  made.number = otherwise;
  return made;
}

class StandIn : public plugins::PluginSource {
 public:
  StandIn() {
    formula_.parameters = {number("slope", 1.0), number("offset", std::nullopt)};
    formula_.at = [](const Values& v, double lambda_nm) {
      if (v.numbers[1] == 13) throw plugins::PluginError("plugin x.so: thirteen");
      return plugins::Dispersion::Index{v.numbers[1] + v.numbers[0] * lambda_nm / 1e4, 0.25};
    };
    spectrum_.radiance = [](const Values&, double lambda_nm) { return lambda_nm; };
    Parameter file;
    file.kind = Parameter::Kind::text;
    file.name = "file";
    solid_.parameters = {file};
    solid_.make = [](const Values& v, const plugins::FindFile& find_file) -> plugins::SolidShape {
      if (v.texts[0] == "planes")
        return ConvexShape{{{{-1, 0, 0}, 0}, {{1, 0, 0}, 1}, {{0, -1, 0}, 0}, {{0, 1, 0}, 1}, {{0, 0, -1}, 0}, {{0, 0, 1}, 1}}};
      if (find_file(v.texts[0]).empty()) throw plugins::PluginError("plugin x.so: no file");
      return MeshShape{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
    };
  }
  const plugins::Dispersion& dispersion(const std::string& name) override {
    if (name != "line") throw plugins::PluginError("plugin '" + name + "' is not found");
    return formula_;
  }
  const plugins::Spectrum& spectrum(const std::string&) override { return spectrum_; }
  const plugins::Solid& solid(const std::string&) override { return solid_; }

 private:
  plugins::Dispersion formula_;
  plugins::Spectrum spectrum_;
  plugins::Solid solid_;
};

Bound bound_with(const std::string& text) {
  StandIn source;
  BindOptions options;
  options.plugins = &source;
  options.lambda_nm = {450, 500, 650};
  return bind_text(lit + text, options);
}

std::string told_of(const std::string& words) {
  return bound_with("box { 0, 1 interior { index { plugin { " + words + " } } } }").text();
}

}  // namespace

TEST_CASE("a plugin's formula is sampled at the scene's wavelengths, in any place for indices") {
  const Bound b = bound_with(
      "box { 0, 1 interior { ordinary { plugin { \"line\" offset 1.5 } } extraordinary { plugin { \"line\" slope -1 \"offset\" 1.6 } }"
      " extinction { plugin { \"line\" offset 2 } } } }");
  CHECK_MESSAGE(b.parsed->diagnostics.all().empty(), b.text());
  const Medium& m = b.scene.media.at(*b.scene.objects.at(0).medium);
  CHECK(m.n[0] == Samples{1.5 + 0.045, 1.5 + 0.05, 1.5 + 0.065});
  CHECK(m.n[2] == Samples{1.6 - 0.045, 1.6 - 0.05, 1.6 - 0.065});
  CHECK(m.k[0] == Samples{0.25, 0.25, 0.25});
}

TEST_CASE("what is wrong with a plugin's block has its place") {
  const auto says = [](const std::string& text, const std::string& words) {
    CHECK_MESSAGE(text.find(words) != std::string::npos, text);
    CHECK_MESSAGE(text.find("'test.pov' line 2") != std::string::npos, text);
  };
  says(told_of("offset 2"), "Expected the name of a plugin in quotes, 'offset' found instead");
  says(told_of("\"line\""), "plugin 'line' needs 'offset'");
  says(told_of("\"line\" offset 2 slop 3"), "unknown parameter 'slop' in plugin 'line'; did you mean 'slope'?");
  says(told_of("\"line\" offset <1, 2>"), "Expected 'numeric expression' after 'offset', 2-vector found instead");
  says(told_of("\"line\" offset 2 offset 3"), "'offset' of plugin 'line' is said twice");
  says(told_of("\"line\" offset 13"), "plugin x.so: thirteen");
  says(told_of("\"lime\" offset 1"), "plugin 'lime' is not found");
  says(told_of("\"line\" 3"), "Expected a parameter of plugin 'line', number 3 found instead");
}

TEST_CASE("solids of plugins are planes or meshes; both go into CSG") {
  const std::string mesh = "solid { plugin { \"s\" file \"" SCENES_FOLDER "/include/units.inc\" } ";
  const Bound planes = bound_with("solid { plugin { \"s\" file \"planes\" } interior { ior 1.5 } }");
  CHECK(std::get<ConvexShape>(planes.scene.objects.at(0).shape).faces.size() == 6);
  const Bound alone = bound_with(mesh + " interior { ior 1.5 } luminous { face <1, 1, 1> } }");
  CHECK_MESSAGE(alone.parsed->diagnostics.all().empty(), alone.text());
  CHECK(std::get<MeshShape>(alone.scene.objects.at(0).shape).faces.size() == 4);
  CHECK(alone.scene.objects[0].face_emissions.at(0).face == 3);
  const Bound cut = bound_with("difference { " + mesh + "} box { 0.5, 2 } interior { ior 1.5 } }");
  CHECK(std::holds_alternative<MeshShape>(std::get<CsgShape>(cut.scene.objects.at(0).shape).root.operands.at(0).leaf));
  CHECK(bound_with("solid { plugin { \"s\" file \"nowhere\" } interior { ior 1.5 } }").text().find("plugin x.so: no file") !=
        std::string::npos);
  CHECK(bound_with("solid { interior { ior 1.5 } }").text().find("Expected 'plugin', } of 'solid' found instead") != std::string::npos);
}

TEST_CASE("a plugin's spectrum is scaled to Y = 1 as any other; without a source there are no plugins") {
  const Bound b = bound_with("background { spectrum { plugin { \"any\" } } }");
  REQUIRE(b.scene.sky.size() == 3);
  CHECK(b.scene.sky[2] / b.scene.sky[0] == doctest::Approx(650.0 / 450).epsilon(1e-14));
  CHECK(bind_text(lit + "box { 0, 1 interior { index { plugin { \"line\" } } } }").text().find("no plugins can be loaded here") !=
        std::string::npos);
}
