// Graph to Program: what is uniform, what is fused, in which order, in which registers.
#include <brdf/formula/Program.h>

#include <algorithm>

namespace brdf::formula {

class ProgramCompiler {
 public:
  ProgramCompiler(Program& program, const Graph& graph, const std::vector<NodeId>& outputs)
      : program_(program),
        graph_(graph),
        outputs_(outputs),
        needed_(graph.reachable(outputs)),
        scopes_(graph.scopes()),
        size_(needed_.size()),
        varies_(size_, false),
        uses_(size_, 0),
        places_(size_),
        fused_(size_, false),
        selected_(size_),
        reciprocal_(size_, 0) {}

  void run() {
    findVarying();
    placeUniforms();
    placeReciprocals();
    fuse();
    emit(0, needed_);
    findLastUses();
    allocate();
    copyRemainingOutputs();
  }

 private:
  using Operand = Program::Operand;
  using Place = Program::Place;
  using Instruction = Program::Instruction;

  /// A node as it will be computed, perhaps with a product fused in.
  struct Selected {
    Op op = Op::Copy;
    NodeId operands[4] = {0, 0, 0, 0};
    int count = 0;
  };
  /// One place in the order of evaluation.
  struct Step {
    Instruction::Kind kind;
    NodeId id;
    std::size_t partner = 0;  ///< LoopBegin: position of its LoopEnd
  };

  static bool isTable(Op op) { return op >= Op::Table && op <= Op::TableDy; }
  /// The table's index in the program.
  std::uint32_t tableIndex(std::uint32_t inGraph) {
    const auto& table = graph_.table(inGraph);
    auto it = std::find(program_.tables_.begin(), program_.tables_.end(), table);
    if (it == program_.tables_.end()) it = program_.tables_.insert(it, table);
    return static_cast<std::uint32_t>(it - program_.tables_.begin());
  }
  static bool binds(Op op) { return op == Op::Sum || op == Op::Solve; }
  const Node& node(std::size_t id) const { return graph_[static_cast<NodeId>(id)]; }

  void findVarying() {
    for (std::size_t id = 0; id < size_; ++id) {
      if (!needed_[id]) continue;
      const Op op = node(id).op;
      varies_[id] = op == Op::Input || op == Op::Bound || binds(op);
      for (int k = 0; k < arity(op); ++k) {
        varies_[id] = varies_[id] || varies_[node(id).operands[k]];
        ++uses_[node(id).operands[k]];
      }
    }
    for (const NodeId output : outputs_) ++uses_[output];
  }

  void placeUniforms() {
    for (std::size_t id = 0; id < size_; ++id) {
      if (!needed_[id] || varies_[id]) continue;
      Program::UniformStep step;
      step.op = node(id).op;
      step.value = node(id).value;
      if (step.op == Op::Parameter) step.operands[0] = node(id).index;
      for (int k = 0; k < arity(step.op); ++k) step.operands[k] = places_[node(id).operands[k]].index;
      if (isTable(step.op)) step.operands[2] = tableIndex(node(id).index);
      places_[id] = {Place::Uniform, static_cast<std::uint32_t>(program_.uniforms_.size())};
      program_.uniforms_.push_back(step);
    }
  }

  /// A division by a uniform is a product with its reciprocal, computed once in double.
  void placeReciprocals() {
    for (std::size_t id = 0; id < size_; ++id) {
      if (!needed_[id] || !varies_[id] || node(id).op != Op::Div) continue;
      const NodeId divisor = node(id).operands[1];
      if (varies_[divisor] || reciprocal_[divisor] != 0) continue;
      Program::UniformStep one, step;
      one.value = 1;
      step.op = Op::Div;
      step.operands[0] = static_cast<std::uint32_t>(program_.uniforms_.size());
      step.operands[1] = places_[divisor].index;
      program_.uniforms_.push_back(one);
      reciprocal_[divisor] = static_cast<std::uint32_t>(program_.uniforms_.size());
      program_.uniforms_.push_back(step);
    }
  }

