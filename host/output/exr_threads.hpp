// OpenEXR's own threads, which all files of the process share.
#pragma once
#include <ImfThreading.h>

#include <algorithm>
#include <thread>

namespace nicol {

// As many as there are processors, started by the first call; several threads may call at once, which OpenEXR does not bear.
inline int exr_threads() {
  static const int threads = [] {
    const int wanted = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
    if (Imf::globalThreadCount() < wanted) Imf::setGlobalThreadCount(wanted);
    return wanted;
  }();
  return threads;
}

}  // namespace nicol
