// Writes the picture of the tests, in a process of its own so that it may be starved:
//   write_pattern PATH [none] [bytes=N] [nobody] [rows=N] [size=WxHxL]
// none: without packing; bytes: no file may grow longer; nobody: without rights; rows: only the
// first N are done; size: for measuring. Prints the error, 1 for failure.
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>

#include "host/output/sinks.hpp"
#include "tests/output/pattern.hpp"

namespace {

void limit_file_size(rlim_t bytes) {
  const rlimit limit{bytes, bytes};
  ::setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, SIG_IGN);  // so that write() answers EFBIG
}

void become_nobody() {
  if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) std::exit(3);
}

// Smooth values with noise of 5 %, half of the picture empty.
nicol::Frame large_frame(const char* size) {
  int width = 0, height = 0, count = 0;
  if (std::sscanf(size, "%dx%dx%d", &width, &height, &count) != 3) std::exit(2);
  nicol::Frame frame;
  frame.width = width;
  frame.height = height;
  for (int i = 0; i < count; ++i) {
    frame.lambda_nm.push_back(380 + 400.0 * i / count);
    frame.weight_nm.push_back(400.0 / count);
  }
  frame.stokes.resize(4 * frame.lambda_nm.size() * frame.plane());
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(0.95f, 1.05f);
  for (std::size_t start = 0; start < frame.stokes.size(); start += frame.plane())
    for (std::size_t pixel = frame.plane() / 4; pixel < 3 * frame.plane() / 4; ++pixel)
      frame.stokes[start + pixel] =
          noise(random) * static_cast<float>(pixel % width) / static_cast<float>(width);
  return frame;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  nicol::Frame frame = nicol::pattern_frame(7, 5);
  bool packed = true;
  for (int i = 2; i < argc; ++i) {
    if (!std::strcmp(argv[i], "none")) packed = false;
    if (!std::strcmp(argv[i], "nobody")) become_nobody();
    if (!std::strncmp(argv[i], "bytes=", 6))
      limit_file_size(static_cast<rlim_t>(std::atoll(argv[i] + 6)));
    if (!std::strncmp(argv[i], "size=", 5)) frame = large_frame(argv[i] + 5);
    if (!std::strncmp(argv[i], "rows=", 5))
      for (int y = std::atoi(argv[i] + 5); y < frame.height; ++y)
        frame.row_done[static_cast<std::size_t>(y)] = 0;
  }
  try {
    const auto start = std::chrono::steady_clock::now();
    if (packed)
      nicol::make_sink(argv[1])->write(frame);
    else
      nicol::make_exr_sink(argv[1], nicol::ExrPacking::none)->write(frame);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::printf("%.3f s\n", seconds.count());
  } catch (const nicol::OutputError& error) {
    std::printf("%s\n", error.what());
    return 1;
  }
}
