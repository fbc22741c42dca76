// The picture of the tests of output.
#include "tests/output/pattern.hpp"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "host/optics/colour.hpp"

namespace nicol {
namespace {

Frame empty_frame(int width, int height, std::vector<double> lambda_nm) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  frame.weight_nm = wavelength_weights(lambda_nm);
  frame.lambda_nm = std::move(lambda_nm);
  frame.stokes.resize(4 * frame.lambda_nm.size() * frame.plane());
  frame.cut_off.resize(frame.plane());
  frame.row_done.assign(static_cast<std::size_t>(height), 1);
  frame.rows_done = height;
  frame.how = {{"scene", "scenes/a b.pov"},
               {"device", "Prozessor f\xC3\xBCr Versuche"},
               {"settings", "width 7"}};
  return frame;
}

}  // namespace

float pattern_value(int s, std::size_t i, int x, int y) {
  return static_cast<float>(64 * s) + 8 * static_cast<float>(i) + static_cast<float>(x) / 16 +
         static_cast<float>(y) / 256;
}

Frame pattern_frame(int width, int height) {
  Frame frame = empty_frame(width, height, {400, 580, 633.2});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto pixel = static_cast<std::size_t>(y) * width + x;
      for (int s = 0; s < 4; ++s)
        for (std::size_t i = 0; i < 3; ++i)
          frame.component(s, i)[pixel] = pattern_value(s, i, x, y);
      frame.cut_off[pixel] = static_cast<float>(x) + static_cast<float>(y) / 8;
    }
  return frame;
}

Frame colour_frame(int width, int height, const std::vector<float>& rgb) {
  std::vector<double> lambda_nm;
  for (int l = 380; l <= 780; l += 5) lambda_nm.push_back(l);
  Frame frame = empty_frame(width, height, lambda_nm);
  std::vector<std::vector<double>> primaries;
  for (int k = 0; k < 3; ++k) {
    SpectrumFormula primary;
    primary.kind = SpectrumFormula::Kind::rgb;
    primary.numbers = {k == 0 ? 1.0 : 0.0, k == 1 ? 1.0 : 0.0, k == 2 ? 1.0 : 0.0};
    std::string error;
    primaries.push_back(sample_spectrum(primary, frame.lambda_nm, frame.weight_nm, error));
  }
  for (std::size_t pixel = 0; pixel < frame.plane(); ++pixel)
    for (std::size_t i = 0; i < lambda_nm.size(); ++i) {
      double radiance = 0;
      for (std::size_t k = 0; k < 3; ++k)
        radiance += static_cast<double>(rgb[3 * pixel + k]) * primaries[k][i];
      frame.component(0, i)[pixel] = static_cast<float>(radiance);
    }
  return frame;
}

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "nicol-output-XXXXXX").string();
  if (!::mkdtemp(name.data())) throw std::runtime_error("no temporary folder");
  path_ = name;
}

int TemporaryFolder::entries() const {
  const std::filesystem::directory_iterator first(path_), last;
  return static_cast<int>(std::distance(first, last));
}

std::string contents(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace nicol
