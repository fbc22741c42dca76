// One call into a plugin: the nicol_host_v1 it is given, what it may do there, and what it has said.
#pragma once
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>

#include "host/plugins/library.hpp"
#include "host/plugins/nicol_plugin.h"

namespace nicol::plugins {

// What all entries of one file share.
struct SharedObject {
  std::string path;
  std::mutex turn;     // held during a call, unless the entry says that it is thread-safe
  std::mutex guard;    // of `broken`
  std::string broken;  // why it is not called again; "": it is sound
};

class HostCall {
 public:
  enum class Purpose { entry, value, solid, importer, sink };
  explicit HostCall(Purpose purpose);
  ~HostCall();
  HostCall(const HostCall&) = delete;
  HostCall& operator=(const HostCall&) = delete;

  const nicol_host_v1* host() const { return &host_; }
  const std::string& message() const { return message_; }

  // Where the calls of a purpose leave what they say.
  Library* library = nullptr;                // entry
  std::shared_ptr<SharedObject> object;      // entry
  std::string wrong;                         // entry: the first thing that was registered wrongly; wins over the plugin's status
  ConvexShape convex;                        // solid
  MeshShape mesh;
  FindFile find_file;
  std::string text;                          // importer

  // Runs `call` and throws PluginError for what it returns or throws, std::bad_alloc where nicol lacks memory. what: "solid 'stone'".
  void run(SharedObject& shared, bool thread_safe, const std::string& what, const std::function<int(const nicol_host_v1*)>& call);

 private:
  friend struct HostFunctions;
  nicol_host_v1 host_{};
  Purpose purpose_;
  std::string message_, misuse_;
  std::deque<std::string> found_files_;   // what was handed out stays until the call ends
  bool out_of_memory_ = false;            // in one of the functions: told whatever the plugin makes of its refusal
};

// What is registered, checked and wrapped; `call.wrong` says what is amiss. (register.cpp)
int add_entry(HostCall& call, const nicol_dispersion_v1* entry);
int add_entry(HostCall& call, const nicol_spectrum_v1* entry);
int add_entry(HostCall& call, const nicol_solid_v1* entry);
int add_entry(HostCall& call, const nicol_importer_v1* entry);
int add_entry(HostCall& call, const nicol_sink_v1* entry);

}  // namespace nicol::plugins
