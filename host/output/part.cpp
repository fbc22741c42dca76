// See part.hpp.
#include "host/output/part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

#include "host/output/exr_source.hpp"
#include "host/output/sinks.hpp"

namespace nicol {
namespace {

constexpr const char* format = "1";  // of these notes

std::string number_text(double value) { return fmt::format("{:.17g}", value); }

template <class Values>
std::string list_text(const Values& values) {
  std::string text;
  for (const auto value : values) text += (text.empty() ? "" : " ") + number_text(static_cast<double>(value));
  return text;
}

// Finite numbers with one space between; false for anything else.
bool read_list(const std::string& text, std::vector<double>& values) {
  for (const char *at = text.data(), *end = at + text.size(); at < end; ++at) {
    double value = 0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value) || (next != end && *next != ' ')) return false;
    values.push_back(value);
    at = next;
  }
  return true;
}

class NoteReader {
 public:
  NoteReader(const std::string& path, const std::map<std::string, std::string>& notes) : path_(path), notes_(notes) {}

  const std::string& text(const std::string& key) const {
    const auto found = notes_.find(key);
    if (found == notes_.end()) cannot_read(path_, fmt::format("its header has no {}", key));
    return found->second;
  }
  std::vector<double> numbers(const std::string& key) const {
    std::vector<double> values;
    if (!read_list(text(key), values) || values.empty()) cannot_read(path_, fmt::format("{} in its header is damaged", key));
    return values;
  }

 private:
  const std::string& path_;
  const std::map<std::string, std::string>& notes_;
};

const std::string settings_prefix = "whole.same.";

}  // namespace

std::string difference(const WholePicture& one, const WholePicture& two) {
  if (one.width != two.width || one.height != two.height)
    return fmt::format("the sizes differ ({}x{}, {}x{})", one.width, one.height, two.width, two.height);
  if (one.lambda_nm != two.lambda_nm || one.weight_nm != two.weight_nm)
    return fmt::format("the wavelengths of the whole picture differ ({}; {} nm)", list_text(one.lambda_nm), list_text(two.lambda_nm));
  for (const auto& [name, value] : one.settings) {
    const auto other = two.settings.find(name);
    if (other == two.settings.end()) return fmt::format("only one tells its {}", name);
    if (other->second != value && name == "scene") return "the scenes differ (their text, what they include, or what is declared)";
    if (other->second != value) return fmt::format("the {} differs ({}, {})", name, value, other->second);
  }
  if (one.settings.size() != two.settings.size()) return "one tells more of its settings";
  if (one.exposure != two.exposure) return fmt::format("the exposure differs ({:g}, {:g})", one.exposure, two.exposure);
  if (one.shared_channels != two.shared_channels) return "only in one do wavelengths share their paths";
  return "";
}

Notes notes_of_whole(const WholePicture& whole) {
  Notes notes{{"whole.size", fmt::format("{} {}", whole.width, whole.height)},
              {"whole.lambda", list_text(whole.lambda_nm)},
              {"whole.weight", list_text(whole.weight_nm)},
              {"whole.channels", whole.shared_channels ? "shared" : "wavelengths"},
              {"whole.exposure", number_text(whole.exposure)}};
  for (const auto& [name, value] : whole.settings) notes.emplace_back(settings_prefix + name, value);
  return notes;
}

Notes notes_of_part(const PartNote& part) {
  Notes notes{{"part", part.name},
              {"part.format", format},
              {"part.checksum", part.checksum},
              {"part.device", part.device},
              {"part.seconds", number_text(part.seconds)},
              {"part.counted", list_text(part.counted)}};
  for (auto& note : notes_of_whole(part.whole)) notes.push_back(std::move(note));
  return notes;
}

WholePicture read_whole_note(const std::string& path, const std::map<std::string, std::string>& notes) {
  const NoteReader read(path, notes);
  WholePicture whole;
  const std::vector<double> size = read.numbers("whole.size");
  whole.lambda_nm = read.numbers("whole.lambda");
  whole.weight_nm = read.numbers("whole.weight");
  whole.shared_channels = read.text("whole.channels") == "shared";
  whole.exposure = read.numbers("whole.exposure").front();
  constexpr double most = 65536;
  const bool fits = size.size() == 2 && size[0] >= 1 && size[1] >= 1 && size[0] <= most && size[1] <= most &&
                    whole.weight_nm.size() == whole.lambda_nm.size() && whole.lambda_nm.front() > 0 &&
                    std::is_sorted(whole.lambda_nm.begin(), whole.lambda_nm.end()) &&
                    whole.lambda_nm.back() < 1e9;
  if (!fits) cannot_read(path, "what its header says of the whole picture is damaged");
  whole.width = static_cast<int>(size[0]);
  whole.height = static_cast<int>(size[1]);
  for (const auto& [key, value] : notes)
    if (key.rfind(settings_prefix, 0) == 0) whole.settings[key.substr(settings_prefix.size())] = value;
  return whole;
}

PartNote read_part_note(const std::string& path, const std::map<std::string, std::string>& notes) {
  if (notes.count("part.format") == 0)
    cannot_read(path, "it is not a part of a picture (a share i/n, a window, some of the wavelengths)");
  const NoteReader read(path, notes);
  if (read.text("part.format") != format) cannot_read(path, "it is a part as another version of nicol makes them");
  PartNote part;
  part.name = read.text("part");
  part.checksum = read.text("part.checksum");
  part.device = read.text("part.device");
  part.seconds = read.numbers("part.seconds").front();
  for (const double count : read.numbers("part.counted"))
    part.counted.push_back(count > 0 && count < 1e18 ? static_cast<std::uint64_t>(count) : 0);
  part.whole = read_whole_note(path, notes);
  return part;
}

