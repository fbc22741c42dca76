// Choice of a device and what is said when there is none.
#include <doctest/doctest.h>

#include <cctype>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/device.hpp"
#include "host/opencl/errors.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {
std::string message_of(const std::string& wanted) {
  try {
    open_device(wanted);
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}
}  // namespace

TEST_CASE("a device is found by nothing, by its number, by a part of its name in any case") {
  const auto list = list_devices();
  REQUIRE(!list.empty());
  bool any_gpu = false;
  for (const DeviceInfo& d : list) any_gpu = any_gpu || d.is_gpu;
  CHECK(info(*open_device("")).is_gpu == any_gpu);
  CHECK(info(*open_device("0")).name == list[0].name);
  std::string part = list[0].name.substr(1, 6);
  for (char& c : part) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  CHECK(info(*open_device(part)).name == list[0].name);
}

TEST_CASE("a device that is not there is answered with those that are") {
  const auto list = list_devices();
  REQUIRE(!list.empty());
  for (const std::string wanted : {"no such device", "99"}) {
    const std::string message = message_of(wanted);
    CHECK(message.find("'" + wanted + "'") != std::string::npos);
    CHECK(message.find("0: " + list[0].name) != std::string::npos);
  }
}

TEST_CASE("without a driver the message names the package to install" * doctest::skip()) {
  CHECK(list_devices().empty());
  CHECK(message_of("").find("pocl-opencl-icd") != std::string::npos);
}

TEST_CASE("errors are told by name, call and device") {
  CHECK(error_message(cl::Error(CL_OUT_OF_RESOURCES, "clEnqueueNDRangeKernel"), "a card") ==
        "clEnqueueNDRangeKernel failed with CL_OUT_OF_RESOURCES on a card" + way_out(CL_OUT_OF_RESOURCES));
  CHECK(error_message(cl::Error(CL_INVALID_KERNEL_ARGS, "clSetKernelArg"), "a card") ==
        "clSetKernelArg failed with CL_INVALID_KERNEL_ARGS on a card");
  CHECK(error_name(-9999) == "OpenCL error -9999");
  CHECK(is_shortage(CL_MEM_OBJECT_ALLOCATION_FAILURE));
  CHECK(!is_shortage(CL_INVALID_KERNEL_ARGS));
}

TEST_CASE("where the user's cache folder cannot be made, another is taken and PoCL is told") {
  const Environment home("XDG_CACHE_HOME", "/proc/version/cache"), pocl("POCL_CACHE_DIR", "/proc/version/pocl");
  CHECK(!is_writable_folder("/proc/version/cache"));
  const std::string folder = cache_folder();
  REQUIRE(!folder.empty());
  CHECK(is_writable_folder(folder));
  make_opencl_cache_writable();
  CHECK(std::string(std::getenv("POCL_CACHE_DIR")) == folder + "/pocl");
}

TEST_CASE("a cache folder for PoCL that the user chose and that works is left alone") {
  const std::string before = std::getenv("POCL_CACHE_DIR");
  make_opencl_cache_writable();
  CHECK(std::getenv("POCL_CACHE_DIR") == before);
}
