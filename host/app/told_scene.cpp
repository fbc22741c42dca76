#include "host/app/told_scene.hpp"

#include <fmt/format.h>

#include <cstdio>

namespace nicol::app {

std::unique_ptr<engine::LoadedScene> load_and_tell(const std::string& path, const engine::SceneOptions& options,
                                                   engine::Expectations expectations, std::string* told) {
  std::string text;
  auto loaded = engine::load_scene(path, options, expectations, &text);
  if (!told || *told != text) fmt::print(stderr, "{}", text);
  if (told) *told = text;
  return loaded;
}

}  // namespace nicol::app
