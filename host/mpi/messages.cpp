#include "host/mpi/messages.hpp"

namespace nicol {

Parcel job_parcel(std::int64_t epoch, const std::string& build, const std::string& device, const PackedScene& scene,
                  const RenderOptions& options, int lanes) {
  BytesOut out;
  out.put(epoch).put_all(build).put_all(device);
  out.put_all(scene.ints).put_all(scene.reals).put_all(scene.tables).put(scene.channels).put(scene.stride).put(scene.width)
      .put(scene.height).put(scene.features);
  out.put_all(scene.contents().fragment_text());
  const KernelOptions& kernel = options.kernel;
  out.put(kernel.real_double).put(lanes).put(kernel.generic).put(kernel.binary_cache);
  out.put(options.samples).put_all(options.positions).put(options.sample_error).put(options.most_samples);
  return out.take();
}

JobMessage read_job(const Parcel& bytes, const std::string& build) {
  BytesIn in(bytes);
  JobMessage job;
  job.epoch = in.get<std::int64_t>();
  in.get_all(job.build);
  if (job.build != build) return job;
  in.get_all(job.device);
  PackedScene& scene = job.scene;
  in.get_all(scene.ints);
  in.get_all(scene.reals);
  in.get_all(scene.tables);
  scene.channels = in.get<int>();
  scene.stride = in.get<int>();
  scene.width = in.get<int>();
  scene.height = in.get<int>();
  scene.features = in.get<std::uint32_t>();
  const auto text = in.get_all<std::string>();
  if (!text.empty()) {
    auto fragments = std::make_shared<SceneFragments>();   // rank 0 has checked them
    fragments->text = text;
    scene.fragments = fragments;
  }
  KernelOptions& kernel = job.options.kernel;
  kernel.real_double = in.get<bool>();
  kernel.lanes = in.get<int>();
  kernel.generic = in.get<bool>();
  kernel.binary_cache = in.get<bool>();
  job.options.samples = in.get<int>();
  in.get_all(job.options.positions);
  job.options.sample_error = in.get<double>();
  job.options.most_samples = in.get<int>();
  return job;
}

}  // namespace nicol
