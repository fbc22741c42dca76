// polygon, disc and prism: lists of points become contours, each closed by repeating its first
// point.
#include <algorithm>

#include "host/bind/parts.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

bool same(const Vec3& a, const Vec3& b) { return a.x == b.x && a.y == b.y && a.z == b.z; }
bool same(const std::array<double, 2>& a, const std::array<double, 2>& b) { return a == b; }

template <class Point>
std::vector<std::vector<Point>> contours(Context& context, Location where, const char* name,
                                         double stated, const std::vector<Point>& points) {
  std::vector<std::vector<Point>> result;
  if (stated != static_cast<double>(points.size())) {
    context.error(where, std::string("this ") + name + " announces " + to_text(stated) +
                             " points, " + std::to_string(points.size()) + " found instead");
    return result;
  }
  std::vector<Point> open;
  for (const Point& p : points) {
    if (!open.empty() && same(p, open.front())) {
      result.push_back(std::move(open));
      open.clear();
    } else {
      open.push_back(p);
    }
  }
  if (!open.empty()) {
    context.warning(where, std::string(name) + " not closed. Closing it.");
    result.push_back(std::move(open));
  }
  for (const auto& contour : result) {
    if (contour.size() >= 3) continue;
    context.error(where, std::string(name) + " needs at least three points.");
    return {};
  }
  return result;
}

}  // namespace

std::optional<PolygonShape> polygon_shape(Context& context, const RawObject& raw) {
  if (raw.vectors.empty()) return std::nullopt;
  PolygonShape shape{contours(context, raw.block->where, "Polygon", raw.numbers[0], raw.vectors)};
  if (shape.contours.empty()) return std::nullopt;
  return shape;
}

std::optional<DiscShape> disc_shape(Context& context, const RawObject& raw) {
  if (raw.vectors.size() != 2) return std::nullopt;
  DiscShape shape{raw.vectors[0], raw.vectors[1], raw.numbers[0],
                  raw.numbers.size() > 1 ? raw.numbers[1] : 0};
  const Location where = raw.block->where;
  const std::size_t errors_before = context.error_count();
  if (raw.numbers.size() > 2)
    context.error(where, "a disc has one radius and perhaps one hole, " +
                             std::to_string(raw.numbers.size()) + " numbers found instead");
  if (length(shape.normal) == 0) context.error(where, "Degenerate disc normal.");
  if (!(shape.radius > 0)) context.error(where, "the radius of a disc must be greater than 0");
  if (shape.hole_radius < 0 || shape.hole_radius >= shape.radius)
    context.error(where, "the hole of a disc must be smaller than the disc");
  if (context.error_count() != errors_before) return std::nullopt;
  return shape;
}

std::optional<PrismShape> prism_shape(Context& context, const RawObject& raw) {
  if (raw.points.empty()) return std::nullopt;
  PrismShape shape{contours(context, raw.block->where, "Linear prism", raw.numbers[2], raw.points),
                   std::min(raw.numbers[0], raw.numbers[1]),
                   std::max(raw.numbers[0], raw.numbers[1])};
  if (shape.contours.empty()) return std::nullopt;
  return shape;
}

}  // namespace nicol
