// One picture of a scene that is read: settings for its error, its share of pixels and wavelengths, rendering, what it is off by.
#pragma once
#include <atomic>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/engine/error_budget.hpp"
#include "host/engine/kept_error.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/engine/picture_share.hpp"
#include "host/opencl/render.hpp"
#include "host/output/frame.hpp"
#include "host/output/journal.hpp"

namespace nicol::engine {

// Pixels whose values have changed, of those that are wanted.
struct TileView {
  const Frame& frame;
  std::vector<std::int32_t> from;  // in the frame, whose rows are not those of the picture where a part is rendered
  std::vector<std::int32_t> to;    // in the picture: row * width + column
  WavelengthRange wavelengths;     // wanted, of the frame's
};

enum class Severity { note, warning };

// Called on the thread that renders; any may be empty.
struct PictureHooks {
  std::function<void(const Progress&)> progress;
  std::function<void(const TileView&)> tile;
  std::function<void(Severity, const std::string&)> message;  // a line, as it comes
  std::function<void()> stage;                                // before settings are chosen, before rendering, before errors are looked into
  const std::atomic<bool>* cancel = nullptr;                  // looked at between tiles
  // Who shares the tiles with the device: RenderOptions.
  std::vector<std::shared_ptr<Device>> also;
  ExecutorSource* others = nullptr;
  bool only_others = false;
};

struct Picture {
  Frame frame;          // whole, a part (part.hpp), or, interrupted, the rows that are done
  RenderReport report;
  PictureShare share;
  ErrorBudget budget;   // no lines: not asked for, or interrupted
  std::optional<ChosenSettings> chosen;   // where the scene or the options ask for an error
  double error = 0;                       // that they ask for
  double brightest = 0;                   // radiance of the scene's lights, per nm
  bool journal_used = false;              // the rendering took long enough to be kept
  std::unique_ptr<Journal> journal;       // to be removed once the picture is safe; null: none was asked for

  std::size_t rows_done() const;
  // No rows are there, or it was interrupted in a part of a picture: there is nothing to show.
  bool nothing() const { return report.interrupted && (rows_done() == 0 || !share.whole()); }
  // What was chosen keeps the error, as far as is known.
  bool error_kept() const { return chosen && chosen->reachable && report.sample_error_kept && !(budget.rms > error); }
};

// The rendering itself failed: what was finished is in the journal.
struct RenderFailure : DeviceError {
  using DeviceError::DeviceError;
};

// `scene` is changed where an error asks for other settings. device: null is opened as the options say.
// Throws UsageError, DeviceError, OutputError for a journal, std::bad_alloc.
Picture make_picture(std::unique_ptr<LoadedScene>& scene, const PictureOptions& options, std::shared_ptr<Device>& device,
                     const PictureHooks& hooks);

// What each pixel may be off by (output/error_map.hpp). Of pictures with PictureOptions::error_bound.
Frame error_bound(const Picture& picture);

}  // namespace nicol::engine
