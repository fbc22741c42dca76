#include "host/pack.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/channels.hpp"
#include "host/crystal_rows.hpp"
#include "kernels/abi.h"

namespace nicol {
namespace {

constexpr double pi = 3.14159265358979323846;

double length(const Vec3& v) { return std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }

class Packer {
 public:
  Packer(const Scene& scene, const Geometry& geometry, int lanes, WavelengthRange only)
      : scene_(scene), geometry_(geometry), only_(only) {
    if (only_.count == 0) only_ = {0, scene.lambda_nm.size()};
    channels_ = choose_channels(scene);
    out_.channels = channels_.shared ? channels_.count : static_cast<int>(only_.count);
    out_.stride = (out_.channels + lanes - 1) / lanes * lanes;
    for (std::size_t at = 0; at < channels_.mixing.size(); at += scene.lambda_nm.size()) {
      const Samples cut = wanted(Samples(channels_.mixing.begin() + static_cast<std::ptrdiff_t>(at),
                                         channels_.mixing.begin() + static_cast<std::ptrdiff_t>(at + scene.lambda_nm.size())));
      out_.mixing.insert(out_.mixing.end(), cut.begin(), cut.end());
    }
    origin_ = scene_origin();
  }

  PackedScene run(std::uint32_t features, int width, int height, int pixels_across) {
    shrink_ = pixels_across > 0 ? static_cast<double>(width) / pixels_across : 1;
    out_.ints.assign(HEADER_SIZE, 0);
    out_.features = features;
    out_.width = width;
    out_.height = height;
    header(HEADER_FEATURES) = static_cast<std::int32_t>(features);
    header(HEADER_WIDTH) = width;
    header(HEADER_HEIGHT) = height;
    header(HEADER_LAMBDA_COUNT) = out_.channels;
    header(HEADER_LAMBDA_STRIDE) = out_.stride;
    header(HEADER_MAX_TRACE_LEVEL) = scene_.settings.max_trace_level;
    header(HEADER_CAMERA_CELL) = geometry_.camera_cell;
    header(HEADER_CAMERA_POLARIZER) = scene_.camera.polarizer.value_or(-1);
    header(HEADER_CELL_COUNT) = static_cast<int>(geometry_.cells.size());
    header(HEADER_SHEET_COUNT) = static_cast<int>(geometry_.sheets.size());
    header(HEADER_MEDIUM_COUNT) = static_cast<int>(scene_.media.size());
    pack_camera();
    pack_lights();
    pack_media();
    pack_polarizers();
    pack_fragments();
    pack_cells();
    pack_sheets();
    return std::move(out_);
  }

 private:
  std::int32_t& header(int slot) { return out_.ints[slot]; }
  int ints_here() const { return static_cast<int>(out_.ints.size()); }
  int reals_here() const { return static_cast<int>(out_.reals.size()); }
  void add(const Vec3& v) { out_.reals.insert(out_.reals.end(), {v.x, v.y, v.z}); }
  void add(const Plane& p) { out_.reals.insert(out_.reals.end(), {p.normal.x, p.normal.y, p.normal.z, p.offset_mm}); }

  // The middle of everything solid, so that positions keep their digits in single precision.
  Vec3 scene_origin() const {
    Vec3 low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
    const auto include = [&](const Vec3& c) {
      low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
      high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    };
    for (std::size_t i = 1; i < geometry_.cells.size(); ++i) include(geometry_.cells[i].centre_mm);
    if (geometry_.cells.size() <= 1)
      for (const Sheet& sheet : geometry_.sheets) include(sheet.centre_mm);
    if (low.x > high.x) return {};
    return {(low.x + high.x) / 2, (low.y + high.y) / 2, (low.z + high.z) / 2};
  }

  // One row; short ones are padded with their last value so that idle lanes stay finite.
  int row(const std::vector<double>& values) {
    const int index = static_cast<int>(out_.tables.size()) / out_.stride;
    for (int i = 0; i < out_.stride; ++i)
      out_.tables.push_back(values[std::min<std::size_t>(i, values.size() - 1)]);
    return index;
  }
  // Of values by wavelength, those that are packed.
  Samples wanted(const Samples& values) const {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(only_.first);
    return Samples(first, first + static_cast<std::ptrdiff_t>(only_.count));
  }
  // A row of a quantity that is given by wavelength: the same value in every shared channel.
  int transport_row(const Samples& values) { return row(channels_.shared ? Samples(1, values.front()) : wanted(values)); }
  int source_row(const Samples& radiance, const std::vector<double>* shares) {
    std::vector<double> values = channels_.shared ? *shares : wanted(radiance);
    values.resize(out_.stride, 0.0);  // idle lanes see no light
    return row(values);
  }

