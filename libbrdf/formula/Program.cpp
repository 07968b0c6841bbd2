#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Kernels.h>
#include <brdf/formula/Program.h>

#include <algorithm>
#include <cstring>

namespace brdf::formula {
namespace {

std::vector<const KernelSet*> availableSets() {
  std::vector<const KernelSet*> sets;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    sets.push_back(&kKernelsAvx512);
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) sets.push_back(&kKernelsAvx2);
  sets.push_back(&kKernelsSse2);
#endif
  sets.push_back(&kKernelsGeneric);
  return sets;
}

const KernelSet*& currentSet() {
  static const KernelSet* set = availableSets().front();
  return set;
}

template <class T>
const KernelTable<T>& currentKernels() {
  if constexpr (sizeof(T) == sizeof(float))
    return *currentSet()->floats;
  else
    return *currentSet()->doubles;
}

/// Scratch memory of the calling thread, aligned to 64 bytes, kept between runs.
template <class T>
T* scratch(std::size_t count) {
  thread_local std::vector<T> storage;
  const std::size_t padding = 64 / sizeof(T);
  if (storage.size() < count + padding) storage.resize(count + padding);
  const auto address = reinterpret_cast<std::uintptr_t>(storage.data());
  return reinterpret_cast<T*>((address + 63) / 64 * 64);
}

}  // namespace

std::vector<std::string_view> instructionSets() {
  std::vector<std::string_view> names;
  for (const KernelSet* set : availableSets()) names.emplace_back(set->name);
  return names;
}

std::string_view instructionSet() { return currentSet()->name; }

void setInstructionSet(std::string_view name) {
  for (const KernelSet* set : availableSets())
    if (set->name == name) {
      currentSet() = set;
      return;
    }
  throw Error(Error::Kind::Value,
              {"unknown or unavailable", "instruction set", "'" + std::string(name) + "'", joined(instructionSets())});
}

