// See path_record.hpp. The kernels are compiled here as they stand; where they say WITNESS, the log of this thread takes it
// down. PathLog's functions are those that kernels/ calls.
#include "host/record/path_record.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "host/effects.hpp"

namespace nicol {
namespace {

struct PathLog {
  const std::atomic<bool>* stop = nullptr;
  double full_weight = 1;
  std::vector<MetCell> cells;
  std::set<int> polarizers, lights;
  std::set<std::array<int, 2>> aslant;  // cells on both sides of faces that were met aslant
  bool sky = false, pair = false, cone = false;
  int faces = 0, deepest = 0;

  void starts(double weight) { full_weight = weight; }
  void goes_through(int cell, bool carries_pair, double weight) {
    if (stop && *stop) throw RecordStopped();
    if (!(weight > 0)) return;
    MetCell& met = cell_record(cell);
    met.weight = std::max(met.weight, weight);
    pair = pair || carries_pair;
  }
  void meets_face(int cell, int beyond, int level, double cosine) {
    constexpr double aslant_below = 1 - 1e-12;  // a face changes polarization by the square of the angle
    ++faces;
    ++cell_record(cell).faces;
    deepest = std::max(deepest, level + 1);
    if (cosine < aslant_below) aslant.insert({cell, beyond});
  }
  void passes_polarizer(int polarizer) { polarizers.insert(polarizer); }
  void meets_cone() { cone = true; }
  void ends_at_light(int cell, bool carries_pair, double weight, int light, bool seen) {
    if (!seen || !(weight > 0)) return;
    goes_through(cell, carries_pair, weight);
    lights.insert(light);
  }
  void ends_at_sky(int cell, bool carries_pair, double weight, bool seen) {
    if (!seen || !(weight > 0)) return;
    goes_through(cell, carries_pair, weight);
    sky = true;
  }

 private:
  MetCell& cell_record(int cell) {
    const auto found = std::find_if(cells.begin(), cells.end(), [cell](const MetCell& met) { return met.cell == cell; });
    if (found != cells.end()) return *found;
    cells.emplace_back();
    cells.back().cell = cell;
    return cells.back();
  }
};

thread_local PathLog* log_of_thread = nullptr;
struct TakingDown {
  explicit TakingDown(PathLog* log) { log_of_thread = log; }
  ~TakingDown() { log_of_thread = nullptr; }
  TakingDown(const TakingDown&) = delete;
  TakingDown& operator=(const TakingDown&) = delete;
};

}  // namespace

// Generic, double, one lane: the plainest compilation of the kernels.
namespace traced {
namespace {
#define LANES 1
#define REAL_DOUBLE
#define WITNESS(call) log_of_thread->call
#include "kernels/render.h"
}  // namespace
}  // namespace traced

namespace {

// Stokes vector that channel `channel` of the packed scene brings to a pixel.
std::array<double, 4> trace_pixel(const PackedScene& packed, int pixel, int channel, PathLog& log) {
  const double centre[2] = {0.5, 0.5};
  double out[traced::OUT_COMPONENTS];
  traced::event_count counters[traced::COUNTERS] = {};
  const TakingDown taking_down(&log);
  traced::render_item(packed.ints.data(), packed.reals.data(), packed.tables.data(), centre, &pixel, out, counters, 1, channel,
                      0, 1);
  return {out[traced::OUT_STOKES], out[traced::OUT_STOKES + 1], out[traced::OUT_STOKES + 2], out[traced::OUT_STOKES + 3]};
}

// Whether light that meets the face between two cells finds another index there.
bool changes_index(const Scene& scene, const Geometry& geometry, const std::array<int, 2>& cells) {
  const auto& one = scene.media[geometry.cells[cells[0]].medium];
  const auto& two = scene.media[geometry.cells[cells[1]].medium];
  return one.n != two.n || one.k != two.k;
}

std::vector<std::string> effects_met(const Scene& scene, const Geometry& geometry, const PathLog& log,
                                     const std::vector<int>& polarizers) {
  std::set<std::string> met;
  const auto add = [&met](const std::vector<std::string>& names) { met.insert(names.begin(), names.end()); };
  for (const MetCell& cell : log.cells) add(effects_of_medium(scene, scene.media[geometry.cells[cell.cell].medium]));
  for (const int polarizer : polarizers) add(effects_of_polarizer(scene, scene.polarizers[polarizer]));
  for (const auto& cells : log.aslant)
    if (changes_index(scene, geometry, cells)) met.insert("polarization");
  if (log.pair) met.insert("coherence");
  if (log.cone) met.insert("conical_rays");
  std::vector<std::string> effects;
  for (const Effect& effect : effects_of(scene))
    if (met.count(effect.name)) effects.push_back(effect.name);
  return effects;
}

PathRecord record_of(const Scene& scene, const Geometry& geometry, const PathLog& log) {
  PathRecord record;
  record.cells = log.cells;
  for (MetCell& met : record.cells) {
    met.medium = geometry.cells[met.cell].medium;
    met.object = geometry.cells[met.cell].object;
    met.weight /= log.full_weight;
  }
  std::set<int> polarizers = log.polarizers;
  if (scene.camera.polarizer) polarizers.insert(*scene.camera.polarizer);
  for (const int light : log.lights) {
    if (light >= static_cast<int>(scene.emissions.size())) continue;  // the dark back of a face that shines
    record.emissions.push_back(light);
    if (scene.emissions[light].polarizer) polarizers.insert(*scene.emissions[light].polarizer);
  }
  record.polarizers.assign(polarizers.begin(), polarizers.end());
  record.sky = log.sky;
  record.faces = log.faces;
  record.deepest = log.deepest;
  record.effects = effects_met(scene, geometry, log, record.polarizers);
  return record;
}

}  // namespace

PathRecord record_paths(const Scene& scene, const Geometry& geometry, std::uint32_t features, int width, int height, int x,
                        int y, std::size_t wavelength, const std::atomic<bool>* stop) {
  if (x < 0 || y < 0 || x >= width || y >= height) throw std::out_of_range("no such pixel in the picture");
  if (wavelength >= scene.lambda_nm.size()) throw std::out_of_range("no such wavelength in the scene");
  const PackedScene packed = pack(scene, geometry, features, width, height, 1);
  if (packed.fragments) throw std::runtime_error("not known: the scene has optics of plugins, which only the device runs");
  const int pixel = y * width + x;
  const bool shared = !packed.mixing.empty();  // the channels are shapes of spectra: light goes the same way in all of them
  PathLog log, unread;
  log.stop = unread.stop = stop;
  std::array<double, 4> stokes = trace_pixel(packed, pixel, shared ? 0 : static_cast<int>(wavelength), log);
  for (int channel = 0; shared && channel < packed.channels; ++channel) {
    const std::array<double, 4> part = channel == 0 ? stokes : trace_pixel(packed, pixel, channel, unread);
    const double share = packed.mixing[channel * scene.lambda_nm.size() + wavelength];
    for (int i = 0; i < 4; ++i) stokes[i] = share * part[i] + (channel == 0 ? 0 : stokes[i]);
  }
  PathRecord record = record_of(scene, geometry, log);
  record.stokes = stokes;
  return record;
}

}  // namespace nicol
