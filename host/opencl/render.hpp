// Runs the trace kernel over a picture, tile by tile.
#pragma once
#include <atomic>
#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/opencl/device.hpp"
#include "host/output/frame.hpp"
#include "host/output/journal.hpp"
#include "host/pack.hpp"

namespace nicol {

struct KernelOptions {
  bool real_double = false;
  int lanes = 0;            // 0: the device's native width on a CPU, 1 on a GPU
  bool generic = false;     // one build for every scene instead of one specialised to the features
  bool binary_cache = true;
  bool save_later = false;  // the binary is kept when save_kernels() is called
  // Built in a process of its own, which also keeps it: pictures with other kernels go on at full pace (PoCL lets no kernel start while it
  // compiles one). Built here where no cache folder can be written or the program does not call serve_as_builder().
  bool own_process = false;
  const std::atomic<bool>* stop = nullptr;   // set: what is being built in a process of its own is given up, with a DeviceError
};

// How a kernel came to be.
struct BuildReport {
  std::string options;
  double seconds = 0;       // of building or loading, first launch included
  bool cached = false;      // the binary came from the disk cache
  std::string note;         // "" or what the user may want to know: no cache folder can be written
};

struct Progress {
  double fraction = 0;
  double seconds = 0, seconds_left = 0;
  double segments_per_second = 0;   // lane-segments
};

class ExecutorSource;   // executor.hpp

struct RenderOptions {
  KernelOptions kernel;
  // Further devices that share the tiles, with the lanes of the first; and executors of other processes. Together they give the bits of one.
  std::vector<std::shared_ptr<Device>> also;
  ExecutorSource* others = nullptr;
  bool only_others = false;                       // where there are others, the first device traces nothing
  int samples = 1;                                // per pixel
  std::vector<std::array<double, 2>> positions;   // in the pixel, 0..1; empty: low-discrepancy, centre first
  // > 0: every pixel gets `samples`, then more go where they matter, until the estimated error of pixel sampling (RMS of the Stokes
  // vector's over pixels and wavelengths) is below this part of the mean radiance. The scene must have path_signatures.
  double sample_error = 0;
  int most_samples = 4095;                        // of a pixel, then
  std::vector<std::int32_t> pixels;               // only these (row * width + column): the frame is a row of them; empty: all
  bool channel_cut_off = false;                   // fills Frame::channel_cut_off, if wavelengths do not share channels; not with sample_error
  double tile_seconds = 0.03;
  // Where finished tiles are kept and found again; tiles of the first seconds are not worth it. Null: nowhere.
  Journal* journal = nullptr;
  double journal_after_seconds = 3;
  std::function<void(const Progress&)> progress;
  // Called after each tile with the picture so far and the pixels of it (row * width + column) whose values have just changed.
  std::function<void(const Frame& frame, const std::int32_t* pixels, std::size_t count)> tile;
  const std::atomic<bool>* cancel = nullptr;      // set by Ctrl-C: stops after the tiles in flight
};

// What a device, or another process with its own, has done of what is in the picture; interrupted, of what is kept in
// the journal, too.
struct DeviceShare {
  std::string device, place;      // place: "rank 3 on node7"; "": this process
  int tiles = 0;                  // traced: not found in the journal, nor lost and done again
  std::uint64_t segments = 0;     // lane-segments
};

struct RenderReport {
  BuildReport build;
  double seconds = 0;             // tiles only
  double seconds_to_first_tile = 0;
  std::uint64_t segments = 0;     // lane-segments traced
  std::uint64_t nan_count = 0, energy_count = 0, stack_count = 0, stokes_count = 0;
  std::uint64_t fallback_count = 0;  // waves that needed the precise solver
  std::string precise_real;          // its precision: "double", or the kernel's own where the device has no fp64
  int passes = 0;                    // of samples
  double samples_mean = 0;           // per pixel
  double seconds_first_pass = 0;
  // Estimated error of pixel sampling, RMS of the Stokes vector's over pixels and wavelengths, relative to the mean radiance: from each
  // pixel's samples and neighbours (adaptive), or half the difference of the samples' two halves (two or more); NaN: not known.
  double sample_error = 0;
  bool sample_error_kept = true;     // what was asked for
  double mean_radiance = 0;          // S0 per nm
  double cut_off_mean = 0, cut_off_worst = 0;   // weight of dropped paths relative to a full path, per pixel
  int tiles = 0, tiles_found = 0;   // launched; found in the journal
  bool interrupted = false;
  std::vector<DeviceShare> shares;
  std::vector<std::string> notes;   // what went wrong and was mended: each to be told
  std::string device;               // all of them
  int lanes = 0;
  std::string real;               // "float" or "double"
};

// lanes that `options` come to on this device.
int lanes_on(const Device& device, const KernelOptions& options);

// The picture of a packed scene (packed for the same number of lanes). frame: Stokes at lambda_nm.
// Throws DeviceError.
Frame render(Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
             const std::vector<double>& weight_nm, const RenderOptions& options, RenderReport& report);

// The feature that has each pixel's error estimated (kernels/features.def).
std::uint32_t path_signatures_bit();

// All that decides the bits of that picture, for its journal.
std::string render_identity(const Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
                            const RenderOptions& options);

// The same for a picture whatever device renders it: of a scene (packed for one lane) with its fragments and its wavelengths, and
// of the kernels' text.
std::string scene_hash(const PackedScene& scene, const std::vector<double>& lambda_nm);
std::string kernels_hash();

// Builds (or loads) the kernel that this scene needs, without rendering. Pictures with kernels that are here go on meanwhile on
// other threads; who wants the same kernel waits for it, and it is built once. Keeping its binary waits for the picture in work.
// Fragments of plugins are checked before (FragmentError).
BuildReport prepare_kernel(Device& device, const KernelContents& contents, const KernelOptions& options);

enum class KernelReadiness {
  here,      // in this process: at once
  on_disk,   // in the binary cache: a moment
  missing    // to be built, or being built: seconds
};
KernelReadiness kernel_readiness(Device& device, const KernelContents& contents, const KernelOptions& options);

// To be called first in main() by programs that want own_process: started anew by itself the program builds a kernel and has this exit
// code; else there is none.
std::optional<int> serve_as_builder(int argc, const char* const* argv);

// Keeps the binaries of all kernels built with save_later; no picture begins meanwhile (seconds each). While pictures are in work on
// any device: nothing, call it again.
void save_kernels(Device& device);

}  // namespace nicol
