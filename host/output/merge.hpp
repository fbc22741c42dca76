// Joins parts of a picture (part.hpp) to the bits of one run.
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "host/output/part.hpp"

namespace nicol {

class ExrSource;

class Merger {
 public:
  // Throws InputError, naming the files and the place, where the file cannot be read or is damaged, belongs to another picture than
  // those before, or has other values where one of them has some already.
  void add(const std::string& path);

  // What no part has, in words; "": nothing.
  std::string missing() const;

  // The picture. Where something is missing: zero there, with the wavelengths of which there is something, and a channel `weight` that
  // says how much of them each pixel has; a part again if that is all or nothing everywhere. To be called once.
  Frame take();

  const std::vector<PartNote>& parts() const { return parts_; }
  // Notes of the first part.
  const std::map<std::string, std::string>& notes() const { return notes_; }
  // Told to the user: parts of different devices.
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  using Owner = std::uint16_t;  // 1 + the file that a value came from; 0: none

  void begin(const PartNote& part);
  void check_same(const PartNote& part, const std::string& path);
  std::vector<std::size_t> wavelengths_in(const ExrSource& source) const;
  void take_run(std::size_t first, std::size_t count, const float* from, float* to, const Owner* owners, const char* what,
                double lambda_nm = 0);
  void own(std::size_t first, std::size_t count, Owner* owners) const;
  void take_row(int y, const std::vector<std::size_t>& wavelengths, bool own_cut_off, const std::vector<const float*>& planes);
  bool has(std::size_t pixel, const std::vector<std::size_t>& wavelengths) const;
  void join_cut_offs(const std::vector<std::size_t>& wavelengths);
  std::string missing_pixels(const std::vector<std::size_t>& wavelengths) const;
  std::vector<std::size_t> present_wavelengths() const;
  void drop_other_wavelengths(const std::vector<std::size_t>& kept);
  void weigh(const std::vector<std::size_t>& present);

  std::vector<std::string> paths_;
  std::vector<PartNote> parts_;
  std::map<std::string, std::string> notes_;
  std::vector<std::string> warnings_;
  Frame frame_;                                // of all wavelengths
  std::vector<Owner> owners_, cut_off_owners_; // [wavelength][pixel]; [pixel]
  ZeroedFloats channel_cut_off_;               // [wavelength][pixel], once a part has them, as their owners
  std::vector<Owner> channel_owners_;
};

}  // namespace nicol
