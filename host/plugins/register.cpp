// What a plugin registers, checked, copied, and wrapped into functions that throw PluginError.
#include <algorithm>
#include <cmath>
#include <set>

#include "host/plugins/host_call.hpp"

namespace nicol::plugins {

namespace {

using Purpose = HostCall::Purpose;

constexpr std::size_t most_parameters = 1000;

struct Wrong {
  std::string what;
};

bool is_name(const std::string& text) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto fits = [&](char c) { return letter(c) || (c >= '0' && c <= '9'); };
  return !text.empty() && text.size() <= 64 && letter(text[0]) && std::all_of(text.begin(), text.end(), fits);
}

std::string text_or_empty(const char* text) { return text ? text : ""; }

// A struct may be longer than this version's if it has only zeros there.
template <class Struct>
void check_size(const Struct& given, const std::string& what) {
  constexpr std::size_t longest = 4096;
  const std::size_t size = given.struct_size;
  const auto* bytes = reinterpret_cast<const unsigned char*>(&given);
  const bool fits = size >= sizeof given && size <= longest &&
                    std::all_of(bytes + sizeof given, bytes + size, [](unsigned char byte) { return byte == 0; });
  if (!fits)
    throw Wrong{what + " with a struct_size of " + std::to_string(size) + ", not " + std::to_string(sizeof given) +
                ": made for another version of nicol_plugin.h"};
}

Parameter parameter_of(const nicol_parameter_v1& given, const std::string& owner) {
  Parameter made;
  made.name = text_or_empty(given.name);
  const std::string what = owner + " with a parameter '" + made.name + "'";
  if (!is_name(made.name)) throw Wrong{what + ", which is no name (letters, digits and _)"};
  made.unit = text_or_empty(given.unit);
  made.meaning = text_or_empty(given.meaning);
  if (given.kind == NICOL_PARAMETER_TEXT) made.kind = Parameter::Kind::text;
  else if (given.kind != NICOL_PARAMETER_NUMBER) throw Wrong{what + " of the unknown kind " + std::to_string(given.kind)};
  const bool number = made.kind == Parameter::Kind::number;
  if (given.has_bounds && number) {
    made.least = given.least;
    made.most = given.most;
    if (!(made.least <= made.most)) throw Wrong{what + " whose bounds hold nothing"};
  }
  if (!given.has_default) return made;
  if (!number) made.text = text_or_empty(given.default_text);
  else if (given.default_number >= made.least && given.default_number <= made.most) made.number = given.default_number;
  else throw Wrong{what + " whose default lies out of its bounds"};
  return made;
}

template <class Given>
Entry entry_of(const HostCall& call, const Given* given, const std::string& kind, bool callback) {
  if (!given) throw Wrong{"a " + kind + " that is NULL"};
  check_size(*given, "a " + kind);
  Entry made;
  made.name = text_or_empty(given->name);
  made.meaning = text_or_empty(given->meaning);
  made.file = call.object->path;
  if (!is_name(made.name)) throw Wrong{"a " + kind + " '" + made.name + "', which is no name (letters, digits and _)"};
  if (!callback) throw Wrong{kind + " '" + made.name + "' without its function"};
  return made;
}

template <class Given>
void add_parameters(Entry& made, const Given& given, const std::string& kind) {
  const std::string what = kind + " '" + made.name + "'";
  if (given.parameter_count > most_parameters || (given.parameter_count > 0 && !given.parameters))
    throw Wrong{what + " without the parameters that it counts"};
  std::set<std::string> names;
  for (std::size_t i = 0; i < given.parameter_count; ++i) {
    check_size(given.parameters[i], what + " with a parameter");
    made.parameters.push_back(parameter_of(given.parameters[i], what));
    if (!names.insert(made.parameters.back().name).second)
      throw Wrong{what + " with two parameters '" + made.parameters.back().name + "'"};
  }
}

template <class Given>
std::string suffix_of(const Given& given, const std::string& kind) {
  const std::string suffix = text_or_empty(given.suffix);
  const auto fits = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; };
  if (suffix.size() < 2 || suffix.size() > 32 || suffix[0] != '.' || !std::all_of(suffix.begin() + 1, suffix.end(), fits))
    throw Wrong{kind + " '" + text_or_empty(given.name) + "' for the suffix '" + suffix + "', which is none (lower case, with its dot)"};
  return suffix;
}

template <class Made>
void keep(std::vector<Made>& list, Made made, const std::string& kind) {
  for (const Made& other : list)
    if (other.name == made.name) throw Wrong{kind + " '" + made.name + "' twice"};
  list.push_back(std::move(made));
}

// Values as the plugin sees them.
struct GivenValues {
  std::vector<const char*> texts;
  nicol_values_v1 values{};
  explicit GivenValues(const Values& of) {
    for (const std::string& text : of.texts) texts.push_back(text.c_str());
    values.struct_size = sizeof values;
    values.number_count = static_cast<std::uint32_t>(of.numbers.size());
    values.numbers = of.numbers.data();
    values.text_count = static_cast<std::uint32_t>(texts.size());
    values.texts = texts.data();
  }
};

std::string number_text(double number) {
  char text[40];
  std::snprintf(text, sizeof text, "%.10g", number);
  return text;
}

[[noreturn]] void wrong_value(const std::string& path, const std::string& what, double value, double lambda_nm,
                              const std::string& must) {
  throw PluginError("plugin " + path + ": " + what + " " + number_text(value) + " at " + number_text(lambda_nm) + " nm; " + must);
}

