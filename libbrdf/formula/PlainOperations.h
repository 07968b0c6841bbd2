#pragma once
// The operations that mean the same for every type of number. Internal to libbrdf/formula.
#include <brdf/formula/Graph.h>

#include <cmath>

namespace brdf::formula {

/// The operation on double or a number of Boost.Multiprecision, with the corners that Graph.h defines; special() for
/// the operations that each type has functions of its own for.
template <class Number, class Special>
Number applyPlain(Op op, const Number& a, const Number& b, const Number& c, const Special& special) {
  // Boost's functions are found by their arguments.
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp, std::floor, std::sin,
      std::sinh, std::tan, std::tanh;
  const auto truth = [](bool value) { return Number(value ? 1 : 0); };
  const auto clampToOne = [](const Number& x) { return x > 1 ? Number(1) : x < -1 ? Number(-1) : x; };
  switch (op) {
    case Op::Neg:
      return -a;
    case Op::Abs:
      return abs(a);
    case Op::Exp:
      return exp(a);
    case Op::Sin:
      return sin(a);
    case Op::Cos:
      return cos(a);
    case Op::Tan:
      return tan(a);
    case Op::Asin:
      return asin(clampToOne(a));
    case Op::Acos:
      return acos(clampToOne(a));
    case Op::Atan:
      return atan(a);
    case Op::Sinh:
      return sinh(a);
    case Op::Cosh:
      return cosh(a);
    case Op::Tanh:
      return tanh(a);
    case Op::Floor:
      return floor(a);
    case Op::Not:
      return truth(a == 0);
    case Op::Add:
      return a + b;
    case Op::Sub:
      return a - b;
    case Op::Mul:
      return a * b;
    case Op::Div:
      return a / b;
    case Op::Min:
      return b < a ? b : a;
    case Op::Max:
      return b > a ? b : a;
    case Op::Atan2:
      return atan2(a, b);
    case Op::Less:
      return truth(a < b);
    case Op::LessEqual:
      return truth(a <= b);
    case Op::Equal:
      return truth(a == b);
    case Op::And:
      return truth(a != 0 && b != 0);
    case Op::Or:
      return truth(a != 0 || b != 0);
    case Op::Select:
      return a != 0 ? b : c;
    default:
      return special();
  }
}

}  // namespace brdf::formula
