// When a picture cannot be written: a clear reason, no debris, and the old file untouched.
#include <doctest/doctest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <fstream>

#include "host/output/atomic_file.hpp"
#include "tests/output/pattern.hpp"

using namespace nicol;
namespace fs = std::filesystem;

namespace {

std::string refusal(const std::string& path) {
  try {
    make_sink(path);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "(accepted)";
}

struct Outcome {
  int code = 0;
  std::string said;
};

Outcome write_pattern(const std::string& arguments) {
  Outcome outcome;
  std::FILE* pipe = ::popen((std::string(WRITE_PATTERN) + " " + arguments).c_str(), "r");
  REQUIRE(pipe);
  std::array<char, 256> text{};
  while (std::fgets(text.data(), text.size(), pipe)) outcome.said += text.data();
  outcome.code = WEXITSTATUS(::pclose(pipe));
  return outcome;
}

void put(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

}  // namespace

TEST_CASE("targets that cannot be are refused before anything is rendered") {
  const TemporaryFolder folder;
  CHECK(refusal(folder.file("a.jpg")) ==
        "cannot write " + folder.file("a.jpg") + ": unknown suffix .jpg (.exr and .png are known)");
  CHECK(refusal(folder.file("picture")) ==
        "cannot write " + folder.file("picture") +
            ": its name has no suffix (.exr and .png are known)");
  CHECK(refusal("") == "cannot write : its name has no suffix (.exr and .png are known)");
  CHECK(refusal(folder.file("none/a.exr")) == "cannot write " + folder.file("none/a.exr") +
                                                  ": there is no folder " + folder.file("none"));
  fs::create_directory(folder.file("b.png"));
  CHECK(refusal(folder.file("b.png")) ==
        "cannot write " + folder.file("b.png") + ": it is a folder");
  put(folder.file("file"), "");
  CHECK(refusal(folder.file("file/a.exr")) == "cannot write " + folder.file("file/a.exr") + ": " +
                                                  folder.file("file") + " is not a folder");
  CHECK(refusal(folder.file("a.exr")) == "(accepted)");
  CHECK(refusal(folder.file("a.PNG")) == "(accepted)");
  CHECK(folder.entries() == 2);  // b.png and file: asking leaves nothing behind
}

TEST_CASE("a folder without the right to write is refused") {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec |
                                     fs::perms::group_read | fs::perms::group_exec |
                                     fs::perms::others_read | fs::perms::others_exec);
  const auto outcome = write_pattern(folder.file("a.exr") + " nobody");
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(outcome.code == 1);
  CHECK(outcome.said == "cannot write " + folder.file("a.exr") + ": Permission denied\n");
  CHECK(folder.entries() == 0);
}

TEST_CASE("a file that cannot be finished leaves the old one and no debris") {
  for (const std::string name : {"a.exr", "a.png"}) {
    const TemporaryFolder folder;
    REQUIRE(write_pattern(folder.file(name)).code == 0);
    const auto whole_bytes = fs::file_size(folder.file(name));
    put(folder.file(name), "the old picture");
    for (const auto bytes :
         {std::uintmax_t{0}, std::uintmax_t{10}, whole_bytes / 2, whole_bytes - 1}) {
      CAPTURE(bytes);
      const auto outcome = write_pattern(folder.file(name) + " bytes=" + std::to_string(bytes));
      CHECK(outcome.code == 1);
      CHECK(outcome.said == "cannot write " + folder.file(name) + ": File too large\n");
      CHECK(folder.entries() == 1);
      CHECK(contents(folder.file(name)) == "the old picture");
    }
    CHECK(write_pattern(folder.file(name) + " bytes=" + std::to_string(whole_bytes)).code == 0);
    CHECK(fs::file_size(folder.file(name)) == whole_bytes);
  }
}

TEST_CASE("the file appears whole, under its name only") {
  const TemporaryFolder folder;
  put(folder.file("a.png"), "old");
  {
    AtomicFile file(folder.file("a.png"));
    file.write("newer", 5);
    CHECK(contents(folder.file("a.png")) == "old");
    CHECK(folder.entries() == 2);
    file.commit();
    CHECK(contents(folder.file("a.png")) == "newer");
  }
  CHECK(folder.entries() == 1);
  { AtomicFile abandoned(folder.file("a.png")); }
  CHECK(contents(folder.file("a.png")) == "newer");
  CHECK(folder.entries() == 1);
}

TEST_CASE("two pictures may be written at the same place at once") {
  const TemporaryFolder folder;
  AtomicFile first(folder.file("a.exr")), second(folder.file("a.exr"));
  first.write("1", 1);
  second.write("2", 1);
  second.commit();
  first.commit();
  CHECK(contents(folder.file("a.exr")) == "1");
  CHECK(folder.entries() == 1);
}

TEST_CASE("a link stays a link") {
  const TemporaryFolder folder;
  fs::create_directory(folder.file("shelf"));
  fs::create_symlink("shelf/a.exr", folder.file("a.exr"));
  make_sink(folder.file("a.exr"))->write(pattern_frame(3, 2));
  CHECK(fs::is_symlink(folder.file("a.exr")));
  CHECK(fs::is_regular_file(folder.file("shelf/a.exr")));
}

TEST_CASE("a picture that contradicts itself is refused") {
  const TemporaryFolder folder;
  for (const std::string name : {"a.exr", "a.png"}) {
    Frame frame = pattern_frame(3, 2);
    frame.stokes.pop_back();
    CHECK_THROWS_WITH_AS(
        make_sink(folder.file(name))->write(frame),
        ("cannot write " + folder.file(name) + ": the arrays of the picture do not fit its size")
            .c_str(),
        OutputError);
    CHECK_THROWS_AS(make_sink(folder.file(name))->write(Frame{}), OutputError);
  }
  CHECK(folder.entries() == 0);
}
