#pragma once
#include <brdf/brdf_export.h>
#include <brdf/formula/Graph.h>

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace brdf::formula {

template <class T>
class NativeCode;

/// A graph compiled for batches: instructions over blocks of lanes, registers reused as soon as they are free, inputs
/// read where they lie. What depends on parameters alone is computed once a run, in double. Immutable; one Program may
/// run in several threads.
class BRDF_EXPORT Program {
 public:
  /// Compiles the nodes that `outputs` need.
  Program(const Graph& graph, const std::vector<NodeId>& outputs);

  /// Evaluates `count` lanes on the calling thread. `inputs[k]` holds `count` numbers for each Input k that the program
  /// reads (others may be null); `parameters` one number for each Parameter index; `outputs[k]` receives `count`
  /// numbers.
  void run(const double* const* inputs, std::span<const double> parameters, double* const* outputs,
           std::size_t count) const;
  /// The same in float. Results below the smallest normal float (1.2e-38) are flushed to 0.
  void run(const float* const* inputs, std::span<const double> parameters, float* const* outputs,
           std::size_t count) const;

  std::size_t outputCount() const { return outputCount_; }
  std::size_t instructionCount() const { return instructions_.size(); }
  std::size_t registerCount() const { return registerCount_; }
  /// Whether every lane goes the same way: no loops, no tables.
  bool straight() const { return loops_.empty() && tables_.empty(); }
  /// Whether an instruction reads an output again.
  bool readsOutputs() const;
  bool reads(Input input) const { return reads_[static_cast<std::size_t>(input)]; }

 private:
  friend class ProgramCompiler;
  friend class NativeAssembler;
  friend class NativeEmitter;
  friend struct NativePlan;

  enum class Place : std::uint8_t { Register, Input, Output, Uniform };
  struct Operand {
    Place place = Place::Register;
    std::uint32_t index = 0;
  };
  struct Instruction {
    enum class Kind : std::uint8_t { Compute, Table, LoopBegin, LoopEnd };
    Kind kind = Kind::Compute;
    Op op = Op::Copy;
    Operand target;
    Operand operands[3];
    std::uint32_t index = 0;  ///< into loops_ of LoopBegin and LoopEnd, into tables_ of Table
  };
  struct Loop {
    Op op = Op::Sum;          ///< Sum or Solve
    double tolerance = 0;     ///< Sum
    Operand from, to;         ///< first and last, or the bracket
    Operand body, slope;      ///< term, or f and df/dx
    Operand bound, result;    ///< registers
    Operand state[4];         ///< registers, see Loops.h
    std::uint32_t begin = 0;  ///< index of its LoopBegin
  };
  struct UniformStep {
    Op op = Op::Constant;
    std::uint32_t operands[3] = {0, 0, 0};  ///< earlier uniforms; Parameter: its index in operands[0]; tables: [2]
    double value = 0;
  };

  template <class T>
  void runBlocks(const T* const* inputs, std::span<const double> parameters, T* const* outputs,
                 std::size_t count) const;

  /// Machine code for the type and the instruction set in use, made at its first use; null where there is none.
  template <class T>
  const NativeCode<T>* native() const;
  /// The uniforms for these parameters, and behind them what machine code expects, in the calling thread's memory.
  template <class T>
  const T* uniformValues(std::span<const double> parameters) const;
  template <class T>
  void runNative(const NativeCode<T>& code, const T* const* inputs, const T* uniforms, T* const* outputs,
                 std::size_t count) const;

  struct Natives;
  static std::shared_ptr<Natives> makeNatives();
  std::shared_ptr<Natives> natives_ = makeNatives();
  std::vector<UniformStep> uniforms_;
  std::vector<Instruction> instructions_;
  std::vector<Loop> loops_;
  std::vector<std::shared_ptr<const Table>> tables_;
  std::size_t registerCount_ = 0;
  std::size_t outputCount_ = 0;
  bool reads_[static_cast<std::size_t>(Input::Count)] = {};
};

/// Names of the instruction sets this machine can run, best first: "avx512", "avx512_kernels", "avx2", "avx2_kernels",
/// "sse2", "generic". The first and third make machine code of a program at its first use (formula/NativeCode.h); all
/// run loops and tables, and the others everything, operation by operation over blocks.
BRDF_EXPORT std::vector<std::string_view> instructionSets();
/// The one in use; the best by default. Setting an unknown or unavailable one throws Error::Kind::Value. For tests and
/// measurements: not to be changed while programs run.
BRDF_EXPORT std::string_view instructionSet();
BRDF_EXPORT void setInstructionSet(std::string_view name);

}  // namespace brdf::formula
