// What the window says.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "host/window/texts.hpp"

using namespace nicol;
using namespace nicol::window;

TEST_CASE("numbers have three significant digits") {
  CHECK(short_number(0) == "0");
  CHECK(short_number(0.012345) == "0.0123");
  CHECK(short_number(-1.2345) == "-1.23");
  CHECK(short_number(123.45) == "123");
  CHECK(short_number(12345.6) == "12346");
  CHECK(short_number(1.234e-7) == "1.23e-07");
  CHECK(short_number(std::numeric_limits<double>::quiet_NaN()) == "nan");
}

TEST_CASE("a source line is shown with blanks for tabs, and the caret under its column") {
  CHECK(shown_line("a b", 3).caret == 2);
  const ShownLine tabbed = shown_line("\tab\tc", 5);   // column 5: the c
  CHECK(tabbed.text == "    ab  c");
  CHECK(tabbed.caret == 8);
  CHECK(shown_line("abc", 0).caret == -1);
  CHECK(shown_line("abc", 4).caret == 3);              // behind the end: where something is missing
  CHECK(shown_line("abc", 99).caret == 3);
  CHECK(shown_line("\xC3\xA4 x", 4).caret == 2);       // two bytes, one character
  CHECK(shown_line("abc\r", 1).text == "abc");
}

TEST_CASE("a message tells its place as far as it has one") {
  preview::Message message;
  CHECK(place_text(message) == "");
  message.file = "a.pov";
  CHECK(place_text(message) == "a.pov");
  message.line = 12;
  CHECK(place_text(message) == "a.pov:12");
  message.column = 5;
  CHECK(place_text(message) == "a.pov:12:5");
}

TEST_CASE("axes have round numbers within their ends") {
  CHECK(ticks(0, 1, 5) == std::vector<double>{0, 0.2, 0.4, 0.6000000000000001, 0.8, 1});
  CHECK(ticks(400, 700, 5).front() == 400);
  CHECK(ticks(400, 700, 5).back() == 700);
  for (const auto& [low, high] : {std::pair{-0.013, 0.021}, std::pair{380.0, 781.0}, std::pair{1e-9, 3e-9}})
    for (int most = 1; most < 8; ++most) {
      const auto places = ticks(low, high, most);
      CHECK(places.size() <= static_cast<std::size_t>(most) + 1);
      for (const double place : places) {
        CHECK(place >= low - 1e-9 * (high - low));
        CHECK(place <= high + 1e-9 * (high - low));
      }
    }
  CHECK(ticks(1, 1, 5).empty());
  CHECK(ticks(0, std::numeric_limits<double>::infinity(), 5).empty());
}

TEST_CASE("the status tells blocks first, then samples and their error") {
  preview::PaneStatus status;
  CHECK(progress_text(status) == "-");
  status.step = 8;
  CHECK(progress_text(status) == "block 8x8");
  status.step = 1;
  status.samples = 1;
  CHECK(progress_text(status) == "1 sample");
  status.samples = 3.25;
  CHECK(progress_text(status) == "3.2 samples");
  status.passes = 4;
  status.sample_error = 0.0123;
  status.working = true;
  status.fraction = 0.379;
  status.device = "device";
  status.real = "float";
  CHECK(status_text(status, true) ==
        "tracing 37 %  |  3.2 samples  |  4 passes  |  error 1.23 %  |  generic kernel  |  device, float");
  status.sample_error = std::numeric_limits<double>::quiet_NaN();
  status.counted_errors = 2;
  status.specialised = true;
  CHECK(status_text(status, false) ==
        "2 ERRORS COUNTED  |  tracing 37 %  |  3.2 samples  |  4 passes  |  specialised kernel");
}

TEST_CASE("a pane's title names what is shown and what is left out") {
  preview::PaneStatus status;
  status.title = "scenes/gems/a.pov";
  status.lambda_nm = {500, 589.3};
  preview::View view;
  view.quantity = preview::Quantity::degree;
  view.wavelength = 1;
  status.without = {"rotation", "dispersion"};
  CHECK(pane_title(status, view, "") == "a.pov  |  degree of polarization  |  589 nm  |  without rotation, dispersion");
  view = {};
  status.without.clear();
  CHECK(pane_title(status, view, "before the analyzer") == "a.pov  |  before the analyzer  |  colour");
}

TEST_CASE("texts: the status line tells which kernel renders, and why it is not the specialised one") {
  preview::PaneStatus status;
  status.waits_for_kernel = status.building = true;
  CHECK(status_text(status, false).find("first kernel in building") != std::string::npos);
  status.waits_for_kernel = false;
  CHECK(status_text(status, false).find("generic kernel, specialised one in building") != std::string::npos);
  status.building = false;
  status.kernel_failure = "no";
  CHECK(status_text(status, false).find("does not build") != std::string::npos);
  status.kernel_failure.clear();
  status.specialised = true;
  CHECK(status_text(status, false).find("specialised kernel") != std::string::npos);
}
