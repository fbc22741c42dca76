// See povray_switches.hpp. POV-Ray 3.7 reference, section 2.2 (command-line and INI options).
#include "host/app/povray_switches.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <utility>

#include "host/app/commands.hpp"

namespace nicol::app {
namespace {

struct Rule {
  std::string_view povray;
  std::string_view nicol;  // the option that takes the rest of the argument
};
constexpr std::array<Rule, 5> switches{
    {{"i", "--input"}, {"o", "--output"}, {"w", "--width"}, {"h", "--height"}, {"l", "--library"}}};
// Of a number, the longer names first.
constexpr std::array<Rule, 13> number_switches{{{"kfi", "--initial-frame"}, {"kff", "--final-frame"},
                                                {"ki", "--initial-clock"},  {"kf", "--final-clock"},
                                                {"k", "--clock"},           {"sf", "--subset-start"},
                                                {"ef", "--subset-end"},     {"sr", "--start-row"},
                                                {"er", "--end-row"},        {"sc", "--start-column"},
                                                {"ec", "--end-column"},     {"s", "--start-row"},
                                                {"e", "--end-row"}}};
constexpr std::array<Rule, 18> settings{{{"input_file_name", "--input"},
                                        {"output_file_name", "--output"},
                                        {"width", "--width"},
                                        {"height", "--height"},
                                        {"library_path", "--library"},
                                        {"declare", "--declare"},
                                        {"clock", "--clock"},
                                        {"initial_frame", "--initial-frame"},
                                        {"final_frame", "--final-frame"},
                                        {"initial_clock", "--initial-clock"},
                                        {"final_clock", "--final-clock"},
                                        {"subset_start_frame", "--subset-start"},
                                        {"subset_end_frame", "--subset-end"},
                                        {"start_row", "--start-row"},
                                        {"end_row", "--end-row"},
                                        {"start_column", "--start-column"},
                                        {"end_column", "--end-column"},
                                        {"bits_per_color", ""}}};
// Anti-aliasing, quality, display, threads, console: their first letters.
constexpr std::string_view ignorable = "aqdpvgfjrmubx";

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return result;
}

// +W640, +Iscene.pov. Two letters that begin with one of ours (+WT, +HI, +SC) are not ours.
bool translate_switch(const std::string& argument, std::vector<std::string>& out) {
  const std::string name = lower(argument.substr(1, 1));
  const std::string value = argument.substr(std::min<std::size_t>(2, argument.size()));
  for (const Rule& rule : switches) {
    if (name != rule.povray) continue;
    const bool wants_number = rule.nicol == "--width" || rule.nicol == "--height";
    if (wants_number && (value.empty() || !std::isdigit(static_cast<unsigned char>(value[0]))))
      return false;
    if (value.empty())
      throw UsageError(fmt::format("{} needs its value attached, as in +Iscene.pov", argument));
    out.insert(out.end(), {std::string(rule.nicol), value});
    return true;
  }
  return false;
}

// +KFF100, +SR0.5: the letters, then a number. In one word, as it may begin with a minus.
bool translate_number(const std::string& argument, std::vector<std::string>& out) {
  const std::string name = lower(argument.substr(1));
  for (const Rule& rule : number_switches) {
    const std::string value = name.rfind(rule.povray, 0) == 0 ? name.substr(rule.povray.size()) : "";
    if (value.empty() || value.find_first_not_of("0123456789.-+e") != std::string::npos || value[0] == 'e') continue;
    out.push_back(std::string(rule.nicol) + "=" + value);
    return true;
  }
  return false;
}

bool translate_setting(const std::string& argument, std::vector<std::string>& out,
                       std::vector<std::string>& ignored) {
  const std::size_t equals = argument.find('=');
  const std::string name = lower(argument.substr(0, equals));
  for (const Rule& rule : settings) {
    if (name != rule.povray) continue;
    if (rule.nicol.empty())
      ignored.push_back(argument);
    else if (const std::string value = argument.substr(equals + 1); value.rfind('-', 0) == 0)
      out.push_back(std::string(rule.nicol) + "=" + value);
    else
      out.insert(out.end(), {std::string(rule.nicol), value});
    return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> translate_povray_switches(const std::vector<std::string>& arguments,
                                                   std::vector<std::string>& ignored) {
  std::vector<std::string> out;
  bool declared = false;   // what follows --declare is its value, whatever it looks like
  for (const std::string& argument : arguments) {
    if (std::exchange(declared, argument == "--declare")) {
      out.push_back(argument);
      continue;
    }
    const bool plus = argument.size() > 1 && argument[0] == '+';
    if (lower(argument) == "+c" || lower(argument) == "continue_trace=on") {
      out.push_back("--continue");
      continue;
    }
    if (lower(argument) == "+kc" || lower(argument) == "cyclic_animation=on") {
      out.push_back("--cyclic");
      continue;
    }
    if (plus && (translate_switch(argument, out) || translate_number(argument, out))) continue;
    const std::string name = lower(argument.substr(0, std::min<std::size_t>(3, argument.size())));
    const bool mosaic = name == "+sp" || name == "+ep";  // of a display
    if (plus && (ignorable.find(name[1]) != std::string_view::npos || name == "+wt" || mosaic)) {
      ignored.push_back(argument);
      continue;
    }
    if (plus)
      throw UsageError(
          fmt::format("the POV-Ray switch {} is not obeyed by nicol, which takes +I +O +W +H +L +C, "
                      "+SR +ER +SC +EC, +KFI +KFF +KI +KF +KC +SF +EF +K and Declare=name=value",
                      argument));
    const bool setting = !argument.empty() &&
                         std::isalpha(static_cast<unsigned char>(argument[0])) &&
                         argument.find('=') != std::string::npos;
    if (setting && translate_setting(argument, out, ignored)) continue;
    out.push_back(argument);
  }
  return out;
}

}  // namespace nicol::app
