// One render over several devices: the bits of one, whoever fails on the way.
#include <doctest/doctest.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <thread>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/device_impl.hpp"
#include "host/opencl/executor.hpp"
#include "host/output/journal.hpp"
#include "tests/opencl/faults.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {

// Two of one processor: contexts and queues of their own.
struct Two {
  std::shared_ptr<Device> first = open_device("0");
  std::vector<std::shared_ptr<Device>> also{open_device("0")};
};

bool same_bits(const Frame& a, const Frame& b) {
  return a.stokes.size() == b.stokes.size() && a.cut_off.size() == b.cut_off.size() &&
         std::memcmp(a.stokes.data(), b.stokes.data(), a.stokes.size() * sizeof(float)) == 0 &&
         std::memcmp(a.cut_off.data(), b.cut_off.data(), a.cut_off.size() * sizeof(float)) == 0;
}

struct Wanted {
  int samples = 1;
  bool over_pixels = false;
  Journal* journal = nullptr;
};

// Tiles are many, and long enough that no device gets them all.
RenderOptions options_of(const Wanted& wanted) {
  RenderOptions options;
  options.kernel.lanes = 8;
  options.samples = wanted.samples;
  options.tile_seconds = 1e-3;
  options.journal = wanted.journal;
  options.journal_after_seconds = 0;
  return options;
}

Frame picture(Device& device, const Wanted& wanted, RenderOptions options, RenderReport& report) {
  PackedScene scene = stand_in_scene(61, 43, 19, 8, wanted.over_pixels);
  scene.reals = {100};
  return render(device, scene, wavelengths(19), std::vector<double>(19, 10.0), options, report);
}

Frame picture_of_one(const Wanted& wanted, RenderReport& report) {
  return picture(*open_device("0"), wanted, options_of(wanted), report);
}

bool same_counts(const RenderReport& a, const RenderReport& b) { return a.segments == b.segments && a.nan_count == b.nan_count; }

// Answers what the device does until it has given this many tiles, then fails.
class FailsAfter : public TileExecutor {
 public:
  FailsAfter(std::unique_ptr<TileExecutor> inner, int tiles) : inner_(std::move(inner)), left_(tiles) {}
  std::string name() const override { return "the one that fails"; }
  std::string place() const override { return "elsewhere"; }
  bool here() const override { return false; }
  void begin_pass(const std::vector<std::int32_t>& listed, int begin, int end) override { inner_->begin_pass(listed, begin, end); }
  std::int64_t units_that_fit() const override { return inner_->units_that_fit(); }
  int room() const override { return inner_->room(); }
  int in_flight() const override { return inner_->in_flight(); }
  void submit(const Tile& tile, std::int64_t most_units) override { inner_->submit(tile, most_units); }
  bool ready() override { return inner_->ready(); }
  TracedTile collect() override {
    if (left_-- == 0) throw DeviceError("it is gone");
    return inner_->collect();
  }
  void release() override { inner_->release(); }
  void drop() override { inner_->drop(); }

 private:
  std::unique_ptr<TileExecutor> inner_;
  int left_;
};

class Failing : public ExecutorSource {
 public:
  Failing(std::shared_ptr<Device> device, int tiles) : device_(std::move(device)), tiles_(tiles) {}
  std::vector<std::unique_ptr<TileExecutor>> executors(const PackedScene& scene, const RenderOptions& options, int) override {
    BuildReport build;
    std::vector<std::unique_ptr<TileExecutor>> made;
    made.push_back(std::make_unique<FailsAfter>(open_executor(*device_, scene, options, build), tiles_));
    return made;
  }

 private:
  std::shared_ptr<Device> device_;
  int tiles_;
};

}  // namespace

TEST_CASE("two devices give the bits and counts of one, and both work") {
  const KernelFolder kernels;
  for (int samples : {1, 5, 37})
    for (bool over_pixels : {false, true}) {
      CAPTURE(samples);
      CAPTURE(over_pixels);
      const Wanted wanted{samples, over_pixels, nullptr};
      RenderReport one, both;
      const Frame right = picture_of_one(wanted, one);
      Two two;
      RenderOptions options = options_of(wanted);
      options.also = two.also;
      CHECK(same_bits(picture(*two.first, wanted, options, both), right));
      CHECK(same_counts(one, both));
      CHECK(!both.interrupted);
      REQUIRE(both.shares.size() == 2);
      CHECK(both.shares[0].tiles > 0);
      CHECK(both.shares[1].tiles > 0);
      CHECK(both.shares[0].tiles + both.shares[1].tiles == both.tiles);
      CHECK(both.shares[0].segments + both.shares[1].segments == both.segments);
      CHECK(both.device == "2 x " + info(*two.first).name);
      CHECK(both.notes.empty());
    }
}

