// What is told of a finished picture: on standard error, and in the picture's header.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "host/engine/loaded_scene.hpp"
#include "host/opencl/render.hpp"
#include "host/output/frame.hpp"

namespace nicol::engine {

// "1 sample a pixel", "2.37 samples a pixel"
std::string samples_text(double mean);

std::string summary_text(const Frame& frame, const RenderReport& report);

// One line for each counter that is not 0, saying what it means; none if all is well.
std::vector<std::string> counter_warnings(const RenderReport& report);

std::vector<std::pair<std::string, std::string>> how_made(const LoadedScene& loaded,
                                                          const PictureOptions& command,
                                                          const RenderReport& report);

}  // namespace nicol::engine
