// libnicol for C++17: the C interface of nicol.h with handles that release themselves, exceptions and std::function. Header only; what
// functions mean, units, shapes and thread rules are told there.
#pragma once
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "nicol.h"

namespace nicol {

// A status that is not NICOL_OK.
class Error : public std::runtime_error {
 public:
  Error(nicol_status status, const std::string& text) : std::runtime_error(text), status_(status) {}
  nicol_status status() const { return status_; }

 private:
  nicol_status status_;
};

// Values that something else owns.
template <class T>
class View {
 public:
  View() = default;
  View(const T* values, std::size_t count) : values_(values), count_(count) {}
  const T* data() const { return values_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const T* begin() const { return values_; }
  const T* end() const { return values_ + count_; }
  const T& operator[](std::size_t i) const { return values_[i]; }

 private:
  const T* values_ = nullptr;
  std::size_t count_ = 0;
};

namespace detail {

inline void check(nicol_status status) {
  if (status != NICOL_OK) throw Error(status, nicol_last_error());
}

template <class Struct>
Struct sized() {
  Struct made{};
  made.struct_size = sizeof(Struct);
  return made;
}

inline std::vector<const char*> pointers(const std::vector<std::string>& texts) {
  std::vector<const char*> all;
  for (const std::string& text : texts) all.push_back(text.c_str());
  return all;
}

// One count on a C handle.
template <class Raw, Raw* (*retain)(Raw*), void (*release)(Raw*)>
class Handle {
 public:
  explicit Handle(Raw* raw) : raw_(raw) {}
  Handle(const Handle& other) : raw_(retain(other.raw_)) {}
  Handle(Handle&& other) noexcept : raw_(std::exchange(other.raw_, nullptr)) {}
  Handle& operator=(Handle other) noexcept {
    std::swap(raw_, other.raw_);
    return *this;
  }
  ~Handle() { release(raw_); }
  Raw* get() const { return raw_; }

 private:
  Raw* raw_;
};

// What a callback threw, to be thrown again on the other side of the C interface.
class Carried {
 public:
  template <class Call>
  int run(Call call) noexcept {
    try {
      return call() ? 0 : 1;
    } catch (...) {
      thrown_ = std::current_exception();
      return 1;
    }
  }
  void rethrow() const {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  std::exception_ptr thrown_;
};

}  // namespace detail

inline std::string version() { return nicol_version(); }

inline std::vector<nicol_device_info> devices() {
  std::size_t count = 0;
  detail::check(nicol_device_count(&count));
  std::vector<nicol_device_info> all(count, detail::sized<nicol_device_info>());
  for (std::size_t i = 0; i < count; ++i) detail::check(nicol_device_get(i, &all[i]));
  return all;
}

struct ContextOptions {
  std::string device;
  std::vector<std::string> library_paths;
  std::function<void(nicol_severity, std::string_view)> log;  // must not throw: an exception stops the call with NICOL_ERROR_CALLBACK
};

class Picture;

class Context {
 public:
  explicit Context(const ContextOptions& options = {}) : log_(std::make_shared<Log>(options.log)), handle_(create(options, log_.get())) {}

  nicol_device_info device() const {
    auto info = detail::sized<nicol_device_info>();
    detail::check(nicol_context_device(get(), &info));
    return info;
  }

  void load_plugin(const std::string& path) const { detail::check(nicol_load_plugin(get(), path.c_str())); }

  // Joins parts written as .exr. incomplete: even where something is missing.
  Picture merge(const std::vector<std::string>& paths, bool incomplete = false) const;

  nicol_context* get() const { return handle_.get(); }

 private:
  using Log = std::function<void(nicol_severity, std::string_view)>;
  static nicol_context* create(const ContextOptions& options, Log* log) {
    const auto paths = detail::pointers(options.library_paths);
    auto raw = detail::sized<nicol_context_options>();
    raw.device = options.device.c_str();
    raw.library_paths = paths.data();
    raw.library_path_count = static_cast<std::uint32_t>(paths.size());
    if (*log) raw.log = [](void* user, nicol_severity severity, const char* text) { (*static_cast<Log*>(user))(severity, text); };
    raw.user = log;
    nicol_context* made = nullptr;
    detail::check(nicol_context_create(&raw, &made));
    return made;
  }

