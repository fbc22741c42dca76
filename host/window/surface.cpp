// See surface.hpp: what all surfaces share.
#include "host/window/surface.hpp"

#include <utility>

namespace nicol::window {

double Surface::logical_width() const {
  int width = 0, height = 0;
  framebuffer_size(width, height);
  return width / content_scale();
}

double Surface::logical_height() const {
  int width = 0, height = 0;
  framebuffer_size(width, height);
  return height / content_scale();
}

void Surface::push(Event event) {
  {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
  }
  wake();
}

std::optional<Event> Surface::next_event() {
  const std::lock_guard lock(mutex_);
  if (events_.empty()) return std::nullopt;
  Event event = std::move(events_.front());
  events_.pop_front();
  return event;
}

bool Surface::has_events() const {
  const std::lock_guard lock(mutex_);
  return !events_.empty();
}

}  // namespace nicol::window
