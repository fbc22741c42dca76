// Random trees: volumes obey the laws of sets exactly, surfaces close, seams match.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "csg_shapes.hpp"

using namespace nicol;
using namespace nicol::test;

namespace {

// Small whole numbers, so that planes, edges and corners often coincide.
double step() { return *rc::gen::inRange(-2, 3); }

CsgNode random_box() {
  const Vec3 low{step(), step(), step()};
  const auto size = [] { return static_cast<double>(*rc::gen::inRange(1, 4)); };
  return csg_box(low, low + Vec3{size(), size(), size()});
}

CsgNode random_solid() {
  const int kind = *rc::gen::inRange(0, 4);
  if (kind == 0) return octahedron({step(), step(), step()}, *rc::gen::inRange(1, 4));
  if (kind == 1) {
    const double x = step(), y = step(), z = step();
    return csg_leaf(PrismShape{
        {{{x, z}, {x + 3, z}, {x + 3, z + 1}, {x + 1, z + 1}, {x + 1, z + 3}, {x, z + 3}}}, y, y + 2});
  }
  CsgNode box = random_box();
  if (kind == 2) box.transforms = {rotate_x(17 * step()), rotate_y(23 * step())};
  return box;
}

std::vector<Affine> random_place() {
  return {rotate_x(20.0 * step()), rotate_y(35.0 * step()), translate(step(), 0.1 * step(), 7)};
}

}  // namespace

TEST_CASE("random pairs: V(A - B) + V(A B) = V(A), V(A + B) = V(A) + V(B) - V(A B), exactly") {
  const bool ok = rc::check([] {
    const CsgNode a = random_solid(), b = random_solid();
    const std::vector<Affine> moves = random_place();
    const mpq_class of_a = volume_of(a, moves), of_b = volume_of(b, moves);
    const mpq_class shared = volume_of(intersected({a, b}), moves);
    RC_ASSERT(of_a > 0);
    RC_ASSERT(volume_of(differing({a, b}), moves) + shared == of_a);
    RC_ASSERT(volume_of(differing({b, a}), moves) + shared == of_b);
    RC_ASSERT(volume_of(merged({a, b}), moves) == of_a + of_b - shared);
    RC_ASSERT(volume_of(merged({b, a}), moves) == of_a + of_b - shared);
    RC_ASSERT(volume_of(intersected({a, inverse(b)}), moves) + shared == of_a);
  });
  CHECK(ok);
}

TEST_CASE("random triples: inclusion and exclusion, distribution, De Morgan, exactly") {
  const bool ok = rc::check([] {
    const CsgNode a = random_solid(), b = random_solid(), c = random_solid();
    const auto v = [](const CsgNode& node) { return volume_of(node); };
    const auto shared = [&](std::vector<CsgNode> nodes) { return v(intersected(std::move(nodes))); };
    RC_ASSERT(v(merged({a, b, c})) == v(a) + v(b) + v(c) - shared({a, b}) - shared({b, c}) -
                                          shared({c, a}) + shared({a, b, c}));
    RC_ASSERT(v(differing({a, b, c})) == v(differing({a, merged({b, c})})));
    RC_ASSERT(v(intersected({a, merged({b, c})})) ==
              v(merged({intersected({a, b}), intersected({a, c})})));
    RC_ASSERT(v(differing({a, intersected({b, c})})) ==
              v(merged({differing({a, b}), differing({a, c})})));
    RC_ASSERT(v(inverse(merged({inverse(a), inverse(b)}))) == shared({a, b}));
  });
  CHECK(ok);
}

TEST_CASE("random trees: cells are closed, seams have their twins, the surface closes") {
  const bool ok = rc::check([] {
    const CsgNode a = random_solid(), b = random_solid(), c = random_solid();
    const int kind = *rc::gen::inRange(0, 3);
    const CsgNode tree = kind == 0   ? merged({a, b, c})
                         : kind == 1 ? differing({merged({a, b}), c})
                                     : differing({a, b, c});
    const Built built = built_csg(tree, random_place());
    if (built.failed) {
      RC_ASSERT(built.says("encloses nothing"));
      return;
    }
    const Geometry& geometry = built.geometry;
    RC_ASSERT(fault_in_seams(geometry) == "");
    const Vec3 closed = outer_area_vector(geometry);
    RC_ASSERT(std::sqrt(dot(closed, closed)) < 1e-11 * outer_area(geometry));
    for (std::size_t i = 1; i < geometry.cells.size(); ++i)
      RC_ASSERT(counts(geometry, geometry.cells[i]).closed);
  });
  CHECK(ok);
}

TEST_CASE("no area is lost: each piece of a face of A or B lies on two of A - B, B - A, A + B, A B") {
  // On A - B and A B, or B - A and A + B: one of each pair. No faces coincide here.
  const bool ok = rc::check([] {
    const auto shifted = [](CsgNode node) {
      node.transforms.push_back(translate(0.31, 0.17, 0.23));
      node.transforms.push_back(rotate_x(7));
      return node;
    };
    const CsgNode a = random_solid(), b = shifted(random_solid());
    const auto area_of = [](const CsgNode& node) {
      const Built built = built_csg(node);
      return built.failed ? 0.0 : outer_area(built.geometry);
    };
    const double split = area_of(differing({a, b})) + area_of(differing({b, a}));
    const double whole = area_of(merged({a, b})) + area_of(intersected({a, b}));
    const double plain = area_of(a) + area_of(b);
    RC_ASSERT(std::abs(whole - plain) < 1e-11 * plain);
    RC_ASSERT(std::abs(split - plain) < 1e-11 * plain);
  });
  CHECK(ok);
}
