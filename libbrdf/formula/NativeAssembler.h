#pragma once
// Where a Program's values lie in the processor, and its vector instructions for float and double under one name.
// Internal to NativeEmitter.h.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/Program.h>
#include <xbyak/xbyak.h>

namespace brdf::formula {

/// Register use: rbx inputs, rbp outputs, r12 uniforms, r13 byte offset of the vector, r14 its end, rsp the spill slots
/// (one a program register), rax addresses. Vector registers 0 to 5 are scratch (and arguments), the rest hold the
/// program's registers; those for which there is none live in their slots.
class NativeAssembler : protected Xbyak::CodeGenerator {
 protected:
  /// `scalarBytes`: 4 for float, 8 for double. `streaming`: outputs, aligned to whole vectors, go to memory past the
  /// caches.
  NativeAssembler(const Program& program, const KernelSet& set, std::size_t scalarBytes, bool streaming)
      : Xbyak::CodeGenerator(4096, Xbyak::AutoGrow),
        program_(program),
        set_(set),
        scalarBytes_(scalarBytes),
        single_(scalarBytes == 4),
        streaming_(streaming),
        wide_(set.vectorBytes == 64),
        constants_(program.uniforms_.size()) {}

  using Vector = Xbyak::Xmm;  // of any width: the encoder looks at the register
  using Address = Xbyak::Address;
  using Place = Program::Place;
  using ProgramOperand = Program::Operand;
  using Instruction = Program::Instruction;
  static constexpr int kScratch = 6;
  enum Constant { kOne, kHalf, kThreeEighths, kSign, kMagnitude };

  Vector vector(int index) const { return wide_ ? Vector(Xbyak::Zmm(index)) : Vector(Xbyak::Ymm(index)); }
  std::size_t registersForProgram() const { return (wide_ ? 32 : 16) - kScratch; }
  bool inRegister(const ProgramOperand& o) const {
    return o.place == Place::Register && o.index < registersForProgram();
  }
  Vector registerOf(const ProgramOperand& o) const { return vector(kScratch + static_cast<int>(o.index)); }

  // ----- values ------------------------------------------------------------------------------------------------

  Address slot(std::size_t programRegister) const {
    return ptr[rsp + static_cast<int>(programRegister * set_.vectorBytes)];
  }
  Address uniform(std::size_t index) const { return ptr[r12 + static_cast<int>(index * scalarBytes_)]; }
  Address uniformToAllLanes(std::size_t index) const { return ptr_b[r12 + static_cast<int>(index * scalarBytes_)]; }
  /// Where an input, an output or a spilled register lies; uses rax.
  Address memory(const ProgramOperand& o) {
    if (o.place == Place::Register) return slot(o.index);
    mov(rax, ptr[(o.place == Place::Input ? rbx : rbp) + static_cast<int>(8 * o.index)]);
    return ptr[rax + r13];
  }
  void broadcast(const Vector& to, std::size_t index) {
    const int k = to.getIdx();
    if (single_)
      vbroadcastss(to, uniform(index));
    else if (wide_)
      vbroadcastsd(Xbyak::Zmm(k), uniform(index));
    else
      vbroadcastsd(Xbyak::Ymm(k), uniform(index));
  }
  void broadcastConstant(const Vector& to, Constant constant) { broadcast(to, constants_ + constant); }
  void loadInto(const Vector& to, const ProgramOperand& o) {
    if (inRegister(o))
      vmovaps(to, registerOf(o));
    else if (o.place == Place::Uniform)
      broadcast(to, o.index);
    else
      vmovups(to, memory(o));
  }
  /// The operand in a register: its own, or `scratch` filled with it.
  Vector load(const ProgramOperand& o, int scratch) {
    if (inRegister(o)) return registerOf(o);
    loadInto(vector(scratch), o);
    return vector(scratch);
  }
  /// Calls use(operand) with a register or, where an instruction can take it, a memory operand.
  template <class Use>
  void withOperand(const ProgramOperand& o, int scratch, const Use& use) {
    if (inRegister(o))
      use(registerOf(o));
    else if (o.place != Place::Uniform)
      use(memory(o));
    else if (wide_)
      use(uniformToAllLanes(o.index));
    else
      use(load(o, scratch));
  }
  template <class Use>
  void withConstant(Constant constant, int scratch, const Use& use) {
    withOperand({Place::Uniform, static_cast<std::uint32_t>(constants_ + constant)}, scratch, use);
  }
  /// Calls make(register) for the target's register, or for scratch 5 that is then stored.
  template <class Make>
  void into(const ProgramOperand& target, const Make& make) {
    if (inRegister(target)) return make(registerOf(target));
    make(vector(5));
    store(target, vector(5));
  }
  /// To an output or a spilled register.
  void store(const ProgramOperand& target, const Vector& from) {
    if (streaming_ && target.place == Place::Output)
      vmovntps(memory(target), from);
    else
      vmovups(memory(target), from);
  }

  // ----- operations --------------------------------------------------------------------------------------------

#define BRDF_BOTH(name, ps, pd)     \
  template <class... Operands>      \
  void name(const Operands&... o) { \
    if (single_)                    \
      ps(o...);                     \
    else                            \
      pd(o...);                     \
  }
  BRDF_BOTH(plus, vaddps, vaddpd)
  BRDF_BOTH(minus, vsubps, vsubpd)
  BRDF_BOTH(times, vmulps, vmulpd)
  BRDF_BOTH(over, vdivps, vdivpd)
  BRDF_BOTH(least, vminps, vminpd)
  BRDF_BOTH(most, vmaxps, vmaxpd)
  BRDF_BOTH(root, vsqrtps, vsqrtpd)
  BRDF_BOTH(bitAnd, vandps, vandpd)
  BRDF_BOTH(bitXor, vxorps, vxorpd)
  BRDF_BOTH(compare, vcmpps, vcmppd)
  BRDF_BOTH(reciprocal14, vrcp14ps, vrcp14pd)
  BRDF_BOTH(reciprocalRoot14, vrsqrt14ps, vrsqrt14pd)
  BRDF_BOTH(fma213, vfmadd213ps, vfmadd213pd)
  BRDF_BOTH(fma231, vfmadd231ps, vfmadd231pd)
  BRDF_BOTH(fms213, vfmsub213ps, vfmsub213pd)
  BRDF_BOTH(fms231, vfmsub231ps, vfmsub231pd)
  BRDF_BOTH(fnma213, vfnmadd213ps, vfnmadd213pd)
  BRDF_BOTH(fnma231, vfnmadd231ps, vfnmadd231pd)
  BRDF_BOTH(blendByVector, vblendvps, vblendvpd)
  BRDF_BOTH(blendByMask, vblendmps, vblendmpd)
  BRDF_BOTH(classify, vfpclassps, vfpclasspd)
  BRDF_BOTH(round, vroundps, vroundpd)
  BRDF_BOTH(roundScaled, vrndscaleps, vrndscalepd)
#undef BRDF_BOTH

  enum Predicate { kEqual = 0, kLess = 1, kLessEqual = 2, kUnordered = 3, kNotEqual = 4 };
  enum Class { kZero = 0x06, kSubnormal = 0x20 };  ///< of vfpclass; may be added

  const Program& program_;
  const KernelSet& set_;
  std::size_t scalarBytes_;
  bool single_, streaming_, wide_;
  std::size_t constants_;
};

}  // namespace brdf::formula
