// Anisotropic media: which words go together, and the frame and gyration that they come to.
//
// Uniaxial: the optic axis is the crystal's Z; `optic_axis` gives it in the object's axes instead. Biaxial: alpha,
// beta, gamma along X, Y, Z unless `optic_frame` says where. Indices may cross with the wavelength:
// nothing is sorted. Absorption has the axes of the indices (true of orthorhombic crystals and higher
// symmetry; monoclinic and triclinic ones may deviate).
//
// Activity of a uniaxial crystal from its rotation rho along the axis:
//   g33 = rho n_o lambda/pi,  g11 = g22 = ratio g33       (Nye 1957, XIV.2, eq. 8)
// Without a `ratio` it is 1: turning as in an isotropic medium, which the crystal then becomes as its
// indices approach each other. Test: tests/bind/crystal_medium_test.cpp.
#include "host/bind/parts.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

using Symmetry = Medium::Symmetry;

std::string quoted(principal::Axis axis) {
  return std::string("'") + principal::names[axis] + "'";
}

// The place of the first word of these that is there.
std::optional<Location> first_said(const RawMedium& raw, int from, int to) {
  for (int i = from; i < to; ++i)
    if (raw.index_along[i]) return raw.index_along_where[i];
  return std::nullopt;
}

bool all_said(Context& context, const RawMedium& raw, int from, int to, Location where) {
  bool all = true;
  for (int i = from; i < to; ++i) {
    if (raw.index_along[i]) continue;
    context.error(where, std::string(to == principal::count ? "a biaxial" : "a uniaxial") +
                             " medium needs " + quoted(static_cast<principal::Axis>(i)) + " as well");
    all = false;
  }
  return all;
}

void check_absorption(Context& context, const RawAbsorption& raw, const char* what,
                      Symmetry symmetry) {
  using Kind = AbsorptionFormula::Kind;
  int said = 0;
  for (int axis = 0; axis < principal::count; ++axis) {
    if (raw.along[axis].kind == Kind::none) continue;
    ++said;
    const bool belongs = symmetry == Symmetry::uniaxial   ? axis < principal::alpha
                         : symmetry == Symmetry::biaxial ? axis >= principal::alpha
                                                         : false;
    if (!belongs)
      context.error(raw.where, std::string("'") + what + "' along " +
                                   quoted(static_cast<principal::Axis>(axis)) +
                                   ", but the medium has no index along it");
  }
  const int axes = symmetry == Symmetry::uniaxial ? 2 : symmetry == Symmetry::biaxial ? 3 : 0;
  if (said && said < axes && raw.every.kind == Kind::none)
    context.error(raw.where, std::string("'") + what +
                                 "' along some axes leaves the others unsaid: name them all, or write "
                                 "a 'constant' or 'table' for the rest");
}

void check_activity(Context& context, const RawMedium& raw, Symmetry symmetry) {
  const bool rotates = raw.rotation.kind != RotationFormula::Kind::none;
  if (symmetry == Symmetry::biaxial && rotates)
    context.error(raw.rotation_where,
                  "the activity of a biaxial crystal differs with direction: write 'gyration { tensor "
                  "g11, g22, g33, g23, g13, g12 }'");
  if (!raw.gyration) return;
  const RawGyration& g = *raw.gyration;
  if (symmetry == Symmetry::isotropic)
    context.error(g.where, "an isotropic medium has a 'rotation', no 'gyration'");
  else if (g.ratio && (symmetry != Symmetry::uniaxial || !rotates))
    context.error(g.where, "'ratio' is that of g11 to the g33 of a uniaxial crystal's 'rotation'");
  else if (!g.ratio && symmetry == Symmetry::uniaxial && rotates)
    context.error(g.where, "a uniaxial crystal has a 'rotation' (with a 'ratio') or a tensor, not both");
}

void check_axes(Context& context, const RawMedium& raw, Symmetry symmetry) {
  if (raw.optic_frame && symmetry != Symmetry::biaxial)
    context.error(raw.optic_frame->where,
                  symmetry == Symmetry::uniaxial
                      ? "a uniaxial crystal has an 'optic_axis'; 'optic_frame' is for biaxial ones"
                      : "an isotropic medium has no 'optic_frame'");
  if (!raw.optic_axis) return;
  if (symmetry == Symmetry::biaxial)
    context.error(raw.optic_axis_where,
                  "a biaxial crystal has two optic axes, and they follow from its indices: 'optic_frame' "
                  "says where alpha, beta and gamma lie");
  else if (symmetry == Symmetry::isotropic)
    context.error(raw.optic_axis_where, "an isotropic medium has no 'optic_axis'");
  else if (length(*raw.optic_axis) == 0)
    context.error(raw.optic_axis_where, "'optic_axis' must not be the zero vector");
}

// Nye 1957, table of gyration tensors: about a 3-, 4- or 6-fold axis g is diag(g11, g11, g33), of the classes
// -4 and -42m (g11, -g11, 0) with g12.
bool fits_uniaxial(const GyrationTensor& g) {
  const bool along_axis_only = g[3] == 0 && g[4] == 0;
  const bool like_axis = g[0] == g[1] && g[5] == 0, like_inversion = g[0] == -g[1] && g[2] == 0;
  return along_axis_only && (like_axis || like_inversion);
}

