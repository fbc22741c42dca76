#include "host/opencl/program.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "host/opencl/binary_cache.hpp"
#include "host/opencl/cache_folder.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/kernel_source.hpp"

namespace nicol {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

// No option that loosens the arithmetic: with fast-relaxed or finite-math-only PoCL folds tests for NaN away.
std::string build_options(const DeviceInfo& device, const KernelRequest& request) {
  return fmt::format("-cl-std=CL1.2 -w -D LANES={} -D LOCAL_SIZE={}{}{}{}", request.lanes, local_size_on(device),
                     device.has_fp64 ? " -D NICOL_FP64" : "", request.real_double ? " -D REAL_DOUBLE" : "",
                     request.defines);
}

std::string identity_of(const DeviceInfo& d, const std::string& kernel, const std::string& options,
                        const std::string& source) {
  return fmt::format("{}\n{}\n{}\n{}\n{}\n{}\n{} {}", d.name, d.platform, d.version, d.driver, kernel, options,
                     source.size(), hash_text(source));
}

std::string kernel_cache_folder() {
  const std::string folder = cache_folder();
  return folder.empty() ? "" : folder + "/kernels";
}

cl::Program build_source(Device& device, const std::string& source, const std::string& options) {
  cl::Program program(device.context, source);
  try {
    program.build({device.device}, options.c_str());
  } catch (const cl::BuildError& error) {
    std::string log;
    for (const auto& [where, text] : error.getBuildLog()) log += text;
    throw DeviceError(fmt::format("{} failed with {} on {} (options {}){}\n{}", error.what(), error_name(error.err()),
                                  device.about.name, options, way_out(error.err()), log));
  }
  return program;
}

// The first launch, on a queue that no picture uses.
void launch_first(Device& device, const KernelRequest& request, Kernel& made) {
  cl::CommandQueue queue(device.context, device.device);
  const std::lock_guard<std::mutex> one_at_a_time(device.compiling);
  const cl::Buffer empty(device.context, CL_MEM_READ_WRITE, 4096);
  request.set_no_work(made.kernel, empty);
  enqueue(queue, made.kernel, made.local_size, max_work_groups * made.local_size);
  queue.finish();
}

// True if the binary was taken: built, and launched once.
bool use_binary(Device& device, const Bytes& binary, const std::string& options, const KernelRequest& request,
                Kernel& made) {
  try {
    made.program = cl::Program(device.context, {device.device}, {binary});
    made.program.build({device.device}, options.c_str());
    made.kernel = cl::Kernel(made.program, request.name.c_str());
    launch_first(device, request, made);
    return true;
  } catch (const cl::Error&) {
    return false;   // the driver refuses it: build from source
  }
}

// Not to be kept is no failure: the next start builds again.
void save_program(const cl::Program& program, const std::string& folder, const std::string& identity) {
  try {
    const auto binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    if (!binaries.empty()) save_binary(folder, identity, binaries.front());
  } catch (const std::exception&) {
    return;
  }
}

// A kernel's text and options, and its name in the caches.
struct Recipe {
  std::string source, options, identity;
};

Recipe recipe_of(const Device& device, const KernelRequest& request) {
  Recipe recipe;
  recipe.source = expand_includes(request.file, request.fragments);
  recipe.options = build_options(device.about, request);
  recipe.identity = identity_of(device.about, request.name, recipe.options, recipe.source);
  return recipe;
}

std::shared_ptr<Kernel> make_kernel(Device& device, const KernelRequest& request, const Recipe& recipe) {
  const auto start = Clock::now();
  auto made = std::make_shared<Kernel>();
  made->local_size = local_size_on(device.about);
  made->report.options = recipe.options;
  const std::string folder = request.binary_cache ? kernel_cache_folder() : "";
  const auto load = [&] {
    const auto binary = folder.empty() ? std::nullopt : load_binary(folder, recipe.identity);
    return binary && use_binary(device, *binary, recipe.options, request, *made);
  };
  made->report.cached = load();
  const bool writable = !folder.empty() && is_writable_folder(folder);
  const bool built_elsewhere = !made->report.cached && writable && request.build_elsewhere && request.build_elsewhere() && load();
  if (!made->report.cached && !built_elsewhere) {
    made->program = build_source(device, recipe.source, recipe.options);
    made->kernel = cl::Kernel(made->program, request.name.c_str());
    launch_first(device, request, *made);
    if (request.binary_cache && !writable) {
      made->report.note = "compiled kernels are not kept: no cache folder can be written";
    } else if (request.binary_cache) {
      made->unsaved = true;
      made->save = [program = made->program, folder, identity = recipe.identity] { save_program(program, folder, identity); };
    }
  }
  made->report.seconds = seconds_since(start);
  return made;
}

std::shared_ptr<KernelPlace> place_of(Device& device, const std::string& identity) {
  const std::lock_guard<std::mutex> lock(device.kernels_lock);
  auto& place = device.kernels[identity];
  if (!place) place = std::make_shared<KernelPlace>();
  return place;
}

std::shared_ptr<const Kernel> kernel_at(Device& device, const KernelPlace& place) {
  const std::lock_guard<std::mutex> lock(device.kernels_lock);
  return place.kernel;
}

}  // namespace

