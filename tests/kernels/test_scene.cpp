#include "tests/kernels/test_scene.hpp"

#include <cmath>

namespace nicol::test {
namespace {

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Plane local(Plane plane, const Vec3& centre) {
  plane.offset_mm -= dot(plane.normal, centre);
  return plane;
}
std::vector<Plane> local(std::vector<Plane> planes, const Vec3& centre) {
  for (Plane& plane : planes) plane = local(plane, centre);
  return planes;
}

}  // namespace

TestScene::TestScene(std::vector<double> lambda_nm) {
  scene.lambda_nm = lambda_nm;
  scene.weight_nm.assign(lambda_nm.size(), 1);
  scene.sky.assign(lambda_nm.size(), 0);
  scene.settings.max_trace_level = 1000000;
  scene.settings.adc_bailout = 1e-9;
  scene.camera.direction = {0, 0, -1};
  scene.camera.right = {1, 0, 0};
  scene.camera.up = {0, 1, 0};
  add_medium(1);
  cells_.emplace_back();
}

int TestScene::add_medium(double n, double k, double rotation_deg_per_mm) {
  Medium medium;
  const std::size_t count = scene.lambda_nm.size();
  medium.n.fill(Samples(count, n));
  medium.k.fill(Samples(count, k));
  medium.rotation_deg_per_mm.assign(count, rotation_deg_per_mm);
  medium.frame = {OpticFrame{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}};
  scene.media.push_back(medium);
  return static_cast<int>(scene.media.size()) - 1;
}

int TestScene::add_crystal(const std::array<double, 3>& n, const OpticFrame& frame, const std::vector<double>& gyration,
                           const std::array<double, 3>& k) {
  const int index = add_medium(n[0]);
  Medium& medium = scene.media.back();
  const std::size_t count = scene.lambda_nm.size();
  medium.symmetry = n[0] == n[1] ? Medium::Symmetry::uniaxial : Medium::Symmetry::biaxial;
  for (int axis = 0; axis < 3; ++axis) {
    medium.n[axis].assign(count, n[axis]);
    medium.k[axis].assign(count, k[axis]);
  }
  for (std::size_t i = 0; i < gyration.size(); ++i) medium.gyration[i].assign(count, gyration[i]);
  medium.frame = {frame};
  return index;
}

int TestScene::add_polarizer(Polarizer::Kind kind, Vec3 axis, Vec3 normal, double n_o, double n_e) {
  Polarizer polarizer;
  polarizer.kind = kind;
  polarizer.transmission_axis = axis;
  polarizer.normal = normal;
  polarizer.n_o.assign(scene.lambda_nm.size(), n_o);
  polarizer.n_e.assign(scene.lambda_nm.size(), n_e);
  scene.polarizers.push_back(polarizer);
  return static_cast<int>(scene.polarizers.size()) - 1;
}

int TestScene::add_emission(double radiance, std::optional<int> polarizer, bool one_sided) {
  Emission emission;
  emission.radiance.assign(scene.lambda_nm.size(), radiance);
  emission.polarizer = polarizer;
  emission.one_sided = one_sided;
  scene.emissions.push_back(emission);
  return static_cast<int>(scene.emissions.size()) - 1;
}

int TestScene::add_solid(const std::vector<Plane>& planes, Vec3 centre, double radius, int medium, int parent) {
  Object object;
  object.kind = "solid";
  object.medium = medium;
  scene.objects.push_back(object);
  OpenCell open;
  open.cell.object = static_cast<int>(scene.objects.size()) - 1;
  open.cell.medium = medium;
  open.cell.parent = parent;
  open.cell.centre_mm = centre;
  open.first_face = static_cast<int>(geometry.faces.size());
  for (const Plane& plane : planes) {
    Face face;
    face.plane = local(plane, centre);
    face.corners = {{centre.x + radius, centre.y, centre.z}};  // the packer reads the cell's radius off them
    geometry.faces.push_back(face);
  }
  const int index = static_cast<int>(cells_.size());
  open.cell.face_count = static_cast<int>(planes.size());
  cells_[parent].cell.children.push_back(index);
  cells_.push_back(open);
  return index;
}

int TestScene::add_box(Vec3 low, Vec3 high, int medium, int parent) {
  const Vec3 centre{(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
  const Vec3 half{(high.x - low.x) / 2, (high.y - low.y) / 2, (high.z - low.z) / 2};
  return add_solid({{{-1, 0, 0}, -low.x}, {{1, 0, 0}, high.x}, {{0, -1, 0}, -low.y}, {{0, 1, 0}, high.y},
                    {{0, 0, -1}, -low.z}, {{0, 0, 1}, high.z}},
                   centre, std::sqrt(dot(half, half)), medium, parent);
}

void TestScene::join(Patch::Behind how, int cell, int side, int other_cell, int other_side, const std::vector<Plane>& edges) {
  const int ends[2][2] = {{cell, side}, {other_cell, other_side}};
  for (int i = 0; i < 2; ++i) {
    Patch patch;
    patch.behind = how;
    patch.face = face_of(ends[i][0], ends[i][1]);
    patch.other_face = face_of(ends[1 - i][0], ends[1 - i][1]);
    patch.other_cell = ends[1 - i][0];
    patch.edges = local(edges, cells_[ends[i][0]].cell.centre_mm);
    cells_[ends[i][0]].patches.push_back(patch);
  }
}

void TestScene::cover(int cell, int side, int sheet, const std::vector<Plane>& edges, const Ring* disc) {
  Patch patch;
  patch.behind = geometry.sheets[sheet].emission >= 0 ? Patch::Behind::light : Patch::Behind::polarizer;
  patch.face = face_of(cell, side);
  patch.sheet = sheet;
  patch.emission = geometry.sheets[sheet].emission;
  const Vec3 centre = cells_[cell].cell.centre_mm;
  patch.edges = local(edges, centre);
  if (disc) {
    patch.has_disc = true;
    patch.disc = *disc;
    patch.disc.centre_mm = {disc->centre_mm.x - centre.x, disc->centre_mm.y - centre.y, disc->centre_mm.z - centre.z};
  }
  cells_[cell].patches.push_back(patch);
}

int TestScene::add_sheet(Vec3 centre, Vec3 normal, double half_x, double half_y, std::optional<int> emission,
                         std::optional<int> polarizer, int cell) {
  const int index = add_disc(centre, normal, 0, 0, emission, polarizer, cell);
  Sheet& sheet = geometry.sheets[index];
  sheet.has_disc = false;
  sheet.edges = {{{1, 0, 0}, half_x}, {{-1, 0, 0}, half_x}, {{0, 1, 0}, half_y}, {{0, -1, 0}, half_y}};
  return index;
}

int TestScene::add_disc(Vec3 centre, Vec3 normal, double radius, double hole, std::optional<int> emission,
                        std::optional<int> polarizer, int cell) {
  Object object;
  object.kind = "sheet";
  scene.objects.push_back(object);
  Sheet sheet;
  sheet.object = static_cast<int>(scene.objects.size()) - 1;
  sheet.cell = cell;
  sheet.emission = emission.value_or(-1);
  sheet.polarizer = polarizer.value_or(-1);
  sheet.centre_mm = centre;
  sheet.plane = {normal, 0};
  sheet.has_disc = true;
  sheet.disc = {{0, 0, 0}, radius, hole};
  const int index = static_cast<int>(geometry.sheets.size());
  geometry.sheets.push_back(sheet);
  cells_[cell].cell.sheets.push_back(index);
  return index;
}

PackedScene TestScene::packed(int lanes, int width, int height) {
  geometry.cells.clear();
  geometry.patches.clear();
  for (OpenCell& open : cells_) {
    Cell cell = open.cell;
    cell.first_face = open.first_face;
    cell.first_patch = static_cast<int>(geometry.patches.size());
    cell.patch_count = static_cast<int>(open.patches.size());
    geometry.patches.insert(geometry.patches.end(), open.patches.begin(), open.patches.end());
    geometry.cells.push_back(cell);
  }
  features_ = decide_features(scene, geometry);
  return pack(scene, geometry, features_.mask, width, height, lanes);
}

}  // namespace nicol::test