Program::Program(const Graph& graph, const std::vector<NodeId>& outputs) : outputCount_(outputs.size()) {
  const std::vector<bool> needed = graph.reachable(outputs);
  const std::size_t size = needed.size();

  // What varies from lane to lane, and how often each such node is used.
  std::vector<bool> varies(size, false);
  std::vector<std::uint32_t> uses(size, 0);
  for (std::size_t id = 0; id < size; ++id) {
    if (!needed[id]) continue;
    const Node& node = graph[static_cast<NodeId>(id)];
    varies[id] = node.op == Op::Input;
    for (int k = 0; k < arity(node.op); ++k) {
      varies[id] = varies[id] || varies[node.operands[k]];
      ++uses[node.operands[k]];
    }
  }
  for (const NodeId output : outputs) ++uses[output];

  // Uniforms, in order; a node's place.
  std::vector<Operand> places(size);
  for (std::size_t id = 0; id < size; ++id) {
    if (!needed[id] || varies[id]) continue;
    const Node& node = graph[static_cast<NodeId>(id)];
    UniformStep step;
    step.op = node.op;
    step.value = node.value;
    if (node.op == Op::Parameter) step.operands[0] = node.index;
    for (int k = 0; k < arity(node.op); ++k) step.operands[k] = places[node.operands[k]].index;
    places[id] = {Place::Uniform, static_cast<std::uint32_t>(uniforms_.size())};
    uniforms_.push_back(step);
  }

  // A division by a uniform is a product with its reciprocal, computed once in double.
  std::vector<std::uint32_t> reciprocal(size, 0);
  for (std::size_t id = 0; id < size; ++id) {
    if (!needed[id] || !varies[id] || graph[static_cast<NodeId>(id)].op != Op::Div) continue;
    const NodeId divisor = graph[static_cast<NodeId>(id)].operands[1];
    if (varies[divisor] || reciprocal[divisor] != 0) continue;
    UniformStep one;
    one.value = 1;
    UniformStep step;
    step.op = Op::Div;
    step.operands[0] = static_cast<std::uint32_t>(uniforms_.size());
    step.operands[1] = places[divisor].index;
    uniforms_.push_back(one);
    reciprocal[divisor] = static_cast<std::uint32_t>(uniforms_.size());
    uniforms_.push_back(step);
  }

  // A product used once, by a sum, is fused into it.
  struct Selected {
    Op op;
    NodeId operands[3];
    int count;
  };
  std::vector<Selected> selected(size);
  std::vector<bool> fused(size, false);
  for (std::size_t id = size; id-- > 0;) {
    if (!needed[id] || !varies[id]) continue;
    const Node& node = graph[static_cast<NodeId>(id)];
    Selected s{node.op, {node.operands[0], node.operands[1], node.operands[2]}, arity(node.op)};
    const auto product = [&](NodeId operand) {
      return graph[operand].op == Op::Mul && varies[operand] && uses[operand] == 1;
    };
    if (node.op == Op::Add || node.op == Op::Sub) {
      const NodeId a = node.operands[0], b = node.operands[1];
      if (product(a)) {
        s = {node.op == Op::Add ? Op::MulAdd : Op::MulSub, {graph[a].operands[0], graph[a].operands[1], b}, 3};
        fused[a] = true;
      } else if (product(b)) {
        s = {node.op == Op::Add ? Op::MulAdd : Op::NegMulAdd, {graph[b].operands[0], graph[b].operands[1], a}, 3};
        fused[b] = true;
      }
    }
    selected[id] = s;
  }

  // Last reader of each node, to free its register there.
  std::vector<std::size_t> lastUse(size, 0);
  for (std::size_t id = 0; id < size; ++id)
    if (needed[id] && varies[id] && !fused[id])
      for (int k = 0; k < selected[id].count; ++k) lastUse[selected[id].operands[k]] = id;

  std::vector<std::uint32_t> freeRegisters;
  const auto release = [&](NodeId id) {
    if (places[id].place == Place::Register && varies[id]) freeRegisters.push_back(places[id].index);
  };
  for (std::size_t id = 0; id < size; ++id) {
    if (!needed[id] || !varies[id] || fused[id]) continue;
    const Node& node = graph[static_cast<NodeId>(id)];
    if (node.op == Op::Input) {
      places[id] = {Place::Input, node.index};
      reads_[node.index] = true;
      continue;
    }
    Instruction instruction;
    instruction.op = selected[id].op;
    for (int k = 0; k < selected[id].count; ++k) instruction.operands[k] = places[selected[id].operands[k]];
    if (instruction.op == Op::Div && instruction.operands[1].place == Place::Uniform) {
      instruction.op = Op::Mul;
      instruction.operands[1].index = reciprocal[selected[id].operands[1]];
    }
    for (int k = 0; k < selected[id].count; ++k) {
      const NodeId operand = selected[id].operands[k];
      const bool repeated = (k > 0 && operand == selected[id].operands[0]) || (k > 1 && operand == selected[id].operands[1]);
      if (lastUse[operand] == id && !repeated) release(operand);
    }
    const auto output = std::find(outputs.begin(), outputs.end(), static_cast<NodeId>(id));
    if (output != outputs.end()) {
      instruction.target = {Place::Output, static_cast<std::uint32_t>(output - outputs.begin())};
    } else {
      if (freeRegisters.empty()) freeRegisters.push_back(static_cast<std::uint32_t>(registerCount_++));
      instruction.target = {Place::Register, freeRegisters.back()};
      freeRegisters.pop_back();
    }
    places[id] = instruction.target;
    instructions_.push_back(instruction);
  }

  // Outputs that are an input, a uniform, or another output again.
  for (std::uint32_t k = 0; k < outputs.size(); ++k) {
    const Operand place = places[outputs[k]];
    if (place.place == Place::Output && place.index == k) continue;
    Instruction copy;
    copy.operands[0] = place;
    copy.target = {Place::Output, k};
    instructions_.push_back(copy);
  }
}

