// Renders a packed scene: checks, kernel, frame; renderer.hpp does the work.
#include "host/opencl/render.hpp"

#include <fmt/format.h>

#include <climits>
#include <memory>

#include "host/opencl/binary_cache.hpp"
#include "host/opencl/builder_process.hpp"
#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/opencl/fragment_check.hpp"
#include "host/opencl/kernel_source.hpp"
#include "host/opencl/program.hpp"
#include "host/opencl/renderer.hpp"

namespace nicol {
namespace {

void set_no_work(cl::Kernel& kernel, const cl::Buffer& empty) {
  for (cl_uint i = 0; i < 7; ++i) kernel.setArg(i, empty);
  for (cl_uint i = 7; i < 12; ++i) kernel.setArg(i, cl_int{0});
}

KernelRequest trace_request(Device& device, std::uint32_t features, const std::string& fragments, const KernelOptions& options) {
  KernelRequest request;
  request.file = "trace.cl";
  request.name = "trace";
  request.fragments = fragments;
  request.lanes = lanes_on(device, options);
  request.real_double = options.real_double;
  if (!options.generic) request.defines = fmt::format(" -D SCENE_FEATURES={}", features);
  request.binary_cache = options.binary_cache;
  request.set_no_work = set_no_work;
  if (options.own_process)
    request.build_elsewhere = [&device, features, fragments, options] {
      return build_in_own_process(device, features, fragments, options);
    };
  return request;
}

void check_scene(const PackedScene& scene, const std::vector<double>& lambda_nm,
                 const std::vector<double>& weight_nm, int lanes) {
  const std::size_t channels = static_cast<std::size_t>(scene.channels);
  const bool fits = scene.width > 0 && scene.height > 0 && scene.channels > 0 && scene.stride >= scene.channels &&
                    scene.stride % lanes == 0 && lambda_nm.size() == weight_nm.size() && !lambda_nm.empty() &&
                    scene.mixing.size() == (scene.mixing.empty() ? 0 : channels * lambda_nm.size()) &&
                    (!scene.mixing.empty() || channels == lambda_nm.size());
  if (!fits)
    throw std::invalid_argument(fmt::format(
        "the packed scene does not fit the launch: {} x {} pixels, {} channels in rows of {}, {} mixing shares, "
        "{} wavelengths, {} lanes", scene.width, scene.height, scene.channels, scene.stride, scene.mixing.size(),
        lambda_nm.size(), lanes));
}

// The kernel numbers its work-items with an int.
void check_item_count(const PackedScene& scene, int lanes) {
  if (item_layout(scene, lanes).items() > INT_MAX)
    throw DeviceError(fmt::format("a picture of {} x {} pixels and {} channels is more than one launch can number: "
                                  "render parts of it", scene.width, scene.height, scene.channels));
}

void check_sampling(const PackedScene& scene, const RenderOptions& options) {
  const std::int64_t plane = static_cast<std::int64_t>(scene.width) * scene.height;
  for (const std::int32_t p : options.pixels)
    if (p < 0 || p >= plane) throw std::invalid_argument(fmt::format("pixel {} is not in the picture", p));
  if (options.sample_error > 0 && ((scene.features & path_signatures_bit()) == 0 || !options.positions.empty() || !options.pixels.empty()))
    throw std::invalid_argument("a sampling error can be kept only in whole pictures of scenes with path signatures");
}

// Bytes for a hash.
template <class Values>
void put(std::string& data, const Values& values) {
  data.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(values[0]));
  data += ';';
}

}  // namespace

int lanes_on(const Device& device, const KernelOptions& options) {
  const DeviceInfo& about = info(device);
  const int wanted = options.lanes > 0 ? options.lanes : about.is_cpu ? about.native_float_width : 1;
  for (int lanes : {16, 8, 4, 1})
    if (lanes == wanted || (options.lanes <= 0 && lanes <= wanted)) return lanes;
  throw DeviceError(fmt::format("{} lanes: there are kernels for 1, 4, 8 and 16", options.lanes));
}

