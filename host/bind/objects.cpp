// Objects: unions and instances are written out, each solid and sheet gets its transforms, its
// medium, its polarizer and its light.
#include <algorithm>

#include "host/bind/crystal.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// The objects around the one at hand, innermost first: they lend what it does not say itself.
struct Chain {
  const RawObject* raw;
  const Chain* outer;
};

template <class Member>
auto nearest(const Chain* chain, Member member) -> decltype(chain->raw->*member) {
  for (; chain->outer; chain = chain->outer)
    if (!(chain->raw->*member == std::decay_t<decltype(chain->raw->*member)>{})) break;
  return chain->raw->*member;
}

// In POV-Ray's space: the object's own, then those around it.
Affines transforms_of(const Chain* chain) {
  Affines all;
  for (; chain; chain = chain->outer)
    all.insert(all.end(), chain->raw->transforms.begin(), chain->raw->transforms.end());
  return all;
}

Affines all_transforms(Context& context, const Chain* chain) {
  const RawObject& leaf = *chain->raw;
  Affines all = transforms_of(chain);
  const Affines frame = shape_frame(leaf);
  all.insert(all.begin(), frame.begin(), frame.end());
  all.push_back(to_world(context.scene.settings.mm_per_unit));
  context.transform_count += all.size();
  if (context.transform_count > context.limits.transforms) {
    context.error(leaf.block->where, "more than " + std::to_string(context.limits.transforms) +
                                         " transforms once every object is written out");
    throw GiveUp{};
  }
  return all;
}

// One emission; the polarizer, if any, lies in `plane`.
int add_emission(Context& context, const sdl::Block& block, const RawLuminous& raw,
                 const PolarizerPlane& plane) {
  Emission e;
  e.where = block.where;
  e.one_sided = raw.one_sided;
  e.radiance = bind_spectrum(context, raw.spectrum, block.where);
  if (raw.polarizer) e.polarizer = bind_polarizer(context, *raw.polarizer, plane);
  context.scene.emissions.push_back(std::move(e));
  return static_cast<int>(context.scene.emissions.size()) - 1;
}

bool nothing_vanishes(Context& context, const PolarizerPlane& plane, Location where) {
  if (length(plane.x) > 0 && length(plane.y) > 0) return true;
  context.error(where, "the corners of this polygon lie on a line");
  return false;
}

// ---- sheets ----

void fill_sheet(Context& context, const Chain* chain, const PolarizerPlane& plane, Object& object) {
  const Location where = object.where;
  if (!nearest(chain, &RawObject::surfaces).empty())
    context.error(where, "'surface' is worn by the faces of a solid, not by a " + object.kind);
  const auto& lights = nearest(chain, &RawObject::lights);
  const sdl::Block* polarizer = nearest(chain, &RawObject::polarizer);
  if (lights.empty() == (polarizer == nullptr)) {
    context.error(where,
                  lights.empty()
                      ? "this " + object.kind +
                            " neither shines ('luminous { }') nor "
                            "polarizes ('polarizer { }'); nicol does not render opaque surfaces"
                      : "a light's polarizer is written inside 'luminous { }'");
    return;
  }
  if (polarizer) {
    object.polarizer = bind_polarizer(context, *polarizer, plane);
    return;
  }
  RawLuminous raw;
  read_block(context, *lights.back(), luminous_schema(context, raw));
  if (raw.face)
    context.error(lights.back()->where, "'face' names a face of a solid, not of a " + object.kind);
  object.emission = add_emission(context, *lights.back(), raw, plane);
}

void add_polygon(Context& context, const Chain* chain, Object& object) {
  const auto shape = polygon_shape(context, *chain->raw);
  if (!shape) return;
  const PolarizerPlane plane = plane_of_polygon(shape->contours[0], object.transforms);
  if (nothing_vanishes(context, plane, object.where)) fill_sheet(context, chain, plane, object);
  object.shape = *shape;
  context.scene.objects.push_back(std::move(object));
}

void add_disc(Context& context, const Chain* chain, Object& object) {
  const auto shape = disc_shape(context, *chain->raw);
  if (!shape) return;
  fill_sheet(context, chain, plane_of_face(shape->normal, object.transforms), object);
  object.shape = *shape;
  context.scene.objects.push_back(std::move(object));
}

// ---- solids ----

// The face whose outward normal is nearest to `towards`; nothing if two are as near.
std::optional<int> nearest_face(const ConvexShape& shape, Vec3 towards) {
  int best = -1;
  double best_cos = -2, second_cos = -2;
  for (std::size_t i = 0; i < shape.faces.size(); ++i) {
    const double cos_angle = dot(normalize(shape.faces[i].normal), normalize(towards));
    if (cos_angle > best_cos) {
      second_cos = best_cos;
      best_cos = cos_angle;
      best = static_cast<int>(i);
    } else {
      second_cos = std::max(second_cos, cos_angle);
    }
  }
  if (best < 0 || best_cos <= 0 || best_cos - second_cos < 1e-9) return std::nullopt;
  return best;
}

