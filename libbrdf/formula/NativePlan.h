#pragma once
// What is decided about a straight Program before it becomes machine code. Internal to NativeEmitter.h.
#include <brdf/formula/Program.h>

#include <functional>
#include <vector>

namespace brdf::formula {

struct NativePlan {
  /// `isCall`: whether an operation is a call, which no mask register outlives. `masks`: how many mask registers hold
  /// truths; kUnlimited where truths need none.
  NativePlan(const Program& program, const std::function<bool(Op)>& isCall, int masks);

  static constexpr int kUnlimited = -1, kNumber = -1;

  /// For each instruction, the program registers that are read after it before they are written.
  std::vector<std::vector<bool>> liveAfter;
  /// For each instruction that makes a truth which serves only as a condition: the number, from 0, of the mask register
  /// that holds it (0 with kUnlimited). kNumber for all others: 1 or 0 in a register for numbers.
  std::vector<int> mask;

 private:
  void findLive(const Program& program);
  void placeTruths(const Program& program, const std::function<bool(Op)>& isCall, int masks);
};

}  // namespace brdf::formula
