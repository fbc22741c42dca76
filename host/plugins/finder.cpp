// See finder.hpp.
#include "host/plugins/finder.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

namespace nicol::plugins {

namespace {

namespace fs = std::filesystem;

bool is_file_name(const std::string& text) {
  return text.find('/') != std::string::npos || fs::path(text).extension() == ".so";
}

// Letters, digits, _, - and . (not at the front): nothing that leads out of a folder.
bool is_stem(const std::string& text) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' || c == '.';
  };
  return !text.empty() && text.size() <= 200 && text[0] != '.' && std::all_of(text.begin(), text.end(), fits);
}

std::string joined(const std::vector<std::string>& list, const std::string& none) {
  std::string text;
  for (const std::string& part : list) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? none : text;
}

template <class Kind>
const Kind* entry_named(const std::vector<Kind>& list, const std::string& name) {
  for (const Kind& entry : list)
    if (entry.name == name) return &entry;
  return nullptr;
}

template <class Kind>
std::string names_in(const std::vector<Kind>& list) {
  std::vector<std::string> names;
  for (const Kind& entry : list) names.push_back("'" + entry.name + "'");
  return joined(names, "none");
}

}  // namespace

Places places_of(std::vector<std::string> named, const std::vector<std::string>& given, const std::vector<std::string>& own) {
  Places places;
  places.named = std::move(named);
  const char* variable = std::getenv("NICOL_PLUGIN_PATH");
  std::string list = variable ? variable : "";
  for (std::size_t from = 0; from < list.size();) {
    const std::size_t to = std::min(list.find(':', from), list.size());
    if (to > from) places.folders.push_back(list.substr(from, to - from));
    from = to + 1;
  }
  places.folders.insert(places.folders.end(), given.begin(), given.end());
  places.folders.insert(places.folders.end(), own.begin(), own.end());
  return places;
}

Finder::Finder(Places places) : places_(std::move(places)) {}

std::string Finder::file_of(const std::string& stem) const {
  std::error_code ignored;
  if (!is_stem(stem)) return "";
  for (const std::string& folder : places_.folders) {
    const fs::path file = fs::path(folder) / (stem + ".so");
    if (fs::is_regular_file(file, ignored)) return file.string();
  }
  return "";
}

void Finder::load_named() {
  if (named_loaded_) return;
  std::vector<const Library*> loaded;
  for (const std::string& name : places_.named) {
    const std::string file = is_file_name(name) ? name : file_of(name);
    if (file.empty())
      throw PluginError("plugin '" + name + "' is not found: there is no " + name + ".so in " + joined(places_.folders, "any folder"));
    std::error_code ignored;
    if (!fs::exists(file, ignored)) throw PluginError("plugin " + file + ": there is no such file");
    loaded.push_back(&load_library(file));
  }
  named_ = std::move(loaded);
  named_loaded_ = true;
}

template <class Kind>
const Kind& Finder::find(const std::string& name, const char* kind, std::vector<Kind> Library::*list) {
  load_named();
  const std::size_t slash = name.find('/');
  const std::string file = slash == std::string::npos ? "" : name.substr(0, slash);
  const std::string entry = slash == std::string::npos ? name : name.substr(slash + 1);
  const Kind* found = nullptr;
  for (const Library* library : named_) {
    if (!file.empty() && stem_of(library->path) != file) continue;
    const Kind* here = entry_named(library->*list, entry);
    if (here && found && here != found)
      throw PluginError("two plugins have a " + std::string(kind) + " '" + name + "': say '" + stem_of(found->file) + "/" + entry +
                        "' or '" + stem_of(here->file) + "/" + entry + "'");
    if (here) found = here;
  }
  if (found) return *found;
  const std::string stem = file.empty() ? entry : file;
  const std::string path = file_of(stem);
  if (path.empty())
    throw PluginError("plugin '" + name + "' is not found: " + (named_.empty() ? "" : "none that is named has this " + std::string(kind) + ", and ") +
                      "there is no " + stem + ".so in " + joined(places_.folders, "any folder"));
  const Library& library = load_library(path);
  if (const Kind* here = entry_named(library.*list, entry)) return *here;
  throw PluginError("plugin " + library.path + " has no " + kind + " '" + entry + "' (it has: " + names_in(library.*list) + ")");
}

const Dispersion& Finder::dispersion(const std::string& name) {
  return find(name, "dispersion formula", &Library::dispersions);
}
const Spectrum& Finder::spectrum(const std::string& name) { return find(name, "spectrum", &Library::spectra); }
const Solid& Finder::solid(const std::string& name) { return find(name, "solid", &Library::solids); }

template <class Kind>
const Kind* Finder::by_suffix(const std::string& suffix, const char* kind, std::vector<Kind> Library::*list) {
  load_named();
  const Kind* found = nullptr;
  for (const Library* library : named_)
    for (const Kind& entry : library->*list) {
      if (entry.suffix != suffix || &entry == found) continue;
      if (found)
        throw PluginError("two plugins have a " + std::string(kind) + " for " + suffix + ": '" + stem_of(found->file) + "/" + found->name +
                          "' and '" + stem_of(entry.file) + "/" + entry.name + "'; name one of them");
      found = &entry;
    }
  return found;
}

const Importer* Finder::importer(const std::string& suffix) { return by_suffix(suffix, "importer", &Library::importers); }
const Sink* Finder::sink(const std::string& suffix) { return by_suffix(suffix, "sink", &Library::sinks); }

std::vector<std::string> Finder::files() const {
  std::vector<std::string> found;
  for (const std::string& folder : places_.folders) {
    std::error_code failed;
    std::vector<std::string> here;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, failed))
      if (entry.path().extension() == ".so") here.push_back(entry.path().string());
    std::sort(here.begin(), here.end());
    found.insert(found.end(), here.begin(), here.end());
  }
  return found;
}

}  // namespace nicol::plugins
