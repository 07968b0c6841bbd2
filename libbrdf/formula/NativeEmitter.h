#pragma once
// Translates a Program's instructions to AVX2 or AVX-512. Internal to NativeCode.cpp.
#include <brdf/formula/Kernels.h>
#include <brdf/formula/Program.h>
#include <xbyak/xbyak.h>

#include <functional>

namespace brdf::formula {

/// Register use: rbx inputs, rbp outputs, r12 uniforms, r13 byte offset of the vector, r14 its end, rsp the spill slots
/// (one a program register). Vector registers 0 to 5 are scratch (and arguments), the rest hold the program's
/// registers; those for which there is none live in their slots.
template <class T>
class NativeEmitter : private Xbyak::CodeGenerator {
 public:
  using Function = void (*)(const T* const* inputs, T* const* outputs, const T* uniforms, std::size_t bytes);

  /// `streaming`: outputs, aligned to whole vectors, go to memory past the caches.
  NativeEmitter(const Program& program, const KernelSet& set, bool streaming)
      : Xbyak::CodeGenerator(4096, Xbyak::AutoGrow),
        program_(program),
        set_(set),
        streaming_(streaming),
        wide_(set.vectorBytes == 64),
        constants_(program.uniforms_.size()) {
    findLive();
    emitFunction();
  }

  Function finish() {
    readyRE();
    return getCode<Function>();
  }

