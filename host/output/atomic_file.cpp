// Temporary file, fsync, rename.
#include "host/output/atomic_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include "host/output/frame.hpp"

namespace nicol {
namespace {

namespace fs = std::filesystem;

// The names of the files not committed yet. A file beyond the last slot is only not removed at an abrupt end.
std::array<std::atomic<const char*>, 16> unfinished_names{};
static_assert(std::atomic<const char*>::is_always_lock_free, "a signal handler reads the names");

int enlist(const char* name) {
  for (std::size_t i = 0; i < unfinished_names.size(); ++i) {
    const char* none = nullptr;
    if (unfinished_names[i].compare_exchange_strong(none, name)) return static_cast<int>(i);
  }
  return -1;
}

void strike_off(int& slot) {
  if (slot >= 0) unfinished_names[static_cast<std::size_t>(slot)] = nullptr;
  slot = -1;
}

std::string folder_of(const std::string& target) {
  const auto folder = fs::path(target).parent_path().string();
  return folder.empty() ? "." : folder;
}

// The place that a path names, through links (whole or dangling), so that a link stays one.
std::string resolve(const std::string& path) {
  std::error_code error;
  fs::path place = path;
  for (int links = 0; links < 40 && fs::is_symlink(place, error); ++links)
    place = place.parent_path() / fs::read_symlink(place, error);
  return place.string();
}

void refuse_impossible_targets(const std::string& path, const std::string& target) {
  std::error_code error;
  const auto status = fs::status(target, error);
  if (fs::is_directory(status)) cannot_write(path, "it is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status))
    cannot_write(path, "it is not an ordinary file");
  if (fs::exists(status) && ::access(target.c_str(), W_OK) != 0)
    cannot_write(path, std::strerror(errno));
  const std::string folder = folder_of(target);
  if (!fs::exists(folder, error)) cannot_write(path, "there is no folder " + folder);
  if (!fs::is_directory(folder, error)) cannot_write(path, folder + " is not a folder");
}

// Makes the rename durable; some file systems cannot sync a folder, which harms nothing.
void sync_folder(const std::string& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void remove_unfinished_files() noexcept {
  for (const std::atomic<const char*>& name : unfinished_names)
    if (const char* file = name) ::unlink(file);
}

void cannot_write(const std::string& path, const std::string& reason) {
  throw OutputError("cannot write " + path + ": " + reason);
}

AtomicFile::AtomicFile(const std::string& path) : path_(path), target_(resolve(path)) {
  static std::atomic<unsigned> serial{0};
  refuse_impossible_targets(path_, target_);
  do {
    temporary_ = folder_of(target_) + "/.nicol-" + std::to_string(::getpid()) + "-" +
                 std::to_string(serial++) + ".tmp";
    descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) cannot_write(path_, std::strerror(errno));
  slot_ = enlist(temporary_.c_str());
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  strike_off(slot_);
}

void AtomicFile::fail(int error_number) {
  if (first_error_ == 0) first_error_ = error_number;
  cannot_write(path_, std::strerror(error_number));
}

void AtomicFile::rethrow_error() const {
  if (first_error_ != 0) cannot_write(path_, std::strerror(first_error_));
}

void AtomicFile::write(const char* bytes, std::size_t count) {
  while (count > 0) {
    const ssize_t written = ::write(descriptor_, bytes, count);
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    bytes += written;
    count -= static_cast<std::size_t>(written);
    position_ += static_cast<std::uint64_t>(written);
  }
}

void AtomicFile::seek(std::uint64_t position) {
  if (::lseek(descriptor_, static_cast<off_t>(position), SEEK_SET) < 0) fail(errno);
  position_ = position;
}

void AtomicFile::commit() {
  if (::fsync(descriptor_) != 0) fail(errno);
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail(errno);
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  strike_off(slot_);
  temporary_.clear();
  sync_folder(folder_of(target_));
}

}  // namespace nicol
