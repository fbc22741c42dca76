// The verbs of the command line, each with its options.
// Each answers the exit code: 0 done, 1 error, 2 interrupted.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "host/engine/options.hpp"

namespace nicol {
class Ranks;
}

namespace nicol::app {

using namespace engine;

inline constexpr int exit_done = 0, exit_error = 1, exit_interrupted = 2;

// POV-Ray's animation options. Frames, if final_frame is given.
struct AnimationOptions {
  int initial_frame = 1;
  std::optional<int> final_frame;
  double initial_clock = 0, final_clock = 1;
  bool cyclic = false;                                  // the last frame is one step before final_clock
  std::optional<double> subset_start, subset_end;       // frames; below 1: parts of final_frame
  std::string film;                                     // to be made of the frames by ffmpeg; "": none
  double frames_per_second = 25;
};

// outputs empty: the scene's name with .png, in the working directory.
struct RenderCommand : PictureOptions {
  bool quiet = false;
  Ranks* ranks = nullptr;         // of mpirun; null: this process is alone
  bool first_rank_idle = false;   // rank 0 only deals and gathers
  AnimationOptions animation;
};

struct MergeCommand {
  std::vector<std::string> parts, outputs;
  bool incomplete = false;   // what is missing does not matter
  bool quiet = false;
  std::string command_line;  // for the picture's header
};

struct ExplainCommand {
  std::string scene;
  SceneOptions options;
  DeviceOptions device;
  bool no_build = false;
  bool media = false;        // a table of media instead, of a scene or of a library of them
  double lambda_nm = 589.3;  // for the table
};

struct CheckCommand {
  std::vector<std::string> scenes;
  SceneOptions options;
};

struct ExpectCommand {
  std::vector<std::string> scenes;
  SceneOptions options;
  DeviceOptions device;  // real: float, double or both
};

int render_command(const RenderCommand& command);
int merge_command(const MergeCommand& command);
int explain_command(const ExplainCommand& command);
int check_command(const CheckCommand& command);
int expect_command(const ExpectCommand& command);
int devices_command();
int probe_command(const DeviceOptions& options);
int words_command();
int plugins_command(const SceneOptions& options);

}  // namespace nicol::app
