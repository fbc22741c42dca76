// EXR as the OpenEXR library reads it back: channels, values, attributes.
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfInputFile.h>
#include <ImfStandardAttributes.h>
#include <ImfStringAttribute.h>
#include <doctest/doctest.h>

#include "host/output/sinks.hpp"
#include "tests/output/pattern.hpp"

using namespace nicol;

namespace {

std::vector<float> read_channel(Imf::InputFile& file, const std::string& name, int width,
                                int height) {
  std::vector<float> values(static_cast<std::size_t>(width) * height, -1);
  Imf::FrameBuffer pixels;
  const std::size_t row_bytes = static_cast<std::size_t>(width) * sizeof(float);
  pixels.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                 row_bytes));
  file.setFrameBuffer(pixels);
  file.readPixels(0, height - 1);
  return values;
}

std::string attribute(const Imf::InputFile& file, const char* name) {
  const auto* found = file.header().findTypedAttribute<Imf::StringAttribute>(name);
  return found ? found->value() : "(none)";
}

}  // namespace

TEST_CASE("every value of an EXR comes back in its place, packed or not") {
  const TemporaryFolder folder;
  const int width = 37, height = 70;  // more than two blocks of 32 rows
  const Frame frame = pattern_frame(width, height);
  const char* names[4][3] = {{"S0.400,000000nm", "S0.580,000000nm", "S0.633,200000nm"},
                             {"S1.400,000000nm", "S1.580,000000nm", "S1.633,200000nm"},
                             {"S2.400,000000nm", "S2.580,000000nm", "S2.633,200000nm"},
                             {"S3.400,000000nm", "S3.580,000000nm", "S3.633,200000nm"}};
  for (const auto packing : {ExrPacking::piz, ExrPacking::none}) {
    make_exr_sink(folder.file("a.exr"), packing)->write(frame);
    Imf::InputFile file(folder.file("a.exr").c_str());
    int wrong = 0;
    for (int s = 0; s < 4; ++s)
      for (std::size_t i = 0; i < 3; ++i) {
        REQUIRE(file.header().channels().findChannel(names[s][i]));
        CHECK(file.header().channels().findChannel(names[s][i])->type == Imf::FLOAT);
        const auto values = read_channel(file, names[s][i], width, height);
        for (std::size_t p = 0; p < values.size(); ++p)
          wrong += values[p] !=
                   pattern_value(s, i, static_cast<int>(p % width), static_cast<int>(p / width));
      }
    CHECK(wrong == 0);
    CHECK(read_channel(file, "cutoff", width, height) == frame.cut_off);
    const auto rgb = linear_rgb(frame);
    const auto green = read_channel(file, "G", width, height);
    for (std::size_t p = 0; p < green.size(); ++p) wrong += green[p] != rgb[3 * p + 1];
    CHECK(wrong == 0);
  }
}

TEST_CASE("an EXR says what it is and how it was made") {
  const TemporaryFolder folder;
  make_sink(folder.file("a.EXR"))->write(pattern_frame(4, 3));
  const Imf::InputFile file(folder.file("a.EXR").c_str());
  CHECK(attribute(file, "spectralLayoutVersion") == "1.0");
  CHECK(attribute(file, "emissiveUnits") == "W.m^-2.sr^-1");
  CHECK(attribute(file, "polarisationHandedness") == "right");
  CHECK(attribute(file, "nicol:scene") == "scenes/a b.pov");
  CHECK(attribute(file, "nicol:partial") == "(none)");
  REQUIRE(Imf::hasChromaticities(file.header()));
  CHECK(Imf::chromaticities(file.header()).red == Imath::V2f(0.64f, 0.33f));
  CHECK(Imf::chromaticities(file.header()).white == Imath::V2f(0.3127f, 0.3290f));
}

TEST_CASE("an interrupted picture says how much of it is there") {
  const TemporaryFolder folder;
  Frame frame = pattern_frame(4, 3);
  frame.row_done = {1, 0, 1};
  make_sink(folder.file("a.exr"))->write(frame);
  CHECK(attribute(Imf::InputFile(folder.file("a.exr").c_str()), "nicol:partial") == "2 of 3 rows");
}

TEST_CASE("exposure acts on the colours and not on the Stokes vectors") {
  Frame frame = pattern_frame(4, 3);
  const auto once = linear_rgb(frame);
  frame.exposure = 2;
  const auto twice = linear_rgb(frame);
  for (std::size_t i = 0; i < once.size(); ++i)
    CHECK(twice[i] == doctest::Approx(2 * once[i]).epsilon(1e-6));
}
