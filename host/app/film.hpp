// A film of an animation's frames, by ffmpeg where that is installed.
#pragma once
#include <string>
#include <vector>

#include "host/app/animation.hpp"

namespace nicol::app {

// Before anything is rendered. UsageError: no .png among the outputs, or a folder that is not there.
void check_film(const std::string& film, const std::vector<std::string>& outputs);

// What ffmpeg is called with, its name first. unfinished: where it writes.
std::vector<std::string> film_command(const AnimationOptions& options, const std::vector<std::string>& outputs, FrameRange range,
                                      const std::string& unfinished);

// The exit code. The film appears whole or not at all.
int make_film(const AnimationOptions& options, const std::vector<std::string>& outputs, FrameRange range, bool quiet);

}  // namespace nicol::app
