// What the handles of the C interface hold. Counted; scenes and pictures do not change once they are handed out.
#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "host/api/guard.hpp"
#include "host/engine/loaded_scene.hpp"
#include "host/engine/picture.hpp"

namespace nicol::api {

class Counted {
 public:
  void retain() noexcept { count_.fetch_add(1, std::memory_order_relaxed); }
  bool release() noexcept { return count_.fetch_sub(1, std::memory_order_acq_rel) == 1; }  // true: that was the last

 private:
  std::atomic<std::uint32_t> count_{1};
};

// A count on a handle, held by another or during a call.
template <class Handle>
class Held {
 public:
  explicit Held(Handle* handle) : handle_(handle) {
    if (handle_) handle_->retain();
  }
  ~Held() {
    if (handle_ && handle_->release()) delete handle_;
  }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;
  Handle* operator->() const { return handle_; }
  Handle& operator*() const { return *handle_; }
  Handle* get() const { return handle_; }

 private:
  Handle* handle_;
};

template <class Handle>
Handle* retained(Handle* handle) noexcept {
  if (handle) handle->retain();
  return handle;
}

template <class Handle>
void released(Handle* handle) noexcept {
  if (handle && handle->release()) delete handle;
}

// The texts that an include callback gave, for reading the scene once more. During the first reading they are asked for.
struct IncludeTexts {
  std::map<std::string, std::optional<std::string>> known;
  nicol_include_callback include = nullptr;
  void* user = nullptr;
  nicol_context* context = nullptr;
  Callbacks* callbacks = nullptr;  // null once the scene is read

  std::optional<std::string> text_of(const std::string& name);
  void debug(const std::string& text) const;  // what #debug prints
};

struct DiagnosticText {
  nicol_severity severity;
  std::string file, message, text;
  std::uint32_t line, column;
};

void fill(const DeviceInfo& device, nicol_device_info* info);

}  // namespace nicol::api

struct nicol_context : nicol::api::Counted {
  std::string wanted_device;
  std::vector<std::string> library_paths;
  nicol_log_callback log = nullptr;
  void* user = nullptr;

  std::vector<std::shared_ptr<nicol::Device>> open();  // DeviceError
  void load_plugin(const std::string& path);           // Failure
  std::vector<std::string> plugins();
  void tell(nicol::api::Callbacks& callbacks, nicol_severity severity, const std::string& text) const;

 private:
  std::mutex lock_;  // of what follows
  std::vector<std::string> plugins_;
  std::vector<std::shared_ptr<nicol::Device>> devices_;
};

struct nicol_include {
  std::optional<std::string> text;
};

struct nicol_scene : nicol::api::Counted {
  explicit nicol_scene(nicol_context* owner) : context(owner) {}

  const nicol::api::Held<nicol_context> context;
  nicol::engine::PictureOptions options;   // its name, and how it is read
  nicol::api::IncludeTexts includes;       // that options.options refers to
  nicol::engine::ReadScene read;
  std::vector<nicol::api::DiagnosticText> diagnostics;
  std::vector<std::string> files;
  std::string explanation;                 // "": it has errors
};

struct nicol_picture : nicol::api::Counted {
  explicit nicol_picture(nicol_scene* owner) : scene(owner) {}

  const nicol::api::Held<nicol_scene> scene;  // null: merged
  nicol::engine::Picture picture;
  std::optional<nicol::Frame> bound;
  int samples = 0;                            // of every pixel, where the frame does not say; 0: not known

  // Made when first asked for, then left alone.
  const std::vector<float>& xyz() const;
  const std::vector<float>& rgb() const;
  const std::vector<float>& coverage() const;
  const std::vector<float>& sample_counts() const;

 private:
  mutable std::once_flag xyz_once_, rgb_once_, coverage_once_, samples_once_;
  mutable std::vector<float> xyz_, rgb_, coverage_, samples_;
};
