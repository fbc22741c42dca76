// libnicol where memory lacks, at one allocation after the other: each call says so, throws nothing, and the next one goes on.
#include <dlfcn.h>
#include <doctest/doctest.h>
#include <elf.h>
#include <link.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <new>

#include "scenes.hpp"

namespace {

// The code of libnicol: what OpenCL and its compiler allocate is theirs, and they do not bear failures.
std::uintptr_t code_begin = 0, code_end = 0;
thread_local long counted = 0, left = -1;   // of libnicol's allocations on this thread; left: until one fails, < 0: none does

void* allocate(std::size_t size, const void* caller) {
  const auto from = reinterpret_cast<std::uintptr_t>(caller);
  if (from >= code_begin && from < code_end) {
    ++counted;
    if (left >= 0 && left-- == 0) throw std::bad_alloc();
  }
  void* memory = std::malloc(std::max<std::size_t>(size, 1));
  if (!memory) throw std::bad_alloc();
  return memory;
}

void find_code() {
  Dl_info about{};
  REQUIRE(dladdr(reinterpret_cast<const void*>(&nicol_render), &about) != 0);
  const auto base = reinterpret_cast<std::uintptr_t>(about.dli_fbase);
  const auto* head = static_cast<const ElfW(Ehdr)*>(about.dli_fbase);
  const auto* part = reinterpret_cast<const ElfW(Phdr)*>(base + head->e_phoff);
  for (int i = 0; i < head->e_phnum; ++i)
    if (part[i].p_type == PT_LOAD && (part[i].p_flags & PF_X) != 0) {
      code_begin = base + part[i].p_vaddr;
      code_end = code_begin + part[i].p_memsz;
    }
}

// Fails at up to `most` of the call's allocations, evenly chosen. NICOL_OK: it did without; a file that OpenEXR cannot read for lack of
// memory is one that cannot be read.
void sweep(const char* what, long most, const std::function<nicol_status()>& call) {
  INFO(std::string(what));
  counted = 0;
  REQUIRE_MESSAGE(call() == NICOL_OK, std::string(nicol_last_error()));
  const long all = counted;
  REQUIRE(all > 0);
  int told = 0;
  for (long at = 0; at < all; at += std::max(1L, all / most)) {
    left = at;
    const nicol_status status = call();
    left = -1;
    CHECK_MESSAGE((status == NICOL_OK || status == NICOL_ERROR_MEMORY || status == NICOL_ERROR_INPUT), at << ": " << std::string(nicol_last_error()));
    told += status == NICOL_ERROR_MEMORY ? 1 : 0;
  }
  CHECK(told > 0);
  CHECK_MESSAGE(call() == NICOL_OK, std::string(nicol_last_error()));
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void* operator new[](std::size_t size) { return allocate(size, __builtin_return_address(0)); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return std::malloc(std::max<std::size_t>(size, 1)); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

TEST_CASE("where memory lacks, calls say so and nothing is lost") {
  find_code();
  const std::string text = api_test::cube, folder = std::filesystem::temp_directory_path();
  const std::string paths[] = {folder + "/nicol_memory_1.exr", folder + "/nicol_memory_2.exr"};
  nicol_context* context = nullptr;
  REQUIRE(nicol_context_create(nullptr, &context) == NICOL_OK);
  nicol_scene_options size{};
  size.struct_size = sizeof size;
  size.width = size.height = 48;
  nicol_scene* scene = nullptr;
  const auto load = [&](const std::string& from) {
    return nicol_scene_load_text(context, "cube.pov", from.data(), from.size(), &size, &scene);
  };
  const std::size_t polygon = text.find("polygon");   // CGAL's triangulations leak where memory lacks
  const std::string without = std::string(text).erase(polygon, text.find('\n', polygon) - polygon);
  sweep("load", 100, [&] {
    const nicol_status status = load(without);
    nicol_scene_release(scene);
    return status;
  });
  REQUIRE(load(text) == NICOL_OK);
  nicol_render_options options{};
  options.struct_size = sizeof options;
  nicol_picture* picture = nullptr;
  sweep("render", 60, [&] {
    const nicol_status status = nicol_render(scene, &options, &picture);
    nicol_picture_release(picture);
    return status;
  });
  options.part_count = 2;
  for (const std::string& path : paths) {
    ++options.part;
    REQUIRE_MESSAGE(nicol_render(scene, &options, &picture) == NICOL_OK, std::string(nicol_last_error()));
    sweep("write", 60, [&] { return nicol_picture_write(picture, path.c_str()); });
    nicol_picture_release(picture);
  }
  const char* parts[] = {paths[0].c_str(), paths[1].c_str()};
  sweep("merge", 60, [&] {
    const nicol_status status = nicol_merge(context, parts, 2, nullptr, &picture);
    const float* values = nullptr;
    const nicol_status seen = picture ? nicol_picture_linear_srgb(picture, &values) : NICOL_OK;
    nicol_picture_release(picture);
    return status == NICOL_OK ? seen : status;
  });
  for (const std::string& path : paths) std::filesystem::remove(path);
  nicol_scene_release(scene);
  nicol_context_release(context);
}
