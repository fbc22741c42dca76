// Versions, statuses, devices and contexts of the C interface.
#include <cstring>

#include "host/api/handles.hpp"
#include "host/engine/plugins.hpp"

namespace nicol::api {
namespace {

template <std::size_t room>
void put(const std::string& text, char (&place)[room]) {
  std::size_t size = std::min(text.size(), room - 1);
  while (size < text.size() && size > 0 && (static_cast<unsigned char>(text[size]) & 0xC0) == 0x80) --size;
  std::memcpy(place, text.data(), size);
  place[size] = 0;
}

}  // namespace

void fill(const DeviceInfo& device, nicol_device_info* info) {
  nicol_device_info filled{};
  filled.index = device.index;
  put(device.name, filled.name);
  put(device.platform, filled.platform);
  put(device.version, filled.version);
  put(device.driver, filled.driver);
  filled.is_cpu = device.is_cpu;
  filled.is_gpu = device.is_gpu;
  filled.has_fp64 = device.has_fp64;
  filled.compute_units = device.compute_units;
  filled.memory_bytes = device.memory_bytes;
  give(filled, info, "info");
}

}  // namespace nicol::api

using namespace nicol;
using namespace nicol::api;

std::vector<std::shared_ptr<Device>> nicol_context::open() {
  const std::lock_guard<std::mutex> held(lock_);
  if (devices_.empty()) devices_ = open_devices(wanted_device);
  return devices_;
}

void nicol_context::load_plugin(const std::string& path) {
  engine::SceneOptions options;
  options.library_paths = library_paths;
  options.plugins = plugins();
  options.plugins.push_back(path);
  try {
    engine::load_plugins(options);
  } catch (const engine::UsageError& error) {
    throw Failure(NICOL_ERROR_PLUGIN, error.what());
  }
  const std::lock_guard<std::mutex> held(lock_);
  plugins_.push_back(path);
}

std::vector<std::string> nicol_context::plugins() {
  const std::lock_guard<std::mutex> held(lock_);
  return plugins_;
}

void nicol_context::tell(Callbacks& callbacks, nicol_severity severity, const std::string& text) const {
  if (!log || text.empty()) return;
  callbacks.ask([&] {
    log(user, severity, text.c_str());
    return 0;
  });
}

extern "C" {

uint32_t nicol_abi_version(void) { return NICOL_ABI_VERSION; }

const char* nicol_version(void) { return engine::version(); }

const char* nicol_status_text(nicol_status status) {
  switch (status) {
    case NICOL_OK: return "done";
    case NICOL_CANCELLED: return "stopped by a callback";
    case NICOL_ERROR_ARGUMENT: return "what was asked makes no sense";
    case NICOL_ERROR_SCENE: return "the scene has errors";
    case NICOL_ERROR_DEVICE: return "the device failed, or there is none";
    case NICOL_ERROR_INPUT: return "a file cannot be read";
    case NICOL_ERROR_OUTPUT: return "a file cannot be written";
    case NICOL_ERROR_MEMORY: return "out of memory";
    case NICOL_ERROR_PLUGIN: return "a plugin cannot be loaded, or failed";
    case NICOL_ERROR_CALLBACK: return "an exception left a callback";
    case NICOL_ERROR_UNAVAILABLE: return "the picture does not have it";
    case NICOL_ERROR_INTERNAL: return "an error in libnicol";
    default: return "unknown status";
  }
}

nicol_status nicol_device_count(size_t* count) {
  return guarded([&] {
    require(count, "count");
    *count = 0;
    *count = list_devices().size();
    return NICOL_OK;
  });
}

nicol_status nicol_device_get(size_t index, nicol_device_info* info) {
  return guarded([&] {
    require(info, "info");
    const auto devices = list_devices();
    require(index < devices.size(), "there is no device " + std::to_string(index));
    fill(devices[index], info);
    return NICOL_OK;
  });
}

nicol_status nicol_context_create(const nicol_context_options* options, nicol_context** context) {
  return guarded([&] {
    require(context, "context");
    *context = nullptr;
    const nicol_context_options wanted = taken(options, "nicol_context_options");
    require(wanted.library_path_count == 0 || wanted.library_paths, "library_paths is NULL");
    auto made = std::make_unique<nicol_context>();
    if (wanted.device) made->wanted_device = wanted.device;
    for (uint32_t i = 0; i < wanted.library_path_count; ++i) {
      require(wanted.library_paths[i], "one of library_paths");
      made->library_paths.push_back(wanted.library_paths[i]);
    }
    made->log = wanted.log;
    made->user = wanted.user;
    if (!made->wanted_device.empty()) made->open();
    *context = made.release();
    return NICOL_OK;
  });
}

nicol_context* nicol_context_retain(nicol_context* context) { return retained(context); }
void nicol_context_release(nicol_context* context) { released(context); }

nicol_status nicol_context_device(nicol_context* context, nicol_device_info* info) {
  return guarded([&] {
    require(context, "context");
    require(info, "info");
    fill(nicol::info(*context->open().front()), info);
    return NICOL_OK;
  });
}

nicol_status nicol_load_plugin(nicol_context* context, const char* path) {
  return guarded([&] {
    require(context, "context");
    require(path, "path");
    refuse_in_callback("nicol_load_plugin");
    context->load_plugin(path);
    return NICOL_OK;
  });
}

}  // extern "C"
