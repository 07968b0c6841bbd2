#pragma once
// Translates a Program's instructions to AVX2 or AVX-512. Internal to NativeCode.cpp.
#include <brdf/formula/NativeAssembler.h>
#include <brdf/formula/NativePlan.h>

#include <functional>

namespace brdf::formula {

/// The machine code of one straight program, which lives as long as this.
class NativeEmitter : private NativeAssembler {
 public:
  NativeEmitter(const Program& program, const KernelSet& set, std::size_t scalarBytes, bool streaming)
      : NativeAssembler(program, set, scalarBytes, streaming),
        functions_(static_cast<const VectorFunction*>(single_ ? set.floatFunctions : set.doubleFunctions)),
        plan_(
            program, [this](Op op) { return function(op) != nullptr; }, wide_ ? kMasks : NativePlan::kUnlimited),
        heldMask_(program.registerCount_, NativePlan::kNumber) {
    emitFunction();
  }

  /// `T` as scalarBytes says.
  template <class T>
  using Function = void (*)(const T* const* inputs, T* const* outputs, const T* uniforms, std::size_t bytes);
  template <class T>
  Function<T> finish() {
    readyRE();
    return getCode<Function<T>>();
  }

 private:
  static constexpr int kFirstMask = 4, kMasks = 4;  // k1 to k3 are scratch

  /// The kernel set's own function of an operation, or null.
  VectorFunction function(Op op) const {
    const std::size_t binary = arity(op) == 2 ? static_cast<std::size_t>(Op::Count) : 0;
    return functions_[static_cast<std::size_t>(op) + binary];
  }

  template <class Emit>
  void binary(const Instruction& i, const Emit& emit) {
    const Vector a = load(i.operands[0], 0);
    withOperand(i.operands[1], 1,
                [&](const Xbyak::Operand& b) { into(i.target, [&](const Vector& to) { emit(to, a, b); }); });
  }

  // Truths. A truth that serves only as a condition stays one: in a mask register (AVX-512), or in the vector register
  // as all bits (AVX2). Any other is 1 or 0.

  bool isCondition(const ProgramOperand& o) const {
    return o.place == Place::Register && heldMask_[o.index] != NativePlan::kNumber;
  }
  /// The mask register that is to hold the truth in work.
  Xbyak::Opmask maskInWork() const { return mask_ < 0 ? k1 : Xbyak::Opmask(kFirstMask + mask_); }
  /// AVX-512: the operand's truth in a mask register, its own or `scratch`; scratch vector 4 is 0.
  Xbyak::Opmask truthMask(const ProgramOperand& o, const Xbyak::Opmask& scratch) {
    if (isCondition(o)) return Xbyak::Opmask(kFirstMask + heldMask_[o.index]);
    compare(scratch, load(o, 0), vector(4), kNotEqual);
    return scratch;
  }
  /// AVX2: the operand's truth as all bits of a vector register, its own or `scratch`; scratch vector 4 is 0.
  Vector truthBits(const ProgramOperand& o, int scratch) {
    const Vector value = load(o, scratch);
    if (isCondition(o)) return value;
    compare(vector(scratch), value, vector(4), kNotEqual);
    return vector(scratch);
  }
  void clearScratch4() { vxorps(Xbyak::Xmm(4), Xbyak::Xmm(4), Xbyak::Xmm(4)); }
  /// Stores the truth in maskInWork() or, as all bits, in scratch 3.
  void truthInto(const ProgramOperand& target) {
    if (mask_ >= 0) {
      if (!wide_) moveInto(target, vector(3));
      return;
    }
    into(target, [&](const Vector& to) {
      if (!wide_) {
        broadcastConstant(vector(4), kOne);
        bitAnd(to, vector(3), vector(4));
      } else if (single_) {
        vbroadcastss(to | k1 | T_z, uniform(constants_ + kOne));
      } else {
        vbroadcastsd(Xbyak::Zmm(to.getIdx()) | k1 | T_z, uniform(constants_ + kOne));
      }
    });
  }

