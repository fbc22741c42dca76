// What the tests of libnicol render: small, and of few effects, so that few kernels are built.
#pragma once
#include <string>

#include "nicol.hpp"

namespace api_test {

inline const char* const cube = R"(
#version unofficial 3.7;
#ifndef (Sky) #declare Sky = 0.4; #end
global_settings { mm_per_unit 1 wavelengths { 450, 550, 650 } max_trace_level 12 adc_bailout 1e-4 }
camera { location <0, 30, -30> right x*image_width/image_height angle 30 look_at 0 }
background { spectrum { e scale Sky } }
polygon { 5, <-8, 0, -8>, <8, 0, -8>, <8, 0, 8>, <-8, 0, 8>, <-8, 0, -8> luminous { spectrum { e } } }
box { <-4, 0, -4>, <4, 6, 4> interior { ior 1.5 } }
)";

inline nicol::SceneOptions sized(int width, int height) {
  nicol::SceneOptions options;
  options.width = width;
  options.height = height;
  return options;
}

inline nicol::Scene cube_scene(const nicol::Context& context, int width = 40, int height = 30) {
  return nicol::Scene::load_text(context, "cube.pov", cube, sized(width, height));
}

inline bool same(nicol::View<float> a, nicol::View<float> b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!(a[i] == b[i])) return false;
  return true;
}

}  // namespace api_test
