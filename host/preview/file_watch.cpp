#include "host/preview/file_watch.hpp"

#include <poll.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <optional>

namespace nicol::preview {
namespace {

namespace fs = std::filesystem;
constexpr std::uint32_t events = IN_CLOSE_WRITE | IN_MOVED_TO | IN_CREATE | IN_DELETE;
constexpr std::uint32_t folder_went = IN_DELETE_SELF | IN_MOVE_SELF;
constexpr std::chrono::milliseconds quiet{40};   // editors write in several steps

}  // namespace

FileWatch::FileWatch(std::function<void()> changed) : changed_(std::move(changed)) {
  inotify_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  if (inotify_ < 0 || pipe(stop_) != 0) {
    failure_ = std::string("changes of files are not seen (inotify: ") + std::strerror(errno) + ")";
    return;
  }
  thread_ = std::thread([this] { run(); });
}

FileWatch::~FileWatch() {
  if (thread_.joinable()) {
    [[maybe_unused]] const auto written = write(stop_[1], "", 1);
    thread_.join();
  }
  for (const int fd : {inotify_, stop_[0], stop_[1]})
    if (fd >= 0) close(fd);
}

std::string FileWatch::failure() const {
  const std::lock_guard<std::mutex> held(lock_);
  return failure_;
}

void FileWatch::add(const std::string& file) {
  const fs::path path(file);
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const int watch = inotify_add_watch(inotify_, folder.c_str(), events | folder_went);
  if (watch < 0) {
    if (errno == ENOENT) add(folder.string());   // told of when the folder comes
    else failure_ = "changes in " + folder.string() + " are not seen (" + std::strerror(errno) + ")";
    return;
  }
  const auto known = std::find_if(folders_.begin(), folders_.end(), [&](const auto& f) { return f.first == watch; });
  Folder& entry = known != folders_.end() ? known->second : folders_.emplace_back(watch, Folder{folder.string(), {}}).second;
  entry.names.insert(path.filename().string());
}

void FileWatch::watch(const std::vector<std::string>& files, bool any_new) {
  if (!thread_.joinable()) return;
  const std::lock_guard<std::mutex> held(lock_);
  files_ = files;
  any_new_ = any_new;
  renew();
}

// Folders may have come, gone or been put in the place of others.
void FileWatch::renew() {
  const auto before = std::move(folders_);
  folders_.clear();
  failure_.clear();
  for (const std::string& file : files_) {
    add(file);
    std::error_code failed;
    const fs::path behind = fs::canonical(file, failed);
    if (!failed && behind.string() != file) add(behind.string());
  }
  for (const auto& [watch, folder] : before) {
    const int old = watch;
    if (std::none_of(folders_.begin(), folders_.end(), [&](const auto& f) { return f.first == old; }))
      inotify_rm_watch(inotify_, old);
  }
}

bool FileWatch::drain() {
  alignas(inotify_event) std::array<char, 16384> buffer;
  bool matters = false;
  for (;;) {
    const ssize_t size = read(inotify_, buffer.data(), buffer.size());
    if (size <= 0) return matters;
    const std::lock_guard<std::mutex> held(lock_);
    for (ssize_t at = 0; at < size;) {
      const auto* event = reinterpret_cast<const inotify_event*>(buffer.data() + at);
      at += static_cast<ssize_t>(sizeof *event + event->len);
      if (event->mask & IN_Q_OVERFLOW) matters = true;
      for (const auto& [watch, folder] : folders_) {
        if (watch != event->wd) continue;
        const bool named = event->len > 0 && folder.names.count(event->name) > 0;
        matters |= named || (event->mask & folder_went) || (any_new_ && (event->mask & (IN_CLOSE_WRITE | IN_MOVED_TO)));
      }
    }
  }
}

void FileWatch::run() {
  using Clock = std::chrono::steady_clock;
  std::optional<Clock::time_point> due;   // other files that come and go do not put it off
  for (;;) {
    const auto left = due ? std::chrono::ceil<std::chrono::milliseconds>(*due - Clock::now()).count() : -1;
    std::array<pollfd, 2> ends{{{inotify_, POLLIN, 0}, {stop_[0], POLLIN, 0}}};
    const int ready = poll(ends.data(), ends.size(), due ? static_cast<int>(std::max<long long>(left, 0)) : -1);
    if (ready < 0 && errno != EINTR) return;
    if (ready > 0 && ends[1].revents) return;
    if (ready > 0 && drain()) due = Clock::now() + quiet;
    if (!due || Clock::now() < *due) continue;
    due.reset();
    {
      const std::lock_guard<std::mutex> held(lock_);
      renew();
    }
    changed_();
  }
}

}  // namespace nicol::preview