  void pack_camera() {
    const Camera& camera = scene_.camera;
    header(HEADER_CAMERA_REALS) = reals_here();
    add(minus(camera.location, origin_));
    add(camera.direction);
    add(camera.right);
    add(camera.up);
    const double pixel = shrink_ * std::sqrt(length(camera.right) / out_.width * length(camera.up) / out_.height);
    const double per_mm = camera.orthographic ? 0 : pixel / length(camera.direction);
    out_.reals.insert(out_.reals.end(), {camera.orthographic ? pixel : 0, per_mm});
    header(HEADER_CONICAL_RAYS) = scene_.settings.conical_rays;
    header(HEADER_SETTING_REALS) = reals_here();
    const double spread = scene_.settings.conical_spread_rad;
    out_.reals.insert(out_.reals.end(), {scene_.settings.adc_bailout, spread > 0 ? spread : std::max(per_mm, 1e-5)});
  }

  // The scene's emissions, and last a black one for the back of a one-sided luminous face.
  void pack_lights() {
    header(HEADER_SKY_ROW) = source_row(scene_.sky, &channels_.sky);
    header(HEADER_LIGHTS_AT) = ints_here();
    for (std::size_t i = 0; i < scene_.emissions.size(); ++i) {
      const Emission& e = scene_.emissions[i];
      const int at = source_row(e.radiance, channels_.shared ? &channels_.emission[i] : nullptr);
      out_.ints.insert(out_.ints.end(), {at, e.polarizer.value_or(-1), e.one_sided ? 1 : 0});
    }
    black_light_ = static_cast<int>(scene_.emissions.size());
    out_.ints.insert(out_.ints.end(), {row({0.0}), -1, 0});
  }

  // Rows of a medium that is isotropic or taken as such; what a crystal adds comes after.
  int pack_medium(const Medium& medium) {
    const std::size_t count = medium.n[0].size();
    Samples absorb(count), hi(count), lo(count);
    for (std::size_t i = 0; i < count; ++i) {
      absorb[i] = 4 * pi * medium.k[0][i] / (scene_.lambda_nm[i] * 1e-6);
      const double turns = medium.rotation_deg_per_mm[i] / 360;
      hi[i] = static_cast<float>(turns);
      lo[i] = turns - hi[i];
    }
    const int first = transport_row(reference_index(medium));
    transport_row(medium.k[0]);
    transport_row(absorb);
    transport_row(hi);
    transport_row(lo);
    for (const Samples& values : crystal_rows(medium, scene_.lambda_nm)) transport_row(values);
    return first;
  }

  void pack_media() {
    const auto any = [](const Samples& v) { return std::any_of(v.begin(), v.end(), [](double x) { return x != 0; }); };
    std::vector<Medium> media;
    for (const Medium& medium : scene_.media)
      media.push_back(scene_.settings.polarization ? medium : without_polarization(medium));
    std::vector<std::int32_t> records;
    std::vector<Samples> index;
    for (const Medium& medium : media) {
      const bool absorbs = any(medium.k[0]) || any(medium.k[1]) || any(medium.k[2]);
      records.insert(records.end(), {pack_medium(medium), absorbs, any(medium.rotation_deg_per_mm), waves_of(medium),
                                     medium.is_active()});
      index.push_back(reference_index(medium));
    }
    header(HEADER_MEDIA_AT) = ints_here();
    out_.ints.insert(out_.ints.end(), records.begin(), records.end());
    header(HEADER_DELTA_ROW) = static_cast<int>(out_.tables.size()) / out_.stride;
    for (const Samples& one : index) {
      for (const Samples& two : index) {
        Samples delta(one.size());
        for (std::size_t i = 0; i < delta.size(); ++i) delta[i] = (two[i] - one[i]) * (two[i] + one[i]);
        transport_row(delta);
      }
    }
    pack_wavelengths();
  }

  // A single wavelength is strictly monochromatic light: its bin has no width.
  void pack_wavelengths() {
    Samples per_mm, bin;
    for (std::size_t i = 0; i < scene_.lambda_nm.size(); ++i) {
      per_mm.push_back(1 / (scene_.lambda_nm[i] * 1e-6));
      bin.push_back(scene_.lambda_nm.size() == 1 ? 0 : scene_.weight_nm[i] / scene_.lambda_nm[i]);
    }
    header(HEADER_WAVELENGTH_ROW) = transport_row(per_mm);
    transport_row(bin);
  }

