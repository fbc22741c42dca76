// The finished tiles of a picture that is not finished: a file beside it (out.exr.part) from which a
// later run goes on to the same bits. It only grows, every record carries a checksum, so that it can be
// read after the program was killed at any byte.
#pragma once
#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>

namespace nicol {

// Samples [sample_begin, sample_end) of units first_unit .. first_unit + unit_count of a pass.
struct TileKey {
  std::int32_t pass = 0;
  std::int64_t first_unit = 0, unit_count = 0;
  std::int32_t sample_begin = 0, sample_end = 0;
};

// For one thread. Nothing here throws but for lack of memory: a picture is rendered all the same where its
// tiles cannot be kept.
class Journal {
 public:
  // identity: all that decides the bits (scene, settings, kernel text, device, lanes, real). resume: takes up
  // what is there; else, and where that is of another identity or version or damaged, begins anew and says
  // why in `note` ("": nothing to tell). A damaged or cut tail is dropped and told. Where no file can be kept
  // (unwritable folder, not a journal, in use by another process) the note says so, and nothing is recorded.
  static std::unique_ptr<Journal> open(const std::string& path, const std::string& identity, bool resume,
                                       std::string& note);
  ~Journal();  // a file without tiles goes away
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  // The bytes of a tile, unit after unit, from whatever tiles of the same pass and samples cover it. False
  // if some are not there or were recorded with other bytes per unit.
  bool find(const TileKey& tile, std::size_t bytes_per_unit, void* bytes) const;

  // How many units from `from_unit` on are all there.
  std::int64_t covered_units(int pass, std::int64_t from_unit, int sample_begin, int sample_end) const;

  // How many units from `from_unit` on are all not there; huge if none are from there on.
  std::int64_t missing_units(int pass, std::int64_t from_unit, int sample_begin, int sample_end) const;

  // size: a multiple of the tile's units. On a full disk recording stops, and note() says so.
  void add(const TileKey& tile, const void* bytes, std::size_t size);

  // "" while tiles are recorded, else why not.
  std::string note() const { return note_; }

  // The picture is finished: the file goes away.
  void remove();

 private:
  // Units of one record that no earlier record holds; by their first unit.
  struct Piece {
    std::int64_t unit_count;
    std::uint64_t offset, bytes_per_unit;
  };
  using Pieces = std::map<std::int64_t, Piece>;
  using Samples = std::tuple<std::int32_t, std::int32_t, std::int32_t>;  // pass, begin, end

  explicit Journal(const std::string& path) : path_(path) {}
  std::string open_locked();
  std::string take_up(const std::string& identity);
  void begin(const std::string& identity);
  bool read_records(std::uint64_t at, std::uint64_t end);
  void enter(const TileKey& tile, std::uint64_t offset, std::uint64_t size);
  void stop(const std::string& reason);

  std::string path_, note_;
  int descriptor_ = -1;     // -1: nothing is recorded and nothing is there
  bool recording_ = false;
  std::uint64_t end_ = 0;   // of the last whole record
  std::map<Samples, Pieces> index_;
};

}  // namespace nicol
