#include <brdf/formula/NativePlan.h>

#include <algorithm>

namespace brdf::formula {

NativePlan::NativePlan(const Program& program, const std::function<bool(Op)>& isCall, int masks) {
  findLive(program);
  placeTruths(program, isCall, masks);
}

void NativePlan::findLive(const Program& program) {
  const std::vector<Program::Instruction>& list = program.instructions_;
  std::vector<bool> live(program.registerCount_, false);
  liveAfter.resize(list.size());
  for (std::size_t at = list.size(); at-- > 0;) {
    liveAfter[at] = live;
    if (list[at].target.place == Program::Place::Register) live[list[at].target.index] = false;
    for (int k = 0; k < arity(list[at].op); ++k)
      if (list[at].operands[k].place == Program::Place::Register) live[list[at].operands[k].index] = true;
  }
}

void NativePlan::placeTruths(const Program& program, const std::function<bool(Op)>& isCall, int masks) {
  const std::vector<Program::Instruction>& list = program.instructions_;
  const auto isLogic = [](Op op) { return op == Op::Not || op == Op::And || op == Op::Or; };
  const auto isTruth = [&](Op op) { return op == Op::Less || op == Op::LessEqual || op == Op::Equal || isLogic(op); };
  std::vector<std::size_t> busyUntil(static_cast<std::size_t>(std::max(masks, 1)), 0);
  mask.assign(list.size(), kNumber);
  for (std::size_t at = 0; at < list.size(); ++at) {
    const Program::Operand& target = list[at].target;
    if (!isTruth(list[at].op) || target.place != Program::Place::Register) continue;
    std::size_t last = at;
    bool condition = true, calls = false, pending = false;
    for (std::size_t use = at + 1; use < list.size() && condition && liveAfter[use - 1][target.index]; ++use) {
      const Program::Instruction& user = list[use];
      pending = pending || isCall(user.op);
      for (int k = 0; k < arity(user.op); ++k) {
        if (user.operands[k].place != Program::Place::Register || user.operands[k].index != target.index) continue;
        condition = condition && (isLogic(user.op) || (user.op == Op::Select && k == 0));
        last = use;
        calls = pending;
      }
    }
    if (!condition) continue;
    if (masks == kUnlimited) {
      mask[at] = 0;
    } else if (!calls) {
      const auto free =
          std::find_if(busyUntil.begin(), busyUntil.end(), [&](std::size_t until) { return until <= at; });
      if (free == busyUntil.end()) continue;
      *free = last;
      mask[at] = static_cast<int>(free - busyUntil.begin());
    }
  }
}

}  // namespace brdf::formula
