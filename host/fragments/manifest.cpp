#include "host/fragments/manifest.hpp"

#include "host/fragments/source_text.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <sstream>

namespace nicol {
namespace {

using nlohmann::json;

constexpr int interface_version = 1;
constexpr std::size_t most_bytes = 1u << 20, most_parameters = 64;

std::optional<std::string> text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.gcount() == 0 && !in.eof()) return std::nullopt;
  text.resize(static_cast<std::size_t>(in.gcount()));
  return text;
}

bool is_identifier(const std::string& name) {
  const auto letter = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  return !name.empty() && name.size() <= 60 && std::isdigit(static_cast<unsigned char>(name[0])) == 0 &&
         std::all_of(name.begin(), name.end(), letter);
}

class Reader {
 public:
  explicit Reader(std::string file) : file_(std::move(file)) {
    const auto text = text_of(file_);
    if (!text) throw ManifestError(file_ + ": cannot be read");
    if (text->size() > most_bytes) throw ManifestError(file_ + ": too large for a manifest");
    text_ = *text;
    try {
      root_ = json::parse(text_);
    } catch (const json::parse_error& error) {
      fail_at(error.byte > 0 ? error.byte - 1 : 0, std::string("this is not JSON: ") + words_of(error));
    }
    if (!root_.is_object()) fail_at(0, "a manifest is an object { }");
  }

  Manifest read() {
    known(root_, {"name", "version", "nicol", "kind", "meaning", "source", "parameters", "needs", "reciprocal", "lossless"},
          "a manifest");
    auto fragment = std::make_shared<Fragment>();
    Fragment& f = *fragment;
    f.name = string_at(root_, "name", true);
    if (!is_identifier(f.name)) fail("name", "'" + f.name + "' is no name of a function: letters, digits, _");
    const std::string stem = file_.substr(file_.rfind('/') + 1, file_.size() - file_.rfind('/') - 1 - std::string(".json").size());
    if (f.name != stem) fail("name", "'name' is '" + f.name + "', but the manifest's file is '" + stem + ".json': the same name is expected");
    f.version = string_at(root_, "version", true);
    check_interface();
    f.meaning = string_at(root_, "meaning", true);
    f.source = string_at(root_, "source", false);
    read_kind(f);
    read_needs(f);
    f.reciprocal = bool_at("reciprocal", true);
    f.lossless = bool_at("lossless", false);
    if (f.kind == Fragment::Kind::surface && !f.reciprocal)
      fail("reciprocal", "a surface is reciprocal: its t is used both ways");
    Manifest manifest;
    read_parameters(manifest.parameters);
    for (const plugins::Parameter& parameter : manifest.parameters) f.parameters.push_back(parameter.name);
    read_source(f);
    manifest.fragment = std::move(fragment);
    return manifest;
  }

 private:
  // What nlohmann's message says after its own place.
  static std::string words_of(const json::parse_error& error) {
    const std::string text = error.what();
    const std::size_t at = text.find("column ");
    const std::size_t colon = at == std::string::npos ? at : text.find(": ", at);
    return colon == std::string::npos ? text : text.substr(colon + 2);
  }

  [[noreturn]] void fail_at(std::size_t byte, const std::string& message) const {
    byte = std::min(byte, text_.size());
    const auto end = text_.begin() + static_cast<std::ptrdiff_t>(byte);
    const auto line = 1 + std::count(text_.begin(), end, '\n');
    const std::size_t before = byte == 0 ? std::string::npos : text_.rfind('\n', byte - 1);
    const std::size_t column = before == std::string::npos ? byte + 1 : byte - before;
    throw ManifestError(file_ + ":" + std::to_string(line) + ":" + std::to_string(column) + ": " + message);
  }
  // At the first place where the key stands.
  [[noreturn]] void fail(const std::string& key, const std::string& message) const {
    const std::size_t at = text_.find("\"" + key + "\"", from_);
    fail_at(at == std::string::npos ? from_ : at, message);
  }

  // Where object `index` of the list behind the key begins.
  std::size_t object_at(const std::string& key, std::size_t index) const {
    int depth = 0;
    for (std::size_t at = text_.find("\"" + key + "\"") + key.size() + 2; at < text_.size(); ++at) {
      if (text_[at] == '"')
        for (++at; at < text_.size() && text_[at] != '"'; ++at) at += text_[at] == '\\';
      else if (text_[at] == '{' && depth++ == 0 && index-- == 0) return at;
      else if (text_[at] == '}') --depth;
    }
    return 0;
  }

  void known(const json& object, const std::set<std::string>& keys, const std::string& of) const {
    for (const auto& [key, value] : object.items())
      if (keys.count(key) == 0) fail(key, "'" + key + "' is no key of " + of);
  }
  std::string string_at(const json& object, const std::string& key, bool needed, const std::string& of = "") const {
    if (!object.contains(key)) {
      if (needed) fail_at(from_, "'" + key + "' is missing" + of);
      return "";
    }
    if (!object.at(key).is_string()) fail(key, "'" + key + "' is a text");
    return object.at(key).get<std::string>();
  }
  bool bool_at(const std::string& key, bool otherwise) const {
    if (!root_.contains(key)) return otherwise;
    if (!root_.at(key).is_boolean()) fail(key, "'" + key + "' is true or false");
    return root_.at(key).get<bool>();
  }

