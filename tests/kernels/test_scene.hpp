// Scenes made by hand: boxes with contacts, sheets, lights, at one or more wavelengths; no text, no CGAL.
#pragma once
#include "host/features.hpp"
#include "host/pack.hpp"

namespace nicol::test {

enum Side { x_low, x_high, y_low, y_high, z_low, z_high };

class TestScene {
 public:
  Scene scene;
  Geometry geometry;

  explicit TestScene(std::vector<double> lambda_nm = {580});

  int add_medium(double n, double k = 0, double rotation_deg_per_mm = 0);
  // The symmetry follows from n; gyration: g11 g22 g33 g23 g13 g12 on the frame's axes, empty: not active.
  int add_crystal(const std::array<double, 3>& n, const OpticFrame& frame, const std::vector<double>& gyration = {},
                  const std::array<double, 3>& k = {0, 0, 0});
  int add_polarizer(Polarizer::Kind kind, Vec3 axis, Vec3 normal, double n_o = 1.6584, double n_e = 1.4864);
  int add_emission(double radiance, std::optional<int> polarizer = {}, bool one_sided = false);

  // A convex solid from outward planes in world mm, and a box; the cell's index.
  int add_solid(const std::vector<Plane>& planes, Vec3 centre, double radius, int medium, int parent = 0);
  int add_box(Vec3 low, Vec3 high, int medium, int parent = 0);
  int face_of(int cell, int side) const { return cells_[cell].first_face + side; }

  // The whole faces touch (both patches are made), within `edges` (world planes) if given.
  void join(Patch::Behind how, int cell, int side, int other_cell, int other_side, const std::vector<Plane>& edges = {});
  // Part of a face on a light or a polarizing sheet.
  void cover(int cell, int side, int sheet, const std::vector<Plane>& edges = {}, const Ring* disc = nullptr);

  int add_sheet(Vec3 centre, Vec3 normal, double half_x, double half_y, std::optional<int> emission,
                std::optional<int> polarizer, int cell = 0);  // rectangle along x and y
  int add_disc(Vec3 centre, Vec3 normal, double radius, double hole, std::optional<int> emission,
               std::optional<int> polarizer, int cell = 0);

  std::vector<FeatureReason> reasons() const { return features_.rows; }
  PackedScene packed(int lanes, int width = 1, int height = 1);

 private:
  struct OpenCell {
    Cell cell;
    int first_face = 0;
    std::vector<Patch> patches;
  };
  std::vector<OpenCell> cells_;
  Features features_;
};

}  // namespace nicol::test