  void comparison(const Instruction& i, Predicate predicate) {
    const Vector a = load(i.operands[0], 0), b = load(i.operands[1], 1);
    if (wide_)
      compare(maskInWork(), a, b, predicate);
    else
      compare(vector(3), a, b, predicate);
    truthInto(i.target);
  }
  void logic(const Instruction& i) {
    clearScratch4();
    if (wide_) {
      const Xbyak::Opmask a = truthMask(i.operands[0], k1), b = i.op == Op::Not ? a : truthMask(i.operands[1], k2);
      if (i.op == Op::Not)
        knotw(maskInWork(), a);
      else if (i.op == Op::And)
        kandw(maskInWork(), a, b);
      else
        korw(maskInWork(), a, b);
    } else {
      const Vector a = truthBits(i.operands[0], 1), b = i.op == Op::Not ? a : truthBits(i.operands[1], 2);
      if (i.op == Op::Not) {
        compare(vector(4), vector(4), vector(4), kEqual);
        vxorps(vector(3), a, vector(4));
      } else if (i.op == Op::And) {
        vandps(vector(3), a, b);
      } else {
        vorps(vector(3), a, b);
      }
    }
    truthInto(i.target);
  }
  void select(const Instruction& i) {
    if (!isCondition(i.operands[0])) clearScratch4();
    if (wide_) {
      const Xbyak::Opmask test = truthMask(i.operands[0], k1);
      const Vector no = load(i.operands[2], 2);
      withOperand(i.operands[1], 1, [&](const Xbyak::Operand& yes) {
        into(i.target, [&](const Vector& to) { blendByMask(to | test, no, yes); });
      });
    } else {
      const Vector test = truthBits(i.operands[0], 3), yes = load(i.operands[1], 1), no = load(i.operands[2], 2);
      into(i.target, [&](const Vector& to) { blendByVector(to, no, yes, test); });
    }
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
    if (single_) {
      fma213(e, r, r);
    } else {
      fma213(e, e, e);
      fma213(e, r, r);
    }
    times(q, a, e);
    vmovaps(rest, a);
    fnma231(rest, b, q);
    fma213(rest, e, q);  // the quotient
    compare(k1, rest, rest, kUnordered);
    classify(k2, e, kZero | kSubnormal);
    if (!single_) {
      classify(k3, a, kSubnormal);
      korw(k2, k2, k3);
    }
    orElse(k2, [this, a, b, rest] { over(rest, a, b); });
    moveInto(i.target, rest);
  }

  void squareRoot(const Instruction& i) {
    const Vector a = load(i.operands[0], 0);
    if (!wide_) return into(i.target, [&](const Vector& to) { root(to, a); });
    const Vector y = vector(1), s = vector(2), e = vector(3), t = vector(4);
    reciprocalRoot14(y, a);
    if (!single_) {
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
    compare(k1, e, e, kUnordered);
    orElse(k1, [this, a, e] { root(e, a); });
    moveInto(i.target, e);
  }

  void moveInto(const ProgramOperand& target, const Vector& from) {
    if (inRegister(target))
      vmovaps(registerOf(target), from);
    else
      store(target, from);
  }

  /// Where k1 or `either` holds for any lane, does `other`, out of the way of those who need it not.
  void orElse(const Xbyak::Opmask& either, std::function<void()> other) {
    kortestw(k1, either);
    detours_.push_back({Xbyak::Label(), Xbyak::Label(), std::move(other)});
    jnz(detours_.back().begin, T_NEAR);
    L(detours_.back().end);
  }

  /// Calls function(), which may change every vector and mask register.
  void call(const Instruction& i, const std::vector<bool>& live) {
    const int count = arity(i.op);
    for (std::size_t k = 0; k < live.size(); ++k)
      if (live[k] && k < registersForProgram()) vmovups(slot(k), vector(kScratch + static_cast<int>(k)));
    for (int k = 0; k < count; ++k) loadInto(vector(k), i.operands[k]);
    mov(rax, reinterpret_cast<std::size_t>(function(i.op)));
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
      case Op::Floor: {
        constexpr int down = 9;  // towards -infinity, without the exception "inexact"
        const Vector a = load(i.operands[0], 0);
        return into(i.target, [&](const Vector& to) { wide_ ? roundScaled(to, a, down) : round(to, a, down); });
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

  /// Asks for the inputs' lines some vectors ahead: the processor itself stops at the ends of pages.
  void prefetchInputs() {
    for (std::size_t k = 0; k < std::size(program_.reads_); ++k) {
      if (!program_.reads_[k]) continue;
      mov(rax, ptr[rbx + static_cast<int>(8 * k)]);
      prefetcht0(ptr[rax + r13 + kPrefetchDistance]);
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
    if (streaming_) prefetchInputs();
    for (std::size_t at = 0; at < program_.instructions_.size(); ++at) {
      const Instruction& instruction = program_.instructions_[at];
      mask_ = plan_.mask[at];
      emit(instruction, plan_.liveAfter[at]);
      if (instruction.target.place == Place::Register) heldMask_[instruction.target.index] = mask_;
    }
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

  static constexpr int kPrefetchDistance = 1024;  // bytes

  const VectorFunction* functions_;
  NativePlan plan_;
  int mask_ = NativePlan::kNumber;  ///< plan_.mask of the instruction in work
  std::vector<int> heldMask_;       ///< the same of the value that each program register holds
  std::vector<Detour> detours_;
};

}  // namespace brdf::formula