  friend class Scene;
  friend class Picture;
  std::shared_ptr<Log> log_;  // outlives the handle
  detail::Handle<nicol_context, nicol_context_retain, nicol_context_release> handle_;
};

struct SceneOptions {
  int width = 0, height = 0;
  std::vector<std::string> library_paths;
  std::vector<std::pair<std::string, double>> declares;
  std::vector<double> wavelengths_nm;
  int samples = 0, max_trace_level = 0;
  double error = 0, sample_error = 0, adc_bailout = 0;
  nicol_switch polarization = NICOL_AS_IN_SCENE;
  int frame_number = 0, initial_frame = 0, final_frame = 0;
  double clock = 0, clock_delta = 0, initial_clock = 0, final_clock = 0;
  std::function<std::optional<std::string>(std::string_view name)> include;  // none: a file
};

struct Diagnostic {
  nicol_severity severity;
  std::string file;
  std::uint32_t line, column;
  std::string message, text;
};

struct Feature {
  bool on;
  std::string name, meaning, reason;
};

struct Tile {
  int width, height;
  View<std::int32_t> pixels;
  View<double> wavelengths_nm;
  View<float> stokes;       // [component 0..3][wavelength][pixels.size()]
  View<float> linear_srgb;  // [pixels.size()][3]
};

// First and count of rows or columns.
struct Span {
  int first = 0, count = 0;
};

struct RenderOptions {
  nicol_precision precision = NICOL_FLOAT;
  int lanes = 0;
  bool generic = false, no_cache = false;
  std::string journal;  // "": none
  bool resume = false, want_error_bound = false, want_error_budget = false;
  int part = 0, part_count = 0;
  Span rows, columns;
  double first_wavelength_nm = 0, last_wavelength_nm = 0;
  // false: stop
  std::function<bool(double fraction, double seconds, double seconds_left)> progress;
  std::function<bool(const Tile&)> tile;
  std::function<bool()> cancel;  // true: stop
};

struct BudgetLine {
  std::string source;
  double rms;
  std::string detail, price;
  double seconds;
};

class Picture {
 public:
  // NICOL_CANCELLED: a callback said stop.
  bool cancelled() const { return cancelled_; }
  int width() const { return size().first; }
  int height() const { return size().second; }
  std::size_t plane_size() const { return static_cast<std::size_t>(width()) * static_cast<std::size_t>(height()); }

  View<double> wavelengths_nm() const { return wavelengths().first; }
  View<double> widths_nm() const { return wavelengths().second; }
  View<float> stokes() const { return {values(nicol_picture_stokes), 4 * wavelengths_nm().size() * plane_size()}; }
  View<float> stokes(int component, std::size_t wavelength) const {
    return {stokes().data() + (static_cast<std::size_t>(component) * wavelengths_nm().size() + wavelength) * plane_size(), plane_size()};
  }
  View<float> xyz() const { return {values(nicol_picture_xyz), 3 * plane_size()}; }
  View<float> linear_srgb() const { return {values(nicol_picture_linear_srgb), 3 * plane_size()}; }
  View<float> plane(nicol_plane which) const {
    const float* found = nullptr;
    detail::check(nicol_picture_plane(get(), which, &found));
    return {found, plane_size()};
  }

  nicol_report report() const {
    auto report = detail::sized<nicol_report>();
    detail::check(nicol_picture_report(get(), &report));
    return report;
  }
  std::vector<BudgetLine> budget() const {
    std::vector<BudgetLine> lines;
    for (std::size_t i = 0; i < nicol_picture_budget_count(get()); ++i) {
      auto line = detail::sized<nicol_budget_line>();
      detail::check(nicol_picture_budget_line(get(), i, &line));
      lines.push_back({line.source, line.rms, line.detail, line.price, line.seconds});
    }
    return lines;
  }
  double budget_rms() const {
    double rms = 0;
    detail::check(nicol_picture_budget_rms(get(), &rms));
    return rms;
  }
  // Texts valid as long as the picture.
  nicol_chosen chosen() const {
    auto chosen = detail::sized<nicol_chosen>();
    detail::check(nicol_picture_chosen(get(), &chosen));
    return chosen;
  }
  std::vector<std::pair<std::string, std::string>> notes() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (std::size_t i = 0; i < nicol_picture_note_count(get()); ++i) {
      const char *key = nullptr, *text = nullptr;
      detail::check(nicol_picture_note(get(), i, &key, &text));
      all.emplace_back(key, text);
    }
    return all;
  }

  void write(const std::string& path) const { detail::check(nicol_picture_write(get(), path.c_str())); }
  void write_error_map(const std::string& path) const { detail::check(nicol_picture_write_error_map(get(), path.c_str())); }

