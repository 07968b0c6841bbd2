#pragma once
// Machine code of a Program: one loop over vectors of lanes, its values kept in the processor's registers. Internal to
// libbrdf/formula.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/Program.h>

#include <memory>

namespace brdf::formula {

/// Machine code of one program for one instruction set and one type. Simple operations are instructions; the others
/// call the functions of the kernel set, so that either way gives the same values.
template <class T>
class NativeCode {
 public:
  /// Null where there is none: for sets other than AVX2 and AVX-512, programs with loops or tables (whose lanes go
  /// different ways), and where the system forbids making code.
  static std::unique_ptr<const NativeCode> make(const Program& program, const KernelSet& set);
  ~NativeCode();

  /// Lanes of one vector.
  std::size_t width() const;
  /// Runs over `count` lanes, a multiple of width(). `uniforms` has kNativeConstants numbers more behind the program's
  /// (writeNativeConstants()).
  void run(const T* const* inputs, T* const* outputs, const T* uniforms, std::size_t count) const;
  /// The same for outputs that do not fit in the caches: they are written without being read into them first. Outputs
  /// are aligned to whole vectors, and none is an operand (Program::readsOutputs()).
  void runStreaming(const T* const* inputs, T* const* outputs, const T* uniforms, std::size_t count) const;

 private:
  struct Code;
  explicit NativeCode(std::unique_ptr<Code> code);
  std::unique_ptr<Code> code_;
};

inline constexpr std::size_t kNativeConstants = 5;
/// What machine code expects behind the uniforms: 1, 1/2, 3/8, the sign bit, and all bits but it.
template <class T>
void writeNativeConstants(T* behindUniforms);

}  // namespace brdf::formula
