// solid { plugin { } }: a solid whose planes or mesh a plugin brings.
#include "host/bind/parts.hpp"
#include "host/bind/plugin_values.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// Of a polygon that is nearly flat, twice its area long (Newell's method).
Vec3 area_normal(const MeshShape& mesh, const std::vector<int>& face) {
  Vec3 sum;
  for (std::size_t i = 0; i < face.size(); ++i)
    sum = sum + cross(mesh.points[face[i]] - mesh.points[face[0]], mesh.points[face[(i + 1) % face.size()]] - mesh.points[face[0]]);
  return sum;
}

bool corners_are_there(const MeshShape& mesh) {
  for (const auto& face : mesh.faces)
    for (int corner : face)
      if (corner < 0 || corner >= static_cast<int>(mesh.points.size()) || face.size() < 3) return false;
  return !mesh.faces.empty();
}

}  // namespace

void add_solid_rules(Context& context, RawObject& raw, Schema& schema) {
  Context* c = &context;
  RawObject* r = &raw;
  schema.rules.push_back({"plugin", "{}",
                          [=](const Args& a) {
                            r->facets.clear();
                            r->mesh = nullptr;
                            auto made = plugin_solid(*c, *a.block);
                            if (!made) return;
                            r->told = std::move(made->told);
                            if (auto* planes = std::get_if<ConvexShape>(&made->shape)) r->facets = std::move(planes->faces);
                            else r->mesh = std::make_shared<MeshShape>(std::move(std::get<MeshShape>(made->shape)));
                          },
                          "`\"NAME\" parameter value ...`: planes or a closed mesh that a plugin brings"});
}

std::optional<ConvexShape> planes_of_convex(const MeshShape& mesh) {
  constexpr double on_plane = 1e-9;  // of the mesh's size, as host/solids has it
  if (!corners_are_there(mesh)) return std::nullopt;
  double size = 0;
  for (const Vec3& p : mesh.points) size = std::max(size, length(p - mesh.points[0]));
  ConvexShape shape;
  for (const auto& face : mesh.faces) {
    const Vec3 normal = normalize(area_normal(mesh, face));
    const HalfSpace plane{normal, dot(normal, mesh.points[face[0]])};
    for (const Vec3& p : mesh.points)
      if (!(dot(normal, p) - plane.offset <= 2 * on_plane * size)) return std::nullopt;
    shape.faces.push_back(plane);
  }
  return shape;
}

}  // namespace nicol
