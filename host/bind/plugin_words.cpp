// plugin { "NAME" parameter value ... }: see plugin_words.hpp.
#include "host/bind/plugin_words.hpp"

#include <cmath>
#include <filesystem>
#include <map>

#include "host/bind/schema.hpp"

namespace nicol {

namespace {

using plugins::Parameter;

// Index of the item behind the name; 0 if there is no name.
std::size_t first_parameter(const sdl::Block& block) {
  return !block.items.empty() && block.items[0].string() ? 1 : 0;
}

std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return names;
}

std::string with_unit(double number, const Parameter& parameter) {
  return to_text(number) + (parameter.unit.empty() ? "" : " " + parameter.unit);
}

// "at least 0 K", "between 0 and 10 nm".
std::string range_text(const Parameter& parameter) {
  if (!std::isfinite(parameter.most)) return "at least " + with_unit(parameter.least, parameter);
  if (!std::isfinite(parameter.least)) return "at most " + with_unit(parameter.most, parameter);
  return "between " + to_text(parameter.least) + " and " + with_unit(parameter.most, parameter);
}

// Walks the words and values of one block.
class ParameterReader {
 public:
  ParameterReader(Context& context, const sdl::Block& block, const std::string& name,
                  const std::vector<Parameter>& parameters)
      : context_(context), block_(block), name_(name), parameters_(parameters) {}

  std::optional<plugins::Values> read() {
    const std::size_t errors_before = context_.error_count();
    at_ = first_parameter(block_);
    while (at_ < block_.items.size()) read_one();
    plugins::Values values = collect();
    if (context_.error_count() > errors_before || block_.damaged) return std::nullopt;
    return values;
  }

 private:
  void read_one() {
    const sdl::Item& item = block_.items[at_];
    context_.step(item.where);
    const std::string* word = item.word() ? item.word() : item.string();
    if (!word) {
      context_.error(item.where,
                     "Expected a parameter of plugin '" + name_ + "', " + describe(item) +
                         " found instead; the name of a parameter that the scene has declared as "
                         "something else is written in quotes");
      ++at_;
      return;
    }
    ++at_;
    const Parameter* parameter = find(*word);
    if (!parameter) {
      context_.error(item.where,
                     unknown("parameter", *word, "plugin '" + name_ + "'", names_of(parameters_)));
      skip_value();
    } else if (!said_.emplace(parameter->name, nullptr).second) {
      context_.error(item.where, "'" + *word + "' of plugin '" + name_ + "' is said twice");
      skip_value();
    } else {
      read_value(*parameter);
    }
  }

  const Parameter* find(const std::string& word) const {
    for (const Parameter& parameter : parameters_)
      if (parameter.name == word) return &parameter;
    return nullptr;
  }

  // Whatever may have been meant as the value of a parameter that is not there.
  void skip_value() {
    if (at_ < block_.items.size() && !block_.items[at_].word()) ++at_;
  }

  void read_value(const Parameter& parameter) {
    const bool text = parameter.kind == Parameter::Kind::text;
    const bool at_end = at_ >= block_.items.size();
    const sdl::Item* item = at_end ? nullptr : &block_.items[at_];
    if (at_end || !(text ? item->string() != nullptr : item->number() != nullptr)) {
      context_.error(at_end ? block_.end_where : item->where,
                     std::string("Expected '") + (text ? "string" : "numeric") +
                         " expression' after '" + parameter.name + "', " +
                         (at_end ? "} of 'plugin'" : describe(*item)) + " found instead");
      return skip_value();
    }
    ++at_;
    if (!text && !within(parameter, *item->number(), item->where)) return;
    said_[parameter.name] = item;
  }

  bool within(const Parameter& parameter, double number, Location where) {
    if (!std::isfinite(number)) {
      context_.error(where, "this number is not finite");
      return false;
    }
    if (number >= parameter.least && number <= parameter.most) return true;
    context_.error(where, "'" + parameter.name + "' of plugin '" + name_ + "' is " +
                              range_text(parameter) + ", " + to_text(number) + " found instead");
    return false;
  }

  plugins::Values collect() {
    plugins::Values values;
    for (const Parameter& parameter : parameters_) {
      const auto said = said_.find(parameter.name);
      const sdl::Item* item = said == said_.end() ? nullptr : said->second;
      const bool text = parameter.kind == Parameter::Kind::text;
      if (item && text) values.texts.push_back(*item->string());
      else if (item) values.numbers.push_back(*item->number());
      else if (text && parameter.text) values.texts.push_back(*parameter.text);
      else if (!text && parameter.number) values.numbers.push_back(*parameter.number);
      else if (said == said_.end() && !block_.damaged)
        context_.error(block_.end_where, "plugin '" + name_ + "' needs '" + parameter.name + "'" +
                                             (parameter.meaning.empty() ? "" : ": ") +
                                             parameter.meaning);
    }
    return values;
  }

  Context& context_;
  const sdl::Block& block_;
  const std::string& name_;
  const std::vector<Parameter>& parameters_;
  std::size_t at_ = 0;
  std::map<std::string, const sdl::Item*> said_;  // null: its value was wrong, and that was told
};

}  // namespace

std::optional<std::string> plugin_name(Context& context, const sdl::Block& block) {
  if (first_parameter(block) && !block.items[0].string()->empty()) return *block.items[0].string();
  if (!block.damaged)
    context.error(block.items.empty() ? block.end_where : block.items[0].where,
                  "Expected the name of a plugin in quotes, " +
                      (block.items.empty()        ? std::string("} of 'plugin'")
                       : first_parameter(block) ? "an empty string"
                                                : describe(block.items[0])) +
                      " found instead");
  return std::nullopt;
}

std::optional<plugins::Values> read_parameters(Context& context, const sdl::Block& block,
                                               const std::string& name,
                                               const std::vector<Parameter>& parameters) {
  return ParameterReader(context, block, name, parameters).read();
}

std::string find_file(const Context& context, const std::string& name) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (name.empty() || name.size() > 4096) return "";
  std::vector<fs::path> folders{""};
  if (fs::path(name).is_relative()) {
    for (const std::string& folder : context.options.library_paths) folders.push_back(folder);
    folders.push_back(fs::path(context.options.path).parent_path());
  }
  for (const fs::path& folder : folders) {
    if (!fs::is_regular_file(folder / name, ignored)) continue;
    const std::string path = (folder / name).string();
    if (context.options.files_read) context.options.files_read->push_back(path);
    return path;
  }
  return "";
}

}  // namespace nicol
