// Finds devices and picks one.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <mutex>

#include "host/opencl/cache_folder.hpp"
#include "host/opencl/device_impl.hpp"
#include "host/opencl/errors.hpp"

namespace nicol {
namespace {

struct Found {
  DeviceInfo about;
  cl::Device device;
};

// OpenCL's strings may carry a closing zero.
std::string text(std::string s) {
  while (!s.empty() && (s.back() == '\0' || s.back() == ' ')) s.pop_back();
  return s;
}

DeviceInfo describe(const cl::Device& device, const cl::Platform& platform, int index) {
  DeviceInfo d;
  d.index = index;
  d.name = text(device.getInfo<CL_DEVICE_NAME>());
  d.platform = text(platform.getInfo<CL_PLATFORM_NAME>());
  d.version = text(platform.getInfo<CL_PLATFORM_VERSION>());
  d.driver = text(device.getInfo<CL_DRIVER_VERSION>());
  const cl_device_type type = device.getInfo<CL_DEVICE_TYPE>();
  d.is_cpu = (type & CL_DEVICE_TYPE_CPU) != 0;
  d.is_gpu = (type & CL_DEVICE_TYPE_GPU) != 0;
  d.has_fp64 = device.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0;
  d.compute_units = static_cast<int>(device.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>());
  d.memory_bytes = device.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>();
  d.max_allocation_bytes = device.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>();
  d.native_float_width = static_cast<int>(device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_FLOAT>());
  d.native_double_width = static_cast<int>(device.getInfo<CL_DEVICE_NATIVE_VECTOR_WIDTH_DOUBLE>());
  return d;
}

std::vector<cl::Platform> platforms() {
  make_opencl_cache_writable();
  std::vector<cl::Platform> found;
  try {
    cl::Platform::get(&found);
  } catch (const cl::Error&) {
    return {};   // no platform counts as an error in OpenCL; here it is an empty list
  }
  return found;
}

std::atomic<pid_t> user{0};   // of OpenCL; 0: nobody yet

// One thread at a time: drivers are loaded by the first call, and not all of them mind others meanwhile.
std::vector<Found> find_devices() {
  refuse_forked();
  user = ::getpid();
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> held(one_at_a_time);
  std::vector<Found> found;
  for (const cl::Platform& platform : platforms()) {
    std::vector<cl::Device> devices;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
      for (const cl::Device& device : devices)
        if (device.getInfo<CL_DEVICE_AVAILABLE>() && device.getInfo<CL_DEVICE_COMPILER_AVAILABLE>())
          found.push_back({describe(device, platform, static_cast<int>(found.size())), device});
    } catch (const cl::Error&) {
      continue;   // a platform without devices, or a broken one, does not hide the others
    }
  }
  return found;
}

std::string lower(std::string s) {
  std::transform(s.begin(), s.end(), s.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return s;
}

std::string list_text(const std::vector<Found>& found) {
  std::string out;
  for (const Found& f : found) out += fmt::format("\n  {}: {} ({})", f.about.index, f.about.name, f.about.platform);
  return out;
}

const Found& choose(const std::vector<Found>& found, const std::string& wanted) {
  if (wanted.empty()) {
    for (const Found& f : found)
      if (f.about.is_gpu) return f;
    for (const Found& f : found)
      if (f.about.is_cpu) return f;
    return found.front();
  }
  const bool is_number = std::all_of(wanted.begin(), wanted.end(), [](unsigned char c) { return std::isdigit(c); });
  for (const Found& f : found)
    if (is_number && wanted == std::to_string(f.about.index)) return f;
  for (const Found& f : found)
    if (!is_number && lower(f.about.name + " " + f.about.platform).find(lower(wanted)) != std::string::npos) return f;
  throw DeviceError(fmt::format("no OpenCL device '{}'; there {}:{}", wanted, found.size() == 1 ? "is" : "are",
                                list_text(found)));
}

void refuse_none(const std::vector<Found>& found) {
  if (found.empty())
    throw DeviceError(
        "no OpenCL device found: install the package pocl-opencl-icd (runs on any CPU) or the OpenCL driver of "
        "your graphics card; `clinfo -l` lists what the system offers");
}

// A device that is simulated to find errors takes hours for a picture.
bool is_simulator(const DeviceInfo& device) { return lower(device.name + device.platform).find("oclgrind") != std::string::npos; }

std::vector<const Found*> choose_all(const std::vector<Found>& found) {
  std::vector<const Found*> all{&choose(found, "")};
  for (const Found& f : found)
    if (&f != all.front() && (f.about.is_cpu || f.about.is_gpu) && !is_simulator(f.about)) all.push_back(&f);
  return all;
}

std::vector<const Found*> choose_several(const std::vector<Found>& found, const std::string& wanted) {
  if (lower(wanted) == "all") return choose_all(found);
  std::vector<const Found*> several;
  for (std::size_t from = 0; from <= wanted.size();) {
    const std::size_t comma = std::min(wanted.find(',', from), wanted.size());
    const std::string one = wanted.substr(from, comma - from);
    if (one.empty() && !wanted.empty()) throw DeviceError(fmt::format("device {}: a number or name lacks between the commas", wanted));
    const Found* chosen = &choose(found, one);
    if (std::find(several.begin(), several.end(), chosen) != several.end())
      throw DeviceError(fmt::format("device {}: {} is named twice", wanted, chosen->about.name));
    several.push_back(chosen);
    from = comma + 1;
  }
  return several;
}

std::shared_ptr<Device> open_found(const Found& chosen) {
  try {
    return std::make_shared<Device>(chosen.about, chosen.device);
  } catch (const cl::Error& error) {
    throw DeviceError(error_message(error, chosen.about.name));
  }
}

}  // namespace

void refuse_forked() {
  const pid_t first = user;
  if (first != 0 && first != ::getpid())
    throw DeviceError(fmt::format("this process was forked from process {}, which had used OpenCL: no driver works in both. Fork before the first "
                                  "picture, or start processes anew (Python: multiprocessing's 'spawn')", first));
}

Device::Device(const DeviceInfo& device_info, const cl::Device& cl_device)
    : about(device_info), device(cl_device), context(cl_device) {
  for (cl::CommandQueue& queue : queues) queue = cl::CommandQueue(context, device);
}

std::vector<DeviceInfo> list_devices() {
  std::vector<DeviceInfo> list;
  for (const Found& f : find_devices()) list.push_back(f.about);
  return list;
}

std::shared_ptr<Device> open_device(const std::string& wanted) {
  const std::vector<Found> found = find_devices();
  refuse_none(found);
  return open_found(choose(found, wanted));
}

std::vector<DeviceInfo> choose_devices(const std::string& wanted) {
  const std::vector<Found> found = find_devices();
  refuse_none(found);
  std::vector<DeviceInfo> chosen;
  for (const Found* f : choose_several(found, wanted)) chosen.push_back(f->about);
  return chosen;
}

std::vector<std::shared_ptr<Device>> open_devices(const std::string& wanted) {
  const std::vector<Found> found = find_devices();
  refuse_none(found);
  std::vector<std::shared_ptr<Device>> devices;
  for (const Found* f : choose_several(found, wanted)) devices.push_back(open_found(*f));
  return devices;
}

const DeviceInfo& info(const Device& device) { return device.about; }

}  // namespace nicol
