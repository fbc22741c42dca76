// File: magic with version, length of the identity, identity, checksum of all before; then records of a head
// (with its own checksum) and a payload. Numbers as the machine keeps them. Checksums: CRC-32 of zlib.
#include "host/output/journal.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string_view>
#include <vector>

namespace nicol {
namespace {

constexpr std::string_view family = "nicol tiles ";  // what a file must begin with to be overwritten
constexpr std::string_view magic = "nicol tiles 1\n";
constexpr std::uint32_t record_mark = 0x454c4954;    // "TILE"

struct RecordHead {
  std::uint32_t mark = record_mark;
  std::int32_t pass = 0, sample_begin = 0, sample_end = 0;
  std::int64_t first_unit = 0, unit_count = 0;
  std::uint64_t size = 0;
  std::uint32_t payload_sum = 0, head_sum = 0;
};
static_assert(sizeof(RecordHead) == 48, "no padding: all bytes are written");

std::uint32_t checksum(const void* bytes, std::size_t size, std::uint32_t before = 0) {
  return static_cast<std::uint32_t>(crc32_z(before, static_cast<const Bytef*>(bytes), size));
}

std::uint32_t sum_of(const RecordHead& head) { return checksum(&head, offsetof(RecordHead, head_sum)); }

// False at the end of the file and on errors.
bool read_at(int descriptor, void* to, std::size_t size, std::uint64_t at) {
  char* bytes = static_cast<char*>(to);
  while (size > 0) {
    const ssize_t got = ::pread(descriptor, bytes, size, static_cast<off_t>(at));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    bytes += got;
    at += static_cast<std::uint64_t>(got);
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

// 0, or errno.
int write_at(int descriptor, const void* from, std::size_t size, std::uint64_t at) {
  const char* bytes = static_cast<const char*>(from);
  while (size > 0) {
    const ssize_t written = ::pwrite(descriptor, bytes, size, static_cast<off_t>(at));
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return errno;
    bytes += written;
    at += static_cast<std::uint64_t>(written);
    size -= static_cast<std::size_t>(written);
  }
  return 0;
}

std::uint64_t file_size(int descriptor) {
  struct stat status {};
  return ::fstat(descriptor, &status) == 0 ? static_cast<std::uint64_t>(status.st_size) : 0;
}

bool payload_is_whole(int descriptor, const RecordHead& head, std::uint64_t at) {
  std::vector<char> block(static_cast<std::size_t>(std::min<std::uint64_t>(head.size, 1 << 20)));
  std::uint32_t sum = 0;
  for (std::uint64_t done = 0; done < head.size;) {
    const auto part = static_cast<std::size_t>(std::min<std::uint64_t>(block.size(), head.size - done));
    if (!read_at(descriptor, block.data(), part, at + done)) return false;
    sum = checksum(block.data(), part, sum);
    done += part;
  }
  return sum == head.payload_sum;
}

bool is_sensible(const RecordHead& head) {
  constexpr std::int64_t most = std::int64_t{1} << 62;
  return head.unit_count > 0 && head.unit_count < most && head.first_unit >= 0 && head.first_unit < most &&
         head.size % static_cast<std::uint64_t>(head.unit_count) == 0;
}

std::string file_head(const std::string& identity) {
  std::string head{magic};
  const std::uint64_t size = identity.size();
  head.append(reinterpret_cast<const char*>(&size), sizeof size);
  head += identity;
  const std::uint32_t sum = checksum(head.data(), head.size());
  head.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return head;
}

}  // namespace

// "", or why no file can be kept. A file that its last owner removed between open and lock is opened again.
std::string Journal::open_locked() {
  for (;;) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NONBLOCK, 0666);
    if (descriptor_ < 0) return std::strerror(errno);
    struct stat opened {}, named {};
    if (::fstat(descriptor_, &opened) != 0 || !S_ISREG(opened.st_mode)) return "it is not an ordinary file";
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0)
      return errno == EWOULDBLOCK ? "another nicol is rendering this picture" : std::strerror(errno);
    if (::stat(path_.c_str(), &named) == 0 && named.st_ino == opened.st_ino && named.st_dev == opened.st_dev) break;
    ::close(descriptor_);
  }
  std::string first(std::min<std::uint64_t>(family.size(), file_size(descriptor_)), '\0');
  const bool ours = read_at(descriptor_, first.data(), first.size(), 0) && family.substr(0, first.size()) == first;
  return ours ? "" : "it is a file that nicol did not make; move it away";
}