std::vector<std::string> part_channels(const std::vector<double>& lambda_nm, bool with_channel_cut_off) {
  std::vector<std::string> names{"weight", "cutoff"};
  if (with_channel_cut_off)
    for (const double nm : lambda_nm) names.push_back(channel_name("cutoff", nm));
  for (const char* quantity : {"S0", "S1", "S2", "S3"})
    for (const double nm : lambda_nm) names.push_back(channel_name(quantity, nm));
  return names;
}

std::string make_part(Frame& frame, const std::vector<float>& rendered) {
  const std::size_t wavelengths = frame.lambda_nm.size(), plane = frame.plane();
  frame.planes.emplace_back("weight", rendered);
  const bool own_cut_off = !frame.channel_cut_off.empty();
  for (std::size_t w = 0; own_cut_off && w < wavelengths; ++w) {
    const auto first = frame.channel_cut_off.begin() + static_cast<std::ptrdiff_t>(w * plane);
    frame.planes.emplace_back(channel_name("cutoff", frame.lambda_nm[w]),
                              std::vector<float>(first, first + static_cast<std::ptrdiff_t>(plane)));
  }
  std::vector<const float*> planes{rendered.data(), frame.cut_off.data()};
  for (std::size_t w = 0; own_cut_off && w < wavelengths; ++w) planes.push_back(frame.channel_cut_off.data() + w * plane);
  for (int s = 0; s < 4; ++s)
    for (std::size_t w = 0; w < wavelengths; ++w) planes.push_back(frame.component(s, w));
  Checksum checksum;
  const auto width = static_cast<std::size_t>(frame.width);
  for (std::size_t at = 0; at < plane; at += width)
    for (const float* values : planes) checksum.add(values + at, width);
  return checksum.text();
}

void Checksum::add(const float* values, std::size_t count) {
  constexpr std::uint64_t prime = 0x100000001b3u;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, values + i, sizeof bits);
    sum_ = (sum_ ^ bits) * prime;
  }
}

std::string Checksum::text() const { return fmt::format("{:016x}", sum_); }

Frame cut_out(const Frame& rendered, const std::vector<std::int32_t>& pixels, const std::vector<float>& wanted, int width, int height,
              std::size_t first, std::size_t count) {
  Frame frame;
  frame.width = width;
  frame.height = height;
  const auto from = static_cast<std::ptrdiff_t>(first), to = static_cast<std::ptrdiff_t>(first + count);
  frame.lambda_nm.assign(rendered.lambda_nm.begin() + from, rendered.lambda_nm.begin() + to);
  frame.weight_nm.assign(rendered.weight_nm.begin() + from, rendered.weight_nm.begin() + to);
  frame.exposure = rendered.exposure;
  frame.how = rendered.how;
  frame.rows_done = height;
  frame.row_done.assign(static_cast<std::size_t>(height), 1);
  frame.stokes.resize(frame.plane() * 4 * count);
  frame.cut_off.resize(frame.plane());
  const bool own_cut_off = !rendered.channel_cut_off.empty();
  if (own_cut_off) frame.channel_cut_off.resize(frame.plane() * count);
  const auto spread = [&](const float* values, float* picture) {
    for (std::size_t i = 0; i < pixels.size(); ++i)
      if (wanted[static_cast<std::size_t>(pixels[i])] != 0) picture[pixels[i]] = values[i];
  };
  spread(rendered.cut_off.data(), frame.cut_off.data());
  for (std::size_t w = 0; w < count; ++w) {
    for (int s = 0; s < 4; ++s) spread(rendered.component(s, first + w), frame.component(s, w));
    if (own_cut_off)
      spread(rendered.channel_cut_off.data() + (first + w) * rendered.plane(), frame.channel_cut_off.data() + w * frame.plane());
  }
  return frame;
}

std::vector<std::int32_t> dealt_pixels(int width, int height, int i, int n) {
  const std::int64_t plane = static_cast<std::int64_t>(width) * height;
  std::vector<std::int32_t> pixels;
  for (std::int64_t round = 0; round * n * deal_run < plane; ++round) {
    // splitmix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014)
    std::uint64_t random = static_cast<std::uint64_t>(round) * 0x9e3779b97f4a7c15u;
    random = (random ^ (random >> 30)) * 0xbf58476d1ce4e5b9u;
    random = (random ^ (random >> 27)) * 0x94d049bb133111ebu;
    // The last round may hold fewer runs than shares.
    const std::int64_t runs = (plane + deal_run - 1) / deal_run, here = std::min<std::int64_t>(n, runs - round * n);
    const auto turn = static_cast<std::int64_t>((random ^ (random >> 31)) % static_cast<std::uint64_t>(here));
    if (i > here) break;
    const std::int64_t first = (round * n + (i - 1 + turn) % here) * deal_run;
    for (std::int64_t p = first; p < std::min(plane, first + deal_run); ++p) pixels.push_back(static_cast<std::int32_t>(p));
  }
  return pixels;
}

}  // namespace nicol
