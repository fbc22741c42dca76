// Where plugins are found, and by which name. Loading runs code, so only these places count: what is named, NICOL_PLUGIN_PATH,
// folders that the user has given, and nicol's own; never the scene's folder or the working directory unasked.
#pragma once
#include <string>
#include <vector>

#include "host/plugins/library.hpp"

namespace nicol::plugins {

struct Places {
  std::vector<std::string> named;    // --plugin: files (with a '/' or ending in .so), or names to be looked for
  std::vector<std::string> folders;  // in order: those of NICOL_PLUGIN_PATH, +L, nicol's own
};

// `own`: folders that are nicol's own; NICOL_PLUGIN_PATH is read here.
Places places_of(std::vector<std::string> named, const std::vector<std::string>& given, const std::vector<std::string>& own);

class Finder : public PluginSource {
 public:
  explicit Finder(Places places);  // loads nothing yet

  // What is named on the command line is loaded, whether a scene asks for it or not. PluginError.
  void load_named();
  const std::vector<const Library*>& named() const { return named_; }

  const Dispersion& dispersion(const std::string& name) override;
  const Spectrum& spectrum(const std::string& name) override;
  const Solid& solid(const std::string& name) override;

  // Of the named ones; null if there is none. PluginError if two want the same suffix.
  const Importer* importer(const std::string& suffix);
  const Sink* sink(const std::string& suffix);

  // Every .so in the folders beside the named ones, for lists.
  std::vector<std::string> files() const;

 private:
  template <class Kind>
  const Kind& find(const std::string& name, const char* kind, std::vector<Kind> Library::*list);
  template <class Kind>
  const Kind* by_suffix(const std::string& suffix, const char* kind, std::vector<Kind> Library::*list);
  std::string file_of(const std::string& stem) const;  // "" if no folder has it

  Places places_;
  std::vector<const Library*> named_;
  bool named_loaded_ = false;
};

}  // namespace nicol::plugins
