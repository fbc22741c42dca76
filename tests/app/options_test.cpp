// Wavelength lists, POV-Ray's switches, tolerances and the progress line.
#include <doctest/doctest.h>

#include <cmath>

#include "host/app/expectations.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/app/povray_switches.hpp"
#include "host/app/progress_bar.hpp"

using namespace nicol;
using namespace nicol::app;

TEST_CASE("wavelengths: the end of a range belongs to it though 0.1 is no binary number") {
  CHECK(parse_wavelengths("400:700:100") == std::vector<double>{400, 500, 600, 700});
  CHECK(parse_wavelengths("500:501:0.1").size() == 11);
  CHECK(parse_wavelengths("500:505:2") == std::vector<double>{500, 502, 504});
  CHECK(parse_wavelengths("589").size() == 1);
  CHECK(parse_wavelengths("650,450") == std::vector<double>{450, 650});
}

TEST_CASE("wavelengths: nonsense is refused") {
  for (const char* wrong : {"", "a", "400:", "400:700", "400:700:0", "400:700:-1", "700:400:1",
                            "1:2:3:4", "450,450", "400 500", "nan", "0:1e9:1e-9"})
    CHECK_THROWS_AS(parse_wavelengths(wrong), UsageError);
}

TEST_CASE("POV-Ray's switches become options, whatever their case") {
  std::vector<std::string> ignored;
  const auto out = translate_povray_switches(
      {"render", "+iscene.pov", "+Oa b.exr", "+W640", "+h480", "+Lfolder", "Declare=a=1", "WIDTH=3",
       "-o", "x.exr", "+A0.3", "+WT2", "+Q9", "scene=1.pov"},
      ignored);
  CHECK(out == std::vector<std::string>{"render", "--input", "scene.pov", "--output", "a b.exr",
                                        "--width", "640", "--height", "480", "--library", "folder",
                                        "--declare", "a=1", "--width", "3", "-o", "x.exr",
                                        "scene=1.pov"});
  CHECK(ignored == std::vector<std::string>{"+A0.3", "+WT2", "+Q9"});
  for (const char* wrong : {"+SR", "+KFF", "+I", "+HIheader.inc"})
    CHECK_THROWS_AS(translate_povray_switches({wrong}, ignored), UsageError);
}

TEST_CASE("a value passes within its tolerance, both ends included, and never as NaN") {
  Expectation expectation;
  expectation.value = {2, -4};
  expectation.tolerance = 0.25;
  CHECK(compare(expectation, {2.25, -4.25}).pass);
  CHECK_FALSE(compare(expectation, {2, -4.26}).pass);
  CHECK_FALSE(compare(expectation, {std::nan(""), -4}).pass);
  CHECK_FALSE(compare(expectation, {2}).pass);
  CHECK(compare(expectation, {2.125, -4}).difference[0] == 0.125);
  expectation.relative = true;
  CHECK(compare(expectation, {2.5, -5}).pass);
  CHECK_FALSE(compare(expectation, {2.51, -5}).pass);
}

TEST_CASE("the progress line tells share, rate and time left") {
  Progress progress;
  progress.fraction = 0.5;
  progress.segments_per_second = 42.04e6;
  progress.seconds_left = 83;
  CHECK(progress_line(progress) ==
        "[###############...............]  50 %  42.0 M segments/s  1:23 left");
  progress.fraction = 1;
  progress.seconds_left = 3725;
  CHECK(progress_line(progress) ==
        "[##############################] 100 %  42.0 M segments/s  1:02:05 left");
}
