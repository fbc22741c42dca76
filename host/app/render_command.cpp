// `nicol render`: scene file to pictures, or to the frames of a film.
#include "host/app/animation.hpp"
#include "host/app/render_picture.hpp"

namespace nicol::app {

int render_command(const RenderCommand& command) {
  const AnimationOptions& animation = command.animation;
  if (animation.final_frame) return render_animation(command);
  if (animation.subset_start || animation.subset_end || !animation.film.empty())
    throw UsageError("frames need the last one's number: --final-frame (+KFF)");
  RenderTools tools;
  return render_picture(command, tools);
}

}  // namespace nicol::app