template <class T>
void Program::runBlocks(const T* const* inputs, std::span<const double> parameters, T* const* outputs,
                        std::size_t count) const {
  constexpr std::size_t lanes = kLanes<T>;
  constexpr std::size_t inputCount = static_cast<std::size_t>(Input::Count);
  if (count == 0) return;

  // Scratch: registers, padded inputs and outputs for the last block, uniforms.
  T* registers = scratch<T>((registerCount_ + inputCount + outputCount_) * lanes + uniforms_.size());
  T* paddedInputs = registers + registerCount_ * lanes;
  T* paddedOutputs = paddedInputs + inputCount * lanes;
  T* uniforms = paddedOutputs + outputCount_ * lanes;
  {
    double* exact = nullptr;
    if constexpr (sizeof(T) == sizeof(double))
      exact = uniforms;
    else
      exact = scratch<double>(uniforms_.size());
    for (std::size_t k = 0; k < uniforms_.size(); ++k) {
      const UniformStep& step = uniforms_[k];
      if (step.op == Op::Constant)
        exact[k] = step.value;
      else if (step.op == Op::Parameter)
        exact[k] = parameters[step.operands[0]];
      else
        exact[k] = applyOp(step.op, exact[step.operands[0]], exact[step.operands[1]], exact[step.operands[2]]);
    }
    if constexpr (sizeof(T) != sizeof(double))
      for (std::size_t k = 0; k < uniforms_.size(); ++k) uniforms[k] = static_cast<T>(exact[k]);
  }

  // Instructions with their pointers: what streams moves by the block's offset, registers and uniforms stay.
  struct Resolved {
    Kernel<T> kernel;
    T* target;
    const T* operands[3];
    std::size_t targetStride, strides[3];
  };
  thread_local std::vector<Resolved> resolved;
  const auto resolve = [&](const T* const* in, T* const* out) {
    const KernelTable<T>& table = currentKernels<T>();
    resolved.clear();
    for (const Instruction& instruction : instructions_) {
      Resolved r{};
      unsigned mask = 0;
      for (unsigned k = 0; k < 3; ++k) {
        const Operand& operand = instruction.operands[k];
        switch (operand.place) {
          case Place::Register: r.operands[k] = registers + operand.index * lanes; break;
          case Place::Input: r.operands[k] = in[operand.index], r.strides[k] = 1; break;
          case Place::Output: r.operands[k] = out[operand.index], r.strides[k] = 1; break;
          case Place::Uniform: r.operands[k] = uniforms + operand.index, mask |= 1u << k; break;
        }
      }
      const bool toOutput = instruction.target.place == Place::Output;
      r.target = toOutput ? out[instruction.target.index] : registers + instruction.target.index * lanes;
      r.targetStride = toOutput ? 1 : 0;
      r.kernel = table.kernels[static_cast<std::size_t>(instruction.op)][mask];
      resolved.push_back(r);
    }
  };
  const auto runBlock = [&](std::size_t offset) {
    for (const Resolved& r : resolved)
      r.kernel(r.target + r.targetStride * offset, r.operands[0] + r.strides[0] * offset,
               r.operands[1] + r.strides[1] * offset, r.operands[2] + r.strides[2] * offset);
  };

  const std::size_t whole = count / lanes * lanes;
  if (whole > 0) {
    resolve(inputs, outputs);
    for (std::size_t first = 0; first < whole; first += lanes) runBlock(first);
  }
  if (whole == count) return;

  // The rest, padded by repeating the last lane.
  const std::size_t rest = count - whole;
  const T* in[inputCount] = {};
  for (std::size_t k = 0; k < inputCount; ++k) {
    if (!reads_[k]) continue;
    T* padded = paddedInputs + k * lanes;
    std::copy_n(inputs[k] + whole, rest, padded);
    std::fill(padded + rest, padded + lanes, padded[rest - 1]);
    in[k] = padded;
  }
  thread_local std::vector<T*> out;
  out.resize(outputCount_);
  for (std::size_t k = 0; k < outputCount_; ++k) out[k] = paddedOutputs + k * lanes;
  resolve(in, out.data());
  runBlock(0);
  for (std::size_t k = 0; k < outputCount_; ++k) std::copy_n(out[k], rest, outputs[k] + whole);
}

void Program::run(const double* const* inputs, std::span<const double> parameters, double* const* outputs,
                  std::size_t count) const {
  runBlocks<double>(inputs, parameters, outputs, count);
}

void Program::run(const float* const* inputs, std::span<const double> parameters, float* const* outputs,
                  std::size_t count) const {
  runBlocks<float>(inputs, parameters, outputs, count);
}

}  // namespace brdf::formula
