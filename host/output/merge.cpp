// See merge.hpp.
#include "host/output/merge.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "host/output/exr_source.hpp"
#include "host/output/sinks.hpp"

namespace nicol {
namespace {

constexpr int rows_at_once = 32;  // of a packed block of an EXR
constexpr const char* stokes_names[] = {"S0", "S1", "S2", "S3"};

bool same_bits(float a, float b) { return std::memcmp(&a, &b, sizeof a) == 0; }

}  // namespace

void Merger::begin(const PartNote& part) {
  const WholePicture& whole = part.whole;
  frame_.width = whole.width;
  frame_.height = whole.height;
  frame_.lambda_nm = whole.lambda_nm;
  frame_.weight_nm = whole.weight_nm;
  frame_.exposure = whole.exposure;
  frame_.rows_done = whole.height;
  frame_.row_done.assign(static_cast<std::size_t>(whole.height), 1);
  frame_.stokes.resize(4 * whole.lambda_nm.size() * frame_.plane());
  frame_.cut_off.resize(frame_.plane());
  owners_.resize(whole.lambda_nm.size() * frame_.plane());
  cut_off_owners_.resize(frame_.plane());
}

void Merger::check_same(const PartNote& part, const std::string& path) {
  if (parts_.empty()) return;
  const std::string differs = difference(parts_.front().whole, part.whole);
  if (!differs.empty())
    throw InputError(fmt::format("{} and {} are parts of different pictures: {}", paths_.front(), path, differs));
  if (part.device != parts_.front().device)
    warnings_.push_back(fmt::format("{} was rendered on {}, {} on {}: their last bits may differ", paths_.front(),
                                    parts_.front().device, path, part.device));
}

std::vector<std::size_t> Merger::wavelengths_in(const ExrSource& source) const {
  std::vector<std::size_t> found;
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w)
    if (source.has_channel(channel_name("S0", frame_.lambda_nm[w]))) found.push_back(w);
  if (found.empty()) cannot_read(source.path(), "it has no channel of a wavelength");
  return found;
}

void Merger::add(const std::string& path) {
  if (paths_.size() + 1 >= std::numeric_limits<Owner>::max()) throw InputError("too many parts");
  ExrSource source(path);
  const PartNote part = read_part_note(path, source.notes());
  if (part.whole.width != source.width() || part.whole.height != source.height())
    cannot_read(path, "its size is not that in its header");
  check_same(part, path);
  if (parts_.empty()) {
    begin(part);
    notes_ = source.notes();
  }
  paths_.push_back(path);
  parts_.push_back(part);

  const std::vector<std::size_t> wavelengths = wavelengths_in(source);
  std::vector<double> lambda_nm;
  for (const std::size_t w : wavelengths) lambda_nm.push_back(frame_.lambda_nm[w]);
  const bool own_cut_off = source.has_channel(channel_name("cutoff", lambda_nm.front()));
  if (!own_cut_off && !part.whole.shared_channels && wavelengths.size() < frame_.lambda_nm.size())
    cannot_read(path, "it has no cut-offs of its wavelengths");
  if (own_cut_off) {
    channel_cut_off_.resize(owners_.size());
    channel_owners_.resize(owners_.size());
  }
  const std::vector<std::string> names = part_channels(lambda_nm, own_cut_off);
  const std::size_t width = static_cast<std::size_t>(frame_.width), block = rows_at_once * width;
  std::vector<float> values(names.size() * block);
  std::vector<std::pair<std::string, float*>> channels;
  for (std::size_t i = 0; i < names.size(); ++i) channels.emplace_back(names[i], values.data() + i * block);
  Checksum checksum;
  std::vector<const float*> planes(names.size());
  for (int first = 0; first < frame_.height; first += rows_at_once) {
    const int count = std::min(rows_at_once, frame_.height - first);
    source.read_rows(first, count, channels);
    for (int y = 0; y < count; ++y) {
      for (std::size_t i = 0; i < planes.size(); ++i) {
        planes[i] = channels[i].second + static_cast<std::size_t>(y) * width;
        checksum.add(planes[i], width);
      }
      take_row(first + y, wavelengths, own_cut_off, planes);
    }
  }
  if (checksum.text() != part.checksum) cannot_read(path, "its pixels are damaged (their checksum is another)");
}