void add_face_light(Context& context, const sdl::Block& block, const RawLuminous& raw, int face,
                    const ConvexShape& shape, Object& object) {
  for (const FaceEmission& other : object.face_emissions)
    if (other.face == face) context.error(block.where, "this face shines already");
  const PolarizerPlane plane = plane_of_face(shape.faces[face].normal, object.transforms);
  object.face_emissions.push_back({face, add_emission(context, block, raw, plane)});
}

void add_face_lights(Context& context, const Chain* chain, const ConvexShape& shape,
                     Object& object) {
  for (const sdl::Block* block : nearest(chain, &RawObject::lights)) {
    RawLuminous raw;
    read_block(context, *block, luminous_schema(context, raw));
    if (!raw.face) {
      for (std::size_t i = 0; i < shape.faces.size(); ++i)
        add_face_light(context, *block, raw, static_cast<int>(i), shape, object);
    } else if (const auto face = nearest_face(shape, *raw.face)) {
      add_face_light(context, *block, raw, *face, shape, object);
    } else {
      context.error(block->where,
                    "'face' is as near to two faces, or to none: name one by its outward normal");
    }
  }
}

// A later surface takes the place of an earlier one; that it hides the earlier one wholly is seldom meant.
void put_surface(Context& context, const sdl::Block& block, FaceSurface surface, Object& object) {
  for (const FaceSurface& before : object.face_surfaces)
    if (surface.face < 0 || surface.face == before.face)
      context.warning(block.where, surface.face < 0 ? "This surface is worn by all faces: those before it are not seen"
                                                    : "Two surfaces for the same face: the last one is worn");
  object.face_surfaces.push_back(surface);
}

// Surfaces of plugins; `shape`: null if single faces cannot be named.
void add_surfaces(Context& context, const Chain* chain, const ConvexShape* shape, Object& object) {
  for (const sdl::Block* block : nearest(chain, &RawObject::surfaces)) {
    RawSurface raw;
    const auto use = bind_surface(context, *block, raw);
    if (!use) continue;
    if (!raw.face) {
      put_surface(context, *block, {-1, *use}, object);
    } else if (!shape) {
      context.error(block->where,
                    "'face' names a face of a convex solid; this surface is worn by all faces "
                    "or none");
    } else if (const auto face = nearest_face(*shape, *raw.face)) {
      put_surface(context, *block, {*face, *use}, object);
    } else {
      context.error(block->where,
                    "'face' is as near to two faces, or to none: name one by its outward normal");
    }
  }
}

void tell_mirror(Context& context, const Chain* chain, const Object& object) {
  if (!object.medium) return;
  const Medium& medium = context.scene.media[*object.medium];
  const Samples& rotation = medium.rotation_deg_per_mm;
  const bool turns = medium.is_active() || std::any_of(rotation.begin(), rotation.end(),
                                                       [](double a) { return a != 0; });
  double sign = 1;
  for (const Chain* c = chain; c; c = c->outer) sign *= determinant_sign(c->raw->transforms);
  if (sign < 0 && (turns || object.kind == "crystal"))
    context.warn_once("mirror", object.where,
                      "transforms mirror this " + object.kind +
                          ", but not its medium: the rotation of "
                          "the plane of polarization keeps its sense ('left' changes it)");
}

void fill_solid(Context& context, const Chain* chain, bool shines_all_over, Object& object) {
  if (const sdl::Block* interior = nearest(chain, &RawObject::interior)) {
    object.medium = bind_medium(context, *interior,
                                orientation_of(transforms_of(chain), chain->raw->crystal_frame));
  } else if (shines_all_over) {
    object.medium = 0;  // nothing sees its inside
  } else {
    context.error(object.where, object.kind +
                                    " has no interior with an index; nicol renders "
                                    "transparent crystals, polarizers and lights");
  }
  if (nearest(chain, &RawObject::polarizer))
    context.error(object.where,
                  "a solid does not polarize: lay a polygon or disc with 'polarizer { }' "
                  "on its face, or write the polarizer inside 'luminous { }'");
  tell_mirror(context, chain, object);
}

void add_csg(Context& context, const Chain* chain, Object& object) {
  auto shape = csg_shape(context, *chain->raw);
  if (!shape) return;
  if (!nearest(chain, &RawObject::lights).empty())
    context.error(object.where, "faces of a solid that is not convex cannot shine; lay a luminous "
                                "polygon on them");
  fill_solid(context, chain, false, object);
  add_surfaces(context, chain, nullptr, object);
  object.shape = std::move(*shape);
  context.scene.objects.push_back(std::move(object));
}