Frame render(Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
             const std::vector<double>& weight_nm, const RenderOptions& options, RenderReport& report) {
  const auto start = Clock::now();
  report = RenderReport{};
  report.lanes = lanes_on(device, options.kernel);
  report.real = options.kernel.real_double ? "double" : "float";
  report.precise_real = options.kernel.real_double || device.about.has_fp64 ? "double" : "float, for the device has no fp64";
  check_scene(scene, lambda_nm, weight_nm, report.lanes);
  check_item_count(scene, report.lanes);
  check_sampling(scene, options);
  Frame frame = options.pixels.empty() ? make_frame(scene, scene.width, scene.height, lambda_nm, weight_nm)
                                       : make_frame(scene, static_cast<int>(options.pixels.size()), 1, lambda_nm, weight_nm);
  if (options.channel_cut_off && scene.mixing.empty()) frame.channel_cut_off.resize(lambda_nm.size() * frame.plane());
  auto executors = open_executors(device, scene, options, report);
  const double before_tiles = seconds_since(start);
  Renderer(std::move(executors), scene, options, report.lanes, frame, report).run();
  report.seconds_to_first_tile += before_tiles;
  return frame;
}

std::string scene_hash(const PackedScene& scene, const std::vector<double>& lambda_nm) {
  std::string data;
  put(data, scene.ints);
  put(data, scene.reals);
  put(data, scene.tables);
  put(data, scene.mixing);
  put(data, lambda_nm);
  if (!scene.fragments) return hash_text(data);
  for (const SceneFragments::Use& use : scene.fragments->uses) {
    put(data, use.fragment->name);
    put(data, use.fragment->text);
    for (const std::string& name : use.fragment->parameters) put(data, name);
  }
  return hash_text(data);
}

std::string kernels_hash() { return fmt::format("{}; {}", hash_text(expand_includes("trace.cl")), OUT_COMPONENTS); }

std::string render_identity(const Device& device, const PackedScene& scene, const std::vector<double>& lambda_nm,
                            const RenderOptions& options) {
  std::string data = scene_hash(scene, lambda_nm);
  put(data, options.positions);
  put(data, options.pixels);
  const DeviceInfo& about = info(device);
  return fmt::format("{} {} x {}, {} channels, features {:#x}{}, {} samples, error {:.17g} by {}; {} {} lanes of {}; kernels {}",
                     hash_text(data), scene.width, scene.height, scene.channels, scene.features,
                     options.kernel.generic ? " generic" : "", options.samples, options.sample_error, options.most_samples,
                     fmt::format("{} {} {}", about.name, about.version, about.driver), lanes_on(device, options.kernel),
                     options.kernel.real_double ? "double" : "float", kernels_hash());
}

std::shared_ptr<const Kernel> build_kernel(Device& device, std::uint32_t features, const std::string& fragments,
                                           const KernelOptions& options) {
  return get_kernel(device, trace_request(device, features, fragments, options));
}

std::shared_ptr<const Kernel> trace_kernel(Device& device, const KernelContents& contents, const KernelOptions& options) {
  if (contents.fragments) check_fragments(device, *contents.fragments, options);
  return build_kernel(device, contents.features, contents.fragment_text(), options);
}

BuildReport prepare_kernel(Device& device, const KernelContents& contents, const KernelOptions& options) {
  const auto kernel = trace_kernel(device, contents, options);
  if (!options.save_later) keep(kernel);
  BuildReport report = kernel->report;
  const std::string warnings = contents.fragments ? check_fragments(device, *contents.fragments, options) : "";
  if (!warnings.empty()) report.note += (report.note.empty() ? "" : "\n") + warnings.substr(0, warnings.size() - 1);
  return report;
}

KernelReadiness kernel_readiness(Device& device, const KernelContents& contents, const KernelOptions& options) {
  return readiness_of(device, trace_request(device, contents.features, contents.fragment_text(), options));
}

void save_kernels(Device& device) {
  for (const auto& kernel : kernels_here(device)) keep(kernel);
}

}  // namespace nicol
