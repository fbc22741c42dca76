// The scene as plain data: what bind makes of the text and everything after it reads.
// Shapes are in the units of the text, with the list of their transforms; the last transform in each list
// is the one that turns POV-Ray's left-handed scene units into right-handed millimetres. Everything
// else here (cameras, axes, spectra) is in right-handed world millimetres, nanometres and radians.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "host/fragments/fragment.hpp"
#include "sdl/tree.hpp"

namespace nicol {

using sdl::Location;

struct Vec3 {
  double x = 0, y = 0, z = 0;
};

// Row vectors, as POV-Ray: p' = p M, rows 0..2 linear, row 3 translation. The numbers are taken as
// exact; a list of them is composed in exact arithmetic, so that what touches keeps touching.
struct Affine {
  std::array<std::array<double, 3>, 4> m{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};
};

// ---- spectra: sampled at Scene::lambda_nm ----
using Samples = std::vector<double>;

// ---- media ----
// Right-handed orthonormal axes of a medium's dielectric tensor, in the world: columns of its matrix.
using OpticFrame = std::array<Vec3, 3>;

// Isotropic, uniaxial (principal values 0 and 1 are the ordinary ones, axis 2 is the optic axis) or biaxial.
// A medium belongs to one orientation: the same crystal turned is another medium.
struct Medium {
  enum class Symmetry { isotropic, uniaxial, biaxial };
  std::string name;      // the identifier or "interior", for messages
  Location where;
  Symmetry symmetry = Symmetry::isotropic;
  std::array<Samples, 3> n;  // principal refractive indices along the axes of `frame`; isotropic: all equal
  std::array<Samples, 3> k;  // extinction coefficients (0: transparent); absorb_per_mm = 4 pi k / lambda
  Samples rotation_deg_per_mm;  // isotropic media: of the plane of polarization; > 0 dextro; else all 0
  bool circular_waves = false;  // isotropic and active: its two circular waves instead of one ray of the mean index
  // Optical activity of anisotropic media: g11 g22 g33 g23 g13 g12 on the axes of `frame`,
  // D = eps E + i g(s) s x E with g(s) = g_ij s_i s_j, so that light along s turns by pi g(s)/(n lambda),
  // > 0 dextro. All empty: not active.
  std::array<Samples, 6> gyration;
  std::vector<OpticFrame> frame;  // one for all wavelengths, or one per wavelength
  std::string source;    // of the numbers
  std::array<double, 2> range_nm{};  // wavelengths that the numbers hold for; both 0: not said

