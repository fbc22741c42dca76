// Kernels on disk: found again, and never trusted when anything is odd.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "host/opencl/binary_cache.hpp"
#include "host/opencl/cache_folder.hpp"
#include "tests/opencl/stand_in.hpp"

using namespace nicol;
namespace fs = std::filesystem;

namespace {

std::string read(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

void write(const std::string& path, const std::string& content) {
  std::ofstream(path, std::ios::binary) << content;
}

// The device goes away with the call: the binary is on disk afterwards.
BuildReport prepare(const KernelOptions& options = {}) { return prepare_kernel(*open_device("0"), 0, options); }

std::vector<std::string> cached_files() {
  std::vector<std::string> files;
  const std::string folder = cache_folder() + "/kernels";
  if (fs::exists(folder))
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path().string());
  return files;
}

}  // namespace

TEST_CASE("a binary comes back as it went; another identity, a flipped bit and any cut are refused") {
  const std::string folder = cache_folder() + "/plain";
  const Bytes binary = {0, 1, 2, 255, 0, 7};
  REQUIRE(save_binary(folder, "device A", binary));
  CHECK(load_binary(folder, "device A") == binary);
  CHECK(!load_binary(folder, "device B"));

  const std::string path = binary_path(folder, "device A"), content = read(path);
  for (std::size_t i = 0; i < content.size(); ++i) {
    std::string damaged = content;
    damaged[i] = static_cast<char>(damaged[i] ^ 4);
    write(path, damaged);
    CHECK_MESSAGE(!load_binary(folder, "device A"), "byte ", i);
    write(path, content.substr(0, i));
    CHECK_MESSAGE(!load_binary(folder, "device A"), "cut at ", i);
  }
  write(path, content + "x");
  CHECK(!load_binary(folder, "device A"));

  // A whole file of another device under this one's name (two identities with one hash).
  REQUIRE(save_binary(folder, "device B", binary));
  fs::rename(binary_path(folder, "device B"), path);
  CHECK(!load_binary(folder, "device A"));
}

TEST_CASE("saving leaves no temporary files, and says so where it cannot") {
  const std::string folder = cache_folder() + "/tidy";
  REQUIRE(save_binary(folder, "x", {1}));
  CHECK(std::distance(fs::directory_iterator(folder), fs::directory_iterator()) == 1);
  CHECK(!save_binary("/proc/version/kernels", "x", {1}));
  CHECK(!save_binary("", "x", {1}));
}

TEST_CASE("the second start takes the kernel from disk, a damaged or foreign file is built anew") {
  const KernelFolder kernels;
  fs::remove_all(cache_folder() + "/kernels");
  CHECK(!prepare().cached);
  const auto files = cached_files();
  REQUIRE(files.size() == 1);
  const std::string good = read(files[0]);
  const BuildReport warm = prepare();
  CHECK(warm.cached);
  CHECK(warm.note.empty());

  write(files[0], good.substr(0, good.size() / 2));
  CHECK(!prepare().cached);
  CHECK(prepare().cached);   // mended

  std::string foreign = good;
  const std::size_t version = foreign.find("OpenCL");
  REQUIRE(version != std::string::npos);
  foreign.replace(version, 6, "OpenXX");
  write(files[0], foreign);
  CHECK(!prepare().cached);

  SUBCASE("a binary that only the driver can tell to be wrong is built anew as well") {
    const std::size_t at = good.find("poclbin");
    if (at != std::string::npos) {
      const std::string sizes = good.substr(15);
      std::uint64_t identity_size = 0;
      sizes.copy(reinterpret_cast<char*>(&identity_size), sizeof identity_size);
      const std::string identity = good.substr(15 + 8, identity_size);
      REQUIRE(save_binary(cache_folder() + "/kernels", identity, {'n', 'o', 'n', 'e'}));
      CHECK(!prepare().cached);
    }
  }
}

TEST_CASE("another text, other options and double are other kernels") {
  const KernelFolder kernels;
  prepare();
  CHECK(prepare().cached);
  KernelOptions generic, in_double, four_lanes;
  generic.generic = true;
  in_double.real_double = true;
  four_lanes.lanes = 4;
  for (const KernelOptions& options : {generic, in_double, four_lanes}) CHECK(!prepare(options).cached);
  kernels.write("trace.cl", std::string(stand_in_trace) + "// changed\n");
  CHECK(!prepare().cached);
}

TEST_CASE("without a folder to write, kernels work and one note says that they are not kept") {
  const KernelFolder kernels;
  const Environment cache("XDG_CACHE_HOME", "/proc/version/cache"), temporary("TMPDIR", "/proc/version/tmp");
  const BuildReport report = prepare();
  CHECK(!report.cached);
  CHECK(report.note.find("not kept") != std::string::npos);
}

TEST_CASE("a kernel of this process is not built twice") {
  const KernelFolder kernels;
  const auto device = open_device("0");
  KernelOptions options;
  options.binary_cache = false;
  const BuildReport first = prepare_kernel(*device, 3, options);
  const BuildReport again = prepare_kernel(*device, 3, options);
  CHECK(again.seconds == first.seconds);   // the same report: nothing was done
}
