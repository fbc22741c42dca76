// polarizer { } on a camera, a light or a sheet. `angle` is the azimuth of the plane that passes,
// counted in the polarizer's plane from its x axis towards its y axis (parts.hpp: PolarizerPlane):
//   camera    x = the picture's right, y = the camera's up: counter-clockwise as the picture shows
//   it polygon   x = its first edge, y = across it, on the side of its last corner disc, face of a
//   solid   x = the shape's x axis put into the plane (its z axis, if x is the normal),
//                           y = counter-clockwise from x, seen from the outer side (where the
//                           normal points)
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// The axis put into the plane; an error if it stands (nearly) along the normal.
std::optional<Vec3> axis_in_plane(Context& context, const PolarizerPlane& plane, Vec3 normal,
                                  Vec3 axis, Location where) {
  const Vec3 world = normalize(transform_direction(plane.axis_transforms, axis));
  const Vec3 inside = project(world, normal);
  if (length(world) > 0 && length(inside) > 1e-9) return normalize(inside);
  context.error(where, "the polarizer's 'axis' stands along the normal of its plane");
  return std::nullopt;
}

bool fits_together(Context& context, const RawPolarizer& raw, Location where) {
  if (raw.angle_deg && raw.axis) {
    context.error(where, "a polarizer has an 'angle' or an 'axis', not both");
    return false;
  }
  if (!raw.angle_deg && !raw.axis) {
    context.error(where, "Expected 'angle' or 'axis' in 'polarizer'");
    return false;
  }
  if (raw.plugin && (raw.calcite || raw.absorbing)) {
    context.error(where, "a polarizer is a plugin's or one of nicol's, not both");
    return false;
  }
  if (raw.calcite && raw.absorbing) {
    context.error(where, "'projection' belongs to an ideal polarizer, not to calcite");
    return false;
  }
  return true;
}

Polarizer::Kind kind_of(const RawPolarizer& raw) {
  if (raw.plugin) return Polarizer::Kind::fragment;
  if (raw.calcite) return Polarizer::Kind::calcite;
  return raw.absorbing ? Polarizer::Kind::ideal_absorbing : Polarizer::Kind::ideal;
}

}  // namespace

Schema polarizer_schema(Context& context, RawPolarizer& raw) {
  Context* c = &context;
  RawPolarizer* r = &raw;
  return {
      "polarizer",
      {{"ideal", "", [=](const Args&) { r->calcite = false; }, "passes a projection (default)"},
       {"calcite", "", [=](const Args&) { r->calcite = true; },
        "the founding paper's plate: ordinary ray only, Fresnel at both faces"},
       {"angle", "n", [=](const Args& a) { r->angle_deg = a.numbers[0]; },
        "degrees, azimuth of the plane that passes"},
       {"axis", "v", [=](const Args& a) { r->axis = a.vectors[0]; },
        "instead: the direction that passes, put into the plane"},
       {"projection", "w",
        [=](const Args& a) {
          if (a.text == "absorption") r->absorbing = true;
          else if (a.text == "transmission") r->absorbing = false;
          else
            c->error(a.where,
                     "Expected 'transmission' or 'absorption', '" + a.text + "' found instead");
        },
        "`transmission` (default) or `absorption`: which axis is projected across an oblique ray"},
       {"index_o", "{}", [=](const Args& a) { bind_index(*c, "index_o", *a.block, r->index_o); },
        "calcite: ordinary index (Ghosh 1999)"},
       {"index_e", "{}", [=](const Args& a) { bind_index(*c, "index_e", *a.block, r->index_e); },
        "calcite: extraordinary index (Ghosh 1999)"},
       {"plugin", "{}", [=](const Args& a) { r->plugin = a.block; },
        "\"NAME\" parameter value ...: Jones matrices of a plugin's fragment; `angle` is that of its x axis"}},
      {}};
}

std::optional<int> bind_polarizer(Context& context, const sdl::Block& block,
                                  const PolarizerPlane& plane) {
  RawPolarizer raw;
  read_block(context, block, polarizer_schema(context, raw));
  if (!fits_together(context, raw, block.where)) return std::nullopt;
  Polarizer p;
  p.kind = kind_of(raw);
  p.where = block.where;
  p.normal = normalize(cross(plane.x, plane.y));
  if (raw.axis) {
    const auto axis = axis_in_plane(context, plane, p.normal, *raw.axis, block.where);
    if (!axis) return std::nullopt;
    p.transmission_axis = *axis;
  } else {
    p.transmission_axis = plane.x * cos_deg(*raw.angle_deg) + plane.y * sin_deg(*raw.angle_deg);
  }
  if (raw.plugin) {
    const auto use = bind_fragment(context, *raw.plugin, Fragment::Kind::element);
    if (!use) return std::nullopt;
    p.fragment = *use;
  }
  if (raw.calcite) {
    p.n_o = sample_index(context, raw.index_o, block.where, "'index_o' of the polarizer");
    p.n_e = sample_index(context, raw.index_e, block.where, "'index_e' of the polarizer");
  }
  context.scene.polarizers.push_back(std::move(p));
  return static_cast<int>(context.scene.polarizers.size()) - 1;
}

PolarizerPlane plane_of_face(Vec3 normal, const Affines& transforms) {
  const Vec3 n = normalize(transform_normal(transforms, normal));
  Vec3 x = project(normalize(transform_direction(transforms, {1, 0, 0})), n);
  if (length(x) < 1e-9) x = project(normalize(transform_direction(transforms, {0, 0, 1})), n);
  PolarizerPlane plane;
  plane.x = normalize(x);
  plane.y = normalize(cross(n, plane.x));
  plane.axis_transforms = transforms;
  return plane;
}

PolarizerPlane plane_of_polygon(const std::vector<Vec3>& corners, const Affines& transforms) {
  const auto world = [&](std::size_t i) { return transform_point(transforms, corners[i]); };
  const Vec3 first = world(0);
  PolarizerPlane plane;
  plane.x = normalize(world(1) - first);
  plane.axis_transforms = transforms;
  // The last corner may lie on the line of the first edge: then the one before it tells the side.
  for (std::size_t i = corners.size(); i-- > 2;) {
    const Vec3 aside = project(world(i) - first, plane.x);
    if (length(aside) <= 1e-9 * length(world(i) - first)) continue;
    plane.y = normalize(aside);
    break;
  }
  return plane;
}

}  // namespace nicol