  /// A product used once, by a sum in the same loop, is fused into it.
  void fuse() {
    for (std::size_t id = size_; id-- > 0;) {
      if (!needed_[id] || !varies_[id]) continue;
      const Node& n = node(id);
      Selected s{n.op, {n.operands[0], n.operands[1], n.operands[2], n.operands[3]}, arity(n.op)};
      const auto product = [&](NodeId operand) {
        return node(operand).op == Op::Mul && varies_[operand] && uses_[operand] == 1 &&
               scopes_[operand] == scopes_[id];
      };
      if (n.op == Op::Add || n.op == Op::Sub) {
        const NodeId a = n.operands[0], b = n.operands[1];
        if (product(a)) {
          s = {n.op == Op::Add ? Op::MulAdd : Op::MulSub, {node(a).operands[0], node(a).operands[1], b}, 3};
          fused_[a] = true;
        } else if (product(b)) {
          s = {n.op == Op::Add ? Op::MulAdd : Op::NegMulAdd, {node(b).operands[0], node(b).operands[1], a}, 3};
          fused_[b] = true;
        }
      }
      selected_[id] = s;
    }
  }

  /// Appends the nodes of one scope that `wanted` marks; the body of a loop follows its LoopBegin.
  void emit(std::uint32_t scope, const std::vector<bool>& wanted) {
    for (std::size_t id = 0; id < wanted.size(); ++id) {
      if (!wanted[id] || !varies_[id] || fused_[id] || scopes_[id] != scope || arity(node(id).op) == 0) continue;
      if (!binds(node(id).op)) {
        order_.push_back({Instruction::Kind::Compute, static_cast<NodeId>(id)});
        continue;
      }
      const std::size_t begin = order_.size();
      order_.push_back({Instruction::Kind::LoopBegin, static_cast<NodeId>(id)});
      const bool solve = node(id).op == Op::Solve;
      emit(node(id).index + 1, graph_.reachable(solve ? std::vector{node(id).operands[2], node(id).operands[3]}
                                                      : std::vector{node(id).operands[2]}));
      order_[begin].partner = order_.size();
      order_.push_back({Instruction::Kind::LoopEnd, static_cast<NodeId>(id), begin});
    }
  }

  /// For each step, the nodes whose registers are free after it. A value made outside a loop lives until the loop ends.
  void findLastUses() {
    std::vector<std::size_t> madeAt(size_, 0), lastUse(size_, 0);
    std::vector<bool> made(size_, false);
    std::vector<std::size_t> open;  // positions of the LoopBegins around the current step
    freedAfter_.assign(order_.size() + 1, {});
    const auto use = [&](NodeId id, std::size_t at) {
      if (!made[id]) return;  // a uniform, an input or a loop's variable
      std::size_t until = at;
      for (const std::size_t begin : open)
        if (begin > madeAt[id]) {
          until = std::max(until, order_[begin].partner);
          break;
        }
      lastUse[id] = std::max(lastUse[id], until);
    };
    // A body shared by two loops (a sum and its derivative) is emitted in each: its nodes are made anew each time.
    const auto make = [&](NodeId id, std::size_t at) {
      if (made[id]) freedAfter_[lastUse[id]].push_back(id);
      made[id] = true;
      madeAt[id] = lastUse[id] = at;
    };
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Step& step = order_[at];
      const Selected& s = selected_[step.id];
      if (step.kind == Instruction::Kind::Compute) {
        for (int k = 0; k < s.count; ++k) use(s.operands[k], at);
        make(step.id, at);
      } else if (step.kind == Instruction::Kind::LoopBegin) {
        open.push_back(at);
        use(s.operands[0], at);
        use(s.operands[1], at);
      } else {
        for (int k = 2; k < s.count; ++k) use(s.operands[k], at);
        open.pop_back();
        make(step.id, at);
      }
    }
    for (const NodeId output : outputs_) lastUse[output] = order_.size();  // never freed
    for (std::size_t id = 0; id < size_; ++id)
      if (made[id]) freedAfter_[lastUse[id]].push_back(static_cast<NodeId>(id));
  }

  Operand newRegister() {
    if (free_.empty()) free_.push_back(static_cast<std::uint32_t>(program_.registerCount_++));
    const Operand place{Place::Register, free_.back()};
    free_.pop_back();
    return place;
  }
  void release(const Operand& place) {
    if (place.place == Place::Register) free_.push_back(place.index);
  }
  void releaseAfter(std::size_t at, NodeId except) {
    for (const NodeId id : freedAfter_[at])
      if (id != except) release(places_[id]);
  }