  bool is_active() const { return !gyration[0].empty(); }
  const OpticFrame& frame_at(std::size_t i) const { return frame[frame.size() == 1 ? 0 : i]; }
};

// ---- fragments: optics of surfaces and polarizing elements that plugins bring as OpenCL C ----
// One use of a fragment: the same fragment with other values of its parameters is another one.
struct FragmentUse {
  std::shared_ptr<const Fragment> fragment;
  std::vector<double> values;  // of its parameters, in the manifest's order and units
  Location where;              // the scene's `plugin` block
  std::string place;           // the same for messages: "scene.pov:12"
};

// ---- polarizers ----
struct Polarizer {
  enum class Kind {
    ideal,             // passes the projection of its transmission axis on the plane across the ray
    ideal_absorbing,   // absorbs the projection of its absorption axis (Korger 2013), passes the rest
    calcite,           // the founding paper's plate: ordinary ray only, Fresnel at both faces
    fragment           // what a plugin's fragment says
  };
  Kind kind = Kind::ideal;
  int fragment = -1;       // of that kind: index into Scene::fragments
  Vec3 transmission_axis;  // unit, in the polarizer's plane; the optic axis of calcite lies across it
  Vec3 normal;             // unit, of the polarizer's plane
  Samples n_o, n_e;        // calcite only
  Location where;
};

// ---- light ----
struct Emission {
  Samples radiance;               // per nm; a spectrum of scale 1 gives Y = 1 in the picture
  std::optional<int> polarizer;   // index into Scene::polarizers: lies on the surface without a gap
  // Shines only to its outer side: where the outward normal of the face points, the normal of the disc,
  // or from where the polygon's first contour runs counter-clockwise (in world coordinates).
  bool one_sided = false;
  Location where;
};

// ---- shapes ----
struct HalfSpace {  // normal . p <= offset; the normal need not have unit length
  Vec3 normal;
  double offset = 0;
};
struct ConvexShape {  // box, crystal, intersection of planes
  std::vector<HalfSpace> faces;
};
struct PrismShape {  // contours in (x, z), even-odd, swept along y
  std::vector<std::vector<std::array<double, 2>>> contours;
  double y_min = 0, y_max = 0;
};
struct PolygonShape {  // coplanar points, contours closed implicitly, even-odd
  std::vector<std::vector<Vec3>> contours;
};
struct DiscShape {
  Vec3 centre, normal;
  double radius = 1, hole_radius = 0;
};
struct MeshShape {  // closed; planar polygons, their corners counter-clockwise seen from outside
  std::vector<Vec3> points;
  std::vector<std::vector<int>> faces;
};
// What CSG makes of half-space solids: one solid without faces between its parts.
struct CsgShape {
  // merge: inside any; intersection: inside all; difference: inside the first and none of the others
  enum class Operation { leaf, merge, intersection, difference };
  struct Node {
    Operation operation = Operation::leaf;
    bool inverse = false;            // everything but this
    std::vector<Affine> transforms;  // its own; those of the nodes and the object around it follow
    std::variant<ConvexShape, PrismShape, MeshShape> leaf;  // the shape may be open, as a plane is
    std::vector<Node> operands;
    std::string kind;  // "box", "difference", ...
    Location where;
  };
  Node root;
};
using Shape = std::variant<ConvexShape, PrismShape, PolygonShape, DiscShape, CsgShape, MeshShape>;

// A solid has a medium; a sheet (polygon, disc) shines or polarizes. A face of a solid may shine too.
struct FaceEmission {
  int face = 0;       // index into ConvexShape::faces
  int emission = 0;   // index into Scene::emissions
};
struct FaceSurface {
  int face = -1;      // index into ConvexShape::faces; -1: every face
  int fragment = 0;   // index into Scene::fragments
};
struct Object {
  std::string kind;   // "box", "prism", ...
  Location where;
  Shape shape;
  std::vector<Affine> transforms;  // in order, the conversion to right-handed mm last
  std::optional<int> medium;       // solids
  std::optional<int> emission;     // sheets that shine
  std::optional<int> polarizer;    // sheets that polarize
  std::vector<FaceEmission> face_emissions;
  std::vector<FaceSurface> face_surfaces;  // later ones count
  bool optical_contact = false;    // touches its neighbours without a gap
};

// ---- camera ----
// The picture's x (right) and y (up) at the image plane; orthographic rays all run along direction.
struct Camera {
  bool orthographic = false;
  Vec3 location;      // mm
  Vec3 direction;     // perspective: from location to the centre of the picture; orthographic: unit
  Vec3 right, up;     // full width and height of the picture, at `direction` (perspective) or in mm
  std::optional<int> polarizer;  // the analyzer
  Location where;
};

// ---- numbers the scene must give ----
struct Expectation {
  enum class Quantity {
    relative_radiance,  // S0 at lambda_nm over the radiance of the first emission (of the sky, if none)
    stokes,             // S0..S3 at lambda_nm over the same
    xyz,                // CIE 1931 of the pixel
    rgb,                // linear sRGB of the pixel
    chromaticity,       // CIE x, y of the pixel
    rotation_deg,       // rotation at lambda_nm over the refracted chord of the first solid hit
    malus_xyz           // XYZ of the first emission x cos^2(rotation(lambda) length_mm) of a medium
  };
  Quantity quantity{};
  std::array<double, 2> at{0.5, 0.5};  // place in the picture: 0..1 from the left, from the top
  double lambda_nm = 0;
  double length_mm = 0;
  int medium = 0;           // malus_xyz: index into Scene::media
  std::vector<double> value;
  double tolerance = 0;
  bool relative = false;    // tolerance relative to |value|
  std::string source;
  Location where;
};

struct Settings {
  int max_trace_level = 5;       // POV-Ray's default
  double adc_bailout = 1.0 / 255;
  double mm_per_unit = 10;
  double exposure = 1;           // factor on the colours of PNG and of EXR's R, G, B
  int samples = 1;               // per pixel
  // Targets, relative to the picture's mean radiance, RMS; 0: none.
  double error = 0;              // of the whole picture: nicol picks the settings that keep it
  double sample_error = 0;       // of pixel sampling: further samples go where they matter
  bool polarization = true;      // false: scalar intensities (`polarization off`)
  bool coherence = true;         // false: the two waves of a crystal never add as amplitudes (`coherence off`)
  int conical_rays = 0;          // azimuths around the cone at a binormal, per sample; 0: none
  double conical_spread_rad = 0; // half the angle of the bundle that one ray stands for; 0: that of a pixel
};

struct Scene {
  std::string path;
  std::vector<double> lambda_nm;     // ascending
  std::vector<double> weight_nm;     // width that each wavelength stands for in integrals
  Camera camera;
  std::vector<Medium> media;         // media[0] is the surroundings (vacuum unless said)
  std::vector<FragmentUse> fragments;
  std::vector<Polarizer> polarizers;
  std::vector<Emission> emissions;
  Samples sky;                       // radiance of the uniform surroundings
  Location sky_where;
  std::vector<Object> objects;
  std::vector<Expectation> expectations;
  Settings settings;
};

}  // namespace nicol
