// The OpenCL side of a device, for this folder only.
#pragma once
#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "host/opencl/device.hpp"
#include "host/opencl/opencl.hpp"

namespace nicol {

struct Kernel;

// A kernel of this process: null while it is being built, and after a build that failed.
struct KernelPlace {
  std::mutex building;                     // held during a build; comes before kernels_lock
  std::shared_ptr<const Kernel> kernel;    // under kernels_lock
};

// Kernels of this process are being launched, on whatever device, for the life of the object.
class Launching {
 public:
  Launching() { change(1); }
  Launching(const Launching&) = delete;
  ~Launching() { change(-1); }

  // Does the work unless there are launches; none begin meanwhile.
  template <class Work>
  static void if_none(const Work& work) {
    const std::lock_guard<std::mutex> none_begins(lock_);
    if (count_ == 0) work();
  }

 private:
  static void change(int by) {
    const std::lock_guard<std::mutex> lock(lock_);
    count_ += by;
  }
  static inline std::mutex lock_;
  static inline int count_ = 0;
};

// Throws DeviceError in a process that was forked from one that had used OpenCL: the driver's threads and locks did not come with it,
// and calls would wait for ever.
void refuse_forked();

class Device {
 public:
  Device(const DeviceInfo& device_info, const cl::Device& cl_device);

  DeviceInfo about;
  cl::Device device;
  cl::Context context;
  std::array<cl::CommandQueue, 2> queues;   // in order; launches alternate between them

  // Kernels keep their arguments: one picture at a time. To be taken by a Turn.
  std::mutex launches, next_in_line;

  // First launches, in which PoCL compiles, and the saving of binaries take turns; comes after `launches`, before Launching's.
  static inline std::mutex compiling;   // one for all devices: PoCL keeps one table of loaded code

  // Kernels of this process by identity (see program.cpp), so that a second picture builds nothing. Held for look-ups only.
  std::mutex kernels_lock;
  std::map<std::string, std::shared_ptr<KernelPlace>> kernels;
};

// A picture's, or a probe's, right to launch. In order of asking: pictures that follow one another at once would never let go of
// a mutex long enough for anyone else.
class Turn {
 public:
  explicit Turn(Device& device) : launches_(next(device)) {}

 private:
  static std::unique_lock<std::mutex> next(Device& device) {
    refuse_forked();
    const std::lock_guard<std::mutex> next(device.next_in_line);
    return std::unique_lock<std::mutex>(device.launches);
  }
  std::unique_lock<std::mutex> launches_;   // comes before Launching's
  Launching launching_;
};

}  // namespace nicol
