// Complaints without repetition, and budgets: see context.hpp.
#include "host/bind/context.hpp"

#include <cstdio>

namespace nicol {

bool Context::is_new(Location where, const std::string& message) {
  if (!said_.emplace(where.file, where.line, where.column, where.call, message).second)
    return false;
  if (said_.size() <= limits.complaints) return true;
  diagnostics_.error(where, "more than " + std::to_string(limits.complaints) +
                                " complaints about this scene: the rest is not shown");
  ++error_count_;
  throw GiveUp{};
}

void Context::error(Location where, const std::string& message) {
  ++error_count_;
  if (is_new(where, message)) diagnostics_.error(where, message);
}

void Context::warning(Location where, const std::string& message) {
  if (is_new(where, message)) diagnostics_.warning(where, message);
}

void Context::note(Location where, const std::string& message) {
  if (is_new(where, message)) diagnostics_.note(where, message);
}

void Context::warn_once(const std::string& key, Location where, const std::string& message) {
  if (keys_.insert(key).second) warning(where, message);
}

void Context::note_once(const std::string& key, Location where, const std::string& message) {
  if (keys_.insert(key).second) note(where, message);
}

void Context::step(Location where, std::size_t count) {
  steps_ += count;
  if (steps_ <= limits.steps) return;
  error(where, "the scene is too large once every identifier is written out");
  throw GiveUp{};
}

Context::Depth::Depth(Context& context, Location where) : context_(context) {
  if (++context_.depth_ <= context_.limits.depth) return;
  --context_.depth_;
  context_.error(where, "blocks lie more than " + std::to_string(context_.limits.depth) +
                            " deep in each other");
  throw GiveUp{};
}

std::string to_text(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

}  // namespace nicol