void keep(const std::shared_ptr<const Kernel>& kernel) {
  using Kernels = std::vector<std::shared_ptr<const Kernel>>;
  static std::mutex lock;   // of to_save, for a moment each
  static Kernels& to_save = *new Kernels;   // at the end of the process OpenCL may be gone
  const auto waiting = [&] {
    const std::lock_guard<std::mutex> held(lock);
    return std::exchange(to_save, {});
  };
  if (kernel->unsaved) {
    const std::lock_guard<std::mutex> held(lock);
    if (std::find(to_save.begin(), to_save.end(), kernel) == to_save.end()) to_save.push_back(kernel);
  }
  for (bool saved = true; saved;) {   // again for those that came meanwhile
    saved = false;
    const std::unique_lock<std::mutex> no_first_launch(Device::compiling, std::try_to_lock);
    if (!no_first_launch) return;
    Launching::if_none([&] {
      for (const auto& each : waiting()) {
        if (each->unsaved.exchange(false)) each->save();
        saved = true;
      }
    });
  }
}

void enqueue(cl::CommandQueue& queue, const cl::Kernel& kernel, int local_size, std::int64_t items) {
  const auto local = static_cast<std::size_t>(local_size);
  const auto groups = (static_cast<std::size_t>(items) + local - 1) / local;
  queue.enqueueNDRangeKernel(kernel, cl::NullRange, cl::NDRange(groups * local), cl::NDRange(local));
}

int local_size_on(const DeviceInfo& device) { return device.is_cpu ? 1 : 64; }

std::vector<std::shared_ptr<const Kernel>> kernels_here(Device& device) {
  std::vector<std::shared_ptr<const Kernel>> kernels;
  const std::lock_guard<std::mutex> lock(device.kernels_lock);
  for (const auto& [identity, place] : device.kernels)
    if (place->kernel) kernels.push_back(place->kernel);
  return kernels;
}

KernelReadiness readiness_of(Device& device, const KernelRequest& request) {
  const Recipe recipe = recipe_of(device, request);
  if (kernel_at(device, *place_of(device, recipe.identity))) return KernelReadiness::here;
  const std::string folder = request.binary_cache ? kernel_cache_folder() : "";
  const bool on_disk = !folder.empty() && load_binary(folder, recipe.identity).has_value();
  return on_disk ? KernelReadiness::on_disk : KernelReadiness::missing;
}

std::shared_ptr<const Kernel> get_kernel(Device& device, const KernelRequest& request) {
  refuse_forked();
  if (request.real_double && !device.about.has_fp64)
    throw DeviceError(fmt::format("{} cannot calculate in double precision (no cl_khr_fp64): use float, or another "
                                  "device (`nicol devices` lists them)", device.about.name));
  const Recipe recipe = recipe_of(device, request);
  const auto place = place_of(device, recipe.identity);
  const std::lock_guard<std::mutex> one_builds(place->building);
  if (auto known = kernel_at(device, *place)) return known;
  try {
    auto made = make_kernel(device, request, recipe);
    const std::lock_guard<std::mutex> lock(device.kernels_lock);
    place->kernel = made;
    return made;
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
}

}  // namespace nicol
