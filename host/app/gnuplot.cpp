// See gnuplot.hpp. Input and outputs go through unnamed files, so that neither side waits for the other.
#include "host/app/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

extern char** environ;

namespace nicol::app {
namespace {

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File unnamed_file() {
  File file(std::tmpfile());
  if (!file) throw GnuplotError(fmt::format("no plot: cannot make a temporary file: {}", std::strerror(errno)));
  return file;
}

std::string whole(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char buffer[1 << 16];
  for (std::size_t count; (count = std::fread(buffer, 1, sizeof buffer, file)) > 0;) text.append(buffer, count);
  return text;
}

// Its status, as waitpid() gives it.
int spawn(std::FILE* in, std::FILE* out, std::FILE* messages) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(messages), 2);
  char name[] = "gnuplot", dash[] = "-";
  char* arguments[] = {name, dash, nullptr};
  pid_t child = 0;
  const int failed = posix_spawnp(&child, name, &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed == ENOENT) throw GnuplotError("no plot: gnuplot is not installed (Debian's package gnuplot-nox)");
  if (failed != 0) throw GnuplotError(fmt::format("no plot: gnuplot cannot be started: {}", std::strerror(failed)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw GnuplotError(fmt::format("no plot: gnuplot was lost: {}", std::strerror(errno)));
  return status;
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const File in = unnamed_file(), out = unnamed_file(), messages = unnamed_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    throw GnuplotError("no plot: the temporary folder is full");
  std::rewind(in.get());
  const int status = spawn(in.get(), out.get(), messages.get());
  std::string picture = whole(out.get());
  if (status == 0 && !picture.empty()) return picture;
  if (WIFSIGNALED(status))
    throw GnuplotError(fmt::format("no plot: gnuplot ended by signal {}", WTERMSIG(status)));
  throw GnuplotError(fmt::format("no plot: gnuplot failed: {}", whole(messages.get())));
}

}  // namespace nicol::app
