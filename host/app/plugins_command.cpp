// `nicol plugins`: what is found, and what it takes. Loads what it lists.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <set>

#include "host/app/commands.hpp"
#include "host/engine/plugins.hpp"

namespace nicol::app {
namespace {

std::string text_of(const plugins::Parameter& parameter) {
  const bool number = parameter.kind == plugins::Parameter::Kind::number;
  std::string text = fmt::format("    {} {}", parameter.name, number ? "number" : "\"text\"");
  if (!parameter.unit.empty()) text += fmt::format(", {}", parameter.unit);
  if (parameter.number) text += fmt::format(", default {:g}", *parameter.number);
  if (parameter.text) text += fmt::format(", default \"{}\"", *parameter.text);
  if (std::isfinite(parameter.least)) text += fmt::format(", from {:g}", parameter.least);
  if (std::isfinite(parameter.most)) text += fmt::format(" to {:g}", parameter.most);
  if (!parameter.number && !parameter.text) text += ", must be said";
  return text + (parameter.meaning.empty() ? "\n" : fmt::format(": {}\n", parameter.meaning));
}

template <class Entries>
void tell(const Entries& entries, const char* kind) {
  for (const auto& entry : entries) {
    fmt::print("  {} {}{}\n", kind, entry.name, entry.meaning.empty() ? "" : ": " + entry.meaning);
    for (const plugins::Parameter& parameter : entry.parameters) fmt::print("{}", text_of(parameter));
  }
}

void tell(const plugins::Library& library) {
  fmt::print("{}\n", library.path);
  tell(library.dispersions, "dispersion formula");
  tell(library.spectra, "spectrum");
  tell(library.solids, "solid");
  for (const plugins::Importer& importer : library.importers)
    fmt::print("  importer {} for {}{}\n", importer.name, importer.suffix, importer.meaning.empty() ? "" : ": " + importer.meaning);
  for (const plugins::Sink& sink : library.sinks)
    fmt::print("  sink {} for {}{}\n", sink.name, sink.suffix, sink.meaning.empty() ? "" : ": " + sink.meaning);
}

void tell(const std::string& file, const Manifest& manifest) {
  const Fragment& fragment = *manifest.fragment;
  fmt::print("{}\n  {} {}: {}\n", file, fragment.kind == Fragment::Kind::element ? "polarizing element" : "surface", fragment.name,
             fragment.meaning);
  for (const plugins::Parameter& parameter : manifest.parameters) fmt::print("{}", text_of(parameter));
}

void tell_fault(const std::string& fault, int& code) {
  fmt::print(stderr, "nicol: {}\n", fault);
  code = exit_error;
}

}  // namespace

int plugins_command(const SceneOptions& options) {
  plugins::Finder finder = plugin_finder(options);
  int code = exit_done;
  std::set<const plugins::Library*> told;
  const auto tell_once = [&](const plugins::Library& library) {
    if (told.insert(&library).second) tell(library);
  };
  try {
    finder.load_named();
    for (const plugins::Library* library : finder.named()) tell_once(*library);
  } catch (const plugins::PluginError& error) {
    tell_fault(error.what(), code);
  }
  for (const std::string& file : finder.files()) {
    try {
      tell_once(plugins::load_library(file));
    } catch (const plugins::PluginError& error) {
      tell_fault(error.what(), code);
    }
  }
  const FoundFragments fragments = find_fragments(options);
  for (const auto& [file, manifest] : fragments.manifests) tell(file, manifest);
  for (const std::string& fault : fragments.faults) tell_fault(fault, code);
  if (told.empty() && fragments.manifests.empty() && code == exit_done) fmt::print("no plugins are found\n");
  return code;
}

}  // namespace nicol::app
