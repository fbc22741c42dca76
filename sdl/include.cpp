// #include: a text handed in, else a file from the working directory, the library paths, or the scene's own folder.
#include <filesystem>
#include <fstream>
#include <sstream>

#include "parser.hpp"

namespace nicol::sdl {

namespace fs = std::filesystem;

std::string Parser::resolve(const std::string& name) const {
  std::vector<std::string> folders{""};
  if (fs::path(name).is_relative()) {
    folders.insert(folders.end(), options_.library_paths.begin(), options_.library_paths.end());
    if (!scene_folder_.empty()) folders.push_back(scene_folder_);
  }
  for (const std::string& folder : folders) {
    for (const char* ending : {"", ".inc", ".pov"}) {
      const fs::path path = (folder.empty() ? fs::path() : fs::path(folder)) / (name + ending);
      std::error_code ignored;
      if (fs::is_regular_file(path, ignored)) return path.string();
    }
  }
  return "";
}

TokenFilePtr Parser::take_text(const std::string& shown, std::string text) {
  if (text.size() > bytes_left_) throw LimitReached{"The scene's files are too large."};
  bytes_left_ -= text.size();
  const std::uint32_t file = result_.sources.add(shown, text);
  auto tokens = tokenise(text, file, symbols_, options_.limits.items * 4);
  for (const LexicalError& e : tokens->errors) {
    report({{file, e.line, e.column, 0}, e.message});
  }
  return tokens;
}

TokenFilePtr Parser::load(const std::string& path, const std::string& shown, std::string& why) {
  std::error_code ignored;
  if (!fs::is_regular_file(path, ignored)) {
    why = fs::is_directory(path, ignored) ? "it is a directory" : "there is no such file";
    return nullptr;
  }
  if (fs::file_size(path, ignored) > options_.limits.file_bytes) {
    why = "it is too large";
    return nullptr;
  }
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  if (!in || !(in.peek() == std::ifstream::traits_type::eof() || text << in.rdbuf())) {
    why = "it cannot be read";
    return nullptr;
  }
  return take_text(shown, text.str());
}

TokenFilePtr Parser::file_of(const std::string& name, std::string& why) {
  const std::string path = name.size() < 4096 ? resolve(name) : "";
  why = "Cannot find file '" + name + "', even after trying to append file type extension.";
  const auto known = files_.find(path);
  if (known != files_.end()) return known->second;
  TokenFilePtr tokens = path.empty() ? nullptr : load(path, path, why);
  if (tokens) files_[path] = tokens;
  return tokens;
}

TokenFilePtr Parser::handed_in(const std::string& name, std::string& why) {
  if (!options_.include) return nullptr;
  const std::string key = '\0' + name;  // no path has a zero
  const auto known = files_.find(key);
  if (known != files_.end()) return known->second;
  std::optional<std::string> text = options_.include(name);
  if (text && text->size() > options_.limits.file_bytes) {
    why = "it is too large";
    return nullptr;
  }
  return files_[key] = text ? take_text(name, std::move(*text)) : nullptr;
}

void Parser::include_directive(const Token& token) {
  const std::string name = raw_string();
  int files = 0;
  for (const Frame& f : frames_) files += f.macro ? 0 : 1;
  if (files > options_.limits.include_depth) {
    throw Failure{token.where, "Too many nested include files."};
  }
  std::string why;
  TokenFilePtr tokens = handed_in(name, why);
  if (!tokens && why.empty()) tokens = file_of(name, why);
  if (!tokens) {
    names_unknown_ = true;
    throw Failure{token.where, "Cannot open include file " + name + ".\n" + why};
  }
  push_frame(tokens, 0, static_cast<std::uint32_t>(tokens->lexemes.size() - 1), frame().call, false);
}

}  // namespace nicol::sdl
