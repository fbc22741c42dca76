// What of a picture is rendered, which frames of a film, and what ffmpeg is asked for.
#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>

#include "host/app/animation.hpp"
#include "host/app/film.hpp"
#include "host/app/povray_switches.hpp"
#include "host/engine/merged_picture.hpp"
#include "host/engine/picture_share.hpp"
#include "host/opencl/gather.hpp"
#include "host/output/part.hpp"
#include "host/output/sinks.hpp"

using namespace nicol;
using namespace nicol::app;

TEST_CASE("rows and columns of a window are those that POV-Ray 3.7.0.10 renders") {
  struct Case {
    double start, end;  // < 0: not given
    int count, first, last;
  };
  for (const Case& c : {Case{3, 5, 10, 3, 5}, {0.5, -1, 10, 6, 10}, {0.5, -1, 7, 4, 7}, {-1, 0.5, 7, 1, 3}, {0.25, 0.75, 10, 3, 7},
                        {0.25, 0.75, 7, 2, 5}, {0.33, 0.66, 10, 4, 6}, {0.33, 0.66, 7, 3, 4}, {0.34, -1, 10, 4, 10}, {-1, 0.34, 7, 1, 2},
                        {-1, 1, 10, 1, 10}, {1, 1, 10, 1, 10}, {0, 0.99, 10, 1, 9}, {1, 2, 10, 1, 2}, {2, 2, 7, 2, 2}}) {
    const auto given = [](double value) { return value < 0 ? std::optional<double>() : std::optional<double>(value); };
    const PixelRange range = pixel_range(given(c.start), given(c.end), c.count, "row");
    CHECK(range.first + 1 == c.first);
    CHECK(range.last + 1 == c.last);
  }
  for (const auto& [start, end] : {std::pair{11.0, 10.0}, {1.0, 99.0}, {1.0, 0.05}, {0.39, 0.31}, {-1.0, 1.0}, {5.0, 4.0}})
    CHECK_THROWS_AS(pixel_range(start, end, 10, "row"), UsageError);
}

TEST_CASE("shares and parts of wavelengths: nonsense is refused") {
  CHECK(parse_share("2/3") == std::array<int, 2>{2, 3});
  CHECK(parse_wavelength_part("450.5..550") == std::array<double, 2>{450.5, 550});
  for (const char* wrong : {"", "1", "0/3", "4/3", "1/0", "-1/3", "1/3x", "1 / 3", "1/2/3", "1/9999999"})
    CHECK_THROWS_AS(parse_share(wrong), UsageError);
  for (const char* wrong : {"", "..", "400..", "..500", "500..400", "400...500", "400:500", "a..b", "nan..500"})
    CHECK_THROWS_AS(parse_wavelength_part(wrong), UsageError);
}

TEST_CASE("with a share goes what lanes hold together, and no more") {
  PackedScene packed;
  packed.width = 10;
  packed.height = 3;
  packed.features = lanes_over_pixels_bit();
  PictureShare share;
  share.pixels = {3, 4, 9, 29};
  CHECK(whole_lanes(share, packed, 3, 4).pixels == std::vector<std::int32_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 28, 29});
  CHECK(whole_lanes(share, packed, 3, 1).pixels == share.pixels);
  packed.features = 0;
  share.wavelengths = {5, 4};
  CHECK(whole_lanes(share, packed, 21, 8).pixels == share.pixels);
  CHECK(whole_lanes(share, packed, 21, 8).wavelengths.first == 0);
  CHECK(whole_lanes(share, packed, 21, 8).wavelengths.count == 16);
  CHECK(whole_lanes(share, packed, 13, 8).wavelengths.count == 13);
  CHECK(whole_lanes(share, packed, 21, 4).wavelengths.first == 4);
  packed.mixing = {1};
  CHECK(whole_lanes(share, packed, 21, 8).wavelengths.count == 4);
}

TEST_CASE("frames, their clocks and their names are POV-Ray's") {
  AnimationOptions options;
  options.final_frame = 3;
  CHECK(clock_at(options, 1).clock == 0);
  CHECK(clock_at(options, 2).clock == 0.5);
  CHECK(clock_at(options, 3).clock == 1);
  CHECK(clock_at(options, 2).clock_delta == 0.5);
  CHECK(frame_path("a/b.c.png", options, 2) == "a/b.c2.png");
  options.final_frame = 10;
  options.cyclic = true;
  CHECK(clock_at(options, 9).clock == doctest::Approx(0.8));
  CHECK(frame_path("out.exr", options, 9) == "out09.exr");
  options.cyclic = false;
  options.initial_frame = 5;
  options.final_frame = 5;
  options.initial_clock = 3;
  CHECK(clock_at(options, 5).clock == 3);
}