void add_convex(Context& context, const Chain* chain, Object& object) {
  const auto shape = convex_shape(context, *chain->raw);
  if (!shape) return;
  add_face_lights(context, chain, *shape, object);
  fill_solid(context, chain, object.face_emissions.size() == shape->faces.size(), object);
  add_surfaces(context, chain, &*shape, object);
  object.shape = *shape;
  context.scene.objects.push_back(std::move(object));
}

// Individuals are crystals of their own, in optical contact.
void add_twin(Context& context, const Chain* chain, const Object& object) {
  for (const RawIndividual& individual : chain->raw->individuals) {
    RawObject alone = *chain->raw;
    alone.individuals.clear();
    alone.facets = individual.faces;
    alone.crystal_frame = individual.frame;
    const Chain link{&alone, chain->outer};
    Object part = object;
    part.optical_contact = true;
    if (individual.without.empty()) {
      add_convex(context, &link, part);
      continue;
    }
    if (!check_closed(context, alone)) continue;
    fill_solid(context, &link, false, part);
    part.shape = protruding(individual, object.where);
    context.scene.objects.push_back(std::move(part));
  }
}

void add_prism(Context& context, const Chain* chain, Object& object) {
  const auto shape = prism_shape(context, *chain->raw);
  if (!shape) return;
  if (!nearest(chain, &RawObject::lights).empty())
    context.error(object.where, "faces of a prism cannot shine; lay a luminous polygon on them");
  fill_solid(context, chain, false, object);
  add_surfaces(context, chain, nullptr, object);
  object.shape = *shape;
  context.scene.objects.push_back(std::move(object));
}

void add_mesh(Context& context, const Chain* chain, Object& object) {
  const RawObject& raw = *chain->raw;
  if (raw.inverse)
    return context.error(object.where, "an inverse solid fills all of space; inside an intersection it cuts");
  const auto convex = planes_of_convex(*raw.mesh);
  if (convex) add_face_lights(context, chain, *convex, object);
  else if (!nearest(chain, &RawObject::lights).empty())
    context.error(object.where, "faces of a solid that is not convex cannot shine; lay a luminous polygon on them");
  fill_solid(context, chain, object.face_emissions.size() == raw.mesh->faces.size(), object);
  add_surfaces(context, chain, convex ? &*convex : nullptr, object);
  object.shape = *raw.mesh;
  context.scene.objects.push_back(std::move(object));
}

void add_leaf(Context& context, const Chain* chain) {
  const RawObject& raw = *chain->raw;
  if (context.scene.objects.size() >= context.limits.objects) {
    context.error(raw.block->where, "more than " + std::to_string(context.limits.objects) +
                                        " objects once every union and instance is written out");
    throw GiveUp{};
  }
  Object object;
  object.kind = raw.block->name;
  object.where = raw.block->where;
  object.transforms = all_transforms(context, chain);
  object.optical_contact = nearest(chain, &RawObject::optical_contact);
  if (object.kind == "polygon") return add_polygon(context, chain, object);
  if (object.kind == "disc") return add_disc(context, chain, object);
  if (object.kind == "prism") return add_prism(context, chain, object);
  if (object.kind == "plane") {
    context.error(object.where,
                  "a plane alone is infinite, and nothing of it can be rendered; cut a solid "
                  "from planes with 'intersection', or use 'polygon' or 'disc'");
    return;
  }
  if (!raw.told.empty()) object.kind = raw.told;
  if (raw.mesh) return add_mesh(context, chain, object);
  if (!raw.individuals.empty()) return add_twin(context, chain, object);
  if (half_space_count(context, raw)) return add_convex(context, chain, object);
  add_csg(context, chain, object);
}

void add_object(Context& context, const sdl::Block& block, const Chain* outer) {
  const Context::Depth depth(context, block.where);
  const RawObject& raw = read_object(context, block);
  const Chain chain{&raw, outer};
  const bool cut =
      block.name == "intersection" || block.name == "difference" || block.name == "merge";
  if (block.name == "union" || (!raw.children.empty() && !cut)) {
    if (block.name != "union" && raw.children.size() > 1)
      context.error(block.where, "'" + block.name + "' holds more than one object; 'union' may");
    for (const sdl::Block* child : raw.children) add_object(context, *child, &chain);
  } else if (block.name == "object") {
    if (raw.sound) context.error(block.where, "Expected an object in 'object', } found instead");
  } else if (raw.sound) {
    add_leaf(context, &chain);
  } else if (const sdl::Block* interior = nearest(&chain, &RawObject::interior)) {
    bind_medium(context, *interior, {});  // the errors of its medium are told as well
  }
}

}  // namespace

void bind_object(Context& context, const sdl::Block& block) { add_object(context, block, nullptr); }

}  // namespace nicol
