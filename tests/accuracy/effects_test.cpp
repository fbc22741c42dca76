// Each effect that is left out is gone from the features, or from the numbers of the media.
#include "host/effects.hpp"

#include <doctest/doctest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "host/channels.hpp"
#include "host/crystal_rows.hpp"
#include "host/features.hpp"
#include "host/pack.hpp"
#include "tests/bind/built.hpp"

namespace {

using nicol::Scene;

struct Made {
  nicol::Built built;
  const Scene& scene() const { return built.bound.scene; }
  std::set<std::string> effects() const {
    std::set<std::string> names;
    for (const auto& effect : nicol::effects_of(scene())) names.insert(effect.name);
    return names;
  }
  // Features that are on; packing shows that geometry and media still fit.
  std::set<std::string> features(const Scene& changed) const {
    const auto features = nicol::decide_features(changed, built.geometry);
    CHECK(nicol::pack(changed, built.geometry, features.mask, 4, 4, 1).channels > 0);
    std::set<std::string> on;
    for (const auto& row : features.rows)
      if (row.on) on.insert(row.name);
    return on;
  }
  std::set<std::string> gone_without(const std::string& effect) const {
    const auto with = features(scene()), without = features(nicol::without_effect(scene(), effect));
    std::set<std::string> gone;
    std::set_difference(with.begin(), with.end(), without.begin(), without.end(), std::inserter(gone, gone.end()));
    return gone;
  }
};

const std::string sampled = "global_settings { wavelengths { from 400 to 700 step 50 } }";

Made make(const std::string& text) { return {nicol::build_text("#include \"minerals.inc\"\n" + sampled + text)}; }

Made box_of(const std::string& interior) { return make("box { -1, 1 interior { " + interior + " } }"); }

using Names = std::set<std::string>;

bool same_at_all_wavelengths(const nicol::Samples& values) {
  return std::all_of(values.begin(), values.end(), [&](double v) { return v == values.front(); });
}

}  // namespace

TEST_CASE("a scene offers what it has and nothing else") {
  CHECK(make("").effects() == Names{});
  CHECK(box_of("ior 1.5").effects() == Names{"polarization"});
  CHECK(box_of("M_Diamond").effects() == Names{"polarization", "dispersion"});
  CHECK(box_of("M_Calcite").effects() == Names{"polarization", "coherence", "dispersion", "birefringence"});
  CHECK(box_of("ior 1.5 rotation { constant 10 }").effects() == Names{"polarization", "rotation"});
  CHECK(box_of("ior 1.5 rotation { biot 7 }").effects() == Names{"polarization", "rotation", "rotatory_dispersion"});
  CHECK(box_of("ior 1.5 absorption { constant 0.1 }").effects() == Names{"polarization", "absorption"});
  CHECK(box_of("M_Ruby").effects() ==
        Names{"polarization", "coherence", "dispersion", "absorption", "pleochroism", "birefringence"});
  CHECK(box_of("M_Quartz_Right").effects() ==
        Names{"polarization", "coherence", "dispersion", "rotation", "rotatory_dispersion", "birefringence"});
  CHECK(make("polygon { 5, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0>, <-1,-1,0>"
             "  luminous { spectrum { d65 } polarizer { calcite angle 0 } } }")
            .effects() == Names{"polarization", "dispersion", "calcite_polarizers"});
}

TEST_CASE("media that nothing is made of do not count") {
  CHECK(make("#declare Unused = interior { M_Ruby } box { -1, 1 interior { ior 1.5 } }").effects() ==
        Names{"polarization"});
}

TEST_CASE("without polarization there are no waves to leave out") {
  const Made made = make("global_settings { polarization off } box { -1, 1 interior { M_Ruby } }");
  CHECK(made.effects() == Names{"dispersion", "absorption"});
}

