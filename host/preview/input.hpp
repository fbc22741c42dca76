// What the mouse and the keys do. The window translates its events to these; scripts make them.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "host/preview/layout.hpp"

namespace nicol::preview {

enum class Button { left, middle, right };

// Drags in the pictures: left orbits, middle or right (or Shift + left) pans, the wheel zooms, at the divider it moves the
// divider. A left click without a drag (of more than 3 pixels) pins the pixel; another on the same one lets go.
class Mouse {
 public:
  explicit Mouse(Controls& controls) : controls_(controls) {}
  void move(const Layout& layout, Point to);
  void press(const Layout& layout, Button button, bool shift);
  void release(const Layout& layout, Button button);
  void scroll(const Layout& layout, double steps);   // > 0: nearer, towards the pixel under the mouse
  bool dragging() const { return drag_ != Drag::none; }
  bool over_divider(const Layout& layout) const { return drag_ == Drag::divider || layout.divider.holds(at_); }
  Point at() const { return at_; }

 private:
  enum class Drag { none, orbit, pan, divider };
  Controls& controls_;
  Point at_, pressed_at_;
  Drag drag_ = Drag::none;
  Button button_ = Button::left;
  bool moved_ = false;
};

}  // namespace nicol::preview
