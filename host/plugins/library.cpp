// See library.hpp.
#include "host/plugins/library.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <map>

#include "host/plugins/host_call.hpp"

namespace nicol::plugins {

namespace {

namespace fs = std::filesystem;

using Entry = int (*)(const nicol_host_v1*);

[[noreturn]] void cannot_load(const std::string& path, const std::string& reason) {
  throw PluginError("plugin " + path + ": " + reason);
}

// What dlopen says, without the path that stands before it anyway.
std::string loader_error(const std::string& path) {
  const char* text = dlerror();
  std::string said = text ? text : "unknown error";
  if (said.rfind(path + ": ", 0) == 0) said.erase(0, path.size() + 2);
  return said;
}

Entry entry_of(void* handle, const std::string& path) {
  constexpr int latest_tried = 9;
  if (void* found = dlsym(handle, "nicol_plugin_v1")) return reinterpret_cast<Entry>(found);
  for (int version = 2; version <= latest_tried; ++version)
    if (dlsym(handle, ("nicol_plugin_v" + std::to_string(version)).c_str()))
      cannot_load(path, "made for a later nicol: it has nicol_plugin_v" + std::to_string(version) + ", this one calls nicol_plugin_v1");
  cannot_load(path, "a shared object without the function nicol_plugin_v1: no plugin for nicol");
}

std::unique_ptr<Library> loaded(const std::string& path) {
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) cannot_load(path, "cannot be loaded: " + loader_error(path));
  const Entry entry = entry_of(handle, path);
  auto library = std::make_unique<Library>();
  library->path = path;
  auto shared = std::make_shared<SharedObject>();
  shared->path = path;
  HostCall call(HostCall::Purpose::entry);
  call.library = library.get();
  call.object = shared;
  call.run(*shared, false, "nicol_plugin_v1", entry);
  const bool nothing = library->dispersions.empty() && library->spectra.empty() && library->solids.empty() &&
                       library->importers.empty() && library->sinks.empty();
  if (nothing) cannot_load(path, "registers nothing");
  return library;
}

struct Known {
  std::unique_ptr<Library> library;
  std::string failure;
};

}  // namespace

const Library& load_library(const std::string& path) {
  static std::mutex guard;
  static auto& known = *new std::map<std::string, Known>;  // never unloaded
  std::error_code failed;
  const std::string canonical = fs::canonical(path, failed).string();
  if (failed) cannot_load(path, failed.message());
  const std::lock_guard lock(guard);
  const auto [at, is_new] = known.try_emplace(canonical);
  if (is_new) {
    try {
      at->second.library = loaded(canonical);
    } catch (const PluginError& error) {
      at->second.failure = error.what();
    } catch (...) {   // for lack of memory: not the file's fault
      known.erase(at);
      throw;
    }
  }
  if (!at->second.library) throw PluginError(at->second.failure);
  return *at->second.library;
}

std::string stem_of(const std::string& path) { return fs::path(path).stem().string(); }

}  // namespace nicol::plugins
