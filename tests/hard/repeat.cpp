// The same picture from run to run, to the bit: however it is cut into tiles, however many threads work at it.
#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/hard/bench.hpp"

namespace nicol::hard {
namespace {

// A crystal, an active medium and glass before lights, over wavelengths.
Stage everything() {
  std::vector<double> lambda_nm;
  for (int i = 0; i < 11; ++i) lambda_nm.push_back(420 + 25 * i);
  TestScene scene(lambda_nm);
  scene.scene.settings.adc_bailout = 1e-4;
  scene.scene.sky.assign(lambda_nm.size(), 0.3);
  const OpticFrame frame{Vec3{0.6, 0, 0.8}, Vec3{0, 1, 0}, Vec3{-0.8, 0, 0.6}};
  scene.add_box({-3, -3, -3}, {3, 3, 3}, scene.add_crystal({1.530, 1.681, 1.6855}, frame));
  scene.add_box({4, -2, -2}, {8, 2, 2}, scene.add_medium(1.52, 0, 300));
  scene.add_box({-9, -2, -2}, {-4, 2, 2}, scene.add_medium(1.7, 1e-5));
  const int polarizer = scene.add_polarizer(Polarizer::Kind::ideal, {1, 1, 0}, {0, 0, 1});
  scene.add_sheet({0, 0, -9}, {0, 0, 1}, 20, 20, scene.add_emission(1, polarizer), {});
  return stage_of(scene);
}
const Look over{{1, 2, 40}, {0.05, -0.1, -1}, {1, 0, 0}, 0.7};
constexpr int width = 24, height = 9;

// The digest that another process with that many threads has of its picture.
std::string digest_elsewhere(const Way& way, int threads) {
  const std::string command = fmt::format("POCL_MAX_PTHREAD_COUNT={} /proc/{}/exe --digest {}", threads, getpid(),
      way.column());
  std::FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "no process";
  char text[64] = "";
  const bool got = std::fgets(text, sizeof text, pipe) != nullptr;
  return pclose(pipe) == 0 && got ? std::string(text, std::string(text).find('\n')) : "failed";
}

void repeat(Bench& bench) {
  const std::string first = picture_digest(bench.way(), 0.03);
  const auto hold = [&](const char* what, const std::string& other) {
    bench.hold(what, "the same bits", 0, other == first ? 0 : 1);
  };
  for (const double seconds : {0.03, 1e-5, 1e-3, 5.0}) hold("again, in tiles of any size", picture_digest(bench.way(),
      seconds));
  for (const int threads : {1, 2, 3}) hold("by 1, 2 and 3 threads", digest_elsewhere(bench.way(), threads));
}

}  // namespace

// FNV-1a of all numbers of a picture with everything in it.
std::string picture_digest(const Way& way, double tile_seconds) {
  Table unused;
  Bench bench(way, "", unused);
  bench.tile_seconds = tile_seconds;
  std::uint64_t hash = 14695981039346656037u;
  for (const Seen& seen : bench.look(everything(), over, width, height)) {
    const unsigned char* bytes = reinterpret_cast<const unsigned char*>(&seen);
    for (std::size_t i = 0; i < sizeof seen; ++i) hash = (hash ^ bytes[i]) * 1099511628211u;
  }
  return fmt::format("{:016x}", hash);
}

std::vector<Case> repeat_cases() { return {{"repeat", "the same bits", repeat}}; }

}  // namespace nicol::hard
