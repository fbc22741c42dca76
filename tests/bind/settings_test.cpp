// global_settings { } and expect { }.
#include "bound.hpp"

namespace nicol {

namespace {

const std::string thing =
    lit +
    "disc { 0, y, 1 luminous { } } box { 1, 2 interior { ior 1.5 rotation { constant 20 } } }\n";

Expectation expectation(const std::string& inside, const std::string& before = thing) {
  const Bound b = bind_clean(before + "expect { " + inside + " source \"test\" }");
  REQUIRE(b.scene.expectations.size() == 1);
  return b.scene.expectations[0];
}

}  // namespace

TEST_CASE("settings: POV-Ray's defaults and nicol's") {
  const Scene s = bind_clean(thing).scene;
  CHECK(s.settings.max_trace_level == 5);
  CHECK(s.settings.adc_bailout == 1.0 / 255);
  CHECK(s.settings.mm_per_unit == 10);
  CHECK(s.lambda_nm.size() == 21);
  CHECK(s.lambda_nm.front() == 380);
  CHECK(s.lambda_nm.back() == 780);
  CHECK(s.weight_nm.at(1) == doctest::Approx(20));
}

TEST_CASE("settings: all words, wherever they stand") {
  const Scene s =
      bind_clean(
          thing +
          "global_settings { assumed_gamma 1 mm_per_unit 2 max_trace_level 12 adc_bailout 1e-4"
          " samples 9 error 0.001 sample_error 0.02 exposure 3 polarization off wavelengths { from 400 to 700 step 100 } }")
          .scene;
  CHECK(s.settings.mm_per_unit == 2);
  CHECK(s.settings.max_trace_level == 12);
  CHECK(s.settings.adc_bailout == 1e-4);
  CHECK(s.settings.samples == 9);
  CHECK(s.settings.error == 0.001);
  CHECK(s.settings.sample_error == 0.02);
  CHECK(s.settings.exposure == 3);
  CHECK_FALSE(s.settings.polarization);
  CHECK(s.lambda_nm == std::vector<double>{400, 500, 600, 700});
  CHECK(s.objects.at(0).transforms.back().m[0][0] == 2);
}

TEST_CASE("settings: lists of wavelengths are sorted, fractions of steps are not lost") {
  CHECK(bind_clean("global_settings { wavelengths { 587.6, 486.1 } }" + thing).scene.lambda_nm ==
        std::vector<double>{486.1, 587.6});
  CHECK(bind_clean("global_settings { wavelengths { from 400 to 401 step 0.1 } }" + thing)
            .scene.lambda_nm.size() == 11);
}

TEST_CASE("settings: the command line has the last word") {
  BindOptions wanted;
  wanted.lambda_nm = {500, 600};
  wanted.max_trace_level = 3;
  wanted.samples = 4;
  wanted.error = 0.01;
  wanted.polarization = false;
  wanted.path = "a.pov";
  const Scene s =
      bind_clean("global_settings { max_trace_level 9 wavelengths { 580 } }" + thing, wanted).scene;
  CHECK(s.lambda_nm == std::vector<double>{500, 600});
  CHECK(s.settings.max_trace_level == 3);
  CHECK(s.settings.samples == 4);
  CHECK(s.settings.error == 0.01);
  CHECK_FALSE(s.settings.polarization);
  CHECK(s.path == "a.pov");
}

TEST_CASE("settings: POV-Ray's other words are accepted with one note") {
  const Bound b = bind_text(
      "global_settings { ambient_light rgb 1 number_of_waves 3 radiosity { } }" +
      thing);
  CHECK(b.parsed->diagnostics.all().size() == 1);
  CHECK(b.count(sdl::Severity::note) == 1);
}

TEST_CASE("settings: assumed_gamma srgb is a word, not a colour") {
  bind_clean("global_settings { assumed_gamma srgb }" + thing);
}

TEST_CASE("expect: every quantity") {
  using Quantity = Expectation::Quantity;
  const Expectation e = expectation("relative_radiance 580, 0.25 at <0.1, 0.2> within 1e-4");
  CHECK(e.quantity == Quantity::relative_radiance);
  CHECK(e.lambda_nm == 580);
  CHECK(e.value == std::vector<double>{0.25});
  CHECK(e.at[0] == 0.1);
  CHECK(e.at[1] == 0.2);
  CHECK(e.tolerance == 1e-4);
  CHECK_FALSE(e.relative);
  CHECK(e.source == "test");
  CHECK(expectation("stokes 580, <1, 0.5, 0, -0.1> within 1e-3").value ==
        std::vector<double>{1, 0.5, 0, -0.1});
  CHECK(expectation("xyz <0.9, 1, 1.1> within 0.1").quantity == Quantity::xyz);
  CHECK(expectation("rgb <0.9, 1, 1.1> within 0.1").value == std::vector<double>{0.9, 1, 1.1});
  CHECK(expectation("chromaticity <0.31, 0.33> within 0.01").value.size() == 2);
  CHECK(expectation("rotation_deg 580, 360 within 0.1").quantity == Quantity::rotation_deg);
  const Expectation malus = expectation("malus_xyz 1.6, <0.5, 0.5, 0.5> within 0.1");
  CHECK(malus.length_mm == doctest::Approx(16));
  CHECK(malus.medium == 1);
}

TEST_CASE("expect: percent and relative") {
  const Expectation percent = expectation("xyz <1, 1, 1> within 2 percent");
  CHECK(percent.relative);
  CHECK(percent.tolerance == doctest::Approx(0.02));
  CHECK(expectation("xyz <1, 1, 1> within 0.02 relative").relative);
}

TEST_CASE("expect: made by loops and macros") {
  const Bound b =
      bind_clean(thing +
                 "#macro E(L) expect { relative_radiance L, 1/L within 1e-4 source \"m\" } #end"
                 "\n#for (I, 400, 500, 20) E(I) #end");
  REQUIRE(b.scene.expectations.size() == 6);
  CHECK(b.scene.expectations[5].lambda_nm == 500);
  CHECK(b.scene.expectations[5].value[0] == 1.0 / 500);
}

}  // namespace nicol
