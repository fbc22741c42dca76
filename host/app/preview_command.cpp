// See preview_command.hpp: what the panes read and render.
#include "host/app/preview_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <mutex>

#include "host/engine/kept_error.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/effects.hpp"

namespace nicol::app {
namespace {

// A pane's scene and how it is read and rendered.
struct PaneWish {
  std::string scene, title;
  SceneOptions options;
  DeviceOptions device;
  std::vector<std::string> without;
};

constexpr const char* right_forms =
    "'Declare=Name=Value', 'without EFFECT', 'device=NAME', 'real=double', 'error 0.1%', 'samples=N', 'wavelengths=380:780:10', "
    "'polarization=off'";

std::string effect_named(const std::string& name) {
  if (name == "optical_activity") return "rotation";
  const auto& names = effect_names();
  if (std::find(names.begin(), names.end(), name) != names.end()) return name;
  const std::string near = sdl::nearest_word(name, names);
  throw UsageError(fmt::format("--right 'without {}': there is no such effect{}; there are {}", name,
                               near.empty() ? "" : fmt::format(" (did you mean '{}'?)", near), fmt::join(names, ", ")));
}

int parse_samples(const std::string& text) {
  std::size_t end = 0;
  int samples = 0;
  try {
    samples = std::stoi(text, &end);
  } catch (const std::exception&) {
    end = 0;
  }
  if (end != text.size() || samples < 1 || samples > 65536) throw UsageError(fmt::format("--right 'samples={}': 1 to 65536", text));
  return samples;
}

// "error 0.1%" and "error=0.1%" alike.
void apply(const std::string& change, PaneWish& wish) {
  const std::size_t at = change.find_first_of("= ");
  const std::string word = change.substr(0, at);
  const std::size_t from = at == std::string::npos ? at : change.find_first_not_of("= ", at);
  const std::string value = from == std::string::npos ? "" : change.substr(from);
  const auto is = [&](const char* name) { return word == name && !value.empty(); };
  if (is("Declare") || is("declare")) wish.options.declares.push_back(value);
  else if (is("without")) wish.without.push_back(effect_named(value));
  else if (is("device")) wish.device.device = value;
  else if (is("real") && (value == "float" || value == "double")) wish.device.real = value;
  else if (is("error")) wish.options.error = parse_relative_error(value);
  else if (is("samples")) wish.options.samples = parse_samples(value);
  else if (is("wavelengths")) parse_wavelengths(wish.options.wavelengths = value);
  else if (is("polarization") && (value == "on" || value == "off")) wish.options.polarization = value;
  else throw UsageError(fmt::format("--right takes {}; not '{}'", right_forms, change));
  wish.title += (wish.title == wish.scene ? ": " : ", ") + change;
}

// The file and the lines around it, for those who are to mend it.
preview::Message message_of(const sdl::Diagnostics& diagnostics, const sdl::Sources& sources, const sdl::Diagnostic& d) {
  constexpr int around = 2;
  preview::Message message;
  message.error = d.severity == sdl::Severity::error;
  message.text = d.message;
  message.told = diagnostics.text(d);
  message.file = sources.name(d.where.file);
  message.line = static_cast<int>(d.where.line);
  message.column = static_cast<int>(d.where.column);
  for (int line = std::max(1, message.line - around); message.line > 0 && line <= message.line + around; ++line) {
    const std::string_view text = sources.line(d.where.file, static_cast<std::uint32_t>(line));
    if (line <= message.line || !text.empty()) message.lines.emplace_back(line, text);
  }
  return message;
}

preview::Message plain_message(std::string text, bool error) {
  preview::Message message;
  message.error = error;
  message.told = text;
  message.text = std::move(text);
  return message;
}

std::vector<std::string> files_of(const ReadScene& read, const std::string& path) {
  std::vector<std::string> files{path};
  const sdl::Sources& sources = read.loaded->parsed.sources;
  for (std::uint32_t i = 0; sources.name(i) != "?"; ++i) files.push_back(sources.name(i));
  files.insert(files.end(), read.files.begin(), read.files.end());
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

// The settings that keep the error; false: stopped.
bool keep_error(const PaneWish& wish, double error, Device& device, const std::atomic<bool>& cancel,
                std::unique_ptr<LoadedScene>& loaded, preview::ReadResult& result) {
  RenderCommand command;
  command.scene = wish.scene;
  command.options = wish.options;
  command.device = wish.device;
  const ChosenSettings chosen = choose_settings(loaded, command, device, error, cancel);
  if (cancel) return false;
  result.real_double = chosen.real_double;
  result.chosen = fmt::format("error {:g} %: {}", 100 * error, chosen.text);
  if (!chosen.reachable) result.messages.push_back(plain_message(fmt::format("error {:g} % is not reached: {}", 100 * error, chosen.reason), false));
  return true;
}

void leave_out(const PaneWish& wish, Scene& scene, preview::ReadResult& result) {
  for (const std::string& name : wish.without) {
    const auto effects = effects_of(scene);
    if (std::any_of(effects.begin(), effects.end(), [&](const Effect& e) { return e.name == name; }))
      scene = without_effect(scene, name);
    else
      result.messages.push_back(plain_message(fmt::format("the scene has no {} to leave out", name), false));
  }
}

// choose: the settings that keep the scene's error; else those come later.
using Choose = std::function<bool(const PaneWish&, double error, std::unique_ptr<LoadedScene>&, preview::ReadResult&)>;
preview::ReadResult read_pane(PaneWish wish, int width, int height, const Choose& choose) {
  wish.options.width = width;
  wish.options.height = height;
  ReadScene read = read_scene(wish.scene, wish.options);
  preview::ReadResult result;
  result.files = files_of(read, wish.scene);
  const sdl::Diagnostics& diagnostics = read.loaded->parsed.diagnostics;
  for (const sdl::Diagnostic& d : diagnostics.all())
    if (d.severity != sdl::Severity::note) result.messages.push_back(message_of(diagnostics, read.loaded->parsed.sources, d));
  if (!read.whole) return result;
  const double error = read.loaded->scene.settings.error;
  if (error > 0 && !choose) {
    result.choice_wanted = true;
    result.chosen = fmt::format("error {:g} %: settings are chosen after a first picture", 100 * error);
  } else if (error > 0 && !choose(wish, error, read.loaded, result)) {
    return {};
  }
  leave_out(wish, read.loaded->scene, result);
  result.geometry = std::make_shared<const Geometry>(std::move(read.loaded->geometry));
  result.scene = std::make_shared<const Scene>(std::move(read.loaded->scene));
  return result;
}

// Panes on one device share it: its kernels, and turns at it.
class SharedDevices {
 public:
  std::shared_ptr<Device> open(const DeviceOptions& options) {
    const std::lock_guard<std::mutex> held(lock_);
    std::shared_ptr<Device> opened = open_wanted_device(options);
    for (const auto& known : devices_)
      if (info(*known).index == info(*opened).index) return known;
    devices_.push_back(opened);
    return opened;
  }

 private:
  std::mutex lock_;
  std::vector<std::shared_ptr<Device>> devices_;
};

preview::PaneSource source_of(const PaneWish& wish, const std::shared_ptr<SharedDevices>& devices) {
  parse_options(wish.options);   // wrong declares are told at once
  preview::PaneSource source;
  source.title = wish.title;
  source.kernel = kernel_options(wish.device);
  source.open_device = [device = wish.device, devices] { return devices->open(device); };
  source.read = [wish](int width, int height) { return read_pane(wish, width, height, {}); };
  source.choose = [wish](int width, int height, Device& device, const std::atomic<bool>& cancel) {
    return read_pane(wish, width, height, [&](const PaneWish& sized, double error, auto& loaded, auto& result) {
      return keep_error(sized, error, device, cancel, loaded, result);
    });
  };
  return source;
}

}  // namespace

preview::SessionOptions preview_session(const PreviewCommand& command) {
  if (!command.second.empty() && !command.right.empty())
    throw UsageError("--right changes the first scene; with a second one there is nothing to change");
  preview::SessionOptions options;
  const auto devices = std::make_shared<SharedDevices>();
  PaneWish left{command.scene, command.scene, command.options, command.device, {}};
  options.left = source_of(left, devices);
  options.width = command.options.width;
  options.height = command.options.height;
  options.keep_camera_shape = !command.size_given;
  if (!command.second.empty()) {
    options.right = source_of({command.second, command.second, command.options, command.device, {}}, devices);
  } else if (!command.right.empty()) {
    PaneWish right = left;
    for (const std::string& change : command.right) apply(change, right);
    options.right = source_of(right, devices);
  }
  return options;
}

}  // namespace nicol::app
