// Media: an interior sampled at the scene's wavelengths, and laid into the world with its object.
#include "host/bind/parts.hpp"
#include "host/bind/units.hpp"
#include "host/vec.hpp"

namespace nicol {

namespace {

using Symmetry = Medium::Symmetry;

IndexFormula isotropic_index(const RawMedium& raw) {
  if (raw.index) return *raw.index;
  IndexFormula formula;
  formula.coefficients = {1};
  if (!raw.ior) return formula;
  formula.kind = IndexFormula::Kind::povray;
  formula.coefficients = {*raw.ior, raw.dispersion};
  return formula;
}

void add_indices(Context& context, const RawMedium& raw, Medium& medium) {
  if (medium.symmetry == Symmetry::isotropic) {
    medium.n.fill(sample_index(context, isotropic_index(raw), raw.index_where,
                               raw.index ? "'index'" : "'ior'"));
    return;
  }
  for (int i = 0; i < 3; ++i) {
    const principal::Axis axis = principal_axis(medium.symmetry, i);
    medium.n[i] = sample_index(context, *raw.index_along[axis], raw.index_along_where[axis],
                               std::string("'") + principal::names[axis] + "'");
  }
}

Samples rotation_samples(Context& context, const RawMedium& raw) {
  const std::string wrong = check(raw.rotation);
  if (!wrong.empty()) context.error(raw.rotation_where, "'rotation': " + wrong);
  if (!wrong.empty() || raw.rotation.kind == RotationFormula::Kind::none)
    return Samples(context.scene.lambda_nm.size(), 0.0);
  return sample(context, raw.rotation_where, "'rotation'",
                [&](double lambda_nm) { return rotation_deg_per_mm(raw.rotation, lambda_nm); });
}

// Negative values would make light out of nothing.
Samples not_negative(Context& context, const AbsorptionFormula& formula, Location where,
                     const std::string& what) {
  const std::string wrong = check(formula);
  if (!wrong.empty()) context.error(where, what + ": " + wrong);
  if (!wrong.empty() || formula.kind == AbsorptionFormula::Kind::none)
    return Samples(context.scene.lambda_nm.size(), 0.0);
  Samples values = sample(context, where, what,
                          [&](double lambda_nm) { return absorb_per_mm(formula, lambda_nm); });
  for (double value : values) {
    if (value >= 0) continue;
    context.error(where, what + " must not be negative");
    break;
  }
  return values;
}

Samples along(Context& context, const RawAbsorption& raw, principal::Axis axis, const std::string& what) {
  const bool own = raw.along[axis].kind != AbsorptionFormula::Kind::none;
  return not_negative(context, own ? raw.along[axis] : raw.every, raw.where, what);
}

void add_extinctions(Context& context, const RawMedium& raw, Medium& medium) {
  for (int i = 0; i < 3; ++i) {
    const principal::Axis axis = principal_axis(medium.symmetry, i);
    const Samples per_mm = along(context, raw.absorption, axis, "'absorption'");
    medium.k[i] = along(context, raw.extinction, axis, "'extinction'");
    for (std::size_t j = 0; j < per_mm.size(); ++j)
      medium.k[i][j] += extinction(per_mm[j], context.scene.lambda_nm[j]);
  }
}

void change_hand(Medium& medium) {
  for (double& turn : medium.rotation_deg_per_mm) turn = -turn;
  for (Samples& component : medium.gyration)
    for (double& g : component) g = -g;
}

void tell_range(Context& context, const RawMedium& raw) {
  const auto [least, most] = raw.range_nm;
  if (most == 0) return;
  for (double lambda_nm : context.scene.lambda_nm) {
    if (lambda_nm >= least && lambda_nm <= most) continue;
    context.warning(raw.range_where, to_text(lambda_nm) + " nm lies outside the range of '" + raw.name +
                                         "', " + to_text(least) + " to " + to_text(most) +
                                         " nm: its numbers are carried on beyond what is known");
    return;
  }
}

void tell_polarization(Context& context, const Medium& medium) {
  if (medium.symmetry != Symmetry::isotropic && !context.scene.settings.polarization)
    context.warn_once("crystal without polarization", medium.where,
                      "'polarization off' with a crystal that splits light by its polarization: its two "
                      "images cannot be right");
}

Medium make_medium(Context& context, const RawMedium& raw, Symmetry symmetry, Location where) {
  Medium m;
  m.name = raw.name;
  m.where = where;
  m.source = raw.source;
  m.range_nm = raw.range_nm;
  m.symmetry = symmetry;
  add_indices(context, raw, m);
  add_extinctions(context, raw, m);
  m.rotation_deg_per_mm = rotation_samples(context, raw);
  m.circular_waves = raw.circular_waves;
  add_frame_and_gyration(context, raw, m);
  if (raw.left) change_hand(m);
  tell_range(context, raw);
  tell_polarization(context, m);
  return m;
}

// Null, and told, if it is no medium. `raw`: what holds if the block says nothing else.
std::shared_ptr<const BoundInterior> read_interior(Context& context, const sdl::Block& block,
                                                   RawMedium raw = {}) {
  const std::size_t errors_before = context.error_count();
  read_block(context, block, interior_schema(context, raw));
  if (context.error_count() != errors_before) return nullptr;  // what is half read is not sampled
  const auto symmetry = symmetry_of(context, raw, block.where);
  if (!symmetry) return nullptr;
  check_words(context, raw, *symmetry);
  if (context.error_count() != errors_before) return nullptr;
  auto bound = std::make_shared<BoundInterior>();
  bound->medium = make_medium(context, raw, *symmetry, block.where);
  bound->optic_axis = raw.optic_axis;
  return bound;
}

// The medium in its hand and its place in the world.
Medium placed(const BoundInterior& bound, const Orientation& orientation) {
  Medium medium = bound.medium;
  if (orientation.opposite_hand) change_hand(medium);
  if (medium.symmetry == Symmetry::isotropic) return medium;
  for (OpticFrame& frame : medium.frame) frame = turned(orientation.crystal, frame);
  if (bound.optic_axis)
    medium.frame = {frame_of_axis(turned(orientation.object, normalize(*bound.optic_axis)))};
  return medium;
}

// Media of equal values are one, so that many objects share few.
int index_of_equal(Context& context, Medium medium) {
  std::vector<double> key{static_cast<double>(medium.symmetry), medium.circular_waves ? 1.0 : 0.0};
  const auto add = [&](const Samples& s) { key.insert(key.end(), s.begin(), s.end()); };
  for (const Samples& s : medium.n) add(s);
  for (const Samples& s : medium.k) add(s);
  for (const Samples& s : medium.gyration) add(s);
  add(medium.rotation_deg_per_mm);
  for (const OpticFrame& frame : medium.frame)
    for (const Vec3& axis : frame) key.insert(key.end(), {axis.x, axis.y, axis.z});
  std::vector<Medium>& media = context.scene.media;
  const auto [at, is_new] =
      context.medium_of_values.emplace(std::move(key), static_cast<int>(media.size()));
  if (is_new) media.push_back(std::move(medium));
  return at->second;
}

std::array<double, 9> numbers_of(const OpticFrame& frame) {
  return {frame[0].x, frame[0].y, frame[0].z, frame[1].x, frame[1].y,
          frame[1].z, frame[2].x, frame[2].y, frame[2].z};
}

}  // namespace

std::optional<int> bind_medium(Context& context, const sdl::Block& interior,
                               const Orientation& orientation) {
  const auto [at, unread] = context.interior_of_block.try_emplace(&interior);
  if (unread) at->second = read_interior(context, interior);
  const BoundInterior* bound = at->second.get();
  if (!bound) return std::nullopt;
  std::array<double, 9> lie{};
  if (bound->medium.symmetry != Symmetry::isotropic)
    lie = numbers_of(bound->optic_axis ? orientation.object : orientation.crystal);
  const std::tuple key{&interior, orientation.opposite_hand, lie};
  const auto known = context.medium_of_placed.find(key);
  if (known != context.medium_of_placed.end()) return known->second;
  const int medium = index_of_equal(context, placed(*bound, orientation));
  context.medium_of_placed.emplace(key, medium);
  return medium;
}

void bind_surroundings(Context& context, const sdl::Block& block) {
  const sdl::Block* interior = nullptr;
  read_block(context, block,
             {"surroundings",
              {{"interior", "{}", [&](const Args& a) { interior = a.block; }, "the medium around"}},
              {}});
  if (!interior) return;
  RawMedium vacuum;
  vacuum.name = "surroundings";
  vacuum.vacuum = true;
  const auto bound = read_interior(context, *interior, vacuum);
  if (!bound) return;
  if (bound->medium.symmetry != Symmetry::isotropic)
    return context.error(interior->where, "the surroundings must be isotropic: an 'ior' or 'index { }'");
  if (bound->medium.circular_waves)
    return context.error(interior->where, "the surroundings have one ray of the mean index: no 'circular_waves'");
  context.scene.media[0] = bound->medium;
}

}  // namespace nicol
