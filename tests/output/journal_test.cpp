// Finished tiles come back after any accident, or are told to be lost: never wrong bytes, never a crash.
#include <doctest/doctest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <random>
#include <vector>

#include "host/output/journal.hpp"
#include "tests/output/pattern.hpp"

using namespace nicol;
namespace fs = std::filesystem;

namespace {

constexpr std::size_t unit_bytes = 12;
const std::string identity = "cube.pov\n16 samples\nfloat, 8 lanes";

// Every byte tells pass, sample and unit.
std::string bytes_of(const TileKey& tile) {
  std::string bytes;
  for (std::int64_t unit = tile.first_unit; unit < tile.first_unit + tile.unit_count; ++unit)
    for (std::size_t i = 0; i < unit_bytes; ++i)
      bytes += static_cast<char>(31 * tile.pass + 7 * tile.sample_begin + 3 * unit + static_cast<std::int64_t>(i));
  return bytes;
}

void add(Journal& journal, const TileKey& tile) {
  const std::string bytes = bytes_of(tile);
  journal.add(tile, bytes.data(), bytes.size());
}

bool holds(const Journal& journal, const TileKey& tile) {
  std::string bytes(static_cast<std::size_t>(tile.unit_count) * unit_bytes, '\0');
  if (!journal.find(tile, unit_bytes, bytes.data())) return false;
  CHECK(bytes == bytes_of(tile));
  return true;
}

std::unique_ptr<Journal> open(const std::string& path, bool resume, std::string& note) {
  return Journal::open(path, identity, resume, note);
}

const std::vector<TileKey> tiles = {{0, 0, 3, 0, 16}, {0, 0, 3, 16, 20}, {0, 3, 5, 0, 16}, {1, 0, 8, 0, 4}};

// The file that these tiles leave.
std::string written(const std::string& path) {
  std::string note;
  const auto journal = open(path, false, note);
  for (const TileKey& tile : tiles) add(*journal, tile);
  return contents(path);
}

void put(const std::string& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Exit code of `act` in a process of its own; -1 if it was killed.
int in_child(const std::function<int()>& act) {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(act());
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

}  // namespace

TEST_CASE("tiles come back in the same run and in the next") {
  const TemporaryFolder folder;
  std::string note;
  for (bool resume : {false, true}) {
    const auto journal = open(folder.file("a.part"), resume, note);
    CHECK(note == "");
    if (!resume)
      for (const TileKey& tile : tiles) add(*journal, tile);
    for (const TileKey& tile : tiles) CHECK(holds(*journal, tile));
    CHECK(holds(*journal, {0, 2, 4, 0, 16}));         // parts of two tiles
    CHECK(!holds(*journal, {0, 2, 4, 16, 20}));       // one of them lacks
    CHECK(!holds(*journal, {0, 0, 3, 0, 20}));        // other samples
    CHECK(!holds(*journal, {2, 0, 3, 0, 16}));        // another pass
    CHECK(journal->covered_units(0, 0, 0, 16) == 8);
    CHECK(journal->covered_units(0, 7, 0, 16) == 1);
    CHECK(journal->covered_units(0, 8, 0, 16) == 0);
    CHECK(journal->missing_units(0, 7, 0, 16) == 0);
    CHECK(journal->missing_units(0, 8, 0, 16) > 1000000);
    CHECK(journal->missing_units(1, 0, 0, 16) > 1000000);
    CHECK(journal->covered_units(0, 0, 16, 20) == 3);
    CHECK(journal->covered_units(3, 0, 0, 16) == 0);
    std::string bytes(3 * 8, '\0');
    CHECK(!journal->find(tiles[0], 8, bytes.data()));  // another layout
    CHECK(journal->note() == "");
  }
}

TEST_CASE("tiles that overlap, lie apart or come twice") {
  const TemporaryFolder folder;
  std::string note;
  for (bool resume : {false, true}) {
    const auto journal = open(folder.file("a.part"), resume, note);
    if (!resume)
      for (const auto& [first, count] : {std::pair{10, 4}, {2, 3}, {0, 20}, {4, 2}, {10, 4}, {30, 1}, {18, 4}})
        add(*journal, {0, first, count, 0, 1});
    CHECK(journal->covered_units(0, 0, 0, 1) == 22);
    for (std::int64_t first = 0; first < 22; ++first)
      for (std::int64_t count = 1; count <= 22 - first; ++count) CHECK(holds(*journal, {0, first, count, 0, 1}));
    CHECK(!holds(*journal, {0, 20, 3, 0, 1}));
    CHECK(!holds(*journal, {0, 29, 2, 0, 1}));
    CHECK(holds(*journal, {0, 30, 1, 0, 1}));
  }
}

TEST_CASE("cut at every byte: the whole tiles before the cut come back, and recording goes on") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part"), whole = written(path);
  std::size_t most = 0;
  for (std::size_t size = 0; size <= whole.size(); ++size) {
    CAPTURE(size);
    put(path, whole.substr(0, size));
    std::string note;
    std::size_t kept = 0;
    {
      const auto journal = open(path, true, note);
      while (kept < tiles.size() && holds(*journal, tiles[kept])) ++kept;
      for (std::size_t i = kept; i < tiles.size(); ++i) CHECK(!holds(*journal, tiles[i]));
      CHECK(kept >= most);
      most = kept;
      for (std::size_t i = kept; i < tiles.size(); ++i) add(*journal, tiles[i]);
    }
    CHECK(contents(path) == whole);
  }
  CHECK(most == tiles.size());
}

TEST_CASE("a flipped bit: no wrong byte comes back, and it is told") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part"), whole = written(path);
  for (std::size_t at = 0; at < whole.size(); ++at) {
    CAPTURE(at);
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ (1 << at % 8));
    put(path, damaged);
    std::string note;
    std::size_t found = 0;
    {
      const auto journal = open(path, true, note);
      for (const TileKey& tile : tiles) found += holds(*journal, tile);
    }
    CHECK(found < tiles.size());
    CHECK(note != "");
    fs::remove(path);
  }
}

