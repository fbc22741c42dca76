// OpenCL devices: which there are, which is used, and errors told by name.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace nicol {

// The message is complete: the failing call, OpenCL's name of the error, the device.
struct DeviceError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct DeviceInfo {
  int index = 0;
  std::string name, platform, version, driver;
  bool is_cpu = false, is_gpu = false, has_fp64 = false;
  int compute_units = 0;
  std::size_t memory_bytes = 0, max_allocation_bytes = 0;
  int native_float_width = 1, native_double_width = 1;
};

// Every device of every platform. Empty if there is none.
std::vector<DeviceInfo> list_devices();

class Device;  // context and queues of one device; defined in device_impl.hpp for this folder only

// By index or by a part of its name (any case); "" takes a GPU if there is one, else the CPU.
// Throws DeviceError that lists what there is.
std::shared_ptr<Device> open_device(const std::string& wanted);

// Several: numbers or parts of names with commas between, none twice; "all": every GPU and CPU but simulators, the one of "" first.
// Otherwise as above.
std::vector<DeviceInfo> choose_devices(const std::string& wanted);
std::vector<std::shared_ptr<Device>> open_devices(const std::string& wanted);
const DeviceInfo& info(const Device& device);

}  // namespace nicol
