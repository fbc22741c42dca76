// OpenCL calls that fail on purpose: the test program has functions of their names, which pass on to the driver.
#pragma once
#include <string>

namespace nicol {

// While it lives, `call` answers `code` from its `after`-th time on (0: at once), `times` times (-1: for ever).
class Fault {
 public:
  Fault(const std::string& call, int code, int after, int times = -1);
  Fault(const Fault&) = delete;
  ~Fault();
  static int calls();   // of that function, since the fault was made
  static int failed();  // of these
};

// The functions that can be made to fail.
inline const char* const fallible[] = {"clCreateBuffer", "clEnqueueWriteBuffer", "clEnqueueNDRangeKernel",
                                       "clEnqueueReadBuffer", "clEnqueueMapBuffer", "clFlush", "clFinish",
                                       "clEnqueueUnmapMemObject"};

}  // namespace nicol
