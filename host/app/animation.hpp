// A film frame by frame, with POV-Ray's options. POV-Ray 3.7 documentation, "Animation Options": the clock runs from initial_clock in
// frame initial_frame to final_clock in frame final_frame, or in the one after it if the animation is cyclic. Files: out.png becomes
// out001.png, with as many digits as the last frame has.
#pragma once
#include <string>
#include <vector>

#include "host/app/commands.hpp"

namespace nicol::app {

struct FrameRange {
  int first = 1, last = 1;  // that are rendered
};

// UsageError where the options make no sense.
FrameRange frames_of(const AnimationOptions& options);
FrameClock clock_at(const AnimationOptions& options, int frame);
std::string frame_path(const std::string& path, const AnimationOptions& options, int frame);

// Renders all frames, one after the other, and the film. --continue leaves those whose files are there.
int render_animation(const RenderCommand& command);

}  // namespace nicol::app
