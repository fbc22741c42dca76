// What stands between C++ and its exceptions and the C interface: statuses and words of failures, sized structs, callbacks.
#pragma once
#include <algorithm>
#include <atomic>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>

#include "host/api/nicol.h"

namespace nicol::api {

// A failure with the status it is told by.
struct Failure : std::runtime_error {
  Failure(nicol_status failed_with, const std::string& text) : std::runtime_error(text), status(failed_with) {}
  nicol_status status;
};

// Takes the words for nicol_last_error(); answers the status.
nicol_status fail(nicol_status status, const char* text) noexcept;

// Of the exception in flight.
nicol_status fail_with_current_exception() noexcept;

// Runs what a function does; nothing is thrown.
template <class Work>
nicol_status guarded(Work work) noexcept {
  try {
    return work();
  } catch (...) {
    return fail_with_current_exception();
  }
}

template <class Pointer>
void require(Pointer* pointer, const char* what) {
  if (!pointer) throw Failure(NICOL_ERROR_ARGUMENT, std::string(what) + " is NULL");
}

inline void require(bool right, const std::string& text) {
  if (!right) throw Failure(NICOL_ERROR_ARGUMENT, text);
}

// Far more than any struct here will have: beyond it struct_size was never set.
constexpr std::size_t longest_struct = 65536;

inline void require_size(std::size_t size, const char* name) {
  require(size >= sizeof(std::uint32_t) && size <= longest_struct, std::string(name) + ": struct_size is not set");
}

// The struct that a caller fills, as far as it reaches; what this library does not know of it must be zero.
template <class Struct>
Struct taken(const Struct* given, const char* name) {
  Struct taken{};
  if (!given) return taken;
  const std::size_t size = given->struct_size;
  require_size(size, name);
  const auto* bytes = reinterpret_cast<const unsigned char*>(given);
  for (std::size_t i = sizeof(Struct); i < size; ++i)
    require(bytes[i] == 0, std::string(name) + " asks for what this version of libnicol does not know");
  std::memcpy(&taken, given, std::min(size, sizeof(Struct)));
  taken.struct_size = sizeof(Struct);
  return taken;
}

// Into the struct of a caller, as much as it holds; zeros behind.
template <class Struct>
void give(const Struct& values, Struct* wanted, const char* name) {
  require(wanted, name);
  const std::uint32_t size = wanted->struct_size;
  require_size(size, name);
  std::memset(wanted, 0, size);
  std::memcpy(wanted, &values, std::min<std::size_t>(size, sizeof(Struct)));
  wanted->struct_size = size;
}

// True on a thread that is in a callback.
bool in_callback() noexcept;
// For functions that a callback may not call.
void refuse_in_callback(const char* function);

// The callbacks of one call: the first that says stop, or throws, is the last.
class Callbacks {
 public:
  // call: int(), not 0 for stop. False once something said stop.
  template <class Call>
  bool ask(Call call) noexcept {
    if (stop_) return false;
    const Entered entered;
    try {
      if (call() != 0) stop(NICOL_CANCELLED, "a callback said stop");
    } catch (const std::exception& error) {
      stop(NICOL_ERROR_CALLBACK, error.what());
    } catch (...) {
      stop(NICOL_ERROR_CALLBACK, "an exception that is no std::exception left a callback");
    }
    return !stop_;
  }

  const std::atomic<bool>& stopped() const { return stop_; }
  // NICOL_OK, or what it was stopped with.
  nicol_status status() const noexcept { return stop_ ? fail(status_, text_) : NICOL_OK; }

 private:
  struct Entered {
    Entered();
    ~Entered();
  };
  void stop(nicol_status status, const char* text) noexcept;

  std::atomic<bool> stop_{false};
  nicol_status status_ = NICOL_OK;
  char text_[1024] = "";
};

}  // namespace nicol::api