std::unique_ptr<Journal> Journal::open(const std::string& path, const std::string& identity, bool resume,
                                       std::string& note) {
  std::unique_ptr<Journal> journal(new Journal(path));
  const std::string obstacle = journal->open_locked();
  if (!obstacle.empty()) {
    if (journal->descriptor_ >= 0) ::close(journal->descriptor_);
    journal->descriptor_ = -1;
    journal->stop(obstacle);
    note = journal->note_;
    return journal;
  }
  journal->recording_ = true;
  note = resume ? journal->take_up(identity) : "";
  if (journal->end_ == 0) journal->begin(identity);
  if (!journal->note_.empty()) note = journal->note_;
  return journal;
}

// Leaves end_ 0 where nothing can be taken up; tells why, or what was dropped.
std::string Journal::take_up(const std::string& identity) {
  const std::uint64_t size = file_size(descriptor_);
  if (size == 0) return "there are no tiles in " + path_ + " to go on from: the picture begins anew";
  const std::string expected = file_head(identity);
  std::string found(static_cast<std::size_t>(std::min<std::uint64_t>(expected.size(), size)), '\0');
  if (!read_at(descriptor_, found.data(), found.size(), 0)) found.clear();
  if (found != expected) {
    const bool whole = found.size() >= magic.size();
    const std::string why = whole && found.compare(0, magic.size(), magic) != 0 ? "by another version of nicol"
                            : whole ? "for another picture (scene, settings, kernel or device differ), or are damaged"
                                    : "only in part";
    return "the tiles in " + path_ + " were written " + why + ": the picture begins anew";
  }
  const bool whole = read_records(expected.size(), size);
  if (end_ < size && ::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) stop(std::strerror(errno));
  return whole ? "" : "some tiles in " + path_ + " are cut short or damaged: they are rendered again";
}

// Brings end_ behind the last record with a good head and all of its payload. A damaged payload is passed over.
// True if all was good.
bool Journal::read_records(std::uint64_t at, std::uint64_t end) {
  bool whole = true;
  RecordHead head;
  while (end - at >= sizeof head && read_at(descriptor_, &head, sizeof head, at)) {
    const std::uint64_t payload = at + sizeof head;
    if (head.mark != record_mark || head.head_sum != sum_of(head) || head.size > end - payload) break;
    const bool good = is_sensible(head) && payload_is_whole(descriptor_, head, payload);
    if (good)
      enter({head.pass, head.first_unit, head.unit_count, head.sample_begin, head.sample_end}, payload, head.size);
    whole &= good;
    at = payload + head.size;
  }
  end_ = at;
  return whole && at == end;
}

void Journal::begin(const std::string& identity) {
  const std::string head = file_head(identity);
  int failed = ::ftruncate(descriptor_, 0) != 0 ? errno : 0;
  if (failed == 0) failed = write_at(descriptor_, head.data(), head.size(), 0);
  end_ = head.size();
  if (failed != 0) stop(std::strerror(failed));
}

Journal::~Journal() {
  if (descriptor_ < 0) return;
  if (index_.empty()) remove();
  else ::close(descriptor_);
}

void Journal::remove() {
  if (descriptor_ < 0) return;
  ::unlink(path_.c_str());
  ::close(descriptor_);
  descriptor_ = -1;
  recording_ = false;
  index_.clear();
}

void Journal::stop(const std::string& reason) {
  recording_ = false;
  note_ = "finished tiles are not kept: cannot write " + path_ + ": " + reason;
}

