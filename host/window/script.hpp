// Commands in place of a person: one a line, words with spaces in "quotes", # for the rest of a line.
//
//   wait picture | done | rest | error | SECONDS   until every pane shows something; all is traced; kernels are built, too; a text has an error
//   key NAME        as preview::Action has it ("d", "shift+1")      do NAME        an action by its name ("reset")
//   move PLACE      press [BUTTON]     release [BUTTON]     click PLACE     drag PLACE PLACE [BUTTON]     scroll STEPS
//   size W H        of the window, where there is no display
//   set analyzer | polarizer | exposure | amplification | divider NUMBER     set wavelength NM | none     set left | right VIEW
//   replace FILE OLD NEW     in a text file     screenshot FILE.png | .exr     state     pixel left | right X Y     (JSON on standard output)
//   quit
//
// PLACE: X Y in the window's logical pixels; left X Y or right X Y: parts of the picture, 0..1 from its upper left corner; divider X: the
// divider's middle, or a part of the window's width in its height; widget NAME.
#pragma once
#include <iosfwd>
#include <memory>
#include <string>

#include "host/window/window.hpp"

namespace nicol::window {

// What the person did wrong, with the line.
struct ScriptError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Script {
 public:
  // offscreen: the surface, if it is one without a display; else null.
  Script(preview::Session& session, Surface& surface, OffscreenSurface* offscreen, ScreenOptions options);
  ~Script();

  // Until the text ends, or `quit`, or the window is closed. `answers` gets what commands print, and, if `interactive`, a line
  // "ok" or "error: ..." after each; else the first error is thrown as ScriptError.
  void run(std::istream& commands, std::ostream& answers, bool interactive);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace nicol::window
