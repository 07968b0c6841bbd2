// Machine code of programs against the kernels of the same instruction set, bit by bit: random graphs of every
// operation, of few values alive at a time and of more than the processor has registers.
#include <brdf/formula/Program.h>

#include <algorithm>
#include <bit>
#include <random>

#include "FormulaSupport.h"

namespace brdf::formula {
namespace {

constexpr Op kUnary[] = {Op::Neg, Op::Abs,  Op::Sqrt, Op::Exp,  Op::Expm1, Op::Log,   Op::Log1p, Op::Sin,
                         Op::Cos, Op::Asin, Op::Acos, Op::Atan, Op::Tanh,  Op::Floor, Op::Not,   Op::Erf};
constexpr Op kBinary[] = {Op::Add, Op::Sub,   Op::Mul,  Op::Div,       Op::Pow,   Op::Min, Op::Max,
                          Op::And, Op::Atan2, Op::Less, Op::LessEqual, Op::Equal, Op::Or};

struct RandomProgram {
  Graph graph;
  std::vector<NodeId> outputs;

  /// `simple` of ten operations are sums and products; `outputs` many values live to the end.
  RandomProgram(std::mt19937& random, int size, int outputCount, int simple) {
    std::vector<NodeId> nodes{graph.input(Input::Ux), graph.input(Input::Uy), graph.input(Input::Vz),
                              graph.input(Input::Vx), graph.parameter(0),     graph.parameter(1),
                              graph.constant(0.37)};
    const auto pick = [&] { return nodes[random() % nodes.size()]; };
    for (int k = 0; k < size; ++k) {
      const int kind = static_cast<int>(random() % 10);
      if (kind < simple)
        nodes.push_back(graph.make(random() % 2 ? Op::Mul : Op::Add, pick(), pick()));
      else if (kind % 3 == 0)
        nodes.push_back(graph.make(kUnary[random() % std::size(kUnary)], pick()));
      else if (kind % 3 == 1)
        nodes.push_back(graph.make(kBinary[random() % std::size(kBinary)], pick(), pick()));
      else
        nodes.push_back(graph.select(pick(), pick(), pick()));
    }
    for (int k = 0; k < outputCount; ++k) outputs.push_back(nodes[nodes.size() - 1 - static_cast<std::size_t>(k)]);
  }
};

template <class T>
std::vector<std::vector<T>> runWith(std::string_view set, const RandomProgram& made, std::size_t count) {
  setInstructionSet(set);
  const Program program(made.graph, made.outputs);
  std::mt19937 random(17);
  std::normal_distribution<double> normal;
  std::vector<std::vector<T>> inputs(static_cast<std::size_t>(Input::Count), std::vector<T>(count));
  for (auto& column : inputs)
    for (T& value : column) value = random() % 16 == 0 ? T(0) : static_cast<T>(normal(random));
  std::vector<const T*> in;
  for (const auto& column : inputs) in.push_back(column.data());
  std::vector<std::vector<T>> got(made.outputs.size(), std::vector<T>(count));
  std::vector<T*> out;
  for (auto& column : got) out.push_back(column.data());
  program.run(in.data(), std::vector{0.6, -1.3}, out.data(), count);
  setInstructionSet(instructionSets().front());
  return got;
}

bool sameValue(double a, double b) {
  return (std::isnan(a) && std::isnan(b)) || (a == b && std::signbit(a) == std::signbit(b));
}

class NativeCode : public testing::TestWithParam<std::string> {};

template <class T>
void expectSame(const std::string& set) {
  std::mt19937 random(5);
  const struct {
    int size, outputs, simple;
  } shapes[] = {{12, 1, 3}, {40, 3, 5}, {120, 60, 6}};  // the last keeps more values than there are registers
  for (int trial = 0; trial < 90; ++trial) {
    const auto& shape = shapes[trial % 3];
    const RandomProgram made(random, shape.size, shape.outputs, shape.simple);
    for (const std::size_t count : {1u, 7u, 128u, 333u}) {
      const auto native = runWith<T>(set, made, count), kernels = runWith<T>(set + "_kernels", made, count);
      for (std::size_t k = 0; k < native.size(); ++k)
        for (std::size_t i = 0; i < count; ++i)
          ASSERT_TRUE(sameValue(native[k][i], kernels[k][i]))
              << set << ", trial " << trial << ", output " << k << ", lane " << i << " of " << count << ": "
              << native[k][i] << " and " << kernels[k][i];
    }
  }
}

TEST_P(NativeCode, GivesWhatTheKernelsGive) {
  const auto sets = instructionSets();
  if (std::find(sets.begin(), sets.end(), GetParam()) == sets.end()) GTEST_SKIP() << "not on this processor";
  expectSame<double>(GetParam());
  expectSame<float>(GetParam());
}

TEST_P(NativeCode, LongOutputsThatBypassTheCachesAreTheSame) {
  const auto sets = instructionSets();
  if (std::find(sets.begin(), sets.end(), GetParam()) == sets.end()) GTEST_SKIP() << "not on this processor";
  std::mt19937 random(8);
  for (int trial = 0; trial < 4; ++trial) {
    const RandomProgram made(random, 30, 3, 6);
    const std::size_t count = 400'003;  // of float: 4.8 MB in three outputs
    const auto native = runWith<float>(GetParam(), made, count);
    const auto kernels = runWith<float>(GetParam() + "_kernels", made, count);
    for (std::size_t k = 0; k < native.size(); ++k)
      for (std::size_t i = 0; i < count; ++i) ASSERT_TRUE(sameValue(native[k][i], kernels[k][i])) << k << " " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Sets, NativeCode, testing::Values("avx512", "avx2"),
                         [](const auto& set) { return set.param; });

}  // namespace
}  // namespace brdf::formula
