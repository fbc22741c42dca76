// optic_frame { }: where the principal axes alpha, beta, gamma lie in a biaxial crystal, in the
// crystal's right-handed Cartesian axes X, Y, Z; and how they turn with the wavelength in monoclinic
// and triclinic ones. Test: tests/bind/crystal_medium_test.cpp.
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

// Sine of the largest error of a right angle: directions are made perpendicular, but not corrected.
constexpr double squareness = 1e-6;

const char* const names[] = {"alpha", "beta", "gamma"};

bool all_square(Context& context, const RawOpticFrame& raw) {
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    if (!raw.axis[i] || !raw.axis[j]) continue;
    const double cos_angle = dot(normalize(*raw.axis[i]), normalize(*raw.axis[j]));
    if (std::abs(cos_angle) <= squareness) continue;
    context.error(raw.where, std::string("'") + names[i] + "' and '" + names[j] +
                                 "' must be perpendicular (the cosine between them is " +
                                 to_text(cos_angle) + ", 1e-6 is let pass)");
    return false;
  }
  return true;
}

// The missing axis from the two others, then all three made square, right-handed.
OpticFrame completed(const RawOpticFrame& raw, bool& left_handed) {
  std::array<Vec3, 3> a;
  int missing = 2;
  for (int i = 0; i < 3; ++i) {
    if (raw.axis[i]) a[i] = normalize(*raw.axis[i]);
    else missing = i;
  }
  const bool all = raw.axis[0] && raw.axis[1] && raw.axis[2];
  const int i = (missing + 1) % 3, j = (missing + 2) % 3;
  a[j] = normalize(project(a[j], a[i]));
  const Vec3 third = cross(a[i], a[j]);
  left_handed = all && dot(third, a[missing]) < 0;
  a[missing] = third;
  return a;
}

// Right-handed about the unit vector (Rodrigues).
Vec3 rotated(Vec3 v, Vec3 about, double angle_deg) {
  const double c = cos_deg(angle_deg), s = sin_deg(angle_deg);
  return v * c + cross(about, v) * s + about * (dot(about, v) * (1 - c));
}

}  // namespace

Schema optic_frame_schema(Context& context, RawOpticFrame& raw) {
  Context* c = &context;
  RawOpticFrame* r = &raw;
  const auto set = [=](std::optional<Vec3>& to) {
    std::optional<Vec3>* axis = &to;
    return [c, axis](const Args& a) {
      if (length(a.vectors[0]) > 0) *axis = a.vectors[0];
      else c->error(a.where, "a direction must not be the zero vector");
    };
  };
  const auto set_turn = [=](const Args& a) { r->turn = table_points(*c, a); };
  return {"optic_frame",
          {{"alpha", "d", set(r->axis[0]), "where alpha lies; a, b, c are X, Y, Z"},
           {"beta", "d", set(r->axis[1]), "where beta lies"},
           {"gamma", "d", set(r->axis[2]), "where gamma lies; one of the three may be left out"},
           {"turn", "", [](const Args&) {}, "before `about`: the axes turn with the wavelength"},
           {"about", "d", set(r->about), "what they turn about, right-handed"},
           {"table", "{}", set_turn, "nm, deg, nm, deg, ..."},
           {"table", "N", set_turn, "the same without braces"}},
          {}};
}

std::vector<OpticFrame> optic_frames(Context& context, const RawOpticFrame& raw, bool& left_handed) {
  const OpticFrame crystal_axes{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  left_handed = false;
  const int given = !!raw.axis[0] + !!raw.axis[1] + !!raw.axis[2];
  if (given == 1) {
    context.error(raw.where, "'optic_frame' needs two of 'alpha', 'beta' and 'gamma', or none");
    return {crystal_axes};
  }
  if (!all_square(context, raw)) return {crystal_axes};
  const OpticFrame frame = given ? completed(raw, left_handed) : crystal_axes;
  if (!raw.about != raw.turn.empty()) {
    context.error(raw.where, "axes that turn need both: 'turn about <x,y,z> table { nm, deg, ... }'");
    return {frame};
  }
  if (!raw.about) return {frame};
  const RotationFormula angle{RotationFormula::Kind::table, {}, raw.turn};
  const std::string wrong = check(angle);
  if (!wrong.empty()) {
    context.error(raw.where, "'turn': " + wrong);
    return {frame};
  }
  const Vec3 about = normalize(*raw.about);
  std::vector<OpticFrame> frames;
  for (double angle_deg : sample(context, raw.where, "'turn'", [&](double lambda_nm) {
         return rotation_deg_per_mm(angle, lambda_nm);
       }))
    frames.push_back({rotated(frame[0], about, angle_deg), rotated(frame[1], about, angle_deg),
                      rotated(frame[2], about, angle_deg)});
  return frames;
}

}  // namespace nicol