TEST_CASE("an effect left out is gone from the features") {
  CHECK(box_of("M_Calcite").gone_without("polarization") ==
        Names{"polarization", "full_jones", "birefringence", "coherent_waves"});
  CHECK(box_of("M_Calcite").gone_without("coherence") == Names{"coherent_waves"});
  CHECK(box_of("M_Calcite").gone_without("birefringence") == Names{"birefringence", "coherent_waves"});
  CHECK(box_of("M_Quartz_Right").gone_without("rotation") == Names{"general_waves", "gyration"});
  CHECK(box_of("ior 1.5 rotation { biot 7 }").gone_without("rotation") == Names{"rotation"});
  CHECK(box_of("ior 1.5 absorption { constant 0.1 }").gone_without("absorption") == Names{"absorption"});
  CHECK(box_of("M_Ruby").gone_without("absorption") == Names{"pleochroism"});
  CHECK(box_of("M_Ruby").gone_without("birefringence") ==
        Names{"birefringence", "pleochroism", "coherent_waves"});
  const Made sheet = make("polygon { 5, <-1,-1,0>, <1,-1,0>, <1,1,0>, <-1,1,0>, <-1,-1,0>"
                          "  luminous { spectrum { d65 } polarizer { calcite angle 0 } } }");
  CHECK(sheet.gone_without("calcite_polarizers") == Names{"calcite_polarizer"});
}

TEST_CASE("cones and circular waves are left out by their features") {
  const Made cone = make("global_settings { conical_rays 8 } box { -1, 1 interior { M_Aragonite } }");
  REQUIRE(cone.effects().count("conical_rays") == 1);
  CHECK(cone.gone_without("conical_rays") == Names{"conical_rays"});
  const Made chlorate = box_of("ior 1.5 rotation { biot 7 } circular_waves");
  REQUIRE(chlorate.effects().count("circular_waves") == 1);
  CHECK(chlorate.gone_without("circular_waves").count("gyration") == 1);
  CHECK(chlorate.features(nicol::without_effect(chlorate.scene(), "circular_waves")).count("rotation") == 1);
}

TEST_CASE("without dispersion one geometry serves all wavelengths") {
  const Made diamond = box_of("M_Diamond");
  CHECK(nicol::choose_channels(diamond.scene()).count == 7);
  const Scene frozen = nicol::without_effect(diamond.scene(), "dispersion");
  CHECK(nicol::choose_channels(frozen).count == 1);
  CHECK(frozen.media[1].n[0][0] == diamond.scene().media[1].n[0][3]);  // 550 nm
  CHECK(nicol::effects_of(diamond.scene()).back().without == "refractive indices as at 550 nm");
}

TEST_CASE("without its dispersion, rotation is the same at all wavelengths, of glass and of quartz") {
  const Made liquid = box_of("ior 1.5 rotation { biot 7 }");
  const Scene steady = nicol::without_effect(liquid.scene(), "rotatory_dispersion");
  CHECK(same_at_all_wavelengths(steady.media[1].rotation_deg_per_mm));
  CHECK(steady.media[1].rotation_deg_per_mm[3] == liquid.scene().media[1].rotation_deg_per_mm[3]);

  const Made quartz = box_of("M_Quartz_Right");
  const nicol::Medium& with = quartz.scene().media[1];
  const nicol::Medium without = nicol::without_effect(quartz.scene(), "rotatory_dispersion").media[1];
  const auto rho = [&](const nicol::Medium& m, std::size_t i) {  // along the axis, up to a factor
    return m.gyration[2][i] / (m.n[0][i] * quartz.scene().lambda_nm[i]);
  };
  CHECK(rho(with, 0) > 2 * rho(with, 6));
  for (std::size_t i = 0; i < 7; ++i) CHECK(rho(without, i) == doctest::Approx(rho(with, 3)));
}

TEST_CASE("without pleochroism absorption stays, alike in all directions") {
  const Made ruby = box_of("M_Ruby");
  const nicol::Medium mean = nicol::without_effect(ruby.scene(), "pleochroism").media[1];
  const nicol::Medium& with = ruby.scene().media[1];
  CHECK(mean.k[0] == mean.k[2]);
  for (std::size_t i = 0; i < mean.k[0].size(); ++i)
    CHECK(mean.k[1][i] == doctest::Approx((with.k[0][i] + with.k[1][i] + with.k[2][i]) / 3));
}

TEST_CASE("what a scene has not cannot be left out") {
  CHECK_THROWS_AS(nicol::without_effect(make("").scene(), "dispersion"), std::invalid_argument);
  CHECK_THROWS_AS(nicol::without_effect(box_of("M_Calcite").scene(), "colour"), std::invalid_argument);
}
