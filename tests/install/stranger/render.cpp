// render NAME: a picture into NAME.exr and NAME.png, and what it is off by on standard output.
#include <exception>
#include <iostream>
#include <nicol.hpp>
#include <string>

#include "scene.h"

int main(int argc, char** argv) try {
  if (argc != 2) return 2;
  const std::string name = argv[1];
  nicol::SceneOptions options;
  options.width = 32;
  options.height = 24;
  const auto scene = nicol::Scene::load_text(nicol::Context(), "cube.pov", scene_text, options);
  nicol::RenderOptions rendering;
  rendering.want_error_budget = true;
  const auto picture = scene.render(rendering);
  picture.write(name + ".exr");
  picture.write(name + ".png");
  for (const auto& line : picture.budget()) std::cout << line.source << " " << line.rms << "\n";
  return picture.budget().empty() ? 1 : 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << "\n";
  return 1;
}
