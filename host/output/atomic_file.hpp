// A file that appears whole or not at all: written under a temporary name in the folder of its
// target, made durable, then renamed over it. Not committed, it leaves nothing behind and the old
// file untouched.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace nicol {

class AtomicFile {
 public:
  explicit AtomicFile(const std::string& path);  // all of these throw OutputError
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(const char* bytes, std::size_t count);
  void seek(std::uint64_t position);
  std::uint64_t position() const { return position_; }
  void commit();
  const std::string& unfinished_name() const { return temporary_; }  // for what writes by name; "" once committed

  // The first error of write() and seek() again, for callers whose library swallows exceptions.
  void rethrow_error() const;

 private:
  [[noreturn]] void fail(int error_number);

  std::string path_;       // as the user wrote it: for messages
  std::string target_;     // links resolved
  std::string temporary_;  // empty once renamed
  int slot_ = -1;          // where remove_unfinished_files() finds its name
  std::uint64_t position_ = 0;
  int descriptor_ = -1;
  int first_error_ = 0;
};

// Removes every file that is not committed yet, for a program that ends at once. Safe in a signal handler.
void remove_unfinished_files() noexcept;

// "cannot write PATH: REASON"
[[noreturn]] void cannot_write(const std::string& path, const std::string& reason);

}  // namespace nicol
