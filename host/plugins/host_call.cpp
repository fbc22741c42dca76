// See host_call.hpp.
#include "host/plugins/host_call.hpp"

#include <cxxabi.h>

#include <exception>
#include <map>
#include <new>

namespace nicol::plugins {

namespace {

// The calls that are under way: what a plugin kept from an earlier one is not among them.
std::mutex live_guard;
std::map<const nicol_host_v1*, HostCall*>& live_calls() {
  static auto* calls = new std::map<const nicol_host_v1*, HostCall*>;
  return *calls;
}

// Of nicol's own, whose functions a plugin called; bad_alloc would be the plugin's.
struct OutOfMemory {};

constexpr std::size_t most_text = 64u << 20;
constexpr std::size_t most_items = 1'000'000;

}  // namespace

// The functions of nicol_host_v1. None throws into the plugin.
struct HostFunctions {
  using Purpose = HostCall::Purpose;

  // Null if this call is over.
  static HostCall* find(const nicol_host_v1* host) {
    const std::lock_guard lock(live_guard);
    const auto found = live_calls().find(host);
    return found == live_calls().end() ? nullptr : found->second;
  }

  // Null, and told, if this call is not for that.
  static HostCall* find(const nicol_host_v1* host, Purpose purpose, const char* function) {
    HostCall* call = find(host);
    if (!call || call->purpose_ == purpose) return call;
    if (call->misuse_.empty()) call->misuse_ = std::string("calls ") + function + " where it does not belong";
    return nullptr;
  }

  template <class Body>
  static int guarded(HostCall* call, const Body& body) {
    if (!call) return NICOL_PLUGIN_REFUSED;
    try {
      return body(*call) ? NICOL_PLUGIN_OK : NICOL_PLUGIN_REFUSED;
    } catch (const std::bad_alloc&) {
      call->out_of_memory_ = true;
      return NICOL_PLUGIN_REFUSED;
    } catch (const std::exception&) {
      return NICOL_PLUGIN_REFUSED;
    }
  }

  template <class Entry>
  static int add(const nicol_host_v1* host, const Entry* entry) {
    return guarded(find(host, Purpose::entry, "a function that registers"),
                   [&](HostCall& call) { return add_entry(call, entry) == NICOL_PLUGIN_OK; });
  }

  static void set_message(const nicol_host_v1* host, const char* text) {
    guarded(find(host), [&](HostCall& call) {
      call.message_ = text ? std::string(text).substr(0, 4096) : "";
      return true;
    });
  }

  static const char* find_file(const nicol_host_v1* host, const char* name) {
    HostCall* call = find(host, Purpose::solid, "find_file");
    const char* path = nullptr;
    guarded(call, [&](HostCall& c) {
      std::string found = name && c.find_file ? c.find_file(name) : "";
      if (!found.empty()) path = c.found_files_.emplace_back(std::move(found)).c_str();
      return true;
    });
    return path;
  }

  static int add_plane(const nicol_host_v1* host, const double normal[3], double offset) {
    return guarded(find(host, Purpose::solid, "add_plane"), [&](HostCall& call) {
      if (!normal || call.convex.faces.size() >= most_items) return false;
      call.convex.faces.push_back({{normal[0], normal[1], normal[2]}, offset});
      return true;
    });
  }

  static int add_point(const nicol_host_v1* host, const double point[3]) {
    return guarded(find(host, Purpose::solid, "add_point"), [&](HostCall& call) {
      if (!point || call.mesh.points.size() >= most_items) return false;
      call.mesh.points.push_back({point[0], point[1], point[2]});
      return true;
    });
  }

  static int add_face(const nicol_host_v1* host, const std::int32_t* corners, std::size_t count) {
    return guarded(find(host, Purpose::solid, "add_face"), [&](HostCall& call) {
      if (!corners || count > most_items || call.mesh.faces.size() >= most_items) return false;
      call.mesh.faces.emplace_back(corners, corners + count);
      return true;
    });
  }

  static int set_text(const nicol_host_v1* host, const char* text, std::size_t length) {
    return guarded(find(host, Purpose::importer, "set_text"), [&](HostCall& call) {
      if (!text || length > most_text) return false;
      call.text.assign(text, length);
      return true;
    });
  }
};

HostCall::HostCall(Purpose purpose) : purpose_(purpose) {
  using F = HostFunctions;
  host_.struct_size = sizeof host_;
  host_.version = 1;
  host_.nicol_version = NICOL_VERSION;
  host_.add_dispersion = F::add<nicol_dispersion_v1>;
  host_.add_spectrum = F::add<nicol_spectrum_v1>;
  host_.add_solid = F::add<nicol_solid_v1>;
  host_.add_importer = F::add<nicol_importer_v1>;
  host_.add_sink = F::add<nicol_sink_v1>;
  host_.set_message = F::set_message;
  host_.find_file = F::find_file;
  host_.add_plane = F::add_plane;
  host_.add_point = F::add_point;
  host_.add_face = F::add_face;
  host_.set_text = F::set_text;
  const std::lock_guard lock(live_guard);
  live_calls()[&host_] = this;
}

HostCall::~HostCall() {
  const std::lock_guard lock(live_guard);
  live_calls().erase(&host_);
}

void HostCall::run(SharedObject& shared, bool thread_safe, const std::string& what,
                   const std::function<int(const nicol_host_v1*)>& call) {
  const std::string prefix = "plugin " + shared.path + ": " + what + " ";
  std::unique_lock turn(shared.turn, std::defer_lock);
  if (!thread_safe) turn.lock();
  {
    const std::lock_guard lock(shared.guard);
    if (!shared.broken.empty()) throw PluginError(prefix + "is not called again: " + shared.broken);
  }
  std::string thrown;
  try {
    const int status = call(&host_);
    if (out_of_memory_) throw OutOfMemory();
    if (!misuse_.empty()) throw PluginError(prefix + misuse_);
    if (!wrong.empty()) throw PluginError("plugin " + shared.path + ": registers " + wrong);
    if (status == NICOL_PLUGIN_OK) return;
    if (!message_.empty()) throw PluginError(prefix + "failed: " + message_);
    throw PluginError(prefix + "failed with status " + std::to_string(status) + " and no message");
  } catch (const PluginError&) {
    throw;
  } catch (const OutOfMemory&) {
    throw std::bad_alloc();
  } catch (const abi::__forced_unwind&) {
    throw;
  } catch (const std::exception& error) {
    thrown = std::string("threw an exception: ") + error.what();
  } catch (...) {
    thrown = "threw something that is no std::exception";
  }
  const std::lock_guard lock(shared.guard);
  shared.broken = what + " " + thrown;
  throw PluginError(prefix + thrown);
}

}  // namespace nicol::plugins
