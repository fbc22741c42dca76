// Parts of a picture: files that several machines render and that merge.hpp joins to the bits of one run. A part is a picture of
// full size, zero where it was not rendered, with a channel `weight` (1 or 0) and, in its header, which whole it belongs to.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "host/output/frame.hpp"

namespace nicol {

using Notes = std::vector<std::pair<std::string, std::string>>;

// What all parts of a picture have in common.
struct WholePicture {
  int width = 0, height = 0;
  std::vector<double> lambda_nm, weight_nm;
  bool shared_channels = false;  // every wavelength comes from the same paths: `cutoff` of a part is that of the whole
  double exposure = 1;
  // What else decides the bits, by what it is called in messages: "scene", "samples", "precision", ...
  std::map<std::string, std::string> settings;
};

// "" if they are the same picture, else what differs: "the samples differ (4, 16)".
std::string difference(const WholePicture& one, const WholePicture& two);

struct PartNote {
  WholePicture whole;
  std::string name;      // "share 2/3", "rows 1..20", "450..550 nm"
  std::string checksum;  // of the pixels
  std::string device;
  double seconds = 0;
  std::vector<std::uint64_t> counted;  // on the device: not a number, energy, stack, Stokes, precise solver
};

Notes notes_of_part(const PartNote& part);

// Which picture it is: for the header of a whole one, and among the notes of a part.
Notes notes_of_whole(const WholePicture& whole);

// From the notes of a file. Throws InputError where they are not there, or damaged.
WholePicture read_whole_note(const std::string& path, const std::map<std::string, std::string>& notes);

// From the notes of a file. Throws InputError where the file is no part of a picture.
PartNote read_part_note(const std::string& path, const std::map<std::string, std::string>& notes);

// The channels of a part's file beside its colours, in the order of its checksum.
std::vector<std::string> part_channels(const std::vector<double>& lambda_nm, bool with_channel_cut_off);

// The picture with its channels `weight` and, where there are any, the cut-offs of its wavelengths, and their checksum.
// rendered: 1 or 0 for each pixel.
std::string make_part(Frame& frame, const std::vector<float>& rendered);

// Of rows of floats, one after the other.
class Checksum {
 public:
  void add(const float* values, std::size_t count);
  std::string text() const;

 private:
  std::uint64_t sum_ = 0xcbf29ce484222325u;  // FNV-1a
};

// What is wanted of a rendered frame, as a picture of full size, zero elsewhere. pixels[i] of the picture is pixel i of the frame, if it is
// wanted (1, else 0); of the wavelengths, `count` from `first` on.
Frame cut_out(const Frame& rendered, const std::vector<std::int32_t>& pixels, const std::vector<float>& wanted, int width, int height,
              std::size_t first, std::size_t count);

// The share i of n (1 <= i <= n) of a picture's pixels, ascending: runs of deal_run pixels (row after row, over their ends) are dealt, to each share
// one out of n that follow one another, in an order that turns at random: shares lie all over the picture and cost about alike. They
// differ by at most one run. Empty where n is more than there are runs.
inline constexpr int deal_run = 64;  // a multiple of all numbers of lanes: no share cuts what lanes hold together
std::vector<std::int32_t> dealt_pixels(int width, int height, int i, int n);

}  // namespace nicol
