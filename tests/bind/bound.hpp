// A scene text, parsed and bound, with what was said about it.
#pragma once
#include <doctest/doctest.h>

#include <memory>
#include <string>

#include "host/bind/bind.hpp"
#include "host/vec.hpp"
#include "sdl/parse.hpp"

namespace nicol {

struct Bound {
  std::unique_ptr<sdl::Result> parsed = std::make_unique<sdl::Result>();
  Scene scene;

  std::size_t count(sdl::Severity severity) const {
    std::size_t n = 0;
    for (const auto& d : parsed->diagnostics.all()) n += d.severity == severity;
    return n;
  }
  std::string text() const { return parsed->diagnostics.text(); }
};

inline sdl::Options test_options() {
  sdl::Options options;
  options.library_paths = {SCENES_FOLDER "/include", SCENES_FOLDER "/founding"};
  options.image_width = options.image_height = 400;
  return options;
}

inline Bound bind_text(const std::string& text, const BindOptions& wanted = {}) {
  Bound bound;
  sdl::parse_text("test.pov", text, test_options(), *bound.parsed);
  bound.scene = bind(bound.parsed->document, wanted, bound.parsed->diagnostics);
  return bound;
}

// The same, and nothing at all to be said about it.
inline Bound bind_clean(const std::string& text, const BindOptions& wanted = {}) {
  Bound bound = bind_text(text, wanted);
  CHECK_MESSAGE(bound.parsed->diagnostics.all().empty(), bound.text());
  return bound;
}

// Light and a camera, so that only what the test adds is talked about.
inline const std::string lit = "background { rgb 1 } camera { location -10*z }\n";
inline const std::string glass = " interior { ior 1.5 } ";

inline void check_near(Vec3 a, Vec3 b, double tolerance = 1e-12) {
  INFO("<", a.x, ",", a.y, ",", a.z, "> against <", b.x, ",", b.y, ",", b.z, ">");
  CHECK(length(a - b) <= tolerance);
}

}  // namespace nicol
