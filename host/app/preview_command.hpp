// `nicol preview`: one scene or two beside each other in a window, live.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"
#include "host/preview/session.hpp"

namespace nicol::app {

struct PreviewCommand {
  std::string scene, second;
  std::vector<std::string> right;      // changes that make the right pane of the first scene
  SceneOptions options;
  bool size_given = false;             // --width or --height: else the pictures get the shape of the scene's camera
  DeviceOptions device;
  std::string script;                  // file of commands, "-": standard input; empty: a person sits there
  bool show = false;                   // a script in a window, too
};

// The panes' sources. UsageError for changes that cannot be understood.
preview::SessionOptions preview_session(const PreviewCommand& command);

// In a window, or by its script; in a build without the window's libraries: UsageError.
int preview_command(const PreviewCommand& command);

}  // namespace nicol::app
