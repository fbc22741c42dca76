// See film.hpp.
#include "host/app/film.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

extern char** environ;

namespace nicol::app {
namespace {

namespace fs = std::filesystem;

bool is_png(const std::string& path) {
  const std::string suffix = fs::path(path).extension().string();
  return suffix == ".png" || suffix == ".PNG";
}

// "out%03d.png" of "out.png", as ffmpeg reads it.
std::string pattern_of(const std::string& path, const AnimationOptions& options) {
  fs::path named(path);
  const std::string suffix = named.extension().string();
  named.replace_extension();
  std::string pattern;
  for (const char c : named.string()) pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return fmt::format("{}%0{}d{}", pattern, std::to_string(*options.final_frame).size(), suffix);
}

// As a shell reads it, for the user to copy.
std::string shell_text(const std::vector<std::string>& arguments) {
  std::string text;
  for (const std::string& argument : arguments) {
    const bool plain = !argument.empty() && std::all_of(argument.begin(), argument.end(), [](unsigned char c) {
      return std::isalnum(c) || std::strchr("%+,-./:=_", c) != nullptr;
    });
    std::string quoted = argument;
    if (!plain) {
      quoted = "'";
      for (const char c : argument) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
      quoted += "'";
    }
    text += (text.empty() ? "" : " ") + quoted;
  }
  return text;
}

// 0, the exit code, or minus the error of starting it.
int run(const std::vector<std::string>& arguments) {
  std::vector<char*> list;
  for (const std::string& argument : arguments) list.push_back(const_cast<char*>(argument.c_str()));
  list.push_back(nullptr);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, list.front(), nullptr, nullptr, list.data(), environ);
  if (failed != 0) return -failed;
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  constexpr int signalled = 128;  // as a shell says it
  return WIFEXITED(status) ? WEXITSTATUS(status) : signalled + WTERMSIG(status);
}

}  // namespace

void check_film(const std::string& film, const std::vector<std::string>& outputs) {
  if (std::none_of(outputs.begin(), outputs.end(), is_png))
    throw UsageError(fmt::format("--film {} is made of .png frames: give -o NAME.png too", film));
  const fs::path folder = fs::path(film).parent_path();
  if (!folder.empty() && !fs::is_directory(folder)) throw UsageError(fmt::format("--film {}: there is no folder {}", film, folder.string()));
}

// H.264 wants even sizes; its colours are those of BT.709, whose primaries are sRGB's.
std::vector<std::string> film_command(const AnimationOptions& options, const std::vector<std::string>& outputs, FrameRange range,
                                      const std::string& unfinished) {
  const std::string& frames = *std::find_if(outputs.begin(), outputs.end(), is_png);
  return {"ffmpeg", "-nostdin", "-hide_banner", "-loglevel", "error", "-y",
          "-framerate", fmt::format("{:g}", options.frames_per_second),
          "-start_number", std::to_string(range.first), "-i", pattern_of(frames, options),
          "-frames:v", std::to_string(range.last - range.first + 1),
          "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv",
          "-c:v", "libx264", "-crf", "16", "-pix_fmt", "yuv420p", "-colorspace", "bt709", "-color_primaries", "bt709",
          "-color_trc", "iec61966-2-1", "-movflags", "+faststart", unfinished};
}

int make_film(const AnimationOptions& options, const std::vector<std::string>& outputs, FrameRange range, bool quiet) {
  fs::path unfinished(options.film);
  unfinished.replace_filename(fmt::format(".{}.unfinished{}", unfinished.stem().string(), unfinished.extension().string()));
  const int code = run(film_command(options, outputs, range, unfinished.string()));
  std::error_code failed;
  if (code == 0) {
    fs::rename(unfinished, options.film, failed);
    if (!failed) {
      if (!quiet) fmt::print(stderr, "{}: {} frames, {:g} a second\n", options.film, range.last - range.first + 1, options.frames_per_second);
      return exit_done;
    }
    fmt::print(stderr, "nicol: cannot write {}: {}\n", options.film, failed.message());
    return exit_error;
  }
  fs::remove(unfinished, failed);
  const std::string command = shell_text(film_command(options, outputs, range, options.film));
  constexpr int not_found = 127;  // of a posix_spawnp() that tells it so late
  const std::string reason = code == -ENOENT || code == not_found ? "ffmpeg is not installed"
                             : code < 0                           ? fmt::format("ffmpeg: {}", std::strerror(-code))
                                                                  : fmt::format("ffmpeg failed with exit code {}", code);
  fmt::print(stderr, "nicol: the frames are there, but {} was not made: {}. By hand:\n{}\n", options.film, reason, command);
  return exit_error;
}

}  // namespace nicol::app
