// What `nicol explain` tells of a scene: its size, which effects it calls for and why, what is left out.
#pragma once
#include <string>

#include "host/engine/loaded_scene.hpp"

namespace nicol::engine {

std::string explanation(const LoadedScene& loaded);

}  // namespace nicol::engine
