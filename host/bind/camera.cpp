// camera { } with POV-Ray's defaults and in its fixed order: angle, look_at, transforms, whatever
// the order of writing. Numbers measured on POV-Ray 3.7: `angle` of an orthographic camera shows as
// much as a perspective one would see at look_at (which is <0,0,1> unless said).
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

void apply_angle(RawCamera& raw) {
  if (!raw.angle_deg) return;
  const double half = radians(*raw.angle_deg / 2);
  const double width = length(raw.right);
  if (raw.orthographic) {
    const double shown = 2 * length(raw.look_at - raw.location) * std::tan(half);
    raw.right = raw.right * (shown / width);
    raw.up = raw.up * (shown / width);
  } else {
    raw.direction = normalize(raw.direction) * (width / 2 / std::tan(half));
  }
}

void apply_look_at(Context& context, RawCamera& raw, Location where) {
  if (!raw.has_look_at) return;
  const Vec3 towards = raw.look_at - raw.location;
  if (length(towards) == 0) {
    context.error(where, "Camera location and look_at point must be different.");
    return;
  }
  const bool mirrored = dot(cross(raw.up, raw.direction), raw.right) < 0;
  const double depth = length(raw.direction), width = length(raw.right), height = length(raw.up);
  const Vec3 ahead = normalize(towards);
  Vec3 right = cross(normalize(raw.sky), ahead);
  if (length(right) < 1e-10) {
    context.warning(where,
                    "Camera location to look_at direction and sky direction should be different. "
                    "Using default/supplied right vector instead.");
    right = mirrored ? -raw.right : raw.right;
  }
  right = normalize(right);
  raw.direction = ahead * depth;
  raw.up = normalize(cross(ahead, right)) * height;
  raw.right = right * (mirrored ? -width : width);
}

bool usable(Context& context, const RawCamera& raw, Location where) {
  const Vec3 n = cross(raw.right, raw.up);
  if (length(n) == 0 || length(raw.direction) == 0) {
    context.error(where,
                  "the camera's 'right', 'up' and 'direction' must not vanish or be parallel");
    return false;
  }
  if (std::abs(dot(normalize(n), normalize(raw.direction))) < 1e-9) {
    context.error(where, "the camera's 'direction' lies in its picture plane");
    return false;
  }
  const double skew = std::abs(dot(normalize(raw.right), normalize(raw.up)));
  if (skew > 1e-9)
    context.warning(where,
                    "Camera vectors are not perpendicular. Making look_at the last statement "
                    "may help.");
  return true;
}

// Only the default is told of: who writes `right` means it.
void tell_squeeze(Context& context, const RawCamera& raw, Location where) {
  if (raw.has_right) return;
  const double picture = static_cast<double>(context.options.width) / context.options.height;
  if (std::abs(picture / (4.0 / 3) - 1) > 0.01)
    context.note(where,
                 "the camera is 4/3 wide, as POV-Ray's default is, but the picture is not: "
                 "'right x*image_width/image_height' keeps circles round");
}

void store(Context& context, const RawCamera& raw, Location where) {
  const Affine world = to_world(context.scene.settings.mm_per_unit);
  Affines all = raw.transforms;
  all.push_back(world);
  Camera camera;
  camera.orthographic = raw.orthographic;
  camera.location = transform_point(all, raw.location);
  camera.direction = transform_direction(all, raw.direction);
  camera.right = transform_direction(all, raw.right);
  camera.up = transform_direction(all, raw.up);
  camera.where = where;
  if (camera.orthographic) camera.direction = normalize(camera.direction);
  if (raw.polarizer) {
    PolarizerPlane plane;
    plane.y = normalize(camera.up);
    plane.x = normalize(project(camera.right, plane.y));
    plane.axis_transforms = all;
    camera.polarizer = bind_polarizer(context, *raw.polarizer, plane);
  }
  context.scene.camera = camera;
}

}  // namespace

Schema camera_schema(Context& context, RawCamera& raw) {
  Context* c = &context;
  RawCamera* r = &raw;
  const auto type_unknown = [=](const Args& a) {
    r->has_other_type = true;
    c->error(a.where, "nicol has two cameras, 'perspective' and 'orthographic'");
  };
  Schema schema{
      "camera",
      {{"perspective", "", [=](const Args&) { r->orthographic = false; },
        "rays from one point (default)"},
       {"orthographic", "", [=](const Args&) { r->orthographic = true; }, "parallel rays"},
       {"location", "v", [=](const Args& a) { r->location = a.vectors[0]; }, "the eye (<0,0,0>)"},
       {"direction", "v", [=](const Args& a) { r->direction = a.vectors[0]; }, "ahead (<0,0,1>)"},
       {"right", "v",
        [=](const Args& a) {
          r->right = a.vectors[0];
          r->has_right = true;
        },
        "width of the picture at `direction` (4/3 x, whatever the picture's size)"},
       {"up", "v", [=](const Args& a) { r->up = a.vectors[0]; }, "its height (y)"},
       {"sky", "v", [=](const Args& a) { r->sky = a.vectors[0]; },
        "what `look_at` keeps upright (y)"},
       {"look_at", "v",
        [=](const Args& a) {
          r->look_at = a.vectors[0];
          r->has_look_at = true;
        },
        "turns the camera to this point"},
       {"angle", "n",
        [=](const Args& a) {
          if (r->has_other_type) return;
          if (a.numbers[0] >= 180)
            c->error(a.where, "Viewing angle has to be smaller than 180 degrees.");
          else if (a.numbers[0] <= 0)
            c->error(a.where, "Viewing angle has to be greater than 0 degrees.");
          else r->angle_deg = a.numbers[0];
        },
        "degrees across the width"},
       {"polarizer", "{}", [=](const Args& a) { r->polarizer = a.block; },
        "the analyzer; its x axis is the picture's right, its y axis the camera's up"}},
      {{"focal blur (%s) is not rendered: the camera is a pinhole",
        true,
        {"aperture", "blur_samples", "focal_point", "confidence", "variance", "bokeh"}},
       {"%s of a camera is not rendered", true, {"normal"}}}};
  for (const char* type :
       {"fisheye", "ultra_wide_angle", "omnimax", "panoramic", "spherical", "cylinder"})
    schema.rules.push_back({type, "*", type_unknown, "an error: nicol has the two above"});
  schema.rules.push_back({"mesh_camera", "{}", type_unknown, "likewise"});
  add_transform_rules(schema, raw.transforms, context);
  return schema;
}

void bind_camera(Context& context, const sdl::Block& block) {
  RawCamera raw;
  read_block(context, block, camera_schema(context, raw));
  if (length(raw.right) > 0) apply_angle(raw);
  apply_look_at(context, raw, block.where);
  if (!usable(context, raw, block.where)) return;
  tell_squeeze(context, raw, block.where);
  store(context, raw, block.where);
}

void default_camera(Context& context) {
  RawCamera raw;
  store(context, raw, {});
}

}  // namespace nicol