  nicol_picture* get() const { return handle_.get(); }

 private:
  friend class Context;
  friend class Scene;
  Picture(const Context& context, nicol_picture* raw, bool cancelled) : context_(context), handle_(raw), cancelled_(cancelled) {}

  std::pair<int, int> size() const {
    std::int32_t width = 0, height = 0;
    detail::check(nicol_picture_size(get(), &width, &height));
    return {width, height};
  }
  std::pair<View<double>, View<double>> wavelengths() const {
    const double *lambda = nullptr, *widths = nullptr;
    std::size_t count = 0;
    detail::check(nicol_picture_wavelengths(get(), &lambda, &widths, &count));
    return {{lambda, count}, {widths, count}};
  }
  const float* values(nicol_status (*read)(const nicol_picture*, const float**)) const {
    const float* found = nullptr;
    detail::check(read(get(), &found));
    return found;
  }

  Context context_;
  detail::Handle<nicol_picture, nicol_picture_retain, nicol_picture_release> handle_;
  bool cancelled_;
};

class Scene {
 public:
  // A scene with errors is one too: see whole() and diagnostics(). Throws Error for all else, and what `include` throws.
  static Scene load_file(const Context& context, const std::string& path, const SceneOptions& options = {}) {
    return load(context, options, [&](const nicol_scene_options* raw, nicol_scene** scene) {
      return nicol_scene_load_file(context.get(), path.c_str(), raw, scene);
    });
  }
  static Scene load_text(const Context& context, const std::string& name, std::string_view text, const SceneOptions& options = {}) {
    return load(context, options, [&](const nicol_scene_options* raw, nicol_scene** scene) {
      return nicol_scene_load_text(context.get(), name.c_str(), text.data(), text.size(), raw, scene);
    });
  }

  bool whole() const { return nicol_scene_is_whole(get()) == 1; }
  std::vector<Diagnostic> diagnostics() const {
    std::vector<Diagnostic> all;
    for (std::size_t i = 0; i < nicol_scene_diagnostic_count(get()); ++i) {
      auto d = detail::sized<nicol_diagnostic>();
      detail::check(nicol_scene_diagnostic(get(), i, &d));
      all.push_back({d.severity, d.file, d.line, d.column, d.message, d.text});
    }
    return all;
  }
  std::vector<std::string> files() const {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < nicol_scene_file_count(get()); ++i) {
      const char* path = nullptr;
      detail::check(nicol_scene_file(get(), i, &path));
      all.emplace_back(path);
    }
    return all;
  }
  std::vector<Feature> features() const {
    std::vector<Feature> all;
    for (std::size_t i = 0; i < nicol_scene_feature_count(get()); ++i) {
      auto f = detail::sized<nicol_feature>();
      detail::check(nicol_scene_feature(get(), i, &f));
      all.push_back({f.on == 1, f.name, f.meaning, f.reason});
    }
    return all;
  }
  std::string explanation() const {
    const char* text = nullptr;
    detail::check(nicol_scene_explanation(get(), &text));
    return text;
  }
  View<double> wavelengths_nm() const {
    const double* values = nullptr;
    std::size_t count = 0;
    detail::check(nicol_scene_wavelengths(get(), &values, &count));
    return {values, count};
  }

  // Throws Error, also for a rendering stopped before there was anything to show, and what a callback throws.
  Picture render(const RenderOptions& options = {}) const {
    Calls calls{options, {}};
    const nicol_render_options raw = raw_of(calls);
    nicol_picture* picture = nullptr;
    const nicol_status status = nicol_render(get(), &raw, &picture);
    const std::string words = status == NICOL_OK ? "" : nicol_last_error();
    const Picture made(context_, picture, status == NICOL_CANCELLED);
    calls.carried.rethrow();
    if (!picture || (status != NICOL_OK && status != NICOL_CANCELLED)) throw Error(status, words);
    return made;
  }

  nicol_scene* get() const { return handle_.get(); }

 private:
  struct Calls {
    const RenderOptions& options;
    detail::Carried carried;
  };
  struct Including {
    const SceneOptions& options;
    detail::Carried carried;
  };

  Scene(const Context& context, nicol_scene* raw) : context_(context), handle_(raw) {}

