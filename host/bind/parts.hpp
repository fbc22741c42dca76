// The readers of single blocks, one .cpp each. Every reader tells its errors in the context.
#pragma once
#include "host/bind/affine.hpp"
#include "host/bind/schema.hpp"
#include "host/optics/colour.hpp"
#include "host/optics/media.hpp"

namespace nicol {

// ---- transform.cpp: translate, rotate, scale, matrix, transform { } ----
void add_transform_rules(Schema& schema, Affines& list, Context& context);

// ---- settings.cpp ----
struct RawSettings {
  std::vector<double> lambda_nm;
};
Schema settings_schema(Context& context, RawSettings& raw);
Schema wavelengths_schema(Context& context, std::vector<double>& lambda_nm);
// Applies what the command line says on top, and fills lambda_nm and weight_nm.
void finish_settings(Context& context, const RawSettings& raw);

// ---- camera.cpp ----
struct RawCamera {
  bool orthographic = false;
  Vec3 location{0, 0, 0}, direction{0, 0, 1}, right{4.0 / 3, 0, 0}, up{0, 1, 0}, sky{0, 1, 0};
  Vec3 look_at{0, 0, 1};
  bool has_look_at = false, has_right = false, has_other_type = false;
  std::optional<double> angle_deg;
  Affines transforms;
  const sdl::Block* polarizer = nullptr;
};
Schema camera_schema(Context& context, RawCamera& raw);
void bind_camera(Context& context, const sdl::Block& block);
void default_camera(Context& context);

// ---- polarizer.cpp ----
// The plane in which a polarizer's angle is counted: from x towards y. World axes.
struct PolarizerPlane {
  Vec3 x, y;                // unit, perpendicular
  Affines axis_transforms;  // what turns the vector of `axis` into the world
};
struct RawPolarizer {
  Polarizer::Kind kind = Polarizer::Kind::ideal;
  bool calcite = false, absorbing = false;
  std::optional<double> angle_deg;
  std::optional<Vec3> axis;
  IndexFormula index_o = calcite_ordinary(), index_e = calcite_extraordinary();
};
Schema polarizer_schema(Context& context, RawPolarizer& raw);
std::optional<int> bind_polarizer(Context& context, const sdl::Block& block,
                                  const PolarizerPlane& plane);
// Planes of a polarizer on a face or disc with this outward normal, or on a polygon with these
// corners.
PolarizerPlane plane_of_face(Vec3 normal, const Affines& transforms);
PolarizerPlane plane_of_polygon(const std::vector<Vec3>& corners, const Affines& transforms);

// ---- light.cpp ----
Schema spectrum_schema(Context& context, SpectrumFormula& formula);
Samples bind_spectrum(Context& context, const sdl::Block* block, Location where);
void bind_sky(Context& context, const sdl::Block& block);
struct RawLuminous {
  const sdl::Block* spectrum = nullptr;
  const sdl::Block* polarizer = nullptr;
  std::optional<Vec3> face;
  bool one_sided = false;
};
Schema luminous_schema(Context& context, RawLuminous& raw);
Schema sky_schema(Context& context, const char* name, const sdl::Block*& spectrum,
                  std::optional<SpectrumFormula>& colour);

// ---- medium.cpp and index.cpp ----
Schema index_schema(Context& context, const char* name, IndexFormula& formula);
void bind_index(Context& context, const char* name, const sdl::Block& block, IndexFormula& formula);
// Samples at the scene's wavelengths; tells where the formula has no value.
Samples sample_index(Context& context, const IndexFormula& formula, Location where,
                     const std::string& what);
struct RawMedium {
  std::optional<double> ior;
  double dispersion = 1;
  std::optional<IndexFormula> index;
  RotationFormula rotation;
  AbsorptionFormula absorption, extinction;  // of extinction: the coefficient k in place of 1/mm
  Location index_where, rotation_where, absorption_where, extinction_where;
  std::string name = "interior", source;
};
Schema interior_schema(Context& context, RawMedium& raw);
Schema rotation_schema(Context& context, RotationFormula& formula);
Schema absorption_schema(Context& context, const char* name, AbsorptionFormula& formula);
std::optional<int> bind_medium(Context& context, const sdl::Block& interior);
void bind_surroundings(Context& context, const sdl::Block& block);
std::vector<std::pair<double, double>> table_points(Context& context, const Args& args);
Samples sample(Context& context, Location where, const std::string& what,
               const std::function<double(double)>& value_at_nm);

// ---- object_words.cpp: what a block of an object says, before it means anything ----
struct RawObject {
  const sdl::Block* block = nullptr;
  std::vector<Vec3> vectors;                  // box, plane, disc, polygon
  std::vector<double> numbers;                // plane, disc, polygon, prism
  std::vector<std::array<double, 2>> points;  // prism
  std::vector<HalfSpace> facets;              // crystal
  std::vector<const sdl::Block*> children;
  Affines transforms;
  const sdl::Block* interior = nullptr;
  const sdl::Block* polarizer = nullptr;
  std::vector<const sdl::Block*> lights;
  bool optical_contact = false, inverse = false;
  bool sound = false;  // no error in its words
};
bool is_object(std::string_view name);    // of nicol's or POV-Ray's
std::vector<std::string> object_names();  // of nicol's
Schema object_schema(Context& context, const char* kind, RawObject& raw);
// Reads a block once, however often it is named.
const RawObject& read_object(Context& context, const sdl::Block& block);

// ---- convex.cpp: box, crystal, and what is cut from planes ----
// normal . p <= distance of the plane from the origin; exact for planes across an axis.
std::optional<HalfSpace> half_space(Context& context, Location where, Vec3 normal, double distance);
std::optional<ConvexShape> convex_shape(Context& context, const RawObject& raw);

// ---- flat.cpp: polygon, disc, prism ----
std::optional<PolygonShape> polygon_shape(Context& context, const RawObject& raw);
std::optional<DiscShape> disc_shape(Context& context, const RawObject& raw);
std::optional<PrismShape> prism_shape(Context& context, const RawObject& raw);

// ---- objects.cpp ----
void bind_object(Context& context, const sdl::Block& block);

// ---- expect.cpp ----
struct RawExpectation {
  Expectation expectation;
  bool has_quantity = false, has_within = false;
};
Schema expect_schema(Context& context, RawExpectation& raw);
void bind_expectation(Context& context, const sdl::Block& block);

}  // namespace nicol
