// Pictures of the C interface: film, planes, report, error budget, notes, files.
#include <fmt/format.h>

#include "host/api/handles.hpp"
#include "host/optics/colour.hpp"

using namespace nicol;
using namespace nicol::api;

namespace {

const nicol_picture& checked(const nicol_picture* picture) {
  require(picture, "picture");
  return *picture;
}

[[noreturn]] void unavailable(const std::string& what) { throw Failure(NICOL_ERROR_UNAVAILABLE, what); }

const float* named_plane(const Frame& frame, const std::string& name) {
  for (const auto& [plane, values] : frame.planes)
    if (plane == name) return values.data();
  return nullptr;
}

const float* not_empty(const std::vector<float>& values, const char* what) {
  if (values.empty()) unavailable(fmt::format("the picture has no {}", what));
  return values.data();
}

const float* bound_plane(const nicol_picture& picture, const char* name) {
  if (!picture.bound) unavailable("the picture was not rendered with want_error_bound, or not to its end");
  const float* values = named_plane(*picture.bound, name);
  if (!values) unavailable(fmt::format("the error bound has no {}", name));
  return values;
}

const float* plane_of(const nicol_picture& picture, nicol_plane plane) {
  const Frame& frame = picture.picture.frame;
  switch (plane) {
    case NICOL_PLANE_COVERAGE: return picture.coverage().data();
    case NICOL_PLANE_SAMPLES: return not_empty(picture.sample_counts(), "numbers of samples");
    case NICOL_PLANE_CUT_OFF: return not_empty(frame.cut_off, "cut-off");
    case NICOL_PLANE_SAMPLE_ERROR: return not_empty(frame.sample_error, "estimate of the error of pixel sampling");
    case NICOL_PLANE_ERROR_CUT_OFF: return bound_plane(picture, "error.cutoff");
    case NICOL_PLANE_ERROR_SAMPLING: return bound_plane(picture, "error.sampling");
    case NICOL_PLANE_ERROR_ROUNDING: return bound_plane(picture, "error.rounding");
    case NICOL_PLANE_ERROR_TOTAL: return bound_plane(picture, "error.total");
    default: throw Failure(NICOL_ERROR_ARGUMENT, fmt::format("there is no plane {}", plane));
  }
}

nicol_report report_of(const RenderReport& from) {
  nicol_report report{};
  report.lanes = from.lanes;
  report.precision = from.real == "double" ? NICOL_DOUBLE : NICOL_FLOAT;
  report.interrupted = from.interrupted;
  report.device = from.device.c_str();
  report.seconds = from.seconds;
  report.seconds_to_first_tile = from.seconds_to_first_tile;
  report.build_seconds = from.build.seconds;
  report.kernel_cached = from.build.cached;
  report.passes = from.passes;
  report.segments = from.segments;
  report.nan_count = from.nan_count;
  report.energy_count = from.energy_count;
  report.stack_count = from.stack_count;
  report.stokes_count = from.stokes_count;
  report.precise_count = from.fallback_count;
  report.tiles = static_cast<uint64_t>(from.tiles);
  report.tiles_found = static_cast<uint64_t>(from.tiles_found);
  report.samples_mean = from.samples_mean;
  report.sample_error = from.sample_error;
  report.sample_error_kept = from.sample_error_kept;
  report.mean_radiance = from.mean_radiance;
  report.cut_off_mean = from.cut_off_mean;
  report.cut_off_worst = from.cut_off_worst;
  return report;
}

}  // namespace

const std::vector<float>& nicol_picture::xyz() const {
  std::call_once(xyz_once_, [&] {
    const Frame& frame = picture.frame;
    const Observer observer(frame.lambda_nm, frame.weight_nm);
    std::vector<float> values(3 * frame.plane());
    for (std::size_t p = 0; p < frame.plane(); ++p) {
      const auto pixel = observer.xyz(frame.component(0, 0) + p, frame.plane());
      for (std::size_t k = 0; k < 3; ++k) values[k * frame.plane() + p] = static_cast<float>(pixel[k]);
    }
    xyz_ = std::move(values);
  });
  return xyz_;
}

const std::vector<float>& nicol_picture::rgb() const {
  std::call_once(rgb_once_, [&] {
    const std::vector<float> pixels = linear_rgb(picture.frame);
    const std::size_t plane = picture.frame.plane();
    std::vector<float> values(3 * plane);
    for (std::size_t p = 0; p < plane; ++p)
      for (std::size_t k = 0; k < 3; ++k) values[k * plane + p] = pixels[3 * p + k];
    rgb_ = std::move(values);
  });
  return rgb_;
}

const std::vector<float>& nicol_picture::coverage() const {
  std::call_once(coverage_once_, [&] {
    const Frame& frame = picture.frame;
    const std::size_t width = static_cast<std::size_t>(frame.width);
    std::vector<float> values(frame.plane(), 1.0f);
    if (const float* weight = named_plane(frame, "weight")) values.assign(weight, weight + frame.plane());
    else
      for (std::size_t row = 0; row < frame.row_done.size(); ++row)
        std::fill_n(values.begin() + static_cast<std::ptrdiff_t>(row * width), width, frame.row_done[row] != 0 ? 1.0f : 0.0f);
    coverage_ = std::move(values);
  });
  return coverage_;
}