template <class Body>
int registered(HostCall& call, const Body& body) {
  try {
    body();
    return NICOL_PLUGIN_OK;
  } catch (const Wrong& wrong) {
    if (call.wrong.empty()) call.wrong = wrong.what;
    return NICOL_PLUGIN_REFUSED;
  }
}

}  // namespace

int add_entry(HostCall& call, const nicol_dispersion_v1* given) {
  return registered(call, [&] {
    Dispersion made;
    static_cast<Entry&>(made) = entry_of(call, given, "dispersion formula", given && given->index);
    add_parameters(made, *given, "dispersion formula");
    made.at = [shared = call.object, f = given->index, user = given->user, safe = (given->flags & NICOL_PLUGIN_THREAD_SAFE) != 0,
               what = "dispersion formula '" + made.name + "'"](const Values& values, double lambda_nm) {
      HostCall now(Purpose::value);
      const GivenValues asked(values);
      Dispersion::Index index{std::nan(""), 0};
      now.run(*shared, safe, what, [&](const nicol_host_v1* host) {
        return f(user, host, &asked.values, lambda_nm, &index.n, &index.k);
      });
      if (!(index.n > 0) || !std::isfinite(index.n))
        wrong_value(shared->path, what + " gives the refractive index", index.n, lambda_nm, "it must be finite and above 0");
      if (!(index.k >= 0) || !std::isfinite(index.k))
        wrong_value(shared->path, what + " gives the extinction coefficient", index.k, lambda_nm, "it must be finite and not below 0");
      return index;
    };
    keep(call.library->dispersions, std::move(made), "dispersion formula");
  });
}

int add_entry(HostCall& call, const nicol_spectrum_v1* given) {
  return registered(call, [&] {
    Spectrum made;
    static_cast<Entry&>(made) = entry_of(call, given, "spectrum", given && given->radiance);
    add_parameters(made, *given, "spectrum");
    made.radiance = [shared = call.object, f = given->radiance, user = given->user,
                     safe = (given->flags & NICOL_PLUGIN_THREAD_SAFE) != 0,
                     what = "spectrum '" + made.name + "'"](const Values& values, double lambda_nm) {
      HostCall now(Purpose::value);
      const GivenValues asked(values);
      double radiance = std::nan("");
      now.run(*shared, safe, what,
              [&](const nicol_host_v1* host) { return f(user, host, &asked.values, lambda_nm, &radiance); });
      if (!(radiance >= 0) || !std::isfinite(radiance))
        wrong_value(shared->path, what + " gives the radiance", radiance, lambda_nm, "it must be finite and not below 0");
      return radiance;
    };
    keep(call.library->spectra, std::move(made), "spectrum");
  });
}

int add_entry(HostCall& call, const nicol_solid_v1* given) {
  return registered(call, [&] {
    Solid made;
    static_cast<Entry&>(made) = entry_of(call, given, "solid", given && given->make);
    add_parameters(made, *given, "solid");
    made.make = [shared = call.object, f = given->make, user = given->user, safe = (given->flags & NICOL_PLUGIN_THREAD_SAFE) != 0,
                 what = "solid '" + made.name + "'"](const Values& values, const FindFile& find_file) -> SolidShape {
      HostCall now(Purpose::solid);
      now.find_file = find_file;
      const GivenValues asked(values);
      now.run(*shared, safe, what, [&](const nicol_host_v1* host) { return f(user, host, &asked.values); });
      const bool planes = !now.convex.faces.empty(), mesh = !now.mesh.points.empty() || !now.mesh.faces.empty();
      if (planes == mesh)
        throw PluginError("plugin " + shared->path + ": " + what + (planes ? " has planes and a mesh; one of them" : " has neither planes nor a mesh"));
      if (planes) return std::move(now.convex);
      return std::move(now.mesh);
    };
    keep(call.library->solids, std::move(made), "solid");
  });
}

int add_entry(HostCall& call, const nicol_importer_v1* given) {
  return registered(call, [&] {
    Importer made;
    static_cast<Entry&>(made) = entry_of(call, given, "importer", given && given->read);
    made.suffix = suffix_of(*given, "importer");
    made.read = [shared = call.object, f = given->read, user = given->user, safe = (given->flags & NICOL_PLUGIN_THREAD_SAFE) != 0,
                 what = "importer '" + made.name + "'"](const std::string& path) {
      HostCall now(Purpose::importer);
      now.run(*shared, safe, what, [&](const nicol_host_v1* host) { return f(user, host, path.c_str()); });
      return std::move(now.text);
    };
    keep(call.library->importers, std::move(made), "importer");
  });
}

int add_entry(HostCall& call, const nicol_sink_v1* given) {
  return registered(call, [&] {
    Sink made;
    static_cast<Entry&>(made) = entry_of(call, given, "sink", given && given->write);
    made.suffix = suffix_of(*given, "sink");
    if (made.suffix == ".exr" || made.suffix == ".png")
      throw Wrong{"sink '" + made.name + "' for " + made.suffix + ", which nicol writes itself"};
    made.write = [shared = call.object, f = given->write, user = given->user, safe = (given->flags & NICOL_PLUGIN_THREAD_SAFE) != 0,
                  what = "sink '" + made.name + "'"](const nicol_picture_v1& picture, const std::string& path) {
      HostCall now(Purpose::sink);
      now.run(*shared, safe, what, [&](const nicol_host_v1* host) { return f(user, host, &picture, path.c_str()); });
    };
    keep(call.library->sinks, std::move(made), "sink");
  });
}

}  // namespace nicol::plugins
