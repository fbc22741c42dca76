// Functions of floats, shared by expressions and `function { }`; domains as POV-Ray checks them.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "function.hpp"

namespace nicol::sdl {
namespace {

constexpr double pi = 3.14159265358979323846;

[[noreturn]] void negative(const char* name, double value) {
  char text[96];
  std::snprintf(text, sizeof text, "%s of negative number %f", name, value);
  throw MathError{text};
}

double clamped(double value, const char* message, const char** warning) {
  if (value >= -1 && value <= 1) return value;
  *warning = message;
  return value > 1 ? 1 : -1;
}

std::int64_t whole(double value) {
  return value != value ? 0 : static_cast<std::int64_t>(std::fmin(std::fmax(value, -9e15), 9e15));
}

double power(double base, double exponent) {
  if (base == 0 && exponent == 0) throw MathError{"Domain error."};
  return std::pow(base, exponent);
}

double angle(double y, double x) {
  if (x == 0 && y == 0) throw MathError{"Domain error in 'atan2'!"};
  return std::atan2(y, x);
}

double chosen(const double* a, std::size_t count) {
  if (count == 3) return a[0] < 0 ? a[1] : a[2];
  return a[0] < 0 ? a[1] : a[0] == 0 ? a[2] : a[3];
}

}  // namespace

Arity float_builtin_arity(Keyword keyword) {
  switch (keyword) {
    case Keyword::k_atan2: case Keyword::k_div: case Keyword::k_mod: case Keyword::k_pow:
      return {2, 2};
    case Keyword::k_bitwise_and: case Keyword::k_bitwise_or: case Keyword::k_bitwise_xor:
      return {2, -1};
    case Keyword::k_max: case Keyword::k_min: return {1, -1};
    case Keyword::k_select: return {3, 4};
    default: return {1, 1};
  }
}

double float_builtin(Keyword keyword, const double* a, std::size_t count, const char** warning) {
  switch (keyword) {
    case Keyword::k_abs: return std::fabs(a[0]);
    case Keyword::k_acos: return std::acos(clamped(a[0], "Domain error in acos.", warning));
    case Keyword::k_acosh: return std::acosh(a[0]);
    case Keyword::k_asin: return std::asin(clamped(a[0], "Domain error in asin.", warning));
    case Keyword::k_asinh: return std::asinh(a[0]);
    case Keyword::k_atan: return std::atan(a[0]);
    case Keyword::k_atan2: return angle(a[0], a[1]);
    case Keyword::k_atanh: return std::atanh(a[0]);
    case Keyword::k_bitwise_and: case Keyword::k_bitwise_or: case Keyword::k_bitwise_xor: {
      std::int64_t bits = whole(a[0]);
      for (std::size_t i = 1; i < count; ++i) {
        const std::int64_t b = whole(a[i]);
        bits = keyword == Keyword::k_bitwise_and ? bits & b
             : keyword == Keyword::k_bitwise_or  ? bits | b : bits ^ b;
      }
      return static_cast<double>(bits);
    }
    case Keyword::k_ceil: return std::ceil(a[0]);
    case Keyword::k_cos: return std::cos(a[0]);
    case Keyword::k_cosh: return std::cosh(a[0]);
    case Keyword::k_degrees: return a[0] * 180 / pi;
    case Keyword::k_div: return std::trunc(a[0] / a[1]);
    case Keyword::k_exp: return std::exp(a[0]);
    case Keyword::k_floor: return std::floor(a[0]);
    case Keyword::k_int: return std::trunc(a[0]);
    case Keyword::k_ln: if (!(a[0] > 0)) negative("ln", a[0]); return std::log(a[0]);
    case Keyword::k_log: if (!(a[0] > 0)) negative("log", a[0]); return std::log10(a[0]);
    case Keyword::k_max: return *std::max_element(a, a + count);
    case Keyword::k_min: return *std::min_element(a, a + count);
    case Keyword::k_mod: return std::fmod(a[0], a[1]);
    case Keyword::k_pow: return power(a[0], a[1]);
    case Keyword::k_radians: return a[0] * pi / 180;
    case Keyword::k_select: return chosen(a, count);
    case Keyword::k_sin: return std::sin(a[0]);
    case Keyword::k_sinh: return std::sinh(a[0]);
    case Keyword::k_sqr: return a[0] * a[0];
    case Keyword::k_sqrt: if (a[0] < 0) negative("sqrt", a[0]); return std::sqrt(a[0]);
    case Keyword::k_tan: return std::tan(a[0]);
    default: return std::tanh(a[0]);
  }
}

}  // namespace nicol::sdl
