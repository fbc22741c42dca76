#include "host/opencl/cache_folder.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>

namespace nicol {
namespace {

namespace fs = std::filesystem;

std::string environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

// The user's cache folder by the XDG rules (a relative path counts as unset); "" if there is no home.
std::string user_cache() {
  const std::string xdg = environment("XDG_CACHE_HOME"), home = environment("HOME");
  if (!xdg.empty() && xdg[0] == '/') return xdg;
  return !home.empty() && home[0] == '/' ? home + "/.cache" : "";
}

}  // namespace

bool is_writable_folder(const std::string& folder) {
  std::error_code failed;
  fs::create_directories(folder, failed);
  return fs::is_directory(folder, failed) && ::access(folder.c_str(), W_OK | X_OK) == 0;
}

std::string cache_folder() {
  const std::string user = user_cache();
  if (!user.empty() && is_writable_folder(user + "/nicol")) return user + "/nicol";
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  if (failed) return "";
  const std::string own = (temporary / ("nicol-" + std::to_string(::getuid()))).string();
  return is_writable_folder(own) ? own : "";
}

void make_opencl_cache_writable() {
  const std::string chosen = environment("POCL_CACHE_DIR"), user = user_cache();
  const bool fits = !chosen.empty() ? is_writable_folder(chosen)
                                    : !user.empty() && is_writable_folder(user + "/pocl/kcache");
  const std::string folder = fits ? "" : cache_folder();
  if (!folder.empty() && is_writable_folder(folder + "/pocl"))
    ::setenv("POCL_CACHE_DIR", (folder + "/pocl").c_str(), 1);
}

}  // namespace nicol
