// Compiled graphs: any batch length, any wiring of outputs, any number of threads.
#include "FormulaSupport.h"

#include <random>
#include <thread>

namespace brdf::formula {
namespace {

constexpr std::size_t kInputs = static_cast<std::size_t>(Input::Count);

/// `count` lanes of random unit-ish inputs.
template <class T>
std::vector<std::vector<T>> randomInputs(std::size_t count, unsigned seed) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform(0.05, 1);
  std::vector<std::vector<T>> columns(kInputs, std::vector<T>(count));
  for (auto& column : columns)
    for (T& value : column) value = static_cast<T>(uniform(random));
  return columns;
}

template <class T>
std::vector<const T*> pointers(const std::vector<std::vector<T>>& columns, std::size_t offset = 0) {
  std::vector<const T*> result;
  for (const auto& column : columns) result.push_back(column.data() + offset);
  return result;
}

const char* const kFormula = "t = tan2_h / p; exp(-t) / (pi * p * cos2_h ^ 2) + select(uz < vz, uz * q, vz / q) * p";

struct Compiled {
  Graph graph;
  NodeId root;
  Compiled() {
    static const std::vector<std::string> names{"p", "q"};
    ParseOptions options;
    options.parameters = names;
    root = parse(graph, kFormula, options).value;
  }
};

template <class T>
void expectLengthsAgree() {
  const Compiled formula;
  const Program program(formula.graph, {formula.root});
  const std::vector<double> parameters{0.3, 1.7};
  constexpr std::size_t longest = 700, guard = 3;
  const auto inputs = randomInputs<T>(longest + 1, 1);
  std::vector<T> whole(longest + 1);
  T* wholePointer = whole.data();
  program.run(pointers(inputs).data(), parameters, &wholePointer, longest + 1);
  for (std::size_t count = 0; count <= longest; count += count < 300 ? 1 : 37) {
    // From an odd offset, so that nothing is aligned; and not a number beyond the end.
    std::vector<T> got(count + guard, T(-7));
    T* output = got.data();
    program.run(pointers(inputs, 1).data(), parameters, &output, count);
    for (std::size_t i = 0; i < count; ++i) ASSERT_EQ(got[i], whole[i + 1]) << "lane " << i << " of " << count;
    for (std::size_t i = count; i < count + guard; ++i) ASSERT_EQ(got[i], T(-7)) << "beyond the end of " << count;
  }
}

TEST(Program, GivesEachLaneTheSameValueInABatchOfAnyLength) {
  for (const std::string_view set : instructionSets()) {
    setInstructionSet(set);
    expectLengthsAgree<double>();
    expectLengthsAgree<float>();
  }
  setInstructionSet(instructionSets().front());
}

TEST(Program, AgreesWithExtendedPrecision) {
  const Compiled formula;
  const Program program(formula.graph, {formula.root});
  const std::vector<double> parameters{0.3, 1.7};
  constexpr std::size_t count = 500;
  for (const std::string_view set : instructionSets()) {
    setInstructionSet(set);
    const auto doubles = randomInputs<double>(count, 2);
    const auto floats = randomInputs<float>(count, 2);
    std::vector<double> gotDouble(count);
    std::vector<float> gotFloat(count);
    double* outputDouble = gotDouble.data();
    float* outputFloat = gotFloat.data();
    program.run(pointers(doubles).data(), parameters, &outputDouble, count);
    program.run(pointers(floats).data(), parameters, &outputFloat, count);
    for (std::size_t i = 0; i < count; ++i) {
      InputLane lane, narrow;
      for (std::size_t k = 0; k < kInputs; ++k) lane[k] = doubles[k][i], narrow[k] = floats[k][i];
      const double exact = evaluateExtended(formula.graph, {formula.root}, lane, parameters)[0];
      const double exactOfNarrow = evaluateExtended(formula.graph, {formula.root}, narrow, parameters)[0];
      EXPECT_NEAR(gotDouble[i], exact, 1e-14 * exact);
      EXPECT_NEAR(gotFloat[i], exactOfNarrow, 1e-5 * exactOfNarrow);
    }
  }
  setInstructionSet(instructionSets().front());
}

TEST(Program, OutputsMayBeInputsConstantsParametersAndEachOther) {
  Graph graph;
  const NodeId ux = graph.input(Input::Ux), uy = graph.input(Input::Uy), p = graph.parameter(0);
  const NodeId sum = graph.add(ux, uy), root = graph.sqrt(sum);
  const Program program(graph, {sum, ux, graph.constant(4), p, sum, root, ux, graph.mul(p, p), graph.mul(sum, root)});
  for (const std::size_t count : {1u, 64u, 200u}) {
    const auto inputs = randomInputs<double>(count, 4);
    std::vector<std::vector<double>> got(9, std::vector<double>(count));
    std::vector<double*> outputs;
    for (auto& column : got) outputs.push_back(column.data());
    program.run(pointers(inputs).data(), std::vector{3.0}, outputs.data(), count);
    for (std::size_t i = 0; i < count; ++i) {
      const double x = inputs[0][i], y = inputs[1][i], r = std::sqrt(x + y);
      const std::vector<double> expected{x + y, x, 4, 3, x + y, r, x, 9, (x + y) * r};
      for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_DOUBLE_EQ(got[k][i], expected[k]) << "output " << k;
    }
  }
}

TEST(Program, AnOutputThatFeedsLaterInstructionsSurvives) {
  // Outputs are written in place and read again; registers freed by them must not be taken too early.
  std::mt19937 random(11);
  for (int trial = 0; trial < 200; ++trial) {
    Graph graph;
    std::vector<NodeId> nodes{graph.input(Input::Ux), graph.input(Input::Uy), graph.input(Input::Uz),
                              graph.parameter(0), graph.constant(0.5)};
    const auto any = [&] { return nodes[random() % nodes.size()]; };
    constexpr Op operations[] = {Op::Add, Op::Sub, Op::Mul, Op::Max, Op::Min, Op::Abs, Op::Neg, Op::Select, Op::Less};
    for (int k = 0; k < 30; ++k)
      nodes.push_back(graph.make(operations[random() % std::size(operations)], any(), any(), any()));
    std::vector<NodeId> roots;
    for (int k = 0; k < 6; ++k) roots.push_back(any());
    const Program program(graph, roots);
    constexpr std::size_t count = 70;
    const auto inputs = randomInputs<double>(count, static_cast<unsigned>(trial));
    std::vector<std::vector<double>> got(roots.size(), std::vector<double>(count));
    std::vector<double*> outputs;
    for (auto& column : got) outputs.push_back(column.data());
    program.run(pointers(inputs).data(), std::vector{0.25}, outputs.data(), count);
    for (std::size_t i = 0; i < count; i += 23) {
      std::vector<double> value(graph.size());
      for (NodeId id = 0; id < graph.size(); ++id) {
        const Node& node = graph[id];
        if (node.op == Op::Constant)
          value[id] = node.value;
        else if (node.op == Op::Input)
          value[id] = inputs[node.index][i];
        else if (node.op == Op::Parameter)
          value[id] = 0.25;
        else
          value[id] = applyOp(node.op, value[node.operands[0]], value[node.operands[1]], value[node.operands[2]]);
      }
      for (std::size_t k = 0; k < roots.size(); ++k) {
        const double expected = value[roots[k]];
        ASSERT_NEAR(got[k][i], expected, 1e-12 * (1 + std::fabs(expected))) << "trial " << trial << ", output " << k;
      }
    }
  }
}

TEST(Program, ReadsOnlyTheInputsItNeeds) {
  Graph graph;
  const Program program(graph, {graph.add(graph.input(Input::Uy), graph.input(Input::Random1))});
  EXPECT_TRUE(program.reads(Input::Uy));
  EXPECT_TRUE(program.reads(Input::Random1));
  EXPECT_FALSE(program.reads(Input::Ux));
  const double y[] = {1, 2, 3}, u[] = {10, 20, 30};
  const double* inputs[kInputs] = {};
  inputs[1] = y;
  inputs[6] = u;
  double got[3];
  double* output = got;
  program.run(inputs, {}, &output, 3);
  EXPECT_EQ(got[2], 33);
}

TEST(Program, WhatDependsOnParametersAloneIsComputedInDouble) {
  // 1 + p is 1 in float; the difference survives because it is formed in double before the batch.
  Graph graph;
  const std::vector<std::string> names{"p"};
  ParseOptions options;
  options.parameters = names;
  const Program program(graph, {parse(graph, "((1 + p) - 1) * ux", options).value});
  const float x = 2;
  const float* inputs[kInputs] = {&x};
  float got = 0;
  float* output = &got;
  program.run(inputs, std::vector{1e-9}, &output, 1);
  EXPECT_NEAR(got, 2e-9, 1e-15);
}

TEST(Program, RunsInSeveralThreadsAtOnce) {
  const Compiled formula;
  const Program program(formula.graph, {formula.root});
  constexpr std::size_t count = 1001;
  const auto inputs = randomInputs<double>(count, 6);
  std::vector<std::thread> threads;
  std::vector<std::vector<double>> got(8, std::vector<double>(count));
  for (std::size_t t = 0; t < got.size(); ++t)
    threads.emplace_back([&, t] {
      const std::vector<double> parameters{0.1 * static_cast<double>(t + 1), 1.7};
      double* output = got[t].data();
      for (int repeat = 0; repeat < 20; ++repeat) program.run(pointers(inputs).data(), parameters, &output, count);
    });
  for (std::thread& thread : threads) thread.join();
  for (std::size_t t = 0; t < got.size(); ++t) {
    std::vector<double> alone(count);
    double* output = alone.data();
    program.run(pointers(inputs).data(), std::vector{0.1 * static_cast<double>(t + 1), 1.7}, &output, count);
    EXPECT_EQ(got[t], alone) << "thread " << t;
  }
}

}  // namespace
}  // namespace brdf::formula
