#pragma once
#include <brdf/brdf_export.h>

#include <cstdint>
#include <memory>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace brdf::formula {

/// Operations of the expression graph. Truth is 1 and 0; a condition is true when it is not 0.
/// Defined corners: pow(0, 0) = 1 and pow(0, n) = 0 for n > 0; at a tie min and max take (and are differentiated by)
/// their first operand; acos and asin clamp their operand to [-1, 1]; sqrt and log of a negative operand are NaN, which
/// a `select` may discard.
/// Special functions outside their domain (formula/SpecialFunctions.h) are NaN likewise.
/// A Sum ends for a lane when Bound exceeds last, or when two terms running have shrunk and are at most tolerance times
/// the sum so far; at most kMaximumTerms terms. A Solve needs f of opposite sign at its ends; Newton steps kept inside
/// the bracket by bisection, until the step is below an ulp or so; without a change of sign the better end is taken.
enum class Op : std::uint8_t {
  Constant,
  Input,
  Parameter,  // leaves
  Neg,
  Abs,
  Sqrt,
  Exp,
  Expm1,
  Log,
  Log1p,
  Sin,
  Cos,
  Tan,
  Asin,
  Acos,
  Atan,  // one operand
  Sinh,
  Cosh,
  Tanh,
  Erf,
  Erfc,
  Lgamma,
  Digamma,
  Trigamma,
  BesselJ0,
  BesselJ1,
  BesselI0,
  BesselI1,
  BesselK0,
  BesselK1,
  Floor,
  Not,
  Add,
  Sub,
  Mul,
  Div,
  Pow,
  Min,
  Max,
  Atan2,
  GammaP,
  GammaQ,    // regularised incomplete gamma functions of (a, x)
  GammaPDa,  // dP/da, made by derivatives only
  Less,
  LessEqual,
  Equal,
  And,
  Or,      // two operands
  Select,  // condition, then, else
  Bound,   // leaf: the variable that a Sum or Solve binds, which `index` names
  Sum,     // first, last, term: sum of term over Bound = first, first + 1, ... <= last; `value` is the tail tolerance
  Solve,   // low, high, f, df/dx: the root x = Bound of f between low and high
  Table,   // x, y: the table that `index` names
  TableDx,
  TableDy,  // its slopes
  MulAdd,
  MulSub,
  NegMulAdd,
  Copy,  // made by Program only: a*b+c, a*b-c, c-a*b, a
  Count
};

/// What an Input node reads, one number a direction pair.
enum class Input : std::uint8_t { Ux, Uy, Uz, Vx, Vy, Vz, Random1, Random2, Count };

using NodeId = std::uint32_t;
struct Table;

inline constexpr int kMaximumTerms = 2000;      ///< of a Sum
inline constexpr int kMaximumIterations = 100;  ///< of a Solve

struct Node {
  Op op = Op::Constant;
  NodeId operands[4] = {0, 0, 0, 0};
  std::uint32_t index =
      0;             ///< Input: which input; Parameter: which one; Bound, Sum, Solve: the variable bound; Table: which
  double value = 0;  ///< Constant: its value; Sum: tail tolerance
};

/// Number of operands of an operation.
BRDF_EXPORT int arity(Op op);
/// Its function name in the formula language, or its symbol ("+").
BRDF_EXPORT std::string_view opName(Op op);
/// The operation on doubles as the language defines it; used to fold constants.
BRDF_EXPORT double applyOp(Op op, double a, double b, double c);

/// A hash-consed expression graph: equal expressions are one node, constants are folded, and identities such as x*1,
/// x+0 and 0*x (0 whatever x is) are removed when a node is made; so are comparisons with 0, and max with it, that the
/// structure decides (sums of squares, roots), for inputs and parameters that are numbers and results that do not
/// overflow. Operands have smaller ids than the nodes that use them, so ascending ids are an evaluation order.
class BRDF_EXPORT Graph {
 public:
  NodeId constant(double value);
  NodeId input(Input input);
  NodeId parameter(std::uint32_t index);
  NodeId make(Op op, NodeId a, NodeId b = 0, NodeId c = 0);

  /// A fresh variable for a Sum or Solve; the expressions made inside use the node it returns.
  NodeId bound();
  /// The node of the variable with this index.
  NodeId boundNode(std::uint32_t index);
  NodeId sum(NodeId variable, NodeId first, NodeId last, NodeId term, double tolerance);
  /// `slope` is the derivative of `f` with respect to `variable`.
  NodeId solve(NodeId variable, NodeId low, NodeId high, NodeId f, NodeId slope);
  /// A look-up: op is Table, TableDx or TableDy; y is left aside by a table of one variable.
  NodeId lookUp(Op op, const std::shared_ptr<const Table>& table, NodeId x, NodeId y);
  const std::shared_ptr<const Table>& table(std::uint32_t index) const { return tables_[index]; }
  /// `root` with every use of the node `from` replaced by `to`.
  NodeId substitute(NodeId root, NodeId from, NodeId to);

  NodeId add(NodeId a, NodeId b) { return make(Op::Add, a, b); }
  NodeId sub(NodeId a, NodeId b) { return make(Op::Sub, a, b); }
  NodeId mul(NodeId a, NodeId b) { return make(Op::Mul, a, b); }
  NodeId div(NodeId a, NodeId b) { return make(Op::Div, a, b); }
  NodeId neg(NodeId a) { return make(Op::Neg, a); }
  NodeId sqrt(NodeId a) { return make(Op::Sqrt, a); }
  NodeId select(NodeId condition, NodeId yes, NodeId no) { return make(Op::Select, condition, yes, no); }

  const Node& operator[](NodeId id) const { return nodes_[id]; }
  std::size_t size() const { return nodes_.size(); }
  bool isConstant(NodeId id) const { return nodes_[id].op == Op::Constant; }
  bool isConstant(NodeId id, double value) const { return isConstant(id) && nodes_[id].value == value; }

  /// For each node id up to the largest of `roots`: whether a root needs it.
  std::vector<bool> reachable(const std::vector<NodeId>& roots) const;

  /// The innermost variable that each node depends on from inside its Sum or Solve: its number plus one, 0 for none. A
  /// variable made later is further in.
  std::vector<std::uint32_t> scopes() const;

 private:
  struct Hash {
    std::size_t operator()(const Node& node) const;
  };
  struct Equal {
    bool operator()(const Node& a, const Node& b) const;
  };
  /// What the structure of a node says of its value.
  enum class Range : std::uint8_t {
    Any,          ///< perhaps NaN
    Number,       ///< not NaN
    NonNegative,  ///< a number >= 0
    Positive      ///< a number > 0
  };
  Range rangeOf(const Node& node) const;
  NodeId intern(const Node& node);
  NodeId simplified(Op op, NodeId a, NodeId b, NodeId c, bool& found);

  std::vector<Node> nodes_;
  std::vector<Range> ranges_;  ///< one a node
  std::uint32_t boundCount_ = 0;
  std::vector<std::shared_ptr<const Table>> tables_;
  std::unordered_map<Node, NodeId, Hash, Equal> ids_;
};

}  // namespace brdf::formula