// PoCL up to 6.0 counts the users of loaded code wrongly, and dies of it, where a launch is wider than any before, or a binary is
// saved, while others of the same kernel run (host/opencl/program.hpp).
TEST_CASE("pictures that grow and kernels that are saved on several devices at once do not upset the driver") {
  const KernelFolder kernels;
  const OwnCache cache;
  std::atomic<int> right{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([i, &right] {
      const auto device = open_device("0");
      for (int side = 1; side < 40; ++side) {
        PackedScene scene = stand_in_scene(8 * side, 1 + i, 8, 8, false);
        scene.reals = {1000};
        RenderReport report;
        render(*device, scene, wavelengths(8), std::vector<double>(8, 10.0), options_of({}), report);
        right += report.nan_count == 1 && report.segments == 8 * static_cast<std::uint64_t>(8 * side * (1 + i));
      }
    });
  for (std::thread& thread : threads) thread.join();
  CHECK(right == 4 * 39);
}

TEST_CASE("a device that fails in the middle is told, and the others finish its tiles") {
  const KernelFolder kernels;
  for (int samples : {1, 37})
    for (int tiles : {0, 1, 3}) {
      CAPTURE(samples);
      CAPTURE(tiles);
      const Wanted wanted{samples, false, nullptr};
      RenderReport one, report;
      const Frame right = picture_of_one(wanted, one);
      Two two;
      Failing failing(two.also.front(), tiles);
      RenderOptions options = options_of(wanted);
      options.others = &failing;
      CHECK(same_bits(picture(*two.first, wanted, options, report), right));
      CHECK(same_counts(one, report));
      REQUIRE(report.notes.size() == 1);
      CHECK(report.notes[0].find("it is gone") == 0);
      CHECK(report.notes[0].find("Its tiles went to the other device.") != std::string::npos);
      // Tiles that hold not all samples are lost with it.
      if (samples == 1) CHECK(report.shares[1].tiles == tiles);
      else CHECK(report.shares[1].tiles <= tiles);
      CHECK(report.shares[0].segments + report.shares[1].segments == report.segments);
      CHECK(report.shares[1].place == "elsewhere");
    }
}

TEST_CASE("the last one that fails ends the render") {
  const KernelFolder kernels;
  Two two;
  Failing failing(two.also.front(), 2);
  RenderOptions options = options_of({});
  options.others = &failing;
  options.only_others = true;
  RenderReport report;
  CHECK_THROWS_WITH_AS(picture(*two.first, {}, options, report), "it is gone", DeviceError);
}

TEST_CASE("memory lacks on one of two: smaller tiles there, the same picture") {
  const KernelFolder kernels;
  const Wanted wanted{20, false, nullptr};
  RenderReport one;
  const Frame right = picture_of_one(wanted, one);
  for (const std::string call : {"clEnqueueNDRangeKernel", "clFinish", "clEnqueueMapBuffer", "clEnqueueUnmapMemObject"})
    for (int after : {0, 2, 5, 9}) {
      CAPTURE(call);
      CAPTURE(after);
      Two two;
      prepare_kernel(*two.first, 0u, options_of(wanted).kernel);
      prepare_kernel(*two.also.front(), 0u, options_of(wanted).kernel);
      RenderOptions options = options_of(wanted);
      options.also = two.also;
      const Fault fault(call, CL_MEM_OBJECT_ALLOCATION_FAILURE, after, 1);
      RenderReport report;
      CHECK(same_bits(picture(*two.first, wanted, options, report), right));
      CHECK(same_counts(one, report));
      CHECK(report.notes.empty());
    }
}

TEST_CASE("cancelled with two, then continued with one, then with two: the same bits, nothing traced twice") {
  const KernelFolder kernels;
  for (int samples : {1, 37}) {
    const std::string path = cache_folder() + "/several.part";
    Wanted wanted{samples, false, nullptr};
    RenderReport one;
    const Frame right = picture_of_one(wanted, one);
    std::uint64_t traced = 0;
    for (int run = 0; run < 3; ++run) {
      CAPTURE(run);
      std::string note;
      const auto journal = Journal::open(path, "a", run > 0, note);
      CHECK(note == "");
      wanted.journal = journal.get();
      Two two;
      RenderOptions options = options_of(wanted);
      if (run != 1) options.also = two.also;
      std::atomic<bool> cancel{false};
      options.cancel = &cancel;
      const double until = run == 0 ? 0.3 : 0.6;
      if (run < 2) options.progress = [&](const Progress& now) { cancel = cancel || now.fraction > until; };
      RenderReport report;
      const Frame frame = picture(*two.first, wanted, options, report);
      for (const DeviceShare& share : report.shares) traced += share.segments;
      CHECK(report.interrupted == (run < 2));
      CHECK((report.tiles_found > 0) == (run > 0));
      if (run < 2) continue;
      CHECK(same_bits(frame, right));
      CHECK(same_counts(one, report));
      journal->remove();
    }
    CHECK(traced == one.segments);
    CHECK(!std::filesystem::exists(path));
  }
}

TEST_CASE("devices are chosen by numbers and names with commas, or all") {
  const auto devices = list_devices();
  const std::string name = info(*open_device("")).name;
  CHECK(choose_devices("").size() == 1);
  CHECK(choose_devices("").front().name == name);
  CHECK(choose_devices("all").front().index == choose_devices("").front().index);
  for (const DeviceInfo& device : choose_devices("ALL")) CHECK(device.platform.find("Oclgrind") == std::string::npos);
  CHECK(choose_devices("0").size() == 1);
  CHECK(open_devices("0").size() == 1);
  CHECK_THROWS_WITH_AS(choose_devices("0,0"), doctest::Contains("named twice"), DeviceError);
  CHECK_THROWS_WITH_AS(choose_devices("0,"), doctest::Contains("lacks between the commas"), DeviceError);
  CHECK_THROWS_WITH_AS(choose_devices("0,no such thing"), doctest::Contains("no OpenCL device 'no such thing'"), DeviceError);
  if (devices.size() < 2) return;
  const auto two = choose_devices("1,0");
  REQUIRE(two.size() == 2);
  CHECK(two[0].index == 1);
  CHECK(two[1].index == 0);
}
