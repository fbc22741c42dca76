#include "host/api/guard.hpp"

#include <new>

#include "host/engine/options.hpp"
#include "host/opencl/fragment_check.hpp"
#include "host/output/frame.hpp"
#include "host/plugins/source.hpp"

namespace nicol::api {
namespace {

thread_local std::string last_words;
thread_local const char* last_error = "";
thread_local int callbacks_entered = 0;

// UTF-8 is not cut inside a character.
void copy_cut(char* to, std::size_t room, const char* from) noexcept {
  std::size_t size = std::strlen(from);
  if (size >= room)
    for (size = room - 1; size > 0 && (static_cast<unsigned char>(from[size]) & 0xC0) == 0x80;) --size;
  std::memcpy(to, from, size);
  to[size] = 0;
}

}  // namespace

nicol_status fail(nicol_status status, const char* text) noexcept {
  try {
    last_words = text;
    last_error = last_words.c_str();
  } catch (...) {
    last_error = "out of memory";
  }
  return status;
}

nicol_status fail_with_current_exception() noexcept {
  try {
    throw;
  } catch (const Failure& failure) {
    return fail(failure.status, failure.what());
  } catch (const engine::UsageError& error) {
    return fail(NICOL_ERROR_ARGUMENT, error.what());
  } catch (const plugins::PluginError& error) {
    return fail(NICOL_ERROR_PLUGIN, error.what());
  } catch (const FragmentError& error) {
    return fail(NICOL_ERROR_PLUGIN, error.what());
  } catch (const DeviceError& error) {
    return fail(NICOL_ERROR_DEVICE, error.what());
  } catch (const InputError& error) {
    return fail(NICOL_ERROR_INPUT, error.what());
  } catch (const OutputError& error) {
    return fail(NICOL_ERROR_OUTPUT, error.what());
  } catch (const std::bad_alloc&) {
    return fail(NICOL_ERROR_MEMORY, "out of memory");
  } catch (const std::length_error&) {
    return fail(NICOL_ERROR_MEMORY, "out of memory: more than one array can hold");
  } catch (const std::exception& error) {
    return fail(NICOL_ERROR_INTERNAL, error.what());
  } catch (...) {
    return fail(NICOL_ERROR_INTERNAL, "an exception that is no std::exception");
  }
}

bool in_callback() noexcept { return callbacks_entered > 0; }

void refuse_in_callback(const char* function) {
  require(!in_callback(), std::string(function) + " was called by a callback");
}

Callbacks::Entered::Entered() { ++callbacks_entered; }
Callbacks::Entered::~Entered() { --callbacks_entered; }

void Callbacks::stop(nicol_status status, const char* text) noexcept {
  status_ = status;
  copy_cut(text_, sizeof text_, text);
  stop_ = true;
}

}  // namespace nicol::api

extern "C" const char* nicol_last_error(void) { return nicol::api::last_error; }
