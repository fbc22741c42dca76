// Reads the EXR files that exr_sink.cpp writes: single part, scan lines, FLOAT channels.
#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace nicol {

class ExrSource {
 public:
  explicit ExrSource(const std::string& path);  // all of these throw InputError
  ~ExrSource();

  const std::string& path() const { return path_; }
  int width() const { return width_; }
  int height() const { return height_; }
  bool whole() const;  // no rows are missing
  bool has_channel(const std::string& name) const;
  // The notes of the header, by the key they were written under.
  const std::map<std::string, std::string>& notes() const { return notes_; }

  // Rows first .. first + count of these channels, each to `count` rows of width() floats.
  void read_rows(int first, int count, const std::vector<std::pair<std::string, float*>>& channels);

 private:
  struct File;
  std::string path_;
  std::unique_ptr<File> file_;
  int width_ = 0, height_ = 0;
  std::map<std::string, std::string> notes_;
};

// "cannot read PATH: REASON"
[[noreturn]] void cannot_read(const std::string& path, const std::string& reason);

}  // namespace nicol
