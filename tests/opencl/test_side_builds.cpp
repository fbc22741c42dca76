// Kernels built on one thread while pictures with another kernel are rendered on a second one.
#include <doctest/doctest.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <thread>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/device_impl.hpp"
#include "tests/opencl/faults.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {

KernelOptions generic() {
  KernelOptions options;
  options.generic = options.save_later = true;
  options.lanes = 4;
  return options;
}

KernelOptions specialised() {
  KernelOptions options = generic();
  options.generic = false;
  return options;
}

Frame picture(Device& device, const std::function<void()>& at_progress = {}) {
  PackedScene scene = stand_in_scene(24, 16, 8, 4);
  scene.reals = {300};
  RenderOptions options;
  options.kernel = generic();
  options.tile_seconds = 1e-4;
  if (at_progress) options.progress = [&](const Progress&) { at_progress(); };
  RenderReport report;
  return render(device, scene, wavelengths(8), std::vector<double>(8, 10.0), options, report);
}

bool same_bits(const Frame& a, const Frame& b) {
  return a.stokes.size() == b.stokes.size() &&
         std::memcmp(a.stokes.data(), b.stokes.data(), a.stokes.size() * sizeof(float)) == 0;
}

}  // namespace

TEST_CASE("a kernel is missing, then here; on disk for others once it is saved") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  CHECK(kernel_readiness(*device, 5, specialised()) == KernelReadiness::missing);
  prepare_kernel(*device, 5, specialised());
  CHECK(kernel_readiness(*device, 5, specialised()) == KernelReadiness::here);
  CHECK(kernel_readiness(*device, 6, specialised()) == KernelReadiness::missing);
  KernelOptions at_once = specialised();
  at_once.save_later = false;
  CHECK(kernel_readiness(*device, 5, at_once) == KernelReadiness::here);   // the same kernel

  const auto fresh = open_device("0");
  CHECK(kernel_readiness(*fresh, 5, specialised()) == KernelReadiness::missing);
  save_kernels(*device);
  CHECK(kernel_readiness(*fresh, 5, specialised()) == KernelReadiness::on_disk);
  KernelOptions no_cache = specialised();
  no_cache.binary_cache = false;
  CHECK(kernel_readiness(*fresh, 5, no_cache) == KernelReadiness::missing);
  for (const auto& file : std::filesystem::directory_iterator(cache_folder() + "/kernels"))
    std::filesystem::resize_file(file.path(), file.file_size() / 2);
  CHECK(kernel_readiness(*fresh, 5, specialised()) == KernelReadiness::missing);
}

TEST_CASE("a picture does not wait for a build, a build does not wait for a picture") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  const Frame alone = picture(*device);
  {
    std::unique_lock<std::mutex> build_stands_still(device->compiling);
    std::thread builder([&] { prepare_kernel(*device, 1, specialised()); });
    CHECK(same_bits(picture(*device), alone));
    CHECK(kernel_readiness(*device, 1, specialised()) == KernelReadiness::missing);
    build_stands_still.unlock();
    builder.join();
    CHECK(kernel_readiness(*device, 1, specialised()) == KernelReadiness::here);
  }
  bool prepared = false;
  const Frame meanwhile = picture(*device, [&] {
    if (!prepared) std::thread([&] { prepare_kernel(*device, 2, specialised()); }).join();
    prepared = true;
  });
  CHECK(prepared);
  CHECK(same_bits(meanwhile, alone));
}

TEST_CASE("a kernel is not saved while another is compiled, and holds up nobody; it is saved later") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  const Frame alone = picture(*device);
  prepare_kernel(*device, 3, specialised());
  KernelOptions at_once = specialised();
  at_once.save_later = false;
  const auto fresh = open_device("0");
  {
    const std::lock_guard<std::mutex> build_stands_still(Device::compiling);
    std::thread([&] { prepare_kernel(*device, 3, at_once); }).join();
    CHECK(kernel_readiness(*fresh, 3, specialised()) == KernelReadiness::missing);
    CHECK(same_bits(picture(*device), alone));
  }
  prepare_kernel(*device, 4, at_once);
  CHECK(kernel_readiness(*fresh, 3, specialised()) == KernelReadiness::on_disk);
  CHECK(kernel_readiness(*fresh, 4, specialised()) == KernelReadiness::on_disk);
}

TEST_CASE("pictures rendered during builds and savings have the bits of one rendered alone") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  const Frame alone = picture(*device);
  std::atomic<bool> built{false};
  std::thread builder([&] {
    for (std::uint32_t features = 10; features < 14; ++features) prepare_kernel(*device, features, specialised());
    save_kernels(*device);
    built = true;
  });
  int pictures = 0, wrong = 0;
  for (; !built || pictures == 0; ++pictures) wrong += !same_bits(picture(*device), alone);
  builder.join();
  CHECK(wrong == 0);
  CHECK(pictures > 1);
}

TEST_CASE("threads that want the same kernel get one build") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  const Fault count("clBuildProgram", 0, 1 << 30);
  std::array<BuildReport, 3> reports;
  std::vector<std::thread> threads;
  for (BuildReport& report : reports)
    threads.emplace_back([&] { report = prepare_kernel(*device, 20, specialised()); });
  for (std::thread& thread : threads) thread.join();
  CHECK(Fault::calls() == 1);
  for (const BuildReport& report : reports) CHECK(report.seconds == reports[0].seconds);
}

TEST_CASE("a build that fails is tried again") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  constexpr int out_of_host_memory = -6;
  const Fault once("clBuildProgram", out_of_host_memory, 0, 1);
  CHECK_THROWS_AS(prepare_kernel(*device, 30, specialised()), DeviceError);
  CHECK(kernel_readiness(*device, 30, specialised()) == KernelReadiness::missing);
  CHECK(!prepare_kernel(*device, 30, specialised()).cached);
  CHECK(kernel_readiness(*device, 30, specialised()) == KernelReadiness::here);
}

TEST_CASE("a kernel built in a process of its own is loaded here and kept; where that fails it is built here") {
  const KernelFolder kernels;
  const OwnCache cache;
  const auto device = open_device("0");
  KernelOptions options = specialised();
  options.own_process = true;
  const auto other = open_device("0");
  CHECK(!prepare_kernel(*device, 40, options).cached);
  CHECK(kernel_readiness(*other, 40, options) == KernelReadiness::on_disk);   // nothing had to be saved here

  device->about.index = 99;   // there the builder finds no device
  CHECK(!prepare_kernel(*device, 41, options).cached);
  CHECK(kernel_readiness(*device, 41, options) == KernelReadiness::here);
  CHECK(kernel_readiness(*other, 41, options) == KernelReadiness::missing);
}