  void pack_polarizers() {
    header(HEADER_POLARIZERS_AT) = ints_here();
    header(HEADER_POLARIZER_REALS) = reals_here();
    for (const Polarizer& polarizer : scene_.polarizers) {
      int first = -1;
      if (polarizer.kind == Polarizer::Kind::calcite) {
        first = transport_row(polarizer.n_o);
        transport_row(polarizer.n_e);
      }
      const int kind = polarizer.kind == Polarizer::Kind::calcite ? POLARIZER_CALCITE
                       : polarizer.kind == Polarizer::Kind::fragment ? POLARIZER_FRAGMENT
                       : polarizer.kind == Polarizer::Kind::ideal ? POLARIZER_IDEAL
                                                                  : POLARIZER_IDEAL_ABSORBING;
      out_.ints.insert(out_.ints.end(), {kind, first, polarizer.fragment});
      add(polarizer.transmission_axis);
      add(polarizer.normal);
    }
  }

  void pack_fragments() {
    out_.fragments = fragments_of(scene_, geometry_);
    header(HEADER_FRAGMENTS_AT) = ints_here();
    header(HEADER_FRAGMENT_REALS) = reals_here();
    if (!out_.fragments) return;
    int first = 0;
    for (const SceneFragments::Use& use : out_.fragments->uses) {
      out_.ints.insert(out_.ints.end(), {use.index, first, use.fragment->reflects});
      out_.reals.insert(out_.reals.end(), use.values.begin(), use.values.end());
      first += static_cast<int>(use.values.size());
    }
  }

  int add_edges(const std::vector<Plane>& edges) {
    const int first = static_cast<int>(edges_.size());
    edges_.insert(edges_.end(), edges.begin(), edges.end());
    return first;
  }

  int twin_of(const Patch& patch) const {
    if (patch.other_face < 0) return -1;
    const Cell& other = geometry_.cells[patch.other_cell];
    for (int i = other.first_patch; i < other.first_patch + other.patch_count; ++i)
      if (geometry_.patches[i].face == patch.other_face && geometry_.patches[i].other_face == patch.face) return new_patch_[i];
    return -1;
  }

  // Patches in the order of the kernels: a luminous face adds one to its own cell, for rays from inside.
  void number_patches() {
    new_patch_.assign(geometry_.patches.size(), -1);
    int next = 0;
    for (const Cell& cell : geometry_.cells) {
      for (int i = cell.first_patch; i < cell.first_patch + cell.patch_count; ++i) new_patch_[i] = next++;
      for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) next += geometry_.faces[f].emission >= 0;
    }
    header(HEADER_PATCH_COUNT) = next;
  }

  double cell_radius(const Cell& cell) const {
    double largest2 = 0;
    for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
      for (const Vec3& corner : geometry_.faces[f].corners) {
        const Vec3 r = minus(corner, cell.centre_mm);
        largest2 = std::max(largest2, r.x * r.x + r.y * r.y + r.z * r.z);
      }
    }
    return std::sqrt(largest2) * (1 + 1e-5);  // above the rounding of single precision
  }

  void pack_patch(int cell, const Patch& patch, std::vector<std::int32_t>& ints, std::vector<double>& reals) {
    static constexpr int behind[] = {BEHIND_SEAM, BEHIND_CELL_GAP, BEHIND_CELL_CONTACT, BEHIND_LIGHT, BEHIND_POLARIZER};
    const int light = patch.emission >= 0 ? patch.emission : black_light_;
    ints.insert(ints.end(), {behind[static_cast<int>(patch.behind)], cell, patch.face, twin_of(patch), patch.sheet, light,
                             add_edges(patch.edges), static_cast<int>(patch.edges.size()), patch.has_disc});
    const Ring& ring = patch.disc;
    reals.insert(reals.end(), {ring.centre_mm.x, ring.centre_mm.y, ring.centre_mm.z, ring.radius_mm * ring.radius_mm,
                               ring.hole_radius_mm * ring.hole_radius_mm});
  }

