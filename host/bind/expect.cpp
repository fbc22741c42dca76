// expect { }: a number that the picture must give, where, how nearly, and who says so.
#include <cmath>

#include "host/bind/parts.hpp"

namespace nicol {

namespace {

using Quantity = Expectation::Quantity;

bool among_wavelengths(Context& context, const Expectation& e) {
  double nearest_nm = context.scene.lambda_nm.front();
  for (double lambda_nm : context.scene.lambda_nm)
    if (std::abs(lambda_nm - e.lambda_nm) < std::abs(nearest_nm - e.lambda_nm))
      nearest_nm = lambda_nm;
  if (std::abs(nearest_nm - e.lambda_nm) < 1e-6) return true;
  context.error(e.where, to_text(e.lambda_nm) +
                             " nm is not among the scene's wavelengths; the nearest is " +
                             to_text(nearest_nm));
  return false;
}

bool needs_wavelength(Quantity quantity) {
  return quantity == Quantity::relative_radiance || quantity == Quantity::stokes ||
         quantity == Quantity::rotation_deg;
}

// The medium of the first solid that turns the plane of polarization; else of the first solid.
std::optional<int> first_medium(const Scene& scene) {
  std::optional<int> first;
  for (const Object& object : scene.objects) {
    if (!object.medium || *object.medium == 0) continue;
    if (!first) first = object.medium;
    for (double turn : scene.media[*object.medium].rotation_deg_per_mm)
      if (turn != 0) return object.medium;
  }
  return first;
}

bool complete(Context& context, const RawExpectation& raw) {
  const Expectation& e = raw.expectation;
  const std::size_t errors_before = context.error_count();
  if (!raw.has_quantity)
    context.error(
        e.where,
        "Expected a quantity ('relative_radiance', 'stokes', 'xyz', 'rgb', 'chromaticity', "
        "'rotation_deg' or 'malus_xyz') in 'expect'");
  if (!raw.has_within) context.error(e.where, "Expected 'within' and a tolerance in 'expect'");
  if (e.source.empty())
    context.error(e.where, "Expected 'source' and a string in 'expect': who says so?");
  return context.error_count() == errors_before;
}

bool refers_to_something(Context& context, Expectation& e) {
  const Scene& scene = context.scene;
  if (needs_wavelength(e.quantity) && !among_wavelengths(context, e)) return false;
  if (e.quantity == Quantity::malus_xyz) {
    const auto medium = first_medium(scene);
    if (!medium || scene.emissions.empty()) {
      context.error(e.where, "'malus_xyz' needs a light and a solid in the scene");
      return false;
    }
    e.medium = *medium;
  }
  return true;
}

}  // namespace

Schema expect_schema(Context& context, RawExpectation& raw) {
  Context* c = &context;
  RawExpectation* r = &raw;
  Expectation* e = &raw.expectation;
  const auto set = [=](Quantity quantity, const Args& a, std::vector<double> value) {
    if (r->has_quantity) c->error(a.where, "an 'expect' states one quantity");
    r->has_quantity = true;
    e->quantity = quantity;
    e->value = std::move(value);
  };
  const auto xyz_of = [](const Args& a) {
    return std::vector<double>{a.vectors[0].x, a.vectors[0].y, a.vectors[0].z};
  };
  const auto spectral = [=](Quantity quantity) {
    return [=](const Args& a) {
      e->lambda_nm = a.numbers[0];
      set(quantity, a, {a.numbers[1]});
    };
  };
  return {"expect",
          {{"relative_radiance", "nn", spectral(Quantity::relative_radiance),
            "nm, S0 over the radiance of the scene's first light"},
           {"stokes", "nt",
            [=](const Args& a) {
              e->lambda_nm = a.numbers[0];
              if (a.tuple.size() != 4)
                c->error(a.where, "'stokes' takes a vector of four: <S0, S1, S2, S3>");
              set(Quantity::stokes, a, a.tuple);
            },
            "nm, <S0, S1, S2, S3> over the same"},
           {"xyz", "v", [=](const Args& a) { set(Quantity::xyz, a, xyz_of(a)); },
            "<X, Y, Z>, CIE 1931, before `exposure`"},
           {"", "c",
            [=](const Args& a) {
              set(Quantity::rgb, a, {a.colour[0], a.colour[1], a.colour[2]});
            },
            "`rgb <R, G, B>`: linear sRGB, before `exposure`"},
           {"chromaticity", "p",
            [=](const Args& a) {
              set(Quantity::chromaticity, a, {a.points[0][0], a.points[0][1]});
            },
            "<x, y>, CIE 1931"},
           {"rotation_deg", "nn", spectral(Quantity::rotation_deg),
            "nm, degrees over the refracted chord of the first solid"},
           {"malus_xyz", "nv",
            [=](const Args& a) {
              e->length_mm = a.numbers[0] * c->scene.settings.mm_per_unit;
              set(Quantity::malus_xyz, a, xyz_of(a));
            },
            "length (scene units), <X, Y, Z> of the first light times cos^2 of the rotation in the "
            "first solid that rotates"},
           {"at", "p", [=](const Args& a) { e->at = a.points[0]; },
            "place in the picture, exactly: <0,0> its upper left corner, <1,1> its lower right "
            "(<0.5,0.5>)"},
           {"within", "n",
            [=](const Args& a) {
              r->has_within = true;
              e->tolerance = a.numbers[0];
              if (!(a.numbers[0] > 0)) c->error(a.where, "a tolerance must be greater than 0");
            },
            "the tolerance, absolute unless one of the next two follows"},
           {"percent", "",
            [=](const Args&) {
              e->relative = true;
              e->tolerance /= 100;
            },
            "the tolerance is in percent of the value"},
           {"relative", "", [=](const Args&) { e->relative = true; },
            "the tolerance is a part of the value"},
           {"source", "s", [=](const Args& a) { e->source = a.text; }, "whose number it is"}},
          {}};
}

void bind_expectation(Context& context, const sdl::Block& block) {
  RawExpectation raw;
  raw.expectation.where = block.where;
  const std::size_t errors_before = context.error_count();
  read_block(context, block, expect_schema(context, raw));
  if (context.error_count() != errors_before || !complete(context, raw)) return;
  const auto& at = raw.expectation.at;
  if (at[0] < 0 || at[0] > 1 || at[1] < 0 || at[1] > 1) {
    context.error(block.where,
                  "'at' lies outside the picture (0 to 1 from the left and from the top)");
    return;
  }
  if (refers_to_something(context, raw.expectation))
    context.scene.expectations.push_back(raw.expectation);
}

}  // namespace nicol
