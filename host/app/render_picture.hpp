// One picture of `nicol render`: a picture, a part of one, a frame of an animation.
#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/app/commands.hpp"
#include "host/opencl/device.hpp"

namespace nicol::app {

// Which of many frames this is.
struct FrameOfMany {
  int index = 0, count = 1;  // from 0
  int rendered = 0;          // before it, in this run
};

// What frames hand on to the next.
struct RenderTools {
  std::shared_ptr<Device> device;      // null: not opened yet
  std::vector<std::shared_ptr<Device>> also;   // further ones that --device names
  std::string told;                    // of the scene's warnings
  std::optional<FrameOfMany> frames;   // none: a single picture
  bool was_there = false;              // of the last picture: nothing was to be rendered
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
};

// As the command names them, or the scene's name with .png in the working directory.
std::vector<std::string> outputs_of(const RenderCommand& command);

// Where finished tiles lie: beside the first picture.
std::string journal_path(const std::string& output);

// The exit code. With --continue, pictures that are there and are those that would be made are left (was_there). An interrupted picture is written as far as it goes; a frame or a part of a picture is not, its tiles are kept.
int render_picture(const RenderCommand& command, RenderTools& tools);

}  // namespace nicol::app
