// A device that runs out of memory or vanishes, at every call of a render: the same picture, or a message with a way out.
#include <doctest/doctest.h>

#include <cstring>
#include <filesystem>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"
#include "host/output/journal.hpp"
#include "tests/opencl/faults.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// 20 samples: two launches for each tile.
Frame picture(Device& device, RenderReport& report, Journal* journal = nullptr) {
  const PackedScene scene = stand_in_scene(24, 16, 8, 4);
  RenderOptions options;
  options.kernel.lanes = 4;
  options.samples = 20;
  options.tile_seconds = 1e-4;
  options.journal = journal;
  options.journal_after_seconds = 0;
  return render(device, scene, wavelengths(8), std::vector<double>(8, 10.0), options, report);
}

Frame picture(Device& device) {
  RenderReport report;
  return picture(device, report);
}

bool same_bits(const Frame& a, const Frame& b) {
  return a.stokes.size() == b.stokes.size() && a.cut_off.size() == b.cut_off.size() &&
         std::memcmp(a.stokes.data(), b.stokes.data(), a.stokes.size() * sizeof(float)) == 0 &&
         std::memcmp(a.cut_off.data(), b.cut_off.data(), a.cut_off.size() * sizeof(float)) == 0;
}

// "" if it is rendered.
std::string error_of(Device& device, Journal* journal = nullptr) {
  try {
    RenderReport report;
    picture(device, report, journal);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

// How often a whole render calls it.
int calls_of(Device& device, const std::string& call) {
  const Fault none(call, CL_SUCCESS, 1 << 30);
  picture(device);
  return Fault::calls();
}

}  // namespace

TEST_CASE("memory lacks once, at whatever call: smaller tiles, the same picture and counts") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  const Frame right = picture(*device);
  int recovered = 0;
  for (const std::string call : fallible) {
    const int calls = calls_of(*device, call);
    REQUIRE(calls > 0);
    for (int after = 0; after < calls; after += 1 + calls / 12) {
      CAPTURE(call);
      CAPTURE(after);
      const Fault fault(call, CL_MEM_OBJECT_ALLOCATION_FAILURE, after, 1);
      try {
        RenderReport report;
        const Frame frame = picture(*device, report);
        CHECK(same_bits(frame, right));
        CHECK(report.nan_count == 1);
        CHECK(!report.interrupted);
        recovered += Fault::failed();
      } catch (const DeviceError& error) {
        // the scene itself did not get onto the device
        CHECK(has(error.what(), "take fewer wavelengths"));
        CHECK(call == "clCreateBuffer");
      }
    }
  }
  CHECK(recovered > 50);
}

TEST_CASE("memory that never suffices ends with what to do") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  picture(*device);
  for (const std::string call : fallible) {
    CAPTURE(call);
    const Fault fault(call, CL_OUT_OF_RESOURCES, 0);
    const std::string message = error_of(*device);
    CHECK(has(message, " failed with CL_OUT_OF_RESOURCES on " + info(*device).name));
    CHECK(has(message, "take fewer wavelengths"));
  }
}

TEST_CASE("a device that vanishes, at whatever call: told with a way out, and the next render is right") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  const Frame right = picture(*device);
  for (const std::string call : fallible) {
    const int calls = calls_of(*device, call);
    for (int after = 0; after < calls; after += 1 + calls / 8) {
      CAPTURE(call);
      CAPTURE(after);
      {
        const Fault fault(call, CL_DEVICE_NOT_AVAILABLE, after);
        const std::string message = error_of(*device);
        if (message.empty()) continue;  // tiles grow with speed: this time it was not called so often
        CHECK(has(message, " failed with CL_DEVICE_NOT_AVAILABLE on "));
        CHECK(has(message, "--continue"));
        CHECK(has(message, "`nicol devices`"));
      }
      CHECK(same_bits(picture(*device), right));
    }
  }
}

TEST_CASE("after a device has vanished, a second run goes on from the finished tiles to the same bits") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  RenderReport whole;
  const Frame right = picture(*device, whole);
  const std::string path = cache_folder() + "/vanished.part";
  std::string note;
  {
    const auto journal = Journal::open(path, "a", false, note);
    const Fault fault("clFinish", CL_DEVICE_NOT_AVAILABLE, 8);
    CHECK(error_of(*device, journal.get()) != "");
  }
  RenderReport report;
  {
    const auto journal = Journal::open(path, "a", true, note);
    CHECK(note == "");
    CHECK(same_bits(picture(*device, report, journal.get()), right));
    journal->remove();
  }
  CHECK(report.tiles_found > 0);
  CHECK(report.nan_count == whole.nan_count);
  CHECK(report.segments == whole.segments);
  CHECK(!std::filesystem::exists(path));
}

TEST_CASE("a cached binary that the driver refuses is built anew") {
  const KernelFolder kernels;
  prepare_kernel(*open_device("0"), 0, {});
  REQUIRE(prepare_kernel(*open_device("0"), 0, {}).cached);
  for (const std::string call : {"clCreateProgramWithBinary", "clBuildProgram", "clEnqueueNDRangeKernel", "clFinish"}) {
    CAPTURE(call);
    const auto device = open_device("0");
    const Fault fault(call, CL_INVALID_BINARY, 0, 1);
    CHECK(!prepare_kernel(*device, 0, {}).cached);
    CHECK(Fault::failed() == 1);
  }
}
