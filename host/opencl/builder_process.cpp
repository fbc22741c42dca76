#include "host/opencl/builder_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "host/opencl/program.hpp"

namespace nicol {
namespace {

constexpr const char* build_switch = "--build-kernel";
constexpr int built = 0, failed = 1;
constexpr int lower_priority = 5;   // pictures come first

std::atomic<bool> serves{false};

// The program's own file, while it runs.
constexpr const char* this_program = "/proc/self/exe";

// Its end: the code, or `failed` if it was killed.
int wait_for(pid_t process, const std::atomic<bool>* stop) {
  constexpr std::chrono::milliseconds pause{20};
  for (int status = 0;;) {
    const pid_t ended = ::waitpid(process, &status, stop ? WNOHANG : 0);
    if (ended == process) return WIFEXITED(status) ? WEXITSTATUS(status) : failed;
    if (ended < 0 && errno != EINTR) return failed;
    if (stop && *stop) ::kill(process, SIGKILL);
    if (stop) std::this_thread::sleep_for(pause);
  }
}

// A file without a name that holds the text, to be read from its beginning. Null if there can be none.
using TextFile = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
TextFile nameless_file(const std::string& text) {
  TextFile file(std::tmpfile(), std::fclose);
  if (file && (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() || std::fflush(file.get()) != 0 ||
               std::fseek(file.get(), 0, SEEK_SET) != 0))
    file.reset();
  return file;
}

std::string all_of_standard_input() {
  std::string text;
  char part[4096];
  for (std::size_t count = 0; (count = std::fread(part, 1, sizeof part, stdin)) > 0;) text.append(part, count);
  return text;
}

// It reads `input`; nothing of what it writes is wanted.
int run_silently(std::vector<std::string> arguments, std::FILE* input, const std::atomic<bool>* stop) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, ::fileno(input), STDIN_FILENO);
  for (int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const bool started = ::posix_spawn(&process, this_program, &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  return started ? wait_for(process, stop) : failed;
}

}  // namespace

bool build_in_own_process(const Device& device, std::uint32_t features, const std::string& fragments, const KernelOptions& options) {
  if (!serves) return false;
  const TextFile input = nameless_file(fragments);
  if (!input) return false;
  const bool done = run_silently({"nicol", build_switch, std::to_string(info(device).index), std::to_string(features),
                       std::to_string(options.lanes), options.real_double ? "double" : "float",
                       options.generic ? "generic" : "specialised"}, input.get(), options.stop) == built;
  if (options.stop && *options.stop) throw DeviceError("the building of a kernel was given up");
  return done;
}

std::optional<int> serve_as_builder(int argc, const char* const* argv) {
  serves = true;
  if (argc != 7 || std::string(argv[1]) != build_switch) return std::nullopt;
  [[maybe_unused]] const int priority = ::nice(lower_priority);
  try {
    KernelOptions options;
    options.lanes = std::atoi(argv[4]);
    options.real_double = std::string(argv[5]) == "double";
    options.generic = std::string(argv[6]) == "generic";
    const auto device = open_device(argv[2]);
    keep(build_kernel(*device, static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10)), all_of_standard_input(), options));
    return built;
  } catch (const std::exception&) {
    return failed;   // who asked builds it too, and tells why that fails
  }
}

}  // namespace nicol