const std::vector<float>& nicol_picture::sample_counts() const {
  const std::vector<float>& covered = coverage();
  std::call_once(samples_once_, [&] {
    const Frame& frame = picture.frame;
    std::vector<float> values;
    if (!frame.samples.empty()) values.assign(frame.samples.begin(), frame.samples.end());
    else if (samples > 0)
      for (const float weight : covered) values.push_back(weight > 0 ? static_cast<float>(samples) : 0.0f);
    samples_ = std::move(values);
  });
  return samples_;
}

extern "C" {

nicol_picture* nicol_picture_retain(nicol_picture* picture) { return retained(picture); }
void nicol_picture_release(nicol_picture* picture) { released(picture); }

nicol_status nicol_picture_size(const nicol_picture* picture, int32_t* width, int32_t* height) {
  return guarded([&] {
    const Frame& frame = checked(picture).picture.frame;
    require(width, "width");
    require(height, "height");
    *width = frame.width;
    *height = frame.height;
    return NICOL_OK;
  });
}

nicol_status nicol_picture_wavelengths(const nicol_picture* picture, const double** wavelengths_nm, const double** widths_nm,
                                       size_t* count) {
  return guarded([&] {
    require(wavelengths_nm, "wavelengths_nm");
    require(count, "count");
    const Frame& frame = checked(picture).picture.frame;
    *wavelengths_nm = frame.lambda_nm.data();
    if (widths_nm) *widths_nm = frame.weight_nm.data();
    *count = frame.lambda_nm.size();
    return NICOL_OK;
  });
}

nicol_status nicol_picture_stokes(const nicol_picture* picture, const float** stokes) {
  return guarded([&] {
    require(stokes, "stokes");
    *stokes = nullptr;
    *stokes = checked(picture).picture.frame.stokes.data();
    return NICOL_OK;
  });
}

nicol_status nicol_picture_xyz(const nicol_picture* picture, const float** xyz) {
  return guarded([&] {
    require(xyz, "xyz");
    *xyz = nullptr;
    *xyz = checked(picture).xyz().data();
    return NICOL_OK;
  });
}

nicol_status nicol_picture_linear_srgb(const nicol_picture* picture, const float** rgb) {
  return guarded([&] {
    require(rgb, "rgb");
    *rgb = nullptr;
    *rgb = checked(picture).rgb().data();
    return NICOL_OK;
  });
}

nicol_status nicol_picture_plane(const nicol_picture* picture, nicol_plane plane, const float** values) {
  return guarded([&] {
    require(values, "values");
    *values = nullptr;
    *values = plane_of(checked(picture), plane);
    return NICOL_OK;
  });
}

nicol_status nicol_picture_report(const nicol_picture* picture, nicol_report* report) {
  return guarded([&] {
    if (!checked(picture).scene.get()) unavailable("a merged picture has no report; its notes tell of its parts");
    give(report_of(picture->picture.report), report, "report");
    return NICOL_OK;
  });
}

size_t nicol_picture_budget_count(const nicol_picture* picture) { return picture ? picture->picture.budget.lines.size() : 0; }

nicol_status nicol_picture_budget_line(const nicol_picture* picture, size_t index, nicol_budget_line* line) {
  return guarded([&] {
    const auto& lines = checked(picture).picture.budget.lines;
    require(index < lines.size(), fmt::format("there is no line {} in the error budget", index));
    const engine::BudgetLine& from = lines[index];
    give(nicol_budget_line{0, 0, from.source.c_str(), from.rms, from.detail.c_str(), from.price.c_str(), from.seconds}, line, "line");
    return NICOL_OK;
  });
}

nicol_status nicol_picture_budget_rms(const nicol_picture* picture, double* rms) {
  return guarded([&] {
    require(rms, "rms");
    if (checked(picture).picture.budget.lines.empty()) unavailable("the picture was not rendered with want_error_budget");
    *rms = picture->picture.budget.rms;
    return NICOL_OK;
  });
}

nicol_status nicol_picture_chosen(const nicol_picture* picture, nicol_chosen* chosen) {
  return guarded([&] {
    const engine::Picture& made = checked(picture).picture;
    if (!made.chosen) unavailable("no error was asked for");
    give(nicol_chosen{0, made.error_kept() ? 1 : 0, made.error, made.chosen->text.c_str(), made.chosen->reason.c_str(),
                      made.chosen->seconds},
         chosen, "chosen");
    return NICOL_OK;
  });
}

size_t nicol_picture_note_count(const nicol_picture* picture) { return picture ? picture->picture.frame.how.size() : 0; }

nicol_status nicol_picture_note(const nicol_picture* picture, size_t index, const char** key, const char** text) {
  return guarded([&] {
    require(key, "key");
    require(text, "text");
    const auto& notes = checked(picture).picture.frame.how;
    require(index < notes.size(), fmt::format("there is no note {}", index));
    *key = notes[index].first.c_str();
    *text = notes[index].second.c_str();
    return NICOL_OK;
  });
}

nicol_status nicol_picture_write(const nicol_picture* picture, const char* path) {
  return guarded([&] {
    const engine::Picture& made = checked(picture).picture;
    require(path, "path");
    engine::check_output(made.share, path);
    make_sink(path)->write(made.frame);
    return NICOL_OK;
  });
}

nicol_status nicol_picture_write_error_map(const nicol_picture* picture, const char* path) {
  return guarded([&] {
    require(path, "path");
    if (!checked(picture).bound) unavailable("the picture was not rendered with want_error_bound, or not to its end");
    make_sink(path)->write(*picture->bound);
    return NICOL_OK;
  });
}

}  // extern "C"
