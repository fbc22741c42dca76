// Calling a function: postfix steps on a small stack, a matrix, or a spline.
#include <cmath>
#include <limits>

#include "function.hpp"

namespace nicol::sdl {
namespace {

double combined(Step::Op op, double a, double b) {
  using Op = Step::Op;
  switch (op) {
    case Op::add: return a + b;
    case Op::subtract: return a - b;
    case Op::multiply: return a * b;
    case Op::divide: return b == 0 ? std::numeric_limits<double>::infinity() : a / b;
    case Op::less: return a < b;
    case Op::less_equal: return a <= b + slack;
    case Op::greater: return a > b;
    case Op::greater_equal: return a >= b - slack;
    case Op::equal: return std::fabs(a - b) < slack;
    case Op::not_equal: return !(std::fabs(a - b) < slack);
    case Op::logical_and: return a != 0 && b != 0;
    default: return a != 0 || b != 0;
  }
}

double run(const Function& f, const double* arguments, std::size_t& steps_left) {
  std::vector<double> stack;
  for (const Step& step : f.steps) {
    if (steps_left == 0) throw LimitReached{"The scene takes too many steps: does a loop never end?"};
    --steps_left;
    const std::size_t taken = step.count;
    double result = 0;
    double* const top = stack.data() + stack.size() - taken;
    switch (step.op) {
      case Step::Op::number: result = step.number; break;
      case Step::Op::parameter: result = arguments[step.index]; break;
      case Step::Op::negate: result = -top[0]; break;
      case Step::Op::logical_not: result = top[0] == 0; break;
      case Step::Op::choose: result = top[0] != 0 ? top[1] : top[2]; break;
      case Step::Op::builtin: {
        const char* warning = nullptr;
        result = float_builtin(static_cast<Keyword>(step.index), top, taken, &warning);
        break;
      }
      case Step::Op::call:
        result = call_function(*step.callee, top, taken, steps_left).v[step.index];
        break;
      default: result = combined(step.op, top[0], top[1]); break;
    }
    stack.resize(stack.size() - taken);
    stack.push_back(result);
  }
  return stack.back();
}

}  // namespace

Numbers call_function(const Function& f, const double* arguments, std::size_t,
                      std::size_t& steps_left) {
  switch (f.kind) {
    case Function::Kind::expression: return Numbers(run(f, arguments, steps_left));
    case Function::Kind::spline: return spline_at(f, arguments[0]);
    case Function::Kind::opaque: throw MathError{f.what + " is not supported in a function."};
    case Function::Kind::transform: break;
  }
  Numbers moved;
  moved.size = 3;
  for (std::size_t j = 0; j < 3; ++j) {
    moved.v[j] = f.matrix[3][j];
    for (std::size_t i = 0; i < 3; ++i) moved.v[j] += arguments[i] * f.matrix[i][j];
  }
  return moved;
}

}  // namespace nicol::sdl