// Only what no piece holds yet: a tile launched again has the same bytes.
void Journal::enter(const TileKey& tile, std::uint64_t offset, std::uint64_t size) {
  Pieces& pieces = index_[{tile.pass, tile.sample_begin, tile.sample_end}];
  const std::uint64_t bytes_per_unit = size / static_cast<std::uint64_t>(tile.unit_count);
  const std::int64_t end = tile.first_unit + tile.unit_count;
  for (std::int64_t unit = tile.first_unit; unit < end;) {
    auto after = pieces.upper_bound(unit);
    if (after != pieces.begin()) {
      const auto& [first, piece] = *std::prev(after);
      if (first + piece.unit_count > unit) {
        unit = first + piece.unit_count;
        continue;
      }
    }
    const std::int64_t piece_end = after == pieces.end() ? end : std::min(end, after->first);
    pieces.emplace_hint(after, unit,
                        Piece{piece_end - unit, offset + static_cast<std::uint64_t>(unit - tile.first_unit) * bytes_per_unit,
                              bytes_per_unit});
    unit = piece_end;
  }
}

void Journal::add(const TileKey& tile, const void* bytes, std::size_t size) {
  if (!recording_) return;
  RecordHead head;
  head.pass = tile.pass;
  head.sample_begin = tile.sample_begin;
  head.sample_end = tile.sample_end;
  head.first_unit = tile.first_unit;
  head.unit_count = tile.unit_count;
  head.size = size;
  if (!is_sensible(head)) return;
  head.payload_sum = checksum(bytes, size);
  head.head_sum = sum_of(head);
  int failed = write_at(descriptor_, &head, sizeof head, end_);
  if (failed == 0) failed = write_at(descriptor_, bytes, size, end_ + sizeof head);
  if (failed != 0) {
    stop(std::strerror(failed));
    if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) note_ += ", nor can its end be cut off";
    return;
  }
  enter(tile, end_ + sizeof head, size);
  end_ += sizeof head + size;
}

std::int64_t Journal::covered_units(int pass, std::int64_t from_unit, int sample_begin, int sample_end) const {
  const auto pieces = index_.find({pass, sample_begin, sample_end});
  if (pieces == index_.end()) return 0;
  auto piece = pieces->second.upper_bound(from_unit);
  std::int64_t unit = from_unit;
  if (piece != pieces->second.begin()) --piece;
  for (; piece != pieces->second.end() && piece->first <= unit; ++piece)
    unit = std::max(unit, piece->first + piece->second.unit_count);
  return unit - from_unit;
}

std::int64_t Journal::missing_units(int pass, std::int64_t from_unit, int sample_begin, int sample_end) const {
  if (covered_units(pass, from_unit, sample_begin, sample_end) > 0) return 0;
  const auto pieces = index_.find({pass, sample_begin, sample_end});
  const auto next = pieces == index_.end() ? Pieces::const_iterator{} : pieces->second.lower_bound(from_unit);
  if (pieces == index_.end() || next == pieces->second.end()) return std::numeric_limits<std::int64_t>::max();
  return next->first - from_unit;
}

bool Journal::find(const TileKey& tile, std::size_t bytes_per_unit, void* bytes) const {
  if (tile.unit_count <= 0 ||
      covered_units(tile.pass, tile.first_unit, tile.sample_begin, tile.sample_end) < tile.unit_count)
    return false;
  const Pieces& pieces = index_.at({tile.pass, tile.sample_begin, tile.sample_end});
  char* to = static_cast<char*>(bytes);
  const std::int64_t end = tile.first_unit + tile.unit_count;
  auto piece = std::prev(pieces.upper_bound(tile.first_unit));
  for (std::int64_t unit = tile.first_unit; unit < end; ++piece) {
    if (piece->second.bytes_per_unit != bytes_per_unit) return false;
    const std::int64_t piece_end = std::min(end, piece->first + piece->second.unit_count);
    const std::size_t size = static_cast<std::size_t>(piece_end - unit) * bytes_per_unit;
    const std::uint64_t at = piece->second.offset + static_cast<std::uint64_t>(unit - piece->first) * bytes_per_unit;
    if (!read_at(descriptor_, to, size, at)) return false;
    to += size;
    unit = piece_end;
  }
  return true;
}

}  // namespace nicol