  template <class Load>
  static Scene load(const Context& context, const SceneOptions& options, Load read) {
    Including including{options, {}};
    std::vector<const char*> names;
    std::vector<double> values;
    for (const auto& [name, value] : options.declares) {
      names.push_back(name.c_str());
      values.push_back(value);
    }
    const auto paths = detail::pointers(options.library_paths);
    nicol_scene_options raw = raw_of(options);
    raw.library_paths = paths.data();
    raw.library_path_count = static_cast<std::uint32_t>(paths.size());
    raw.declare_names = names.data();
    raw.declare_values = values.data();
    raw.declare_count = names.size();
    if (options.include) raw.include = include;
    raw.user = &including;
    nicol_scene* scene = nullptr;
    const nicol_status status = read(&raw, &scene);
    const std::string words = status == NICOL_OK ? "" : nicol_last_error();
    including.carried.rethrow();
    if (!scene) throw Error(status, words);
    return Scene(context, scene);
  }

  static nicol_scene_options raw_of(const SceneOptions& options) {
    auto raw = detail::sized<nicol_scene_options>();
    raw.width = options.width;
    raw.height = options.height;
    raw.wavelengths_nm = options.wavelengths_nm.data();
    raw.wavelength_count = options.wavelengths_nm.size();
    raw.samples = options.samples;
    raw.max_trace_level = options.max_trace_level;
    raw.error = options.error;
    raw.sample_error = options.sample_error;
    raw.adc_bailout = options.adc_bailout;
    raw.polarization = options.polarization;
    raw.frame_number = options.frame_number;
    raw.initial_frame = options.initial_frame;
    raw.final_frame = options.final_frame;
    raw.clock = options.clock;
    raw.clock_delta = options.clock_delta;
    raw.initial_clock = options.initial_clock;
    raw.final_clock = options.final_clock;
    return raw;
  }

  static int include(void* user, const char* name, nicol_include* answer) {
    auto& including = *static_cast<Including*>(user);
    return including.carried.run([&] {
      const auto text = including.options.include(name);
      if (text) detail::check(nicol_include_set_text(answer, text->data(), text->size()));
      return true;
    });
  }

  static nicol_render_options raw_of(Calls& calls) {
    const RenderOptions& options = calls.options;
    auto raw = detail::sized<nicol_render_options>();
    raw.precision = options.precision;
    raw.lanes = options.lanes;
    raw.generic = options.generic;
    raw.no_cache = options.no_cache;
    raw.resume = options.resume;
    raw.journal = options.journal.empty() ? nullptr : options.journal.c_str();
    raw.want_error_bound = options.want_error_bound;
    raw.want_error_budget = options.want_error_budget;
    raw.part = options.part;
    raw.part_count = options.part_count;
    raw.first_row = options.rows.first;
    raw.row_count = options.rows.count;
    raw.first_column = options.columns.first;
    raw.column_count = options.columns.count;
    raw.first_wavelength_nm = options.first_wavelength_nm;
    raw.last_wavelength_nm = options.last_wavelength_nm;
    if (options.progress) raw.progress = progress;
    if (options.tile) raw.tile = tile;
    if (options.cancel) raw.cancel = cancel;
    raw.user = &calls;
    return raw;
  }

  static int progress(void* user, double fraction, double seconds, double seconds_left) {
    auto& calls = *static_cast<Calls*>(user);
    return calls.carried.run([&] { return calls.options.progress(fraction, seconds, seconds_left); });
  }
  static int tile(void* user, const nicol_tile* raw) {
    auto& calls = *static_cast<Calls*>(user);
    const std::size_t values = 4 * raw->wavelength_count * raw->pixel_count;
    const Tile tile{raw->width, raw->height, {raw->pixels, raw->pixel_count}, {raw->wavelengths_nm, raw->wavelength_count},
                    {raw->stokes, values}, {raw->linear_srgb, 3 * raw->pixel_count}};
    return calls.carried.run([&] { return calls.options.tile(tile); });
  }
  static int cancel(void* user) {
    auto& calls = *static_cast<Calls*>(user);
    return calls.carried.run([&] { return !calls.options.cancel(); });
  }

  Context context_;
  detail::Handle<nicol_scene, nicol_scene_retain, nicol_scene_release> handle_;
};

inline Picture Context::merge(const std::vector<std::string>& paths, bool incomplete) const {
  const auto pointers = detail::pointers(paths);
  auto raw = detail::sized<nicol_merge_options>();
  raw.incomplete = incomplete;
  nicol_picture* picture = nullptr;
  detail::check(nicol_merge(get(), pointers.data(), pointers.size(), &raw, &picture));
  return Picture(*this, picture, false);
}

}  // namespace nicol