  void pack_cells() {
    number_patches();
    std::vector<std::int32_t> cell_ints, patch_ints, lists;
    std::vector<double> cell_reals, patch_reals;
    for (std::size_t c = 0; c < geometry_.cells.size(); ++c) {
      const Cell& cell = geometry_.cells[c];
      const int first_patch = static_cast<int>(patch_ints.size()) / PATCH_INTS;
      for (int i = cell.first_patch; i < cell.first_patch + cell.patch_count; ++i)
        pack_patch(static_cast<int>(c), geometry_.patches[i], patch_ints, patch_reals);
      for (int f = cell.first_face; f < cell.first_face + cell.face_count; ++f) {
        const int emission = geometry_.faces[f].emission;
        if (emission < 0) continue;
        Patch own;
        own.face = f;
        own.emission = scene_.emissions[emission].one_sided ? -1 : emission;
        pack_patch(static_cast<int>(c), own, patch_ints, patch_reals);
      }
      const int patch_count = static_cast<int>(patch_ints.size()) / PATCH_INTS - first_patch;
      const int children = static_cast<int>(lists.size());
      lists.insert(lists.end(), cell.children.begin(), cell.children.end());
      const int sheets = static_cast<int>(lists.size());
      lists.insert(lists.end(), cell.sheets.begin(), cell.sheets.end());
      cell_ints.insert(cell_ints.end(),
                       {cell.first_face, cell.face_count, first_patch, patch_count, children,
                        static_cast<int>(cell.children.size()), sheets, static_cast<int>(cell.sheets.size()),
                        cell.medium, cell.parent});
      const Vec3 centre = c == 0 ? Vec3{} : minus(cell.centre_mm, origin_);
      cell_reals.insert(cell_reals.end(), {centre.x, centre.y, centre.z, cell_radius(cell)});
    }
    header(HEADER_CELLS_AT) = ints_here();
    out_.ints.insert(out_.ints.end(), cell_ints.begin(), cell_ints.end());
    header(HEADER_FACES_AT) = ints_here();
    const std::size_t faces_at = out_.ints.size();
    for (const Face& face : geometry_.faces) out_.ints.insert(out_.ints.end(), {face.emission, -1});
    for (const Cell& cell : geometry_.cells)
      for (int f = cell.first_face; cell.object >= 0 && f < cell.first_face + cell.face_count; ++f)
        out_.ints[faces_at + static_cast<std::size_t>(f) * FACE_INTS + FACE_SURFACE] =
            surface_of_face(scene_.objects[cell.object], geometry_.faces[f].shape_face);
    header(HEADER_PATCHES_AT) = ints_here();
    out_.ints.insert(out_.ints.end(), patch_ints.begin(), patch_ints.end());
    header(HEADER_LISTS_AT) = ints_here();
    out_.ints.insert(out_.ints.end(), lists.begin(), lists.end());
    header(HEADER_CELL_REALS) = reals_here();
    out_.reals.insert(out_.reals.end(), cell_reals.begin(), cell_reals.end());
    header(HEADER_FACE_REALS) = reals_here();
    for (const Face& face : geometry_.faces) add(face.plane);
    header(HEADER_PATCH_REALS) = reals_here();
    out_.reals.insert(out_.reals.end(), patch_reals.begin(), patch_reals.end());
  }

  void pack_sheets() {
    header(HEADER_SHEETS_AT) = ints_here();
    header(HEADER_SHEET_REALS) = reals_here();
    for (std::size_t s = 0; s < geometry_.sheets.size(); ++s) {
      const Sheet& sheet = geometry_.sheets[s];
      const bool touches = std::any_of(geometry_.patches.begin(), geometry_.patches.end(), [&](const Patch& p) {
        return p.behind == Patch::Behind::polarizer && p.sheet == static_cast<int>(s);
      });
      out_.ints.insert(out_.ints.end(), {sheet.emission, sheet.polarizer, touches, add_edges(sheet.edges),
                                         static_cast<int>(sheet.edges.size()), sheet.has_disc});
      add(minus(sheet.centre_mm, origin_));
      add(sheet.plane);
      add(sheet.disc.centre_mm);
      out_.reals.push_back(sheet.disc.radius_mm * sheet.disc.radius_mm);
      out_.reals.push_back(sheet.disc.hole_radius_mm * sheet.disc.hole_radius_mm);
    }
    header(HEADER_EDGE_REALS) = reals_here();
    for (const Plane& edge : edges_) add(edge);
  }

  const Scene& scene_;
  const Geometry& geometry_;
  WavelengthRange only_;
  Channels channels_;
  PackedScene out_;
  double shrink_ = 1;  // of a pixel, against the picture's edge over `width`
  Vec3 origin_;
  std::vector<Plane> edges_;
  std::vector<int> new_patch_;
  int black_light_ = 0;
};

}  // namespace

PackedScene pack(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height, int lanes,
                 int pixels_across, WavelengthRange only) {
  return Packer(scene, geometry, lanes, only).run(features, width, height, pixels_across);
}

}  // namespace nicol
