// Looking into a tree, and comparing two.
#include "tree.hpp"

#include <cmath>

namespace nicol::sdl {

const std::string* Item::word() const {
  const auto* w = std::get_if<Word>(&value);
  return w ? &w->text : nullptr;
}
const double* Item::number() const { return std::get_if<double>(&value); }
const Vector* Item::vector() const { return std::get_if<Vector>(&value); }
const std::string* Item::string() const { return std::get_if<std::string>(&value); }
const Block* Item::block() const {
  const auto* b = std::get_if<BlockPtr>(&value);
  return b ? b->get() : nullptr;
}

namespace {

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

bool same(const Vector& a, const Vector& b) {
  if (a.size != b.size || a.colour != b.colour) return false;
  for (int i = 0; i < a.size; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!same(a.v[k], b.v[k])) return false;
  }
  return true;
}

bool same(const std::vector<Item>& a, const std::vector<Item>& b);

bool same(const Item& a, const Item& b) {
  if (a.value.index() != b.value.index()) return false;
  if (a.word()) return *a.word() == *b.word();
  if (a.number()) return same(*a.number(), *b.number());
  if (a.vector()) return same(*a.vector(), *b.vector());
  if (a.string()) return *a.string() == *b.string();
  const Block *p = a.block(), *q = b.block();
  return p == q || (p && q && p->name == q->name && same(p->items, q->items));
}

bool same(const std::vector<Item>& a, const std::vector<Item>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}

}  // namespace

bool equal(const Document& a, const Document& b) { return same(a.items, b.items); }

}  // namespace nicol::sdl
