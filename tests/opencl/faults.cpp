#include "tests/opencl/faults.hpp"

#include <dlfcn.h>

#include <atomic>

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>

namespace nicol {
namespace {

struct State {
  std::string call;
  int code = 0, after = 0, times = 0;
  std::atomic<int> calls{0}, failed{0};
} state;

// The error that this call is to answer, or 0.
cl_int error_of(const char* call) {
  if (state.call != call) return CL_SUCCESS;
  const int number = state.calls++;
  if (number < state.after || (state.times >= 0 && number >= state.after + state.times)) return CL_SUCCESS;
  ++state.failed;
  return state.code;
}

template <class Function>
Function driver(const char* name) {
  return reinterpret_cast<Function>(::dlsym(RTLD_NEXT, name));
}

}  // namespace

Fault::Fault(const std::string& call, int code, int after, int times) {
  state.code = code;
  state.after = after;
  state.times = times;
  state.calls = state.failed = 0;
  state.call = call;
}
Fault::~Fault() { state.call.clear(); }
int Fault::calls() { return state.calls; }
int Fault::failed() { return state.failed; }

}  // namespace nicol

using nicol::driver;
using nicol::error_of;

// A call that answers its error.
#define PASS_ON(name, parameters, arguments)                                          \
  extern "C" cl_int name parameters {                                                 \
    static const auto next = driver<cl_int(*) parameters>(#name);                     \
    if (const cl_int error = error_of(#name)) return error;                           \
    return next arguments;                                                            \
  }
// A call that answers a thing and puts its error into `failed`.
#define PASS_ON_MAKER(type, name, parameters, arguments)                              \
  extern "C" type name parameters {                                                   \
    static const auto next = driver<type(*) parameters>(#name);                       \
    if (const cl_int error = error_of(#name)) {                                       \
      if (failed) *failed = error;                                                    \
      return nullptr;                                                                 \
    }                                                                                 \
    return next arguments;                                                            \
  }

PASS_ON(clFinish, (cl_command_queue queue), (queue))
PASS_ON(clFlush, (cl_command_queue queue), (queue))
PASS_ON(clEnqueueWriteBuffer,
        (cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size, const void* data, cl_uint count,
         const cl_event* events, cl_event* event),
        (queue, buffer, blocking, offset, size, data, count, events, event))
PASS_ON(clEnqueueReadBuffer,
        (cl_command_queue queue, cl_mem buffer, cl_bool blocking, size_t offset, size_t size, void* data, cl_uint count,
         const cl_event* events, cl_event* event),
        (queue, buffer, blocking, offset, size, data, count, events, event))
PASS_ON(clEnqueueNDRangeKernel,
        (cl_command_queue queue, cl_kernel kernel, cl_uint dimensions, const size_t* offset, const size_t* global,
         const size_t* local, cl_uint count, const cl_event* events, cl_event* event),
        (queue, kernel, dimensions, offset, global, local, count, events, event))
PASS_ON(clEnqueueUnmapMemObject,
        (cl_command_queue queue, cl_mem buffer, void* mapped, cl_uint count, const cl_event* events, cl_event* event),
        (queue, buffer, mapped, count, events, event))
PASS_ON(clBuildProgram,
        (cl_program program, cl_uint count, const cl_device_id* devices, const char* options,
         void(CL_CALLBACK* notify)(cl_program, void*), void* data),
        (program, count, devices, options, notify, data))
PASS_ON_MAKER(cl_mem, clCreateBuffer, (cl_context context, cl_mem_flags flags, size_t size, void* data, cl_int* failed),
              (context, flags, size, data, failed))
PASS_ON_MAKER(void*, clEnqueueMapBuffer,
              (cl_command_queue queue, cl_mem buffer, cl_bool blocking, cl_map_flags flags, size_t offset, size_t size,
               cl_uint count, const cl_event* events, cl_event* event, cl_int* failed),
              (queue, buffer, blocking, flags, offset, size, count, events, event, failed))
PASS_ON_MAKER(cl_program, clCreateProgramWithBinary,
              (cl_context context, cl_uint count, const cl_device_id* devices, const size_t* sizes,
               const unsigned char** binaries, cl_int* status, cl_int* failed),
              (context, count, devices, sizes, binaries, status, failed))
