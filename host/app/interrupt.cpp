// See interrupt.hpp. The handler calls only what POSIX lists as safe in a signal handler.
#include "host/app/interrupt.hpp"

#include <unistd.h>

#include <csignal>
#include <cstring>

#include "host/app/commands.hpp"
#include "host/output/atomic_file.hpp"

namespace nicol::app {
namespace {

std::atomic<bool> interrupted{false};
std::atomic<bool> something_to_save{false};
static_assert(std::atomic<bool>::is_always_lock_free, "the signal handler needs lock-free flags");

void tell(const char* message) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, message, std::strlen(message));
}

extern "C" void on_interrupt(int) {
  if (something_to_save && !interrupted.exchange(true)) {
    tell(
        "\nnicol: interrupted; the tiles in flight are finished and saved (once more quits at "
        "once)\n");
    return;
  }
  remove_unfinished_files();
  tell("\nnicol: interrupted, nothing saved\n");
  _exit(exit_interrupted);
}

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigemptyset(&action.sa_mask);
  sigaddset(&action.sa_mask, SIGINT);
  sigaddset(&action.sa_mask, SIGTERM);
  action.sa_flags = SA_RESTART;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  std::signal(SIGXFSZ,
              SIG_IGN);  // a limit on file sizes shall be an error of writing, told like any other
}

const std::atomic<bool>& interrupt_flag() { return interrupted; }

const std::atomic<bool>& finish_first() {
  something_to_save = true;
  return interrupted;
}

}  // namespace nicol::app
