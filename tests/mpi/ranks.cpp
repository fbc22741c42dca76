// A render by ranks without a scene file: the stand-in kernel (tests/opencl/stand_in.hpp), whose time and answers are known.
//
// ranks OUT SAMPLES TURNS LANES_OVER_PIXELS [JOURNAL [continue]]
// Writes the picture's floats to OUT and tells "all work" when each rank has traced a few tiles, at the end "tiles N found N interrupted N", what each rank did, and what went wrong. NICOL_KERNEL_DIR holds
// the stand-in's trace.cl: `ranks --kernel FOLDER` writes it there.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fstream>

#include "host/mpi/ranks.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;

namespace {

std::atomic<bool> interrupted{false};

int render_to(const std::string& out, const std::vector<std::string>& arguments, Ranks* ranks) {
  const bool over_pixels = arguments.at(2) == "1";
  PackedScene scene = stand_in_scene(211, 83, 19, 8, over_pixels);
  scene.reals = {std::stod(arguments.at(1))};
  RenderOptions options;
  options.kernel.lanes = 8;
  options.samples = std::stoi(arguments.at(0));
  options.tile_seconds = 0.01;
  options.cancel = &interrupted;
  options.journal_after_seconds = 0;
  std::unique_ptr<Journal> journal;
  std::string note;
  if (arguments.size() > 3) journal = Journal::open(arguments[3], "ranks", arguments.size() > 4, note);
  options.journal = journal.get();
  if (ranks) options.others = &ranks->others("");
  RenderReport report;
  bool told = false;
  options.progress = [&](const Progress&) {
    if (told || std::any_of(report.shares.begin(), report.shares.end(), [](const DeviceShare& share) { return share.tiles < 3; })) return;
    told = true;
    fmt::print("all work\n");
    std::fflush(stdout);
  };
  const auto device = open_device("");
  const Frame frame = render(*device, scene, wavelengths(19), std::vector<double>(19, 10.0), options, report);
  if (!report.interrupted) {
    std::ofstream file(out, std::ios::binary);
    for (std::size_t i = 0; i < 4 * 19 * frame.plane(); ++i) file.write(reinterpret_cast<const char*>(&frame.stokes.data()[i]), sizeof(float));
    if (journal) journal->remove();
  }
  fmt::print("tiles {} found {} interrupted {} segments {} seconds {:.3f}\n", report.tiles, report.tiles_found, report.interrupted,
             report.segments, report.seconds);
  for (const DeviceShare& share : report.shares) fmt::print("share {} {}\n", share.place.empty() ? "here" : share.place, share.tiles);
  for (const std::string& line : report.notes) fmt::print("note {}\n", line);
  return report.interrupted ? 2 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() == 2 && arguments[0] == "--kernel") {
    std::ofstream(arguments[1] + "/trace.cl") << stand_in_trace;
    return 0;
  }
  int code = 1;
  std::unique_ptr<Ranks> ranks;
  try {
    ranks = join_ranks(kernels_hash());
    if (ranks && ranks->rank() > 0) return ranks->serve();
    for (const int signal : {SIGINT, SIGTERM}) std::signal(signal, [](int) { interrupted = true; });
    code = render_to(arguments.at(0), {arguments.begin() + 1, arguments.end()}, ranks.get());
  } catch (const std::exception& error) {
    fmt::print("error {}\n", error.what());
  }
  std::fflush(stdout);
  if (ranks) ranks->end(code);
  return code;
}
