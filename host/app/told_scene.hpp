// A scene file read, with what there is to tell of it on standard error.
#pragma once
#include <memory>
#include <string>

#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

// Null if there was an error. told: what was told last time (of another frame), which is not told again.
std::unique_ptr<engine::LoadedScene> load_and_tell(const std::string& path, const engine::SceneOptions& options,
                                                   engine::Expectations expectations = engine::Expectations::where_they_apply,
                                                   std::string* told = nullptr);

}  // namespace nicol::app
