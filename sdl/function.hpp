// `function { }`: an expression of floats kept as a tree, a transform, a spline, or a kind not evaluated here.
#pragma once
#include <array>

#include "value.hpp"

namespace nicol::sdl {

constexpr double slack = 1e-10;  // POV-Ray's tolerance in comparisons
constexpr double radians_per_degree = 3.14159265358979323846 / 180;

using Matrix = std::array<std::array<double, 3>, 4>;  // rows; p' = p*M, the last row is added

// One step of an expression in postfix order: no recursion, however long the expression.
struct Step {
  enum class Op : std::uint8_t {
    number, parameter, negate, logical_not, add, subtract, multiply, divide,
    less, less_equal, greater, greater_equal, equal, not_equal, logical_and, logical_or,
    choose, builtin, call
  };
  Op op = Op::number;
  double number = 0;
  std::uint32_t index = 0;  // of the parameter, the keyword, or the component of a call's result
  std::uint32_t count = 0;  // arguments
  FunctionPtr callee;
};

struct Knot {
  double at;
  std::array<double, 5> value, slope;  // slope: second derivative of a natural spline
};

struct Function {
  enum class Kind : std::uint8_t { expression, transform, spline, opaque };
  Kind kind = Kind::expression;
  std::vector<Symbol> parameters;
  std::vector<Step> steps;
  int depth = 1;  // of calls within calls
  Matrix matrix{};
  enum class Spline : std::uint8_t { linear, quadratic, cubic, natural } spline = Spline::linear;
  std::vector<Knot> knots;
  int knot_size = 3;
  std::string what;  // an opaque one's kind, for the message
  bool vector_valued() const { return kind == Kind::transform || kind == Kind::spline; }
};

// A domain error inside an evaluation.
struct MathError {
  std::string message;
};

// abs, sin, pow...: `count` numbers to one. Throws MathError; `warn` gets what POV-Ray only warns of.
double float_builtin(Keyword keyword, const double* args, std::size_t count, const char** warn);
// How many arguments: least and most (most < 0: any number).
struct Arity {
  int least, most;
};
Arity float_builtin_arity(Keyword keyword);

// Evaluates; `steps_left` counts down, LimitReached at its end.
Numbers call_function(const Function& function, const double* args, std::size_t count,
                      std::size_t& steps_left);

Numbers spline_at(const Function& spline, double at);
void prepare_spline(Function& spline);  // sorts the knots, finds the slopes

Matrix identity_matrix();
Matrix product(const Matrix& a, const Matrix& b);  // a first, then b
// Reads a `transform { }` block; false if it holds what is not a transform.
bool matrix_of(const Block& block, Matrix& out);

}  // namespace nicol::sdl