void add_tensor(Context& context, const RawMedium& raw, bool left_handed, Medium& medium) {
  const Location where = raw.gyration->where;
  const GyrationFormula& formula = raw.gyration->formula;
  const std::string wrong = check(formula);
  if (!wrong.empty()) return context.error(where, "'gyration': " + wrong);
  for (std::size_t i = 0; i < medium.gyration.size(); ++i)
    medium.gyration[i] = sample(context, where, "'gyration'", [&](double lambda_nm) {
      return gyration(formula, lambda_nm)[i];
    });
  for (std::size_t at = 0; at < context.scene.lambda_nm.size(); ++at) {
    const GyrationTensor g = gyration(formula, context.scene.lambda_nm[at]);
    if (medium.symmetry == Symmetry::uniaxial && !fits_uniaxial(g))
      return context.error(where,
                           "no uniaxial crystal has this gyration: g11 = g22 with g12 = 0, or g11 = -g22 "
                           "with g33 = 0, and g23 = g13 = 0");
    if (raw.optic_axis && (g[0] != g[1] || g[5] != 0))
      return context.error(where,
                           "this gyration differs around the optic axis, so that 'optic_axis' does not "
                           "place it: turn the object instead");
    if (left_handed && (g[3] != 0 || g[4] != 0 || g[5] != 0))
      return context.error(where,
                           "g23, g13 and g12 need a right-handed 'optic_frame': write one of its axes "
                           "with the opposite sign, or leave one out");
  }
}

void add_rotation(const RawMedium& raw, const std::vector<double>& lambda_nm, Medium& medium) {
  const double ratio = raw.gyration && raw.gyration->ratio ? *raw.gyration->ratio : 1;
  medium.gyration.fill(Samples(lambda_nm.size(), 0.0));
  for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
    const double g33 =
        gyration_of_rotation(medium.rotation_deg_per_mm[i], medium.n[0][i], lambda_nm[i]);
    medium.gyration[0][i] = medium.gyration[1][i] = ratio * g33;
    medium.gyration[2][i] = g33;
  }
  medium.rotation_deg_per_mm.assign(lambda_nm.size(), 0.0);
}

}  // namespace

std::optional<Symmetry> symmetry_of(Context& context, const RawMedium& raw, Location where) {
  const auto uniaxial = first_said(raw, principal::ordinary, principal::alpha);
  const auto biaxial = first_said(raw, principal::alpha, principal::count);
  const bool isotropic = raw.index || raw.ior;
  if (!uniaxial && !biaxial) {
    if (isotropic || raw.vacuum) return Symmetry::isotropic;
    context.error(where,
                  "this interior has no index: 'ior' or 'index { }' gives it one, 'ordinary { }' and "
                  "'extraordinary { }' or 'alpha { }', 'beta { }' and 'gamma { }' those of a crystal");
    return std::nullopt;
  }
  if (isotropic) {
    context.error(uniaxial ? *uniaxial : *biaxial,
                  "a medium has one index ('ior', 'index { }') or principal indices, not both");
    return std::nullopt;
  }
  if (uniaxial && biaxial) {
    context.error(*biaxial,
                  "a medium is uniaxial ('ordinary', 'extraordinary') or biaxial ('alpha', 'beta', "
                  "'gamma'), not both");
    return std::nullopt;
  }
  if (uniaxial && all_said(context, raw, principal::ordinary, principal::alpha, *uniaxial)) return Symmetry::uniaxial;
  if (biaxial && all_said(context, raw, principal::alpha, principal::count, *biaxial))
    return Symmetry::biaxial;
  return std::nullopt;
}

principal::Axis principal_axis(Symmetry symmetry, int i) {
  if (symmetry == Symmetry::biaxial) return static_cast<principal::Axis>(principal::alpha + i);
  return i < 2 ? principal::ordinary : principal::extraordinary;
}

void check_words(Context& context, const RawMedium& raw, Symmetry symmetry) {
  if (raw.circular_waves && (symmetry != Symmetry::isotropic || raw.rotation.kind == RotationFormula::Kind::none))
    context.error(raw.circular_where, "'circular_waves' are those of an isotropic medium with a 'rotation { }'; crystals have their own");
  check_absorption(context, raw.absorption, "absorption", symmetry);
  check_absorption(context, raw.extinction, "extinction", symmetry);
  check_activity(context, raw, symmetry);
  check_axes(context, raw, symmetry);
}

void add_frame_and_gyration(Context& context, const RawMedium& raw, Medium& medium) {
  bool left_handed = false;
  medium.frame = optic_frames(context, raw.optic_frame.value_or(RawOpticFrame{}), left_handed);
  if (medium.symmetry == Symmetry::isotropic) return;
  if (raw.gyration && !raw.gyration->ratio) add_tensor(context, raw, left_handed, medium);
  else if (raw.rotation.kind != RotationFormula::Kind::none)
    add_rotation(raw, context.scene.lambda_nm, medium);
}

}  // namespace nicol
