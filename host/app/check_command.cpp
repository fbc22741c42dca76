// `nicol check`: everything that can be wrong with scenes, without rendering.
// `nicol words`: what they may say.
#include <fmt/format.h>

#include <cstdio>

#include "host/app/commands.hpp"
#include "host/app/told_scene.hpp"
#include "host/bind/bind.hpp"
#include "host/engine/loaded_scene.hpp"

namespace nicol::app {

int check_command(const CheckCommand& command) {
  int code = exit_done;
  for (const std::string& path : command.scenes) {
    const auto loaded = load_and_tell(path, command.options);
    if (!loaded) code = exit_error;
    fmt::print("{}: {}\n", path, loaded ? "right" : "wrong");
    std::fflush(stdout);
  }
  return code;
}

int words_command() {
  fmt::print("{}", vocabulary());
  return exit_done;
}

}  // namespace nicol::app