TEST_CASE("a damaged tile does not take those behind it along") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part");
  std::string damaged = written(path);
  const std::size_t at = damaged.find(bytes_of(tiles[1]));
  REQUIRE(at != std::string::npos);
  damaged[at] ^= 1;
  put(path, damaged);
  std::string note;
  const auto journal = open(path, true, note);
  CHECK(note == "some tiles in " + path + " are cut short or damaged: they are rendered again");
  CHECK(!holds(*journal, tiles[1]));
  CHECK(holds(*journal, tiles[2]));
  add(*journal, tiles[1]);
  CHECK(holds(*journal, tiles[1]));
}

TEST_CASE("another identity, another version, nothing there, not to go on: the picture begins anew") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part"), whole = written(path);
  std::string note;
  for (const std::string& other : {identity + " ", identity.substr(1), std::string("x"), std::string()}) {
    put(path, whole);
    const auto journal = Journal::open(path, other, true, note);
    CHECK(contains(note, "written for another picture"));
    CHECK(!holds(*journal, tiles[0]));
    add(*journal, tiles[1]);
    CHECK(holds(*journal, tiles[1]));
  }
  std::string newer = whole;
  newer[12] = '7';
  put(path, newer);
  CHECK(!holds(*open(path, true, note), tiles[0]));
  CHECK(contains(note, "another version of nicol"));
  CHECK(!fs::exists(path));  // no tile was recorded
  open(path, true, note);
  CHECK(contains(note, "there are no tiles in"));
  put(path, whole);
  CHECK(!holds(*open(path, false, note), tiles[0]));
  CHECK(note == "");
}

TEST_CASE("a file without tiles and the file of a finished picture go away") {
  const TemporaryFolder folder;
  std::string note;
  open(folder.file("a.part"), false, note);
  CHECK(folder.entries() == 0);
  const auto journal = open(folder.file("a.part"), false, note);
  add(*journal, tiles[0]);
  CHECK(folder.entries() == 1);
  journal->remove();
  CHECK(folder.entries() == 0);
  add(*journal, tiles[0]);
  CHECK(!holds(*journal, tiles[0]));
}

