// Built-ins that are not plain functions of floats: vectors, arrays, strings, random numbers; and calls.
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "parser.hpp"
#include "text.hpp"

namespace nicol::sdl {

Numbers Parser::constant(const Token& token) {
  const auto unit = [](std::size_t axis, int size) {
    Numbers n;
    n.size = size;
    n.v[axis] = 1;
    return n;
  };
  switch (static_cast<Keyword>(token.index)) {
    case Keyword::k_x: return unit(0, 3);
    case Keyword::k_y: return unit(1, 3);
    case Keyword::k_z: return unit(2, 3);
    case Keyword::k_t: return unit(3, 4);
    case Keyword::k_u: return unit(0, 2);
    case Keyword::k_v: return unit(1, 2);
    case Keyword::k_pi: return Numbers(3.14159265358979323846);
    case Keyword::k_tau: return Numbers(6.28318530717958647692);
    case Keyword::k_on: case Keyword::k_yes: case Keyword::k_true: return Numbers(1);
    case Keyword::k_clock: return Numbers(options_.clock);
    case Keyword::k_clock_on: return Numbers(options_.final_frame != options_.initial_frame || options_.clock != 0 ? 1 : 0);
    case Keyword::k_now:
      return Numbers((static_cast<double>(std::time(nullptr)) - 946684800.0) / 86400.0);
    default: return Numbers(0);
  }
}

Numbers Parser::float_call(const Token& name) {
  const auto keyword = static_cast<Keyword>(name.index);
  const Arity arity = float_builtin_arity(keyword);
  expect('(');
  Group group(*this);
  std::vector<double> arguments;
  for (int count = 1;; ++count) {  // commas may be left out where the number of arguments is known
    arguments.push_back(number());
    if (count == arity.most || (!accept(',') && count >= arity.least)) break;
  }
  group.close(')');
  const char* warning = nullptr;
  try {
    const double value = float_builtin(keyword, arguments.data(), arguments.size(), &warning);
    if (warning) warn(name.where, warning);
    return Numbers(value);
  } catch (const MathError& error) {
    throw Failure{name.where, error.message};
  }
}

Numbers Parser::call(const Token& name, const Value& value) {
  FunctionPtr function;
  if (const auto* f = std::get_if<FunctionPtr>(&value)) function = *f;
  else function = spline_function(std::get<BlockPtr>(value), name.where);
  expect('(');
  Group group(*this);
  std::vector<double> arguments;
  const bool spline = function->kind == Function::Kind::spline;
  const std::size_t wanted = spline ? 1 : function->parameters.size();
  while (arguments.size() < wanted) {
    arguments.push_back(number());
    if (arguments.size() < wanted) accept(',');
  }
  if (spline && accept(',')) next();  // `S(t, linear_spline)`: the kind it was made with is used
  group.close(')');
  try {
    return call_function(*function, arguments.data(), arguments.size(), steps_left_);
  } catch (const MathError& error) {
    throw Failure{name.where, error.message};
  }
}

Numbers Parser::other_call(const Token& name) {
  switch (static_cast<Keyword>(name.index)) {
    case Keyword::k_trace: case Keyword::k_inside: case Keyword::k_min_extent:
    case Keyword::k_max_extent: case Keyword::k_vturbulence:
      throw Failure{name.where, "'" + symbols_.text(name.index) + "' is not supported."};
    case Keyword::k_rand: case Keyword::k_seed: return random_call(name);
    case Keyword::k_defined: return Numbers(is_defined() ? 1 : 0);
    case Keyword::k_dimensions: case Keyword::k_dimension_size: return array_call(name);
    case Keyword::k_vdot: case Keyword::k_vlength: case Keyword::k_vcross:
    case Keyword::k_vnormalize: case Keyword::k_vrotate: case Keyword::k_vaxis_rotate:
      return vector_call(name);
    default: break;
  }
  expect('(');
  Group group(*this);
  const auto keyword = static_cast<Keyword>(name.index);
  const std::string text = keyword == Keyword::k_file_exists ? raw_string() : string_value()->text;
  double value = 0;
  if (keyword == Keyword::k_asc) {
    value = code_point(text);
  } else if (keyword == Keyword::k_file_exists) {
    value = text.size() < 4096 && !resolve(text).empty() ? 1 : 0;
  } else if (keyword == Keyword::k_strlen) {
    value = static_cast<double>(character_starts(text).size() - 1);
  } else if (keyword == Keyword::k_val) {
    value = std::strtod(text.c_str(), nullptr);
  } else {
    accept(',');
    const int order = text.compare(string_value()->text);
    value = order < 0 ? -1 : order > 0 ? 1 : 0;
  }
  group.close(')');
  return Numbers(value);
}

Numbers Parser::array_call(const Token& name) {
  expect('(');
  Group group(*this);
  Token token = next_name();
  const auto* held = token.holds<ArrayPtr>();
  if (!held) fail("array identifier", token);
  const ArrayPtr array = *held;
  double value = static_cast<double>(array->dimensions.size());
  if (name.is(Keyword::k_dimension_size)) {
    accept(',');
    const double which = number();
    const bool known = which >= 1 && which < value + 1;
    value = known ? static_cast<double>(array->dimensions[static_cast<std::size_t>(which) - 1]) : 0;
  }
  group.close(')');
  return Numbers(value);
}

namespace {

Numbers triple(double a, double b, double c) {
  Numbers n;
  n.size = 3;
  n.v = {a, b, c, 0, 0};
  return n;
}

double dot(const Numbers& a, const Numbers& b) {
  return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

Numbers cross(const Numbers& a, const Numbers& b) {
  return triple(a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2],
                a.v[0] * b.v[1] - a.v[1] * b.v[0]);
}

// Rodrigues' formula, right-hand rule.
Numbers turned(const Numbers& a, const Numbers& axis, double angle_deg) {
  const double length = std::sqrt(dot(axis, axis));
  if (length == 0) return a;
  const Numbers k = triple(axis.v[0] / length, axis.v[1] / length, axis.v[2] / length);
  const double c = std::cos(angle_deg * radians_per_degree);
  const double s = std::sin(angle_deg * radians_per_degree);
  const Numbers side = cross(k, a);
  const double along = dot(k, a) * (1 - c);
  return triple(a.v[0] * c + side.v[0] * s + k.v[0] * along,
                a.v[1] * c + side.v[1] * s + k.v[1] * along,
                a.v[2] * c + side.v[2] * s + k.v[2] * along);
}

}  // namespace

Numbers Parser::vector_call(const Token& name) {
  expect('(');
  Group group(*this);
  const Numbers a = vector3();
  Numbers b, result;
  const auto keyword = static_cast<Keyword>(name.index);
  if (keyword != Keyword::k_vlength && keyword != Keyword::k_vnormalize) {
    accept(',');
    b = vector3();
  }
  const double length = std::sqrt(dot(a, a));
  switch (keyword) {
    case Keyword::k_vdot: result = Numbers(dot(a, b)); break;
    case Keyword::k_vlength: result = Numbers(length); break;
    case Keyword::k_vcross: result = cross(a, b); break;
    case Keyword::k_vnormalize:
      if (length == 0) warn(name.where, "Normalizing zero-length vector.");
      result = length == 0 ? a : triple(a.v[0] / length, a.v[1] / length, a.v[2] / length);
      break;
    case Keyword::k_vrotate:
      result = turned(a, triple(1, 0, 0), b.v[0]);
      result = turned(result, triple(0, 1, 0), b.v[1]);
      result = turned(result, triple(0, 0, 1), b.v[2]);
      break;
    default:
      accept(',');
      result = turned(a, b, number());
      break;
  }
  group.close(')');
  return result;
}

// POV-Ray's generator: s = s*1812433253 + 12345 modulo 2^32, value s/(2^32-1).
Numbers Parser::random_call(const Token& name) {
  expect('(');
  Group group(*this);
  const double given = number();
  group.close(')');
  if (name.is(Keyword::k_seed)) {
    budget_.charge(1);
    const double clamped = given != given ? 0 : std::fmin(std::fmax(given, -2147483648.0), 2147483647.0);
    seeds_.push_back(static_cast<std::uint32_t>(static_cast<std::int64_t>(clamped)));
    return Numbers(static_cast<double>(seeds_.size() - 1));
  }
  if (!(given > -1 && given < static_cast<double>(seeds_.size()))) {
    throw Failure{name.where, "Illegal random number generator."};
  }
  std::uint32_t& state = seeds_[static_cast<std::size_t>(given < 0 ? 0 : given)];
  state = state * 1812433253u + 12345u;
  return Numbers(state / 4294967295.0);
}

}  // namespace nicol::sdl