// planes: as part_channels() names them.
void Merger::take_row(int y, const std::vector<std::size_t>& wavelengths, bool own_cut_off,
                      const std::vector<const float*>& planes) {
  const std::size_t width = static_cast<std::size_t>(frame_.width), plane = frame_.plane(), count = wavelengths.size();
  const float* weight = planes[0];
  for (std::size_t x = 0; x < width;) {
    const auto begin = x;
    const float here = weight[x];
    while (x < width && same_bits(weight[x], here)) ++x;
    if (here == 0) continue;
    if (here != 1) cannot_read(paths_.back(), fmt::format("its weight at column {}, row {} is neither 0 nor 1", begin + 1, y + 1));
    const std::size_t first = static_cast<std::size_t>(y) * width + begin, run = x - begin;
    if (!own_cut_off) {
      take_run(first, run, planes[1] + begin, frame_.cut_off.data(), cut_off_owners_.data(), "the cut-off");
      own(first, run, cut_off_owners_.data());
    }
    const std::size_t stokes_at = own_cut_off ? 2 + count : 2;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t w = wavelengths[i];
      Owner* owners = owners_.data() + w * plane;
      for (int s = 0; s < 4; ++s)
        take_run(first, run, planes[stokes_at + static_cast<std::size_t>(s) * count + i] + begin, frame_.component(s, w), owners,
                 stokes_names[s], frame_.lambda_nm[w]);
      own(first, run, owners);
      if (!own_cut_off) continue;
      Owner* cut_off_owners = channel_owners_.data() + w * plane;
      take_run(first, run, planes[2 + i] + begin, channel_cut_off_.data() + w * plane, cut_off_owners, "the cut-off", frame_.lambda_nm[w]);
      own(first, run, cut_off_owners);
    }
  }
}

void Merger::take_run(std::size_t first, std::size_t count, const float* from, float* to, const Owner* owners, const char* what,
                      double lambda_nm) {
  for (std::size_t i = 0, p = first; i < count; ++i, ++p) {
    if (owners[p] != 0 && !same_bits(to[p], from[i])) {
      const std::size_t width = static_cast<std::size_t>(frame_.width);
      throw InputError(fmt::format("{} and {} overlap and differ: {}{} at column {}, row {} is {:.9g} and {:.9g}", paths_[owners[p] - 1u],
                                   paths_.back(), what, lambda_nm > 0 ? fmt::format(" at {:g} nm", lambda_nm) : "", p % width + 1,
                                   p / width + 1, to[p], from[i]));
    }
    to[p] = from[i];
  }
}

void Merger::own(std::size_t first, std::size_t count, Owner* owners) const {
  const auto mine = static_cast<Owner>(paths_.size());
  std::replace(owners + first, owners + first + count, Owner{0}, mine);
}

bool Merger::has(std::size_t pixel, const std::vector<std::size_t>& wavelengths) const {
  return std::all_of(wavelengths.begin(), wavelengths.end(), [&](std::size_t w) { return owners_[w * frame_.plane() + pixel] != 0; });
}

// Where no part has the mean over all wavelengths: as it is formed where all are traced together (Gather::scatter_run).
void Merger::join_cut_offs(const std::vector<std::size_t>& wavelengths) {
  if (channel_cut_off_.empty()) return;
  for (std::size_t p = 0; p < frame_.plane(); ++p) {
    if (cut_off_owners_[p] != 0 || !has(p, wavelengths)) continue;
    double sum = 0;
    for (const std::size_t w : wavelengths) sum += static_cast<double>(channel_cut_off_[w * frame_.plane() + p]);
    frame_.cut_off[p] = static_cast<float>(sum / static_cast<double>(wavelengths.size()));
  }
}

std::vector<std::size_t> Merger::present_wavelengths() const {
  std::vector<std::size_t> found;
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w) {
    const auto first = owners_.begin() + static_cast<std::ptrdiff_t>(w * frame_.plane());
    if (std::any_of(first, first + static_cast<std::ptrdiff_t>(frame_.plane()), [](Owner o) { return o != 0; })) found.push_back(w);
  }
  return found;
}