TEST_CASE("subsets of frames are POV-Ray's") {
  AnimationOptions options;
  options.final_frame = 4;
  const auto subset = [&](double start, double end) {
    options.subset_start = start;
    options.subset_end = end;
    const FrameRange range = frames_of(options);
    return std::array<int, 2>{range.first, range.last};
  };
  CHECK(subset(2, 3) == std::array<int, 2>{2, 3});
  CHECK(subset(0.25, 0.75) == std::array<int, 2>{1, 3});
  CHECK(subset(0, 4) == std::array<int, 2>{1, 4});
  CHECK_THROWS_AS(subset(4, 3), UsageError);
  CHECK_THROWS_AS(subset(1, 5), UsageError);
  options.initial_frame = 5;
  CHECK_THROWS_AS(frames_of(options), UsageError);
}

TEST_CASE("POV-Ray's switches of windows and animations become options") {
  std::vector<std::string> ignored;
  const auto out = translate_povray_switches({"+SR0.5", "+er10", "+S3", "+E4", "+SC1", "+EC.5", "+KFI2", "+KFF20", "+KI-1.5", "+KF2",
                                              "+K0.25", "+KC", "+SF3", "+EF0.5", "Initial_Clock=-2", "Final_Frame=7", "Start_Row=2"},
                                             ignored);
  CHECK(out == std::vector<std::string>{"--start-row=0.5", "--end-row=10", "--start-row=3", "--end-row=4", "--start-column=1",
                                        "--end-column=.5", "--initial-frame=2", "--final-frame=20", "--initial-clock=-1.5",
                                        "--final-clock=2", "--clock=0.25", "--cyclic", "--subset-start=3", "--subset-end=0.5",
                                        "--initial-clock=-2", "--final-frame", "7", "--start-row", "2"});
  CHECK(ignored.empty());
  CHECK(translate_povray_switches({"+SP32", "+EP4"}, ignored).empty());
  const std::vector<std::string> declared{"--declare", "Width=3", "--declare", "--declare"};   // a value is no switch
  CHECK(translate_povray_switches(declared, ignored) == declared);
  CHECK(ignored.size() == 2);
  for (const char* wrong : {"+SR", "+KFF", "+KX1", "+SF"}) CHECK_THROWS_AS(translate_povray_switches({wrong}, ignored), UsageError);
}

TEST_CASE("ffmpeg gets the frames by pattern, first number and count, in one argument each") {
  AnimationOptions options;
  options.final_frame = 120;
  options.frames_per_second = 12.5;
  const auto command = film_command(options, {"a.exr", "my 100% film.png"}, {7, 20}, "out.mp4");
  const auto after = [&](const std::string& name) { return *(std::find(command.begin(), command.end(), name) + 1); };
  CHECK(command.front() == "ffmpeg");
  CHECK(after("-i") == "my 100%% film%03d.png");
  CHECK(after("-start_number") == "7");
  CHECK(after("-frames:v") == "14");
  CHECK(after("-framerate") == "12.5");
  CHECK(command.back() == "out.mp4");
  CHECK_THROWS_AS(check_film("out.mp4", {"a.exr"}), UsageError);
  CHECK_THROWS_AS(check_film("/no/such/folder/out.mp4", {"a.png"}), UsageError);
}

TEST_CASE("of many shares that are missing some are named, and a share that makes no sense is none") {
  const std::string path = std::filesystem::temp_directory_path() / "nicol_share_test.exr";
  const auto missing = [&](const std::string& name) {
    Frame picture;
    picture.width = 2;
    picture.height = 1;
    picture.lambda_nm = {500};
    picture.weight_nm = {1};
    picture.stokes.assign(8, 1.0f);
    picture.cut_off.assign(2, 0.0f);
    picture.row_done = {1};
    const std::vector<float> wanted{1, 0};
    Frame frame = cut_out(picture, {0, 1}, wanted, 2, 1, 0, 1);
    PartNote part;
    part.whole.width = 2;
    part.whole.height = 1;
    part.whole.lambda_nm = {500};
    part.whole.weight_nm = {1};
    part.name = name;
    part.counted = {0, 0, 0, 0, 0};
    part.checksum = make_part(frame, wanted);
    for (auto& note : notes_of_part(part)) frame.how.push_back(std::move(note));
    make_exr_sink(path)->write(frame);
    const std::string told = engine::merge_parts({path}, false, "test").missing;
    std::filesystem::remove(path);
    return told;
  };
  CHECK(missing("share 2/3").find("(part 1/3, 3/3)") != std::string::npos);
  CHECK(missing("share 1/1000").find("20/1000, 21/1000 and 979 more)") != std::string::npos);
  for (const char* wrong : {"share 1/2000000000", "share 99999999999999999999/2", "share 3/2", "share -1/2"}) {
    const std::string told = missing(wrong);
    CHECK(!told.empty());
    CHECK(told.find("(part") == std::string::npos);
  }
}