  void check_interface() const {
    if (!root_.contains("nicol")) fail_at(0, "'nicol' is missing: the version of the fragments' interface, 1");
    if (root_.at("nicol") != interface_version)
      fail("nicol", "written for version " + root_.at("nicol").dump() + " of the fragments' interface; this is version " +
                        std::to_string(interface_version));
  }

  void read_kind(Fragment& f) const {
    const std::string kind = string_at(root_, "kind", true);
    if (kind != "element" && kind != "surface") fail("kind", "'kind' is \"element\" or \"surface\", not \"" + kind + "\"");
    f.kind = kind == "element" ? Fragment::Kind::element : Fragment::Kind::surface;
  }

  void read_needs(Fragment& f) const {
    if (!root_.contains("needs")) return;
    if (!root_.at("needs").is_array()) fail("needs", "'needs' is a list of texts");
    for (const json& need : root_.at("needs")) {
      if (need == "reflection" && f.kind == Fragment::Kind::element) f.reflects = true;
      else if (need == "fp64") f.needs_fp64 = true;
      else fail("needs", need.dump() + " is nothing that a fragment of this kind can need");
    }
  }

  double number_at(const json& object, const std::string& key, double otherwise) const {
    if (!object.contains(key)) return otherwise;
    if (!object.at(key).is_number()) fail(key, "'" + key + "' is a number");
    return object.at(key).get<double>();
  }

  void read_parameters(std::vector<plugins::Parameter>& list) {
    if (!root_.contains("parameters")) return;
    const json& parameters = root_.at("parameters");
    if (!parameters.is_array()) fail("parameters", "'parameters' is a list");
    if (parameters.size() > most_parameters) fail("parameters", "more than " + std::to_string(most_parameters) + " parameters");
    std::set<std::string> names;
    for (const json& item : parameters)
      if (!item.is_object()) fail("parameters", "a parameter is an object { }");
    for (const json& item : parameters) {
      from_ = object_at("parameters", list.size());
      known(item, {"name", "unit", "default", "min", "max", "meaning"}, "a parameter");
      plugins::Parameter p;
      p.name = string_at(item, "name", true, " in a parameter");
      if (!is_identifier(p.name)) fail(p.name, "'" + p.name + "' is no name of a parameter: letters, digits, _");
      if (!names.insert(p.name).second) fail(p.name, "the parameter '" + p.name + "' stands here twice");
      p.unit = string_at(item, "unit", false);
      p.meaning = string_at(item, "meaning", true, " in the parameter '" + p.name + "'");
      p.least = number_at(item, "min", p.least);
      p.most = number_at(item, "max", p.most);
      if (item.contains("default")) p.number = number_at(item, "default", 0);
      if (p.least > p.most || (p.number && (*p.number < p.least || *p.number > p.most)))
        fail(p.name, "'min', 'default' and 'max' of '" + p.name + "' must ascend");
      list.push_back(std::move(p));
    }
    from_ = 0;
  }

  void read_source(Fragment& f) const {
    const std::size_t dot = file_.rfind(".json");
    f.file = file_.substr(0, dot) + ".cl";
    const auto text = text_of(f.file);
    if (!text) throw ManifestError(file_ + ": its OpenCL C '" + f.file + "' cannot be read");
    if (text->size() > most_bytes) throw ManifestError(f.file + ": too large for a fragment");
    f.text = *text;
    std::istringstream lines(f.text);
    std::string line;
    for (int number = 1; std::getline(lines, line); ++number) {
      const std::size_t hash = line.find_first_not_of(" \t");
      if (hash == std::string::npos || line[hash] != '#') continue;
      const std::size_t word = line.find_first_not_of(" \t", hash + 1);
      if (word != std::string::npos && line.compare(word, 7, "include") == 0)
        throw ManifestError(f.file + ":" + std::to_string(number) +
                            ": a fragment includes nothing: kernels/fragment.h and what that includes is there");
    }
    check_source(f);
  }

  void check_source(const Fragment& f) const {
    const SourceText source = scan_source(f.text);
    const auto told = [&](const NamedLine& at, const std::string& what) {
      throw ManifestError(f.file + ":" + std::to_string(at.line) + ": '" + at.name + "' " + what);
    };
    if (source.words.count(f.name) == 0) fail("name", f.file + " has no function '" + f.name + "'");
    if (const auto at = find_recursion(source)) told(*at, "calls itself: OpenCL C has no recursion");
    if (const auto at = find_foreign_name(source, f.name))
      told(*at, "must begin with '" + f.name + "', as all names that a fragment defines: other fragments of a scene have names, too");
  }

  std::string file_, text_;
  json root_;
  std::size_t from_ = 0;   // where keys are looked for: the beginning of the parameter at hand
};

}  // namespace

Manifest read_manifest(const std::string& json_file) {
  try {
    return Reader(json_file).read();
  } catch (const json::exception& error) {
    throw ManifestError(json_file + ": " + error.what());
  }
}

}  // namespace nicol
