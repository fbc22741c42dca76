#include "host/opencl/program.hpp"

#include <fmt/format.h>

#include <chrono>

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

// True if the binary was taken: built, and launched once.
bool use_binary(Device& device, const Bytes& binary, const std::string& options, const KernelRequest& request,
                Kernel& made) {
  try {
    made.program = cl::Program(device.context, {device.device}, {binary});
    made.program.build({device.device}, options.c_str());
    made.kernel = cl::Kernel(made.program, request.name.c_str());
    request.warm_up(device.queues[0], made.kernel, made.local_size);
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
  } catch (const cl::Error&) {
    return;
  }
}

std::shared_ptr<Kernel> make_kernel(Device& device, const KernelRequest& request, const std::string& source,
                                    const std::string& options, const std::string& identity) {
  const auto start = Clock::now();
  auto made = std::make_shared<Kernel>();
  made->local_size = local_size_on(device.about);
  made->report.options = options;
  const std::string folder = request.binary_cache ? kernel_cache_folder() : "";
  if (const auto binary = folder.empty() ? std::nullopt : load_binary(folder, identity))
    made->report.cached = use_binary(device, *binary, options, request, *made);
  if (!made->report.cached) {
    made->program = build_source(device, source, options);
    made->kernel = cl::Kernel(made->program, request.name.c_str());
    request.warm_up(device.queues[0], made->kernel, made->local_size);
    if (request.binary_cache && (folder.empty() || !is_writable_folder(folder)))
      made->report.note = "compiled kernels are not kept: no cache folder can be written";
    else if (request.binary_cache)
      made->save = [program = made->program, folder, identity] { save_program(program, folder, identity); };
  }
  made->report.seconds = seconds_since(start);
  return made;
}

}  // namespace

void keep(const Kernel& kernel) {
  if (!kernel.save) return;
  kernel.save();
  kernel.save = nullptr;
}

int local_size_on(const DeviceInfo& device) { return device.is_cpu ? 1 : 64; }

std::shared_ptr<const Kernel> get_kernel(Device& device, const KernelRequest& request) {
  if (request.real_double && !device.about.has_fp64)
    throw DeviceError(fmt::format("{} cannot calculate in double precision (no cl_khr_fp64): use float, or another "
                                  "device (`nicol devices` lists them)", device.about.name));
  const std::string source = expand_includes(request.file);
  const std::string options = build_options(device.about, request);
  const std::string identity = identity_of(device.about, request.name, options, source);
  const std::lock_guard<std::mutex> lock(device.kernels_lock);
  auto& known = device.kernels[identity];
  try {
    if (!known) known = make_kernel(device, request, source, options, identity);
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, device.about.name));
  }
  return known;
}

}  // namespace nicol
