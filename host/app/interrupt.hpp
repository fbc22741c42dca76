// Ctrl-C and SIGTERM. At first they end the program with code 2 at once: there is nothing to save.
// From finish_first() on, the first one only raises the flag, so that what is in flight is finished
// and saved; a second one ends the program at once. Unfinished files are removed either way.
#pragma once
#include <atomic>

namespace nicol::app {

void catch_interrupts();
const std::atomic<bool>& interrupt_flag();
const std::atomic<bool>& finish_first();   // gives the flag, too

}  // namespace nicol::app
