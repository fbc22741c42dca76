// The readers of single blocks, one .cpp each. Every reader tells its errors in the context.
#pragma once
#include "host/bind/affine.hpp"
#include "host/bind/schema.hpp"
#include "host/optics/colour.hpp"
#include "host/optics/crystal.hpp"
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
  const sdl::Block* plugin = nullptr;
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

// ---- fragment_words.cpp: plugin { } of a polarizer or surface ----
// Index into Scene::fragments; nullopt, and told, after an error.
std::optional<int> bind_fragment(Context& context, const sdl::Block& block, Fragment::Kind kind);
struct RawSurface {
  const sdl::Block* plugin = nullptr;
  std::optional<Vec3> face;
};
Schema surface_schema(Context& context, RawSurface& raw);
std::optional<int> bind_surface(Context& context, const sdl::Block& block, RawSurface& raw);

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

// ---- orientation.cpp: how a crystal lies in the world ----
// Of one individual in its object: turned by `extra` in crystal axes before from_crystal() (the second
// of a twin), and of the opposite hand.
struct CrystalFrame {
  Affine extra;
  bool opposite_hand = false;
};
// Where unit vectors point in the world: the crystal's X, Y, Z (right-handed) and the object's x, y, z
// (POV-Ray's, left-handed). Both orthonormal, exact where the rotations are by multiples of 90 degrees.
struct Orientation {
  OpticFrame crystal, object;
  bool opposite_hand = false;
};
// Of the transforms (the object's own first, then those around it, without from_crystal() and to_world())
// only the rotation counts: that of the polar decomposition. Stretching does not distort a crystal, and
// mirroring turns it as the inversion of the mirror does (its tensor is the same), but keeps its hand.
Orientation orientation_of(const Affines& transforms, const CrystalFrame& frame = {});
Vec3 turned(const OpticFrame& axes, Vec3 v);  // axes[0] v.x + axes[1] v.y + axes[2] v.z
OpticFrame turned(const OpticFrame& axes, const OpticFrame& frame);
OpticFrame frame_of_axis(Vec3 axis);  // right-handed, `axis` last; the unit vector's others at will

// ---- index.cpp ----
Schema index_schema(Context& context, const char* name, IndexFormula& formula);
void bind_index(Context& context, const char* name, const sdl::Block& block, IndexFormula& formula);
// Samples at the scene's wavelengths; tells where the formula has no value.
Samples sample_index(Context& context, const IndexFormula& formula, Location where,
                     const std::string& what);
std::vector<std::pair<double, double>> table_points(Context& context, const Args& args);
Samples sample(Context& context, Location where, const std::string& what,
               const std::function<double(double)>& value_at_nm);

// ---- optic_frame.cpp: the principal axes in the crystal's Cartesian axes ----
struct RawOpticFrame {
  std::array<std::optional<Vec3>, 3> axis;           // alpha, beta, gamma
  std::optional<Vec3> about;                         // what the frame turns about
  std::vector<std::pair<double, double>> turn;       // nm, deg, right-handed
  Location where;
};
Schema optic_frame_schema(Context& context, RawOpticFrame& raw);
// Right-handed, one or one per wavelength. `left_handed`: the text's axes are, gamma was turned over.
std::vector<OpticFrame> optic_frames(Context& context, const RawOpticFrame& raw, bool& left_handed);

// ---- medium_words.cpp: what an interior says, before it means anything ----
namespace principal {
enum Axis { ordinary, extraordinary, alpha, beta, gamma, count };
extern const std::array<const char*, count> names;
}
struct RawAbsorption {  // of kind none: not said
  AbsorptionFormula every;
  std::array<AbsorptionFormula, principal::count> along;
  Location where;
};
struct RawGyration {
  std::optional<double> ratio;  // g11/g33 of a uniaxial crystal with a rotation
  GyrationFormula formula;
  Location where;
};
struct RawMedium {
  std::optional<double> ior;
  double dispersion = 1;
  std::optional<IndexFormula> index;
  std::array<std::optional<IndexFormula>, principal::count> index_along;
  RotationFormula rotation;
  RawAbsorption absorption, extinction;  // per mm; the coefficient k
  std::optional<RawGyration> gyration;
  std::optional<RawOpticFrame> optic_frame;
  std::optional<Vec3> optic_axis;
  bool left = false, circular_waves = false;
  Location circular_where;
  bool vacuum = false;  // where it says no index
  std::array<double, 2> range_nm{};
  Location index_where, rotation_where, optic_axis_where, range_where;
  std::array<Location, principal::count> index_along_where;
  std::string name = "interior", source;
};
Schema interior_schema(Context& context, RawMedium& raw);
Schema rotation_schema(Context& context, RotationFormula& formula);
Schema absorption_schema(Context& context, const char* name, RawAbsorption& raw);
Schema gyration_schema(Context& context, RawGyration& raw);

