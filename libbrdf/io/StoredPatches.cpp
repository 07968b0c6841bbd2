#include <brdf/io/StoredPatches.h>
#include <brdf/io/StoredValues.h>

namespace brdf {
namespace {

using stored::broken;
using stored::Sizes;
using stored::valueName;

constexpr std::uint64_t kMaximumValues = std::uint64_t{1} << 29;  // 4 GiB

void storeBasis(const h5::Group& group, const PatchBasis& basis) {
  group.setText("Name", basis.name());
  std::vector<double> upper, counts;
  for (const PatchBasis::Ring& ring : basis.rings()) {
    upper.push_back(ring.upperTheta);
    counts.push_back(static_cast<double>(ring.count));
  }
  group.setNumbers("UpperTheta", upper);
  group.setNumbers("Counts", counts);
}

PatchBasis restoreBasis(const h5::Group& group) {
  const std::vector<double> upper = group.numbers("UpperTheta"), counts = group.numbers("Counts");
  if (upper.size() != counts.size())
    broken(group, "rings disagree", std::to_string(counts.size()) + " counts", std::to_string(upper.size()));
  std::vector<PatchBasis::Ring> rings;
  for (std::size_t r = 0; r < upper.size(); ++r)
    rings.push_back({upper[r], counts[r] >= 1 && counts[r] <= 1e9 ? static_cast<std::size_t>(counts[r]) : 0});
  return {group.text("Name"), std::move(rings)};  // throws where they are no good
}

void listNodes(const TensorTree& tree, TensorTree::Node node, std::vector<std::uint8_t>& branches,
               std::vector<std::size_t>& cells) {
  branches.push_back(tree.isCell(node) ? 0 : 1);
  if (tree.isCell(node)) return cells.push_back(tree.cell(node));
  for (std::size_t c = 0; c < tree.children(); ++c) listNodes(tree, tree.child(node, c), branches, cells);
}

class TreeBuilder {
 public:
  TreeBuilder(const h5::Group& group, const std::vector<std::uint8_t>& branches, const std::vector<double>& values,
              std::size_t cells, TensorTree& tree)
      : group_(group), branches_(branches), values_(values), cells_(cells), tree_(tree) {}

  void run() {
    node(0, 0);
    if (next_ != branches_.size() || cell_ != cells_) fail();
  }

 private:
  [[noreturn]] void fail() const {
    broken(group_, "nodes and cells of the tensor tree disagree",
           std::to_string(branches_.size()) + " nodes, " + std::to_string(cells_) + " cells", "a complete tree");
  }
  void node(TensorTree::Node at, int depth) {
    if (next_ == branches_.size() || depth > TensorTree::kMaximumDepth) fail();
    if (branches_[next_++] != 0) {
      const TensorTree::Node first = tree_.divide(at);
      for (std::size_t c = 0; c < tree_.children(); ++c) node(first + static_cast<TensorTree::Node>(c), depth + 1);
      return;
    }
    if (cell_ == cells_) fail();
    double* values = tree_.values(tree_.cell(at));
    for (std::size_t c = 0; c < tree_.channels(); ++c) values[c] = values_[c * cells_ + cell_];
    ++cell_;
  }

  const h5::Group& group_;
  const std::vector<std::uint8_t>& branches_;
  const std::vector<double>& values_;
  std::size_t cells_;
  TensorTree& tree_;
  std::size_t next_ = 0, cell_ = 0;
};

}  // namespace

void storePatches(const h5::Group& group, const PatchBrdf& patches) {
  const PatchData& data = patches.data();
  stored::storeChannels(group, data.channels);
  group.setText("Quantity", "BRDF without the cosine, 1/sr; mean over a pair of patches");
  storeBasis(group.createGroup("Incident"), data.incident);
  storeBasis(group.createGroup("Outgoing"), data.outgoing);
  const Sizes shape{data.outgoing.count(), data.incident.count()};
  for (std::size_t c = 0; c < data.channels.count(); ++c)
    group.writeArray(valueName(c), data.values.data() + c * shape[0] * shape[1], shape);
}

BrdfPointer restorePatches(const h5::Group& group, const std::string& description) {
  PatchData data{
      restoreBasis(group.group("Incident")), restoreBasis(group.group("Outgoing")), stored::restoreChannels(group), {}};
  data.values = stored::restoreChannelArrays(group, valueName, data.channels.count(),
                                             {data.outgoing.count(), data.incident.count()});
  return std::make_shared<const PatchBrdf>(std::move(data), description);
}

void storeTree(const h5::Group& group, const TreeBrdf& brdf) {
  const TensorTree& tree = brdf.tree();
  stored::storeChannels(group, brdf.channels());
  group.setText("Quantity", "BRDF without the cosine, 1/sr; mean over a cell");
  group.setInteger("Rank", tree.rank());
  std::vector<std::uint8_t> branches;
  std::vector<std::size_t> cells;
  listNodes(tree, 0, branches, cells);
  group.writeArray("branches", branches.data(), Sizes{branches.size()});
  std::vector<double> values(cells.size());
  for (std::size_t c = 0; c < tree.channels(); ++c) {
    for (std::size_t i = 0; i < cells.size(); ++i) values[i] = tree.values(cells[i])[c];
    group.writeArray(valueName(c), values.data(), Sizes{values.size()});
  }
}

BrdfPointer restoreTree(const h5::Group& group, const std::string& description) {
  const Channels channels = stored::restoreChannels(group);
  const std::int64_t rank = group.integer("Rank");
  if (rank != 3 && rank != 4) broken(group, "wrong Rank of a tensor tree", std::to_string(rank), "3, 4");
  const Sizes nodes = group.dimensions("branches"), cells = group.dimensions(valueName(0));
  if (nodes.size() != 1 || cells.size() != 1 || nodes[0] > kMaximumValues || nodes[0] < cells[0])
    broken(group, "nodes and cells of the tensor tree disagree", std::to_string(nodes[0]) + " nodes",
           "a list, at most " + std::to_string(kMaximumValues));
  std::vector<std::uint8_t> branches(nodes[0]);
  group.readArray("branches", branches.data(), nodes);
  const std::vector<double> values = stored::restoreChannelArrays(group, valueName, channels.count(), cells);
  TensorTree tree(static_cast<int>(rank), channels.count());
  TreeBuilder(group, branches, values, cells[0], tree).run();
  return std::make_shared<const TreeBrdf>(std::move(tree), channels, description);
}

}  // namespace brdf
