#include <brdf/base/Error.h>
#include <brdf/base/Text.h>
#include <brdf/formula/Kernels.h>
#include <brdf/formula/Loops.h>
#include <brdf/formula/NativeCode.h>
#include <brdf/formula/Program.h>
#include <brdf/formula/Table.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>

namespace brdf::formula {
namespace {

std::vector<const KernelSet*> availableSets() {
  std::vector<const KernelSet*> sets;
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl"))
    sets = {&kKernelsAvx512, &kKernelsAvx512Alone};
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
    sets.insert(sets.end(), {&kKernelsAvx2, &kKernelsAvx2Alone});
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

Table::Part partOf(Op op) {
  return op == Op::Table ? Table::Part::Value : op == Op::TableDx ? Table::Part::Dx : Table::Part::Dy;
}

/// While it lives, the calling thread flushes float results below 1.2e-38 to 0: the exponentials of sharp lobes fall
/// there by the thousand, and each costs a trap of some hundred cycles otherwise.
class FlushTinyFloats {
 public:
#if defined(__x86_64__)
  FlushTinyFloats() : saved_(__builtin_ia32_stmxcsr()) { __builtin_ia32_ldmxcsr(saved_ | 0x8040); }
  ~FlushTinyFloats() { __builtin_ia32_ldmxcsr(saved_); }

 private:
  unsigned saved_;
#endif
};

/// Scratch memory of the calling thread, aligned to 64 bytes, kept between runs; one for each purpose.
template <class T, int purpose>
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

struct Program::Natives {
  template <class T>
  struct Slot {
    const KernelSet* set = nullptr;
    std::unique_ptr<const NativeCode<T>> code;
  };
  std::mutex mutex;
  std::vector<std::unique_ptr<Slot<float>>> floats;
  std::vector<std::unique_ptr<Slot<double>>> doubles;
  std::atomic<const Slot<float>*> currentFloat = nullptr;
  std::atomic<const Slot<double>*> currentDouble = nullptr;
};

std::shared_ptr<Program::Natives> Program::makeNatives() { return std::make_shared<Natives>(); }

template <class T>
const NativeCode<T>* Program::native() const {
  using Slot = Natives::Slot<T>;
  const auto pick = [](auto& forFloat, auto& forDouble) -> auto& {
    if constexpr (sizeof(T) == sizeof(float))
      return forFloat;
    else
      return forDouble;
  };
  auto& current = pick(natives_->currentFloat, natives_->currentDouble);
  const KernelSet* set = currentSet();
  if (const Slot* slot = current.load(std::memory_order_acquire); slot && slot->set == set) return slot->code.get();
  const std::lock_guard lock(natives_->mutex);
  auto& slots = pick(natives_->floats, natives_->doubles);
  for (const auto& slot : slots)
    if (slot->set == set) {
      current.store(slot.get(), std::memory_order_release);
      return slot->code.get();
    }
  slots.push_back(std::make_unique<Slot>(Slot{set, NativeCode<T>::make(*this, *set)}));
  current.store(slots.back().get(), std::memory_order_release);
  return slots.back()->code.get();
}

template <class T>
const T* Program::uniformValues(std::span<const double> parameters) const {
  T* uniforms = scratch<T, 1>(uniforms_.size() + kNativeConstants);
  double* exact = nullptr;
  if constexpr (sizeof(T) == sizeof(double))
    exact = uniforms;
  else
    exact = scratch<double, 2>(uniforms_.size());
  for (std::size_t k = 0; k < uniforms_.size(); ++k) {
    const UniformStep& step = uniforms_[k];
    if (step.op == Op::Constant)
      exact[k] = step.value;
    else if (step.op == Op::Parameter)
      exact[k] = parameters[step.operands[0]];
    else if (step.op >= Op::Table && step.op <= Op::TableDy)
      exact[k] = tables_[step.operands[2]]->at(partOf(step.op), exact[step.operands[0]], exact[step.operands[1]]);
    else
      exact[k] = applyOp(step.op, exact[step.operands[0]], exact[step.operands[1]], exact[step.operands[2]]);
  }
  if constexpr (sizeof(T) != sizeof(double))
    for (std::size_t k = 0; k < uniforms_.size(); ++k) uniforms[k] = static_cast<T>(exact[k]);
  writeNativeConstants(uniforms + uniforms_.size());
  return uniforms;
}

bool Program::readsOutputs() const {
  for (const Instruction& instruction : instructions_)
    for (const Operand& operand : instruction.operands)
      if (operand.place == Place::Output) return true;
  return false;
}

template <class T>
void Program::runNative(const NativeCode<T>& code, const T* const* inputs, const T* uniforms, T* const* outputs,
                        std::size_t count) const {
  constexpr std::size_t inputCount = static_cast<std::size_t>(Input::Count);
  const std::size_t width = code.width();
  thread_local std::vector<T*> out;
  out.resize(outputCount_);
  // Lanes first .. first + length - 1, fewer than a vector, padded by repeating the last one.
  const auto runPart = [&](std::size_t first, std::size_t length) {
    if (length == 0) return;
    T* padded = scratch<T, 0>((inputCount + outputCount_) * width);
    const T* in[inputCount] = {};
    for (std::size_t k = 0; k < inputCount; ++k) {
      if (!reads_[k]) continue;
      T* lanes = padded + k * width;
      std::copy_n(inputs[k] + first, length, lanes);
      std::fill(lanes + length, lanes + width, lanes[length - 1]);
      in[k] = lanes;
    }
    for (std::size_t k = 0; k < outputCount_; ++k) out[k] = padded + (inputCount + k) * width;
    code.run(in, out.data(), uniforms, width);
    for (std::size_t k = 0; k < outputCount_; ++k) std::copy_n(out[k], length, outputs[k] + first);
  };

  // Outputs larger than the caches bypass them, from the first lane at which all are aligned to whole vectors.
  constexpr std::size_t large = std::size_t{4} << 20;  // bytes
  const auto misaligned = [&](std::size_t k) {
    return reinterpret_cast<std::uintptr_t>(outputs[k]) / sizeof(T) % width;
  };
  bool streaming = count >= 2 * width && count * outputCount_ * sizeof(T) >= large && !readsOutputs();
  for (std::size_t k = 1; k < outputCount_ && streaming; ++k) streaming = misaligned(k) == misaligned(0);
  if (!streaming) {
    const std::size_t whole = count / width * width;
    if (whole > 0) code.run(inputs, outputs, uniforms, whole);
    return runPart(whole, count - whole);
  }
  const std::size_t begin = (width - misaligned(0)) % width, whole = (count - begin) / width * width;
  runPart(0, begin);
  const T* in[inputCount] = {};
  for (std::size_t k = 0; k < inputCount; ++k)
    if (reads_[k]) in[k] = inputs[k] + begin;
  for (std::size_t k = 0; k < outputCount_; ++k) out[k] = outputs[k] + begin;
  code.runStreaming(in, out.data(), uniforms, whole);
  runPart(begin + whole, count - begin - whole);
}

template <class T>
void Program::runBlocks(const T* const* inputs, std::span<const double> parameters, T* const* outputs,
                        std::size_t count) const {
  constexpr std::size_t lanes = kLanes<T>;
  constexpr std::size_t inputCount = static_cast<std::size_t>(Input::Count);
  if (count == 0) return;

  const T* uniforms = uniformValues<T>(parameters);
  if (const NativeCode<T>* code = native<T>()) return runNative(*code, inputs, uniforms, outputs, count);

  // Scratch: registers, padded inputs and outputs for the last block.
  T* registers = scratch<T, 0>((registerCount_ + inputCount + outputCount_) * lanes);
  T* paddedInputs = registers + registerCount_ * lanes;
  T* paddedOutputs = paddedInputs + inputCount * lanes;

  // Instructions with their pointers. Those into arrays move on by a block after each block; registers and uniforms
  // stay.
  struct Call {
    Kernel<T> kernel;  // null: a table, or a loop's begin or end
    T* target;
    const T* operands[3];
  };
  thread_local std::vector<Call> calls;
  thread_local std::vector<const T**> streams;
  thread_local std::vector<int> rounds;
  rounds.assign(loops_.size(), 0);
  const auto resolve = [&](const T* const* in, T* const* out) {
    const KernelTable<T>& table = currentKernels<T>();
    calls.assign(instructions_.size(), Call{});
    streams.clear();
    for (std::size_t at = 0; at < instructions_.size(); ++at) {
      const Instruction& instruction = instructions_[at];
      if (instruction.kind != Instruction::Kind::Compute && instruction.kind != Instruction::Kind::Table) continue;
      Call& call = calls[at];
      unsigned mask = 0;
      for (unsigned k = 0; k < 3; ++k) {
        const Operand& operand = instruction.operands[k];
        const T*& pointer = call.operands[k];
        if (operand.place == Place::Register) {
          pointer = registers + operand.index * lanes;
        } else if (operand.place == Place::Uniform) {
          pointer = uniforms + operand.index;
          mask |= 1u << k;
        } else {
          pointer = operand.place == Place::Input ? in[operand.index] : out[operand.index];
          streams.push_back(&pointer);
        }
      }
      if (instruction.target.place == Place::Output) {
        call.target = out[instruction.target.index];
        streams.push_back(const_cast<const T**>(&call.target));
      } else {
        call.target = registers + instruction.target.index * lanes;
      }
      if (instruction.kind == Instruction::Kind::Compute)
        call.kernel = table.kernels[static_cast<std::size_t>(instruction.op)][mask];
    }
  };
  // A loop's operands, found by its place when it runs: loops are rare.
  const T* const* currentInputs = inputs;
  T* const* currentOutputs = outputs;
  const auto runLoop = [&](const Instruction& instruction, std::size_t offset) {
    const Loop& loop = loops_[instruction.index];
    const bool begins = instruction.kind == Instruction::Kind::LoopBegin;
    const auto source = [&](const Operand& operand) {
      switch (operand.place) {
        case Place::Input:
          return LoopOperand<T>{currentInputs[operand.index] + offset, 1};
        case Place::Output:
          return LoopOperand<T>{currentOutputs[operand.index] + offset, 1};
        case Place::Uniform:
          return LoopOperand<T>{uniforms + operand.index, 0};
        default:
          return LoopOperand<T>{registers + operand.index * lanes, 1};
      }
    };
    const auto state = [&](const Operand& operand) { return registers + operand.index * lanes; };
    LoopFrame<T> frame{source(loop.from),
                       source(loop.to),
                       source(loop.body),
                       source(loop.slope),
                       state(loop.bound),
                       state(loop.result),
                       {state(loop.state[0]), state(loop.state[1]), state(loop.state[2]), state(loop.state[3])},
                       loop.tolerance};
    int& round = rounds[instruction.index];
    if (loop.op == Op::Sum) return begins ? (round = 0, beginSum(frame)) : continueSum(frame, ++round);
    return begins ? (round = 0, beginSolve(frame)) : continueSolve(frame, ++round);
  };
  const auto runTable = [&](const Instruction& instruction, const Call& call) {
    const Table& table = *tables_[instruction.index];
    const std::size_t strideX = instruction.operands[0].place == Place::Uniform ? 0 : 1;
    const std::size_t strideY = instruction.operands[1].place == Place::Uniform ? 0 : 1;
    for (std::size_t i = 0; i < lanes; ++i)
      call.target[i] = table.at(partOf(instruction.op), call.operands[0][strideX * i], call.operands[1][strideY * i]);
  };
  const auto runBlock = [&](std::size_t offset) {
    for (std::size_t at = 0; at < calls.size(); ++at) {
      const Call& call = calls[at];
      if (call.kernel != nullptr) [[likely]] {
        call.kernel(call.target, call.operands[0], call.operands[1], call.operands[2]);
        continue;
      }
      const Instruction& instruction = instructions_[at];
      if (instruction.kind == Instruction::Kind::Table)
        runTable(instruction, call);
      else if (runLoop(instruction, offset) && instruction.kind == Instruction::Kind::LoopEnd)
        at = loops_[instruction.index].begin;
    }
    for (const T** const stream : streams) *stream += lanes;
  };

  const std::size_t whole = count / lanes * lanes;
  if (whole > 0) {
    resolve(inputs, outputs);
    // Long arrays come from memory: the next block's lines are asked for while this one computes.
    constexpr std::size_t line = 64 / sizeof(T);
    for (std::size_t first = 0; first < whole; first += lanes) {
      if (first + 2 * lanes <= whole) {
        for (std::size_t k = 0; k < inputCount; ++k)
          if (reads_[k])
            for (std::size_t i = first + lanes; i < first + 2 * lanes; i += line) __builtin_prefetch(inputs[k] + i);
        for (std::size_t k = 0; k < outputCount_; ++k)
          for (std::size_t i = first + lanes; i < first + 2 * lanes; i += line) __builtin_prefetch(outputs[k] + i, 1);
      }
      runBlock(first);
    }
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
  currentInputs = in;
  currentOutputs = out.data();
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
  const FlushTinyFloats flush;
  runBlocks<float>(inputs, parameters, outputs, count);
}

}  // namespace brdf::formula
