#include "host/opencl/builder_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <vector>

namespace nicol {
namespace {

constexpr const char* build_switch = "--build-kernel";
constexpr int built = 0, failed = 1;

std::atomic<bool> serves{false};

// The program's own file, while it runs.
constexpr const char* this_program = "/proc/self/exe";

// Its end: the code, or `failed` if it was killed.
int wait_for(pid_t process) {
  int status = 0;
  while (::waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return failed;
  return WIFEXITED(status) ? WEXITSTATUS(status) : failed;
}

// Nothing of what it writes is wanted.
int run_silently(std::vector<std::string> arguments) {
  std::vector<char*> argv;
  for (std::string& argument : arguments) argv.push_back(argument.data());
  argv.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  for (int descriptor : {STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&actions, descriptor, "/dev/null", O_WRONLY, 0);
  pid_t process = 0;
  const bool started = ::posix_spawn(&process, this_program, &actions, nullptr, argv.data(), environ) == 0;
  posix_spawn_file_actions_destroy(&actions);
  return started ? wait_for(process) : failed;
}

}  // namespace

bool build_in_own_process(const Device& device, std::uint32_t features, const KernelOptions& options) {
  if (!serves) return false;
  return run_silently({"nicol", build_switch, std::to_string(info(device).index), std::to_string(features),
                       std::to_string(options.lanes), options.real_double ? "double" : "float",
                       options.generic ? "generic" : "specialised"}) == built;
}

std::optional<int> serve_as_builder(int argc, const char* const* argv) {
  serves = true;
  if (argc != 7 || std::string(argv[1]) != build_switch) return std::nullopt;
  try {
    KernelOptions options;
    options.lanes = std::atoi(argv[4]);
    options.real_double = std::string(argv[5]) == "double";
    options.generic = std::string(argv[6]) == "generic";
    prepare_kernel(*open_device(argv[2]), static_cast<std::uint32_t>(std::strtoul(argv[3], nullptr, 10)), options);
    return built;
  } catch (const std::exception&) {
    return failed;   // who asked builds it too, and tells why that fails
  }
}

}  // namespace nicol