TEST_CASE("what nicol did not make is left alone") {
  const TemporaryFolder folder;
  std::string note;
  const auto refused = [&](const std::string& path) {
    const auto journal = open(path, false, note);
    add(*journal, tiles[0]);
    CHECK(journal->note() == note);
    CHECK(contains(note, "cannot write " + path));
    return !holds(*journal, tiles[0]) && journal->covered_units(0, 0, 0, 16) == 0;
  };
  put(folder.file("letter"), "Dear Sir");
  CHECK(refused(folder.file("letter")));
  CHECK(contents(folder.file("letter")) == "Dear Sir");
  fs::create_directory(folder.file("shelf"));
  CHECK(refused(folder.file("shelf")));
  fs::create_symlink("/dev/full", folder.file("full"));
  CHECK(refused(folder.file("full")));
  REQUIRE(::mkfifo(folder.file("pipe").c_str(), 0600) == 0);
  CHECK(refused(folder.file("pipe")));
  CHECK(refused(folder.file("no folder/a.part")));
  CHECK(folder.entries() == 4);
}

TEST_CASE("a folder without the right to write: the picture is rendered all the same") {
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec | fs::perms::others_read |
                                     fs::perms::others_exec);
  const auto said = in_child([&] {
    if (::getuid() == 0 && ::setuid(65534) != 0) return 2;
    std::string note;
    const auto journal = open(folder.file("a.part"), false, note);
    add(*journal, tiles[0]);
    return contains(note, "Permission denied") && journal->note() == note ? 0 : 1;
  });
  fs::permissions(folder.path(), fs::perms::owner_all);
  CHECK(said == 0);
}

TEST_CASE("a full disk stops the recording, at every byte; what was recorded stays good") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part"), whole = written(path);
  for (std::size_t limit = 0; limit < whole.size(); ++limit) {
    CAPTURE(limit);
    fs::remove(path);
    const auto said = in_child([&] {
      const rlimit bytes = {limit, limit};
      ::setrlimit(RLIMIT_FSIZE, &bytes);
      std::signal(SIGXFSZ, SIG_IGN);
      std::string note;
      const auto journal = open(path, false, note);
      for (const TileKey& tile : tiles) add(*journal, tile);
      return contains(journal->note(), "cannot write " + path + ": File too large") ? 0 : 1;
    });
    CHECK(said == 0);
    std::string note;
    const auto journal = open(path, true, note);
    std::size_t kept = 0;
    while (kept < tiles.size() && holds(*journal, tiles[kept])) ++kept;
    CHECK(kept < tiles.size());
    CHECK((note == "" || contains(note, "no tiles") || contains(note, "only in part")));
  }
}

TEST_CASE("two at once: the second renders without keeping tiles, the first is not disturbed") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part");
  std::string note;
  const auto first = open(path, false, note);
  add(*first, tiles[0]);
  for (bool resume : {false, true}) {
    const auto said = in_child([&] {
      std::string told;
      const auto second = open(path, resume, told);
      add(*second, tiles[1]);
      return contains(told, "another nicol is rendering this picture") && !holds(*second, tiles[1]) ? 0 : 1;
    });
    CHECK(said == 0);
  }
  add(*first, tiles[2]);
  CHECK(holds(*first, tiles[0]));
  CHECK(holds(*first, tiles[2]));
}

TEST_CASE("killed at any moment: the next run goes on, and gets the same bytes") {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.part");
  std::mt19937 random(7);
  std::int64_t before = 0;
  for (int turn = 0; turn < 40; ++turn) {
    const pid_t child = ::fork();
    if (child == 0) {
      std::string note;
      const auto journal = open(path, true, note);
      for (std::int64_t unit = journal->covered_units(0, 0, 0, 16);; unit += 50)
        add(*journal, {0, unit, 50, 0, 16});
    }
    ::usleep(static_cast<useconds_t>(500 + random() % 3000));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    std::string note;
    const auto journal = open(path, true, note);
    const std::int64_t covered = journal->covered_units(0, 0, 0, 16);
    CHECK(covered >= before);
    CHECK(covered % 50 == 0);
    if (covered > 0) CHECK(holds(*journal, {0, 0, covered, 0, 16}));
    before = covered;
  }
  CHECK(before > 0);
}
