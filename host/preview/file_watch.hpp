// Tells when files change, however an editor saves them: written in place, or put there under their name (rename).
// Linux's inotify on the folders that the files, and the files behind links, lie in.
#pragma once
#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

namespace nicol::preview {

class FileWatch {
 public:
  // `changed` is called from another thread, once no file has changed for some hundredths of a second.
  explicit FileWatch(std::function<void()> changed);
  ~FileWatch();
  FileWatch(const FileWatch&) = delete;
  FileWatch& operator=(const FileWatch&) = delete;

  // In place of those before. any_new: also a file of another name that comes into one of their folders (one that was missing).
  // A folder that is missing is waited for.
  void watch(const std::vector<std::string>& files, bool any_new);

  std::string failure() const;   // why changes are not seen; empty: they are

 private:
  struct Folder {
    std::string path;
    std::set<std::string> names;
  };
  void run();
  bool drain();                  // reads the events; whether one matters
  void add(const std::string& file);
  void renew();                  // with lock_ held

  std::function<void()> changed_;
  mutable std::mutex lock_;
  std::vector<std::string> files_;
  std::vector<std::pair<int, Folder>> folders_;   // by watch descriptor
  bool any_new_ = false;
  std::string failure_;
  int inotify_ = -1;
  int stop_[2] = {-1, -1};
  std::thread thread_;
};

}  // namespace nicol::preview