 private:
  using Vector = Xbyak::Xmm;  // of any width: the encoder looks at the register
  using Address = Xbyak::Address;
  using Place = Program::Place;
  using ProgramOperand = Program::Operand;
  using Instruction = Program::Instruction;
  static constexpr bool kSingle = sizeof(T) == 4;
  static constexpr int kScratch = 6;
  enum Constant { kOne, kHalf, kThreeEighths, kSign, kMagnitude, kLargestDivisor };

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
  Address uniform(std::size_t index) const { return ptr[r12 + static_cast<int>(index * sizeof(T))]; }
  Address uniformToAllLanes(std::size_t index) const { return ptr_b[r12 + static_cast<int>(index * sizeof(T))]; }
  /// Where an input, an output or a spilled register lies; uses rax.
  Address memory(const ProgramOperand& o) {
    if (o.place == Place::Register) return slot(o.index);
    mov(rax, ptr[(o.place == Place::Input ? rbx : rbp) + static_cast<int>(8 * o.index)]);
    return ptr[rax + r13];
  }
  void broadcast(const Vector& to, std::size_t index) {
    const int k = to.getIdx();
    if constexpr (kSingle)
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
    if constexpr (kSingle)          \
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
#undef BRDF_BOTH

  enum Predicate { kEqual = 0, kLess = 1, kLessEqual = 2, kNotEqual = 4, kOrdered = 7 };

  template <class Emit>
  void binary(const Instruction& i, const Emit& emit) {
    const Vector a = load(i.operands[0], 0);
    withOperand(i.operands[1], 1,
                [&](const Xbyak::Operand& b) { into(i.target, [&](const Vector& to) { emit(to, a, b); }); });
  }

  /// 1 where the comparison holds, else 0.
  void comparison(const Instruction& i, Predicate predicate) {
    const Vector a = load(i.operands[0], 0), b = load(i.operands[1], 1);
    condition(a, b, predicate);
    truthInto(i.target);
  }
  /// Leaves a condition in k1, or in scratch 3 as all bits.
  void condition(const Vector& a, const Vector& b, Predicate predicate) {
    if (wide_)
      compare(k1, a, b, predicate);
    else
      compare(vector(3), a, b, predicate);
  }
  void truthInto(const ProgramOperand& target) {
    into(target, [&](const Vector& to) {
      if (wide_) {
        if constexpr (kSingle)
          vbroadcastss(to | k1 | T_z, uniform(constants_ + kOne));
        else
          vbroadcastsd(Xbyak::Zmm(to.getIdx()) | k1 | T_z, uniform(constants_ + kOne));
      } else {
        broadcastConstant(vector(4), kOne);
        bitAnd(to, vector(3), vector(4));
      }
    });
  }
  /// Both, either, or the opposite of truths.
  void logic(const Instruction& i) {
    const Vector zero = vector(4);
    vxorps(Xbyak::Xmm(4), Xbyak::Xmm(4), Xbyak::Xmm(4));
    const Vector a = load(i.operands[0], 0);
    if (i.op == Op::Not) {
      condition(a, zero, kEqual);
      return truthInto(i.target);
    }
    const Vector b = load(i.operands[1], 1);
    if (wide_) {
      compare(k1, a, zero, kNotEqual);
      compare(k2, b, zero, kNotEqual);
      if (i.op == Op::And)
        kandw(k1, k1, k2);
      else
        korw(k1, k1, k2);
    } else {
      compare(vector(2), a, zero, kNotEqual);
      compare(vector(3), b, zero, kNotEqual);
      if (i.op == Op::And)
        vandps(vector(3), vector(3), vector(2));
      else
        vorps(vector(3), vector(3), vector(2));
    }
    truthInto(i.target);
  }
  void select(const Instruction& i) {
    vxorps(Xbyak::Xmm(4), Xbyak::Xmm(4), Xbyak::Xmm(4));
    const Vector test = load(i.operands[0], 0);
    condition(test, vector(4), kNotEqual);
    const Vector yes = load(i.operands[1], 1), no = load(i.operands[2], 2);
    into(i.target, [&](const Vector& to) {
      if (wide_)
        blendByMask(to | k1, no, yes);
      else
        blendByVector(to, no, yes, vector(3));
    });
  }

  /// a * b + c (MulAdd), a * b - c (MulSub) or c - a * b (NegMulAdd), rounded once.
  void fused(const Instruction& i) {
    const ProgramOperand &a = i.operands[0], &b = i.operands[1], &c = i.operands[2];
    const auto with213 = [&](const Vector& to, const Vector& by, const Xbyak::Operand& added) {
      if (i.op == Op::MulAdd)
        fma213(to, by, added);
      else if (i.op == Op::MulSub)
        fms213(to, by, added);
      else
        fnma213(to, by, added);
    };
    const auto same = [&](const ProgramOperand& o) {
      return inRegister(i.target) && inRegister(o) && o.index == i.target.index;
    };
    if (same(c)) {
      const Vector to = registerOf(i.target), first = load(a, 0);
      withOperand(b, 1, [&](const Xbyak::Operand& second) {
        if (i.op == Op::MulAdd)
          fma231(to, first, second);
        else if (i.op == Op::MulSub)
          fms231(to, first, second);
        else
          fnma231(to, first, second);
      });
    } else if (same(a) || same(b)) {
      const Vector by = load(same(a) ? b : a, 0);
      withOperand(c, 1, [&](const Xbyak::Operand& added) { with213(registerOf(i.target), by, added); });
    } else {
      const Vector by = load(b, 0);
      into(i.target, [&](const Vector& to) {
        loadInto(to, a);
        withOperand(c, 1, [&](const Xbyak::Operand& added) { with213(to, by, added); });
      });
    }
  }

  // Quotient and root as in KernelsX86.inl, step by step: the same values.

  void divide(const Instruction& i) {
    const Vector a = load(i.operands[0], 0), b = load(i.operands[1], 1);
    if (!wide_) return into(i.target, [&](const Vector& to) { over(to, a, b); });
    const Vector r = vector(2), e = vector(3), q = vector(4), rest = vector(5);
    reciprocal14(r, b);
    broadcastConstant(e, kOne);
    fnma231(e, b, r);
    if constexpr (kSingle) {
      fma213(e, r, r);
    } else {
      fma213(e, e, e);
      fma213(e, r, r);
    }
    times(q, a, e);
    vmovaps(rest, a);
    fnma231(rest, b, q);
    fma213(rest, e, q);  // the quotient
    compare(k1, rest, rest, kOrdered);
    withConstant(kMagnitude, 2, [&](const Xbyak::Operand& mask) { bitAnd(q, b, mask); });
    withConstant(kLargestDivisor, 2, [&](const Xbyak::Operand& limit) { compare(k1 | k1, q, limit, kLess); });
    if constexpr (!kSingle) {
      vfpclasspd(k2, a, 0x20);
      kandnb(k1, k2, k1);
    }
    orElse([this, a, b, rest] { over(rest, a, b); });
    moveInto(i.target, rest);
  }

  void squareRoot(const Instruction& i) {
    const Vector a = load(i.operands[0], 0);
    if (!wide_) return into(i.target, [&](const Vector& to) { root(to, a); });
    const Vector y = vector(1), s = vector(2), e = vector(3), t = vector(4);
    reciprocalRoot14(y, a);
    if constexpr (!kSingle) {
      times(s, a, y);
      broadcastConstant(e, kOne);
      fnma231(e, s, y);
      broadcastConstant(t, kHalf);
      withConstant(kThreeEighths, 5, [&](const Xbyak::Operand& c) { fma231(t, e, c); });
      times(e, e, y);
      fma231(y, t, e);
    }
    times(s, a, y);
    withConstant(kHalf, 5, [&](const Xbyak::Operand& half) { times(y, y, half); });
    vmovaps(e, s);
    fnma213(e, s, a);
    fma213(e, y, s);  // the root
    compare(k1, e, e, kOrdered);
    orElse([this, a, e] { root(e, a); });
    moveInto(i.target, e);
  }

  void moveInto(const ProgramOperand& target, const Vector& from) {
    if (inRegister(target))
      vmovaps(registerOf(target), from);
    else
      store(target, from);
  }

  /// Where k1 does not hold for every lane, does `other`, out of the way of those who need it not.
  void orElse(std::function<void()> other) {
    if constexpr (kSingle)
      kortestw(k1, k1);
    else
      kortestb(k1, k1);
    detours_.push_back({Xbyak::Label(), Xbyak::Label(), std::move(other)});
    jnc(detours_.back().begin, T_NEAR);
    L(detours_.back().end);
  }

  /// The kernel set's own function; it may change every vector register.
  void call(const Instruction& i, const std::vector<bool>& live) {
    const int count = arity(i.op);
    for (std::size_t k = 0; k < live.size(); ++k)
      if (live[k] && k < registersForProgram()) vmovups(slot(k), vector(kScratch + static_cast<int>(k)));
    for (int k = 0; k < count; ++k) loadInto(vector(k), i.operands[k]);
    const auto* functions = static_cast<const VectorFunction*>(kSingle ? set_.floatFunctions : set_.doubleFunctions);
    const std::size_t which = static_cast<std::size_t>(i.op) + (count == 2 ? static_cast<std::size_t>(Op::Count) : 0);
    mov(rax, reinterpret_cast<std::size_t>(functions[which]));
    Xbyak::CodeGenerator::call(rax);
    moveInto(i.target, vector(0));
    for (std::size_t k = 0; k < live.size(); ++k)
      if (live[k] && k < registersForProgram() && !(i.target.place == Place::Register && i.target.index == k))
        vmovups(vector(kScratch + static_cast<int>(k)), slot(k));
  }

  void emit(const Instruction& i, const std::vector<bool>& live) {
    switch (i.op) {
      case Op::Neg:
      case Op::Abs: {
        const Vector a = load(i.operands[0], 0);
        return withConstant(i.op == Op::Neg ? kSign : kMagnitude, 1, [&](const Xbyak::Operand& mask) {
          into(i.target, [&](const Vector& to) { i.op == Op::Neg ? bitXor(to, a, mask) : bitAnd(to, a, mask); });
        });
      }
      case Op::Copy:
        return into(i.target, [&](const Vector& to) { loadInto(to, i.operands[0]); });
      case Op::Add:
        return binary(i, [&](const Vector& to, const Vector& a, const Xbyak::Operand& b) { plus(to, a, b); });
      case Op::Sub:
        return binary(i, [&](const Vector& to, const Vector& a, const Xbyak::Operand& b) { minus(to, a, b); });
      case Op::Mul:
        return binary(i, [&](const Vector& to, const Vector& a, const Xbyak::Operand& b) { times(to, a, b); });
      case Op::Min:
      case Op::Max: {  // the instruction gives its second operand at a tie and for NaN: that must be the language's
                       // first
        const Vector b = load(i.operands[1], 0);
        return withOperand(i.operands[0], 1, [&](const Xbyak::Operand& a) {
          into(i.target, [&](const Vector& to) { i.op == Op::Min ? least(to, b, a) : most(to, b, a); });
        });
      }
      case Op::Less:
        return comparison(i, kLess);
      case Op::LessEqual:
        return comparison(i, kLessEqual);
      case Op::Equal:
        return comparison(i, kEqual);
      case Op::Not:
      case Op::And:
      case Op::Or:
        return logic(i);
      case Op::Select:
        return select(i);
      case Op::MulAdd:
      case Op::MulSub:
      case Op::NegMulAdd:
        return fused(i);
      case Op::Div:
        return divide(i);
      case Op::Sqrt:
        return squareRoot(i);
      default:
        return call(i, live);
    }
  }

  // ----- the whole ---------------------------------------------------------------------------------------------

  /// For each instruction, the program registers that are read after it before they are written.
  void findLive() {
    const std::vector<Instruction>& list = program_.instructions_;
    std::vector<bool> live(program_.registerCount_, false);
    liveAfter_.resize(list.size());
    for (std::size_t at = list.size(); at-- > 0;) {
      liveAfter_[at] = live;
      if (list[at].target.place == Place::Register) live[list[at].target.index] = false;
      for (int k = 0; k < std::max(1, arity(list[at].op)); ++k)
        if (list[at].operands[k].place == Place::Register) live[list[at].operands[k].index] = true;
    }
  }

  void emitFunction() {
    const Xbyak::Reg64 saved[] = {rbx, rbp, r12, r13, r14, r15};
    for (const Xbyak::Reg64& reg : saved) push(reg);
    mov(rbx, rdi);
    mov(rbp, rsi);
    mov(r12, rdx);
    mov(r14, rcx);
    mov(r15, rsp);
    sub(rsp, static_cast<int>(program_.registerCount_ * set_.vectorBytes + 64));
    and_(rsp, -64);
    xor_(r13, r13);
    Xbyak::Label next, done;
    test(r14, r14);
    jz(done, T_NEAR);
    align(32);
    L(next);
    for (std::size_t at = 0; at < program_.instructions_.size(); ++at) emit(program_.instructions_[at], liveAfter_[at]);
    add(r13, static_cast<int>(set_.vectorBytes));
    cmp(r13, r14);
    jb(next, T_NEAR);
    L(done);
    if (streaming_) sfence();
    mov(rsp, r15);
    for (std::size_t k = std::size(saved); k-- > 0;) pop(saved[k]);
    vzeroupper();
    ret();
    for (Detour& detour : detours_) {
      L(detour.begin);
      detour.body();
      jmp(detour.end, T_NEAR);
    }
  }

  struct Detour {
    Xbyak::Label begin, end;
    std::function<void()> body;
  };

  const Program& program_;
  const KernelSet& set_;
  bool streaming_, wide_;
  std::size_t constants_;
  std::vector<std::vector<bool>> liveAfter_;
  std::vector<Detour> detours_;
};

}  // namespace brdf::formula
