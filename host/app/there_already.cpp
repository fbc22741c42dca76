// See there_already.hpp.
#include "host/app/there_already.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "host/app/render_picture.hpp"
#include "host/engine/picture_share.hpp"
#include "host/output/picture_note.hpp"

namespace nicol::app {
namespace {

bool exists(const std::string& path) {
  std::error_code failed;
  return std::filesystem::exists(path, failed);
}

}  // namespace

Found find_what_is_there(const RenderCommand& command, const std::vector<std::string>& outputs, const engine::LoadedScene& loaded) {
  Found found;
  found.tiles = exists(journal_path(outputs.front()));
  const auto share = engine::choose_share(command, outputs, loaded.scene);
  // What each pixel is off by is known of a picture just rendered only.
  if (found.tiles || !command.error_map.empty() || std::none_of(outputs.begin(), outputs.end(), exists)) return found;
  const WholePicture wanted = engine::whole_picture(loaded, command);
  found.picture = true;
  for (const std::string& path : outputs) {
    const std::string why = exists(path) ? why_another(path, wanted, share.name) : "";
    found.picture = found.picture && exists(path) && why.empty();
    found.another = found.another || !why.empty();
    if (!why.empty()) fmt::print(stderr, "nicol: {} is another picture ({}): it is rendered anew\n", path, why);
  }
  return found;
}

}  // namespace nicol::app