// The pixels that lack one of these wavelengths.
std::string Merger::missing_pixels(const std::vector<std::size_t>& wavelengths) const {
  constexpr int most_told = 4;
  const auto width = static_cast<std::size_t>(frame_.width);
  const auto lacks = [&](std::size_t pixel) { return !has(pixel, wavelengths); };
  std::size_t pixels = 0;
  int runs = 0;
  std::string text;
  for (std::size_t p = 0; p < frame_.plane();) {
    const std::size_t first = p, row_end = (p / width + 1) * width;
    while (p < row_end && lacks(p)) ++p;
    pixels += p - first;
    if (p > first && ++runs <= most_told)
      text += fmt::format("{}row {} columns {}..{}", text.empty() ? "" : ", ", first / width + 1, first % width + 1, (p - 1) % width + 1);
    if (p < row_end) ++p;
  }
  if (pixels == 0) return "";
  return fmt::format("{} of {} pixels ({}{})", pixels, frame_.plane(), text, runs > most_told ? ", ..." : "");
}

std::string Merger::missing() const {
  const std::vector<std::size_t> present = present_wavelengths();
  std::string text, lacking;
  for (std::size_t w = 0; w < frame_.lambda_nm.size(); ++w)
    if (!std::binary_search(present.begin(), present.end(), w))
      lacking += fmt::format("{}{:g}", lacking.empty() ? "" : ", ", frame_.lambda_nm[w]);
  if (!lacking.empty()) text = "the wavelengths " + lacking + " nm";
  const std::string pixels = missing_pixels(present);
  if (!pixels.empty()) text += (text.empty() ? "" : "; ") + pixels;
  return text;
}

void Merger::drop_other_wavelengths(const std::vector<std::size_t>& kept) {
  Frame small;
  small.width = frame_.width;
  small.height = frame_.height;
  for (const std::size_t w : kept) {
    small.lambda_nm.push_back(frame_.lambda_nm[w]);
    small.weight_nm.push_back(frame_.weight_nm[w]);
  }
  small.stokes.resize(4 * kept.size() * frame_.plane());
  for (int s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < kept.size(); ++i) std::copy_n(frame_.component(s, kept[i]), frame_.plane(), small.component(s, i));
  if (!channel_cut_off_.empty())
    for (const std::size_t w : kept) {
      const auto first = channel_cut_off_.begin() + static_cast<std::ptrdiff_t>(w * frame_.plane());
      small.channel_cut_off.insert(small.channel_cut_off.end(), first, first + static_cast<std::ptrdiff_t>(frame_.plane()));
    }
  frame_.lambda_nm = std::move(small.lambda_nm);
  frame_.weight_nm = std::move(small.weight_nm);
  frame_.stokes = std::move(small.stokes);
  frame_.channel_cut_off = std::move(small.channel_cut_off);
}

// Adds the channel `weight`, and the notes of a part if all pixels have all that is there or nothing.
void Merger::weigh(const std::vector<std::size_t>& present) {
  std::vector<float> weight(frame_.plane());
  bool all_or_nothing = true;
  for (std::size_t p = 0; p < weight.size(); ++p) {
    const auto have = std::count_if(present.begin(), present.end(), [&](std::size_t w) { return owners_[w * frame_.plane() + p] != 0; });
    weight[p] = static_cast<float>(have) / static_cast<float>(present.size());
    all_or_nothing &= weight[p] == 0 || weight[p] == 1;
  }
  if (present.size() < frame_.lambda_nm.size()) drop_other_wavelengths(present);
  PartNote part = parts_.front();
  part.checksum = make_part(frame_, weight);
  if (!all_or_nothing) return;
  for (std::size_t i = 1; i < parts_.size(); ++i) {
    part.name += " + " + parts_[i].name;
    part.seconds += parts_[i].seconds;
    for (std::size_t k = 0; k < std::min(part.counted.size(), parts_[i].counted.size()); ++k) part.counted[k] += parts_[i].counted[k];
  }
  for (auto& note : notes_of_part(part)) frame_.how.push_back(std::move(note));
}

Frame Merger::take() {
  const std::vector<std::size_t> present = present_wavelengths();
  join_cut_offs(present);
  if (!missing().empty()) weigh(present);
  return std::move(frame_);
}

}  // namespace nicol
