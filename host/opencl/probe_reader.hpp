// Members of a JSON document, and where it is when something is wrong with them.
#pragma once
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

namespace nicol {

using Complex = std::complex<double>;
using Vector = std::array<double, 3>;
using ComplexVector = std::array<Complex, 3>;

// Reads members and tells where it is when something is wrong.
class Reader {
 public:
  Reader(const nlohmann::json& value, std::string where) : value_(value), where_(std::move(where)) {}

  [[noreturn]] void fail(const std::string& what) const { throw std::runtime_error(where_ + ": " + what); }

  bool has(const char* name) const { return value_.is_object() && value_.contains(name); }

  Reader member(const char* name) const {
    if (!value_.is_object()) fail("expected an object");
    const auto found = value_.find(name);
    if (found == value_.end()) fail(fmt::format("member '{}' is missing", name));
    return {*found, fmt::format("{}{}{}", where_, where_.back() == ']' || where_.back() == '\'' ? ": " : ".", name)};
  }

  std::string text() const {
    if (!value_.is_string()) fail(fmt::format("expected a text, found {}", value_.type_name()));
    return value_.get<std::string>();
  }

  double number() const {
    if (!value_.is_number()) fail(fmt::format("expected a number, found {}", value_.type_name()));
    const double x = value_.get<double>();
    if (!std::isfinite(x)) fail("the number is not finite");
    return x;
  }

  Reader element(std::size_t i, std::size_t size, const char* what) const {
    if (!value_.is_array() || value_.size() != size)
      fail(fmt::format("expected {} {}, found {}", size, what,
                       value_.is_array() ? fmt::format("{} elements", value_.size()) : value_.type_name()));
    return {value_[i], fmt::format("{}[{}]", where_, i)};
  }

  Vector vector() const {
    Vector v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = element(i, 3, "numbers").number();
    return v;
  }

  Complex complex() const {
    return {element(0, 2, "numbers (re, im)").number(), element(1, 2, "numbers (re, im)").number()};
  }

  ComplexVector complex_vector() const {
    ComplexVector v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = element(i, 3, "complex numbers").complex();
    return v;
  }

  Vector unit_vector() const {
    const Vector v = vector();
    const double length = std::hypot(v[0], v[1], v[2]);
    if (std::fabs(length * length - 1) > 1e-9) fail(fmt::format("not a unit vector: its length is {:.9g}", length));
    return v;
  }

 private:
  const nlohmann::json& value_;
  std::string where_;
};

}  // namespace nicol