// ---- crystal_medium.cpp: symmetry, frame and activity of anisotropic media ----
// nullopt, and told, if the words for indices do not go together.
std::optional<Medium::Symmetry> symmetry_of(Context& context, const RawMedium& raw, Location where);
// The word for principal value i (0..2).
principal::Axis principal_axis(Medium::Symmetry symmetry, int i);
// Tells what does not belong to a medium of this symmetry.
void check_words(Context& context, const RawMedium& raw, Medium::Symmetry symmetry);
// Frame in crystal axes and gyration of a medium that has its indices.
void add_frame_and_gyration(Context& context, const RawMedium& raw, Medium& medium);

// ---- medium.cpp: media, sampled, each in its orientation once ----
// What an interior block gives, once for all objects that hold it.
struct BoundInterior {
  Medium medium;                   // `frame` in the crystal's Cartesian axes
  std::optional<Vec3> optic_axis;  // in the object's axes, in place of `frame`
};
std::optional<int> bind_medium(Context& context, const sdl::Block& interior,
                               const Orientation& orientation);
void bind_surroundings(Context& context, const sdl::Block& block);

// ---- object_words.cpp: what a block of an object says, before it means anything ----
struct RawCrystal;      // crystal.hpp
struct RawGem;          // crystal.hpp
struct RawIndividual {  // of a twin
  std::vector<HalfSpace> faces, without;  // without: what another individual fills
  CrystalFrame frame;
};
struct RawObject {
  const sdl::Block* block = nullptr;
  std::vector<Vec3> vectors;                  // box, plane, disc, polygon
  std::vector<double> numbers;                // plane, disc, polygon, prism
  std::vector<std::array<double, 2>> points;  // prism
  std::vector<HalfSpace> facets;              // crystal, gem, solid
  std::shared_ptr<const MeshShape> mesh;      // solid, in place of facets
  std::string told;                           // solid: what errors call it, with its plugin
  std::vector<const sdl::Block*> children;
  Affines transforms;
  CrystalFrame crystal_frame;
  std::optional<Affine> axes;  // crystal of a lattice: facets are in lattice coordinates, this makes
                               // them Cartesian
  std::vector<RawIndividual> individuals;  // twin: in place of facets and crystal_frame
  std::shared_ptr<RawCrystal> crystal;
  std::shared_ptr<RawGem> gem;
  const sdl::Block* interior = nullptr;
  const sdl::Block* polarizer = nullptr;
  std::vector<const sdl::Block*> lights, surfaces;
  bool optical_contact = false, inverse = false;
  bool sound = false;  // no error in its words
};
bool is_object(std::string_view name);    // of nicol's or POV-Ray's
std::vector<std::string> object_names();  // of nicol's
Schema object_schema(Context& context, const char* kind, RawObject& raw);
// Reads a block once, however often it is named.
const RawObject& read_object(Context& context, const sdl::Block& block);

// ---- solid.cpp: what plugins bring ----
void add_solid_rules(Context& context, RawObject& raw, Schema& schema);
// One plane for each face; nothing if the mesh is not convex.
std::optional<ConvexShape> planes_of_convex(const MeshShape& mesh);

// ---- convex.cpp: box, crystal, and what is cut from planes ----
inline constexpr std::size_t most_faces = 10'000;  // of a solid
// normal . p <= distance of the plane from the origin; exact for planes across an axis.
std::optional<HalfSpace> half_space(Context& context, Location where, Vec3 normal, double distance);
std::optional<ConvexShape> convex_shape(Context& context, const RawObject& raw);
// Of a convex solid or a plane; nothing for all else.
std::optional<std::size_t> half_space_count(Context& context, const RawObject& raw);
// Faces in the coordinates of the object's own text; false if some are unsound.
bool convex_faces(Context& context, const RawObject& raw, std::vector<HalfSpace>& faces);
bool is_instance(const RawObject& raw);  // object { X }, box { X }, ...

// ---- csg.cpp: merge, intersection, difference ----
std::optional<CsgShape> csg_shape(Context& context, const RawObject& raw);

// ---- flat.cpp: polygon, disc, prism ----
std::optional<PolygonShape> polygon_shape(Context& context, const RawObject& raw);
std::optional<DiscShape> disc_shape(Context& context, const RawObject& raw);
std::optional<PrismShape> prism_shape(Context& context, const RawObject& raw);

// ---- objects.cpp ----
// From the coordinates of a shape to those of its object's text: what a crystal's facets are written in.
Affines shape_frame(const RawObject& raw);
void bind_object(Context& context, const sdl::Block& block);

// ---- expect.cpp ----
struct RawExpectation {
  Expectation expectation;
  bool has_quantity = false, has_within = false;
};
Schema expect_schema(Context& context, RawExpectation& raw);
void bind_expectation(Context& context, const sdl::Block& block);

}  // namespace nicol
