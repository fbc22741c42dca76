// Parts of a picture: dealt out, written, joined again; and what does not belong together.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <fstream>

#include "host/output/exr_source.hpp"
#include "host/output/merge.hpp"
#include "host/output/sinks.hpp"
#include "tests/output/pattern.hpp"

using namespace nicol;

namespace {

constexpr int width = 45, height = 34;  // more than one block of 32 rows

WholePicture pattern_whole() {
  const Frame frame = pattern_frame(width, height);
  WholePicture whole;
  whole.width = width;
  whole.height = height;
  whole.lambda_nm = frame.lambda_nm;
  whole.weight_nm = frame.weight_nm;
  whole.settings = {{"scene", "4711"}, {"samples", "4"}};
  return whole;
}

std::vector<std::int32_t> all_pixels() {
  std::vector<std::int32_t> pixels(static_cast<std::size_t>(width) * height);
  for (std::size_t p = 0; p < pixels.size(); ++p) pixels[p] = static_cast<std::int32_t>(p);
  return pixels;
}

// The cut-off of each wavelength alone; the pattern's cut-off takes its place where parts have them.
float own_cut_off(std::size_t w, std::size_t p) { return static_cast<float>(p % 7) / 3 + static_cast<float>(w) / 7; }

Frame picture_with_cut_offs() {
  Frame frame = pattern_frame(width, height);
  for (std::size_t p = 0; p < frame.plane(); ++p) {
    double sum = 0;
    for (std::size_t w = 0; w < 3; ++w) {
      frame.channel_cut_off.resize(3 * frame.plane());
      sum += static_cast<double>(frame.channel_cut_off[w * frame.plane() + p] = own_cut_off(w, p));
    }
    frame.cut_off[p] = static_cast<float>(sum / 3);
  }
  return frame;
}

struct PartOptions {
  std::vector<std::int32_t> pixels = all_pixels();
  std::size_t first = 0, count = 3;
  std::string name = "share 1/1", device = "one device";
  WholePicture whole = pattern_whole();
  float changed = 0;  // added to S1 of the part's first pixel and wavelength
};

void write_part(const std::string& path, const PartOptions& options) {
  Frame picture = picture_with_cut_offs();
  if (options.count == 3) picture.channel_cut_off.clear();
  std::vector<float> wanted(picture.plane(), 0.0f);
  for (const std::int32_t p : options.pixels) wanted[static_cast<std::size_t>(p)] = 1;
  Frame frame = cut_out(picture, all_pixels(), wanted, width, height, options.first, options.count);
  frame.component(1, 0)[options.pixels.front()] += options.changed;
  PartNote part;
  part.whole = options.whole;
  part.name = options.name;
  part.device = options.device;
  part.counted = {0, 1, 2, 3, 4};
  part.checksum = make_part(frame, wanted);
  for (auto& note : notes_of_part(part)) frame.how.push_back(std::move(note));
  make_exr_sink(path)->write(frame);
}

Frame merged(const std::vector<std::string>& paths) {
  Merger merger;
  for (const std::string& path : paths) merger.add(path);
  CHECK(merger.missing() == "");
  return merger.take();
}

void check_whole(const Frame& frame) {
  const Frame picture = picture_with_cut_offs();
  REQUIRE(frame.stokes.size() == picture.stokes.size());
  CHECK(std::memcmp(frame.stokes.data(), picture.stokes.data(), picture.stokes.size() * sizeof(float)) == 0);
  CHECK(frame.cut_off == picture.cut_off);
  CHECK(frame.lambda_nm == picture.lambda_nm);
  CHECK(frame.weight_nm == picture.weight_nm);
  CHECK(frame.planes.empty());
}

std::string refusal(const std::vector<std::string>& paths) {
  try {
    Merger merger;
    for (const std::string& path : paths) merger.add(path);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool says(const std::string& text, const std::vector<std::string>& words) {
  return std::all_of(words.begin(), words.end(), [&](const std::string& word) { return text.find(word) != std::string::npos; });
}

// Three parts: two shares of two wavelengths, and the third wavelength everywhere.
struct ThreeParts {
  TemporaryFolder folder;
  std::string a = folder.file("a.exr"), b = folder.file("b.exr"), c = folder.file("c.exr");
  ThreeParts() {
    write_part(a, {dealt_pixels(width, height, 1, 2), 0, 2});
    write_part(b, {dealt_pixels(width, height, 2, 2), 0, 2});
    write_part(c, {all_pixels(), 2, 1});
  }
};

}  // namespace

TEST_CASE("shares of a picture are all of it, once, and alike in size") {
  for (const auto& [w, h, n] : std::vector<std::array<int, 3>>{{45, 34, 3}, {1920, 1080, 7}, {64, 1, 1}, {1, 1, 1}, {2048, 64, 2}, {333, 77, 100}}) {
    std::vector<int> count(static_cast<std::size_t>(w) * h);
    std::size_t least = count.size(), most = 0;
    for (int i = 1; i <= n; ++i) {
      const auto pixels = dealt_pixels(w, h, i, n);
      CHECK(std::is_sorted(pixels.begin(), pixels.end()));
      for (const std::int32_t p : pixels) ++count.at(static_cast<std::size_t>(p));
      least = std::min(least, pixels.size());
      most = std::max(most, pixels.size());
    }
    CHECK(std::all_of(count.begin(), count.end(), [](int times) { return times == 1; }));
    CHECK(least > 0);
    CHECK(most - least < 2 * deal_run);
  }
  CHECK(dealt_pixels(64, 2, 3, 3).empty());
}

TEST_CASE("a share has its part of every region of a picture") {
  const auto pixels = dealt_pixels(1920, 1080, 2, 4);
  std::vector<int> left(16), count(16);
  for (const std::int32_t p : pixels) ++count[static_cast<std::size_t>(p % 1920 / 480 + p / 1920 / 270 * 4)];
  for (const int c : count) CHECK(std::abs(c - 480 * 270 / 4) < 480 * 270 / 4 / 10);
}

TEST_CASE("what a part's header says comes back") {
  PartNote part;
  part.whole = pattern_whole();
  part.whole.lambda_nm = {400.1, 580, 633.2000000000001};
  part.whole.exposure = 1.0 / 3;
  part.name = "rows 1..2";
  part.checksum = "0";
  part.device = "d";
  part.seconds = 0.1;
  part.counted = {1, 2};
  const Notes notes = notes_of_part(part);
  const PartNote back = read_part_note("a.exr", {notes.begin(), notes.end()});
  CHECK(difference(part.whole, back.whole) == "");
  CHECK(back.whole.lambda_nm == part.whole.lambda_nm);
  CHECK(back.whole.exposure == part.whole.exposure);
  CHECK(back.counted == part.counted);
  for (const auto& [key, value] : notes) {
    std::map<std::string, std::string> less(notes.begin(), notes.end());
    less.erase(key);
    if (key.rfind("whole.same.", 0) != 0) CHECK_THROWS_AS(read_part_note("a.exr", less), InputError);
  }
  std::map<std::string, std::string> wrong(notes.begin(), notes.end());
  for (const char* value : {"", "x", "0 0", "100000 1", "nan 1", "3", "45 34 1", "45,34", "-1 5"}) {
    wrong["whole.size"] = value;
    CHECK_THROWS_AS(read_part_note("a.exr", wrong), InputError);
  }
}

TEST_CASE("parts of pixels and of wavelengths join to the picture, in any order, overlapping or not") {
  const ThreeParts parts;
  check_whole(merged({parts.a, parts.b, parts.c}));
  check_whole(merged({parts.c, parts.b, parts.a, parts.b}));
  write_part(parts.folder.file("all.exr"), {});
  check_whole(merged({parts.folder.file("all.exr")}));
  check_whole(merged({parts.a, parts.folder.file("all.exr"), parts.c}));
}

TEST_CASE("an EXR of joined parts has the bytes of pixels that one run writes") {
  const ThreeParts parts;
  Frame whole = picture_with_cut_offs();
  whole.channel_cut_off.clear();
  whole.how.clear();
  Frame frame = merged({parts.a, parts.b, parts.c});
  make_exr_sink(parts.folder.file("merged.exr"))->write(frame);
  make_exr_sink(parts.folder.file("whole.exr"))->write(whole);
  CHECK(contents(parts.folder.file("merged.exr")) == contents(parts.folder.file("whole.exr")));
}

TEST_CASE("what is missing is told, and what there is can be joined later") {
  const ThreeParts parts;
  Merger two;
  two.add(parts.a);
  two.add(parts.b);
  CHECK(two.missing() == "the wavelengths 633.2 nm");
  Frame incomplete = two.take();
  CHECK(incomplete.lambda_nm == std::vector<double>{400, 580});
  make_exr_sink(parts.folder.file("ab.exr"))->write(incomplete);
  check_whole(merged({parts.folder.file("ab.exr"), parts.c}));

  Merger one;
  one.add(parts.a);
  one.add(parts.c);
  CHECK(says(one.missing(), {"of 1530 pixels", " columns "}));
  const Frame frame = one.take();
  REQUIRE(frame.planes.size() == 1);
  const auto share = dealt_pixels(width, height, 1, 2);
  for (std::size_t p = 0; p < frame.plane(); ++p) {
    const bool there = std::binary_search(share.begin(), share.end(), static_cast<std::int32_t>(p));
    REQUIRE(frame.planes[0].second[p] == (there ? 1.0f : 1.0f / 3));
  }
}

TEST_CASE("parts of different pictures are refused with the names of both and what differs") {
  const ThreeParts parts;
  const std::string other = parts.folder.file("other.exr");
  const auto told = [&](const WholePicture& whole) {
    write_part(other, {all_pixels(), 2, 1, "x", "one device", whole});
    return refusal({parts.a, other});
  };
  WholePicture whole = pattern_whole();
  whole.settings["samples"] = "16";
  CHECK(says(told(whole), {parts.a, other, "samples differs (4, 16)"}));
  whole = pattern_whole();
  whole.settings["scene"] = "4712";
  CHECK(says(told(whole), {parts.a, other, "the scenes differ"}));
  whole = pattern_whole();
  whole.exposure = 2;
  CHECK(says(told(whole), {parts.a, other, "exposure"}));
  whole = pattern_whole();
  whole.weight_nm[1] += 1;
  CHECK(says(told(whole), {parts.a, other, "wavelengths"}));
}

TEST_CASE("parts that overlap must agree to the bit") {
  const ThreeParts parts;
  const std::string other = parts.folder.file("other.exr");
  write_part(other, {dealt_pixels(width, height, 1, 2), 0, 2, "x", "one device", pattern_whole(), 1e-5f});
  CHECK(says(refusal({parts.a, other}), {parts.a, other, "overlap and differ: S1 at 400 nm", "column", "row"}));
  CHECK(refusal({parts.b, other}) == "");
}

TEST_CASE("other devices are told of") {
  const ThreeParts parts;
  write_part(parts.folder.file("other.exr"), {all_pixels(), 2, 1, "x", "another device"});
  Merger merger;
  merger.add(parts.a);
  merger.add(parts.c);
  CHECK(merger.warnings().empty());
  merger.add(parts.folder.file("other.exr"));
  REQUIRE(merger.warnings().size() == 1);
  CHECK(says(merger.warnings()[0], {"one device", "another device"}));
}

TEST_CASE("files that are no parts, cut short or damaged are refused by name") {
  const ThreeParts parts;
  const std::string file = parts.folder.file("d.exr"), good = contents(parts.a);
  make_exr_sink(file)->write(pattern_frame(width, height));
  CHECK(says(refusal({file}), {file, "not a part"}));
  CHECK(says(refusal({parts.folder.file("none.exr")}), {"none.exr", "No such file"}));
  std::ofstream(file) << "no picture";
  CHECK(says(refusal({file}), {file}));
  std::ofstream(file, std::ios::binary) << good.substr(0, good.size() * 2 / 3);
  CHECK(says(refusal({file}), {file}));
  // One bit of the pixels: the last tenth of the file.
  for (std::size_t at = good.size() * 9 / 10; at < good.size(); at += 7) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 16);
    std::ofstream(file, std::ios::binary) << bad;
    const std::string told = refusal({file});
    // Where rounds of the packing leave a bit unused the pixels are the same, and the file is good.
    if (told.empty()) {
      check_whole(merged({file, parts.b, parts.c}));
    } else {
      CHECK(says(told, {file}));
    }
  }
}
