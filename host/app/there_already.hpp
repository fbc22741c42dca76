// What --continue finds of a picture that may be there.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"
#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

struct Found {
  bool picture = false;  // all files are there, and hold what would be made
  bool another = false;  // some file holds another one
  bool tiles = false;    // of an unfinished one
};

// Tells of files that hold another picture. UsageError for a share that makes no sense.
Found find_what_is_there(const RenderCommand& command, const std::vector<std::string>& outputs, const engine::LoadedScene& loaded);

}  // namespace nicol::app
