// Ctrl-C and SIGTERM. At first they end the program with code 2 at once: there is nothing to save. From
// finish_first() on, the first one only raises the flag, so that what is in flight is finished and saved;
// a second one ends the program at once and removes the unfinished files.
#pragma once
#include <atomic>
#include <string>
#include <vector>

namespace nicol::app {

void catch_interrupts();
const std::atomic<bool>& finish_first(const std::vector<std::string>& unfinished_files);

}  // namespace nicol::app