  /// The output that a node is, or a register.
  Operand target(NodeId id) {
    const auto output = std::find(outputs_.begin(), outputs_.end(), id);
    if (output != outputs_.end()) return {Place::Output, static_cast<std::uint32_t>(output - outputs_.begin())};
    return newRegister();
  }

  Operand operandPlace(NodeId id) {
    if (node(id).op == Op::Input) {
      program_.reads_[node(id).index] = true;
      return {Place::Input, node(id).index};
    }
    if (node(id).op == Op::Bound)
      for (std::size_t k = openLoops_.size(); k-- > 0;)
        if (openVariables_[k] == node(id).index) return program_.loops_[openLoops_[k]].bound;
    return places_[id];
  }

  void allocate() {
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Step step = order_[at];
      const Selected& s = selected_[step.id];
      Instruction instruction;
      instruction.kind = step.kind;
      if (step.kind == Instruction::Kind::Compute) {
        instruction.op = s.op;
        for (int k = 0; k < s.count; ++k) instruction.operands[k] = operandPlace(s.operands[k]);
        if (isTable(s.op)) {
          instruction.kind = Instruction::Kind::Table;
          instruction.index = tableIndex(node(step.id).index);
        }
        if (s.op == Op::Div && instruction.operands[1].place == Place::Uniform) {
          instruction.op = Op::Mul;
          instruction.operands[1].index = reciprocal_[s.operands[1]];
        }
        releaseAfter(at, step.id);  // the target may be an operand's register
        places_[step.id] = instruction.target = target(step.id);
        if (std::find(freedAfter_[at].begin(), freedAfter_[at].end(), step.id) != freedAfter_[at].end())
          release(places_[step.id]);
      } else if (step.kind == Instruction::Kind::LoopBegin) {
        Program::Loop loop;
        loop.op = s.op;
        loop.tolerance = node(step.id).value;
        loop.from = operandPlace(s.operands[0]);
        loop.to = operandPlace(s.operands[1]);
        loop.bound = newRegister();
        loop.result = newRegister();
        for (Operand& state : loop.state) state = newRegister();
        loop.begin = static_cast<std::uint32_t>(program_.instructions_.size());
        instruction.index = static_cast<std::uint32_t>(program_.loops_.size());
        openLoops_.push_back(instruction.index);
        openVariables_.push_back(node(step.id).index);
        program_.loops_.push_back(loop);
        releaseAfter(at, step.id);
      } else {
        instruction.index = openLoops_.back();
        Program::Loop& loop = program_.loops_[instruction.index];
        loop.body = operandPlace(s.operands[2]);
        loop.slope = s.op == Op::Solve ? operandPlace(s.operands[3]) : loop.body;
        openLoops_.pop_back();
        openVariables_.pop_back();
        release(loop.bound);
        for (const Operand& state : loop.state) release(state);
        releaseAfter(at, step.id);
        places_[step.id] = loop.result;
      }
      program_.instructions_.push_back(instruction);
    }
  }

  /// Outputs that are an input, a uniform, a loop's result, or another output again.
  void copyRemainingOutputs() {
    for (std::uint32_t k = 0; k < outputs_.size(); ++k) {
      const Operand place = operandPlace(outputs_[k]);
      if (place.place == Place::Output && place.index == k) continue;
      Instruction copy;
      copy.operands[0] = place;
      copy.target = {Place::Output, k};
      program_.instructions_.push_back(copy);
    }
  }

  Program& program_;
  const Graph& graph_;
  const std::vector<NodeId>& outputs_;
  std::vector<bool> needed_;
  std::vector<std::uint32_t> scopes_;
  std::size_t size_;
  std::vector<bool> varies_;
  std::vector<std::uint32_t> uses_;
  std::vector<Operand> places_;
  std::vector<bool> fused_;
  std::vector<Selected> selected_;
  std::vector<std::uint32_t> reciprocal_;
  std::vector<Step> order_;
  std::vector<std::vector<NodeId>> freedAfter_;
  std::vector<std::uint32_t> free_, openLoops_, openVariables_;
};

Program::Program(const Graph& graph, const std::vector<NodeId>& outputs) : outputCount_(outputs.size()) {
  ProgramCompiler(*this, graph, outputs).run();
}

}  // namespace brdf::formula
