// SPDX-License-Identifier: BSD-3-Clause
#include "mapping/block_cholesky.h"

#include <Eigen/OrderingMethods>
#include <Eigen/Sparse>
#include <algorithm>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "mapping/dense_front.h"

namespace armature {
namespace {

using Structure = std::vector<std::vector<int>>;  // for each column the rows below the diagonal, ascending

// Fronts are merged with their parents while less than this part of the merged columns is zeros: larger dense
// matrices are worth some multiplications by 0, small ones more of them.
constexpr int kSmallFront = 4;  // blocks
constexpr double kSmallFrontZeros = 0.5;
constexpr double kLargeFrontZeros = 0.1;

std::vector<int> Inverse(const std::vector<int>& permutation) {
  std::vector<int> inverse(permutation.size());
  for (size_t i = 0; i < permutation.size(); ++i) {
    inverse[static_cast<size_t>(permutation[i])] = static_cast<int>(i);
  }
  return inverse;
}

// The blocks in an order without pattern, always the same (Knuth's multiplicative hash).
std::vector<int> ScatteredOrder(int blocks) {
  std::vector<int> order(static_cast<size_t>(blocks));
  std::iota(order.begin(), order.end(), 0);
  const auto hash = [](int i) { return static_cast<std::uint32_t>(i) * 2654435761u; };
  std::sort(order.begin(), order.end(), [hash](int a, int b) { return hash(a) < hash(b); });
  return order;
}

// Approximate minimum degree: element k is the block to be eliminated k-th. It takes the first of equals, and
// on the regular walks of pose graphs nearly all are equal: in their own order it would eat its way along the
// walk and leave up to a third more work than from a scattered one.
std::vector<int> MinimumDegreeOrder(int blocks, const std::vector<BlockCholesky::BlockIndex>& below) {
  const std::vector<int> scattered = ScatteredOrder(blocks), place = Inverse(scattered);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<size_t>(blocks) + below.size());
  for (int i = 0; i < blocks; ++i) entries.emplace_back(i, i, 1);
  for (const auto& [row, column] : below) {
    const int a = place[static_cast<size_t>(row)], b = place[static_cast<size_t>(column)];
    entries.emplace_back(std::max(a, b), std::min(a, b), 1);
  }
  Eigen::SparseMatrix<double> pattern(blocks, blocks);
  pattern.setFromTriplets(entries.begin(), entries.end());
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order;
  Eigen::AMDOrdering<int>()(pattern.selfadjointView<Eigen::Lower>(), order);
  std::vector<int> eliminated;
  for (const int i : order.indices()) eliminated.push_back(scattered[static_cast<size_t>(i)]);
  return eliminated;
}

std::vector<int> Union(const std::vector<int>& a, const std::vector<int>& b) {
  std::vector<int> both;
  both.reserve(a.size() + b.size());
  std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both;
}

// The rows of the factor: those of the matrix and, of every column, those of its children in the elimination
// tree, a column's parent being its first row.
Structure FactorStructure(size_t blocks, const std::vector<BlockCholesky::BlockIndex>& below,
                          const std::vector<int>& new_index) {
  Structure structure(blocks);
  for (const auto& [row, column] : below) {
    const auto [low, high] =
        std::minmax(new_index[static_cast<size_t>(row)], new_index[static_cast<size_t>(column)]);
    structure[static_cast<size_t>(low)].push_back(high);
  }
  for (auto& rows : structure) std::sort(rows.begin(), rows.end());
  for (auto& rows : structure) {
    if (rows.empty()) continue;
    auto& parent = structure[static_cast<size_t>(rows.front())];
    parent = Union(parent, {rows.begin() + 1, rows.end()});
  }
  return structure;
}

// Depth-first order of the elimination tree, so that every front's children come right before it.
std::vector<int> Postorder(const Structure& structure) {
  const int blocks = static_cast<int>(structure.size());
  Structure children(structure.size());
  std::vector<int> stack, order;
  for (int i = blocks - 1; i >= 0; --i) {
    const auto& rows = structure[static_cast<size_t>(i)];
    if (rows.empty()) {
      stack.push_back(i);
    } else {
      children[static_cast<size_t>(rows.front())].push_back(i);
    }
  }
  while (!stack.empty()) {  // a parent before its children, from the last to the first
    order.push_back(stack.back());
    stack.pop_back();
    const auto& below = children[static_cast<size_t>(order.back())];
    stack.insert(stack.end(), below.begin(), below.end());
  }
  std::reverse(order.begin(), order.end());
  return order;
}

// Doubles from column to column in a matrix of so many blocks.
size_t RowStride(size_t rows) { return kBlockSize * rows + kRowPadding; }

template <typename Vector>
auto Segment(Vector& x, int block) {
  return x.template segment<kBlockSize>(kBlockSize * static_cast<Eigen::Index>(block));
}

void AddBlock(const double* from, size_t from_stride, double* to, size_t to_stride) {
  for (size_t j = 0; j < kBlockSize; ++j) {
    for (size_t i = 0; i < kBlockSize; ++i) to[j * to_stride + i] += from[j * from_stride + i];
  }
}

}  // namespace

size_t BlockCholesky::PanelStride(const Front& front) {
  return RowStride(static_cast<size_t>(front.columns) + front.rows.size());
}

size_t BlockCholesky::UpdateSize(const Front& front) {
  return RowStride(front.rows.size()) * kBlockSize * front.rows.size();
}

BlockCholesky::BlockCholesky(int blocks, const std::vector<BlockIndex>& below) {
  Order(blocks, below);
  BuildFronts(FactorStructure(static_cast<size_t>(blocks), below, new_index_));
  PlaceFronts();
  PlaceBlocks(blocks, below);
}

void BlockCholesky::Order(int blocks, const std::vector<BlockIndex>& below) {
  const std::vector<int> order = MinimumDegreeOrder(blocks, below);
  std::vector<int> postordered;
  for (const int i : Postorder(FactorStructure(static_cast<size_t>(blocks), below, Inverse(order)))) {
    postordered.push_back(order[static_cast<size_t>(i)]);
  }
  new_index_ = Inverse(postordered);
}

// From one front a column, each merged into the one after it where that is its parent and few zeros arise.
void BlockCholesky::BuildFronts(const Structure& structure) {
  for (size_t column = 0; column < structure.size(); ++column) {
    Front front;
    front.first = static_cast<int>(column);
    front.columns = 1;
    front.rows = structure[column];
    while (!fronts_.empty() && Absorb(fronts_.back(), front)) fronts_.pop_back();
    fronts_.push_back(std::move(front));
  }
}

// Puts the columns of the front before it into `front` where that is its parent and few zeros arise.
bool BlockCholesky::Absorb(const Front& child, Front& front) {
  if (child.rows.empty() || child.rows.front() != front.first) return false;
  const long missing = front.columns + static_cast<long>(front.rows.size() - child.rows.size());
  const long zeros = child.zeros + front.zeros + missing * child.columns;
  const int columns = child.columns + front.columns;
  const double size = columns * (0.5 * columns + static_cast<double>(front.rows.size()));
  const double allowed = columns <= kSmallFront ? kSmallFrontZeros : kLargeFrontZeros;
  if (static_cast<double>(zeros) > allowed * size) return false;
  front.first = child.first;
  front.columns = columns;
  front.zeros = zeros;
  return true;
}

void BlockCholesky::PlaceFronts() {
  front_of_.assign(new_index_.size(), 0);
  for (size_t f = 0; f < fronts_.size(); ++f) {
    const auto first = front_of_.begin() + fronts_[f].first;
    std::fill(first, first + fronts_[f].columns, static_cast<int>(f));
  }
  size_t panels = 0;
  for (Front& front : fronts_) {
    front.panel = panels;
    panels += PanelStride(front) * static_cast<size_t>(kBlockSize * front.columns);
    if (front.rows.empty()) continue;
    front.parent = front_of_[static_cast<size_t>(front.rows.front())];
    for (const int row : front.rows) {
      front.in_parent.push_back(PositionIn(fronts_[static_cast<size_t>(front.parent)], row));
    }
  }
  panels_.resize(panels);
  updates_.resize(LargestStack());
}

// The stack of updates as FactorizeFronts fills it.
size_t BlockCholesky::LargestStack() const {
  std::vector<size_t> handed_on(fronts_.size(), 0);  // to each front by its children
  size_t top = 0, largest = 0;
  for (size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    largest = std::max(largest, top + UpdateSize(front));
    top += UpdateSize(front) - handed_on[f];
    if (front.parent != kNoParent) handed_on[static_cast<size_t>(front.parent)] += UpdateSize(front);
  }
  return largest;
}

size_t BlockCholesky::PositionIn(const Front& front, int block) {
  if (block < front.first + front.columns) return static_cast<size_t>(block - front.first);
  const auto row = std::lower_bound(front.rows.begin(), front.rows.end(), block);
  return static_cast<size_t>(front.columns + (row - front.rows.begin()));
}

void BlockCholesky::PlaceBlocks(int blocks, const std::vector<BlockIndex>& below) {
  const auto target = [this](int row, int column) {
    const int a = new_index_[static_cast<size_t>(row)], b = new_index_[static_cast<size_t>(column)];
    const Front& front = fronts_[static_cast<size_t>(front_of_[static_cast<size_t>(std::min(a, b))])];
    const size_t stride = PanelStride(front);
    const size_t r = PositionIn(front, std::max(a, b)), c = PositionIn(front, std::min(a, b));
    return Target{front.panel + kBlockSize * (c * stride + r), stride, a < b};
  };
  for (int i = 0; i < blocks; ++i) diagonal_targets_.push_back(target(i, i));
  for (const auto& [row, column] : below) below_targets_.push_back(target(row, column));
}

void BlockCholesky::StoreMatrix(const std::vector<Matrix6d>& diagonal, const std::vector<Matrix6d>& below) {
  using StridedBlock = Eigen::Map<Matrix6d, 0, Eigen::OuterStride<>>;
  const auto store = [this](const Target& target, const Matrix6d& block) {
    StridedBlock stored(panels_.data() + target.offset,
                        Eigen::OuterStride<>(static_cast<Eigen::Index>(target.stride)));
    if (target.transposed) {
      stored = block.transpose();
    } else {
      stored = block;
    }
  };
  std::fill(panels_.begin(), panels_.end(), 0);
  for (size_t i = 0; i < diagonal.size(); ++i) store(diagonal_targets_[i], diagonal[i]);
  for (size_t i = 0; i < below.size(); ++i) store(below_targets_[i], below[i]);
}

// Adds the lower triangle of what `child` hands on, block by block: to the parent's panel or to its update.
void BlockCholesky::AddUpdate(const Front& child, const double* update, const Front& parent,
                              double* parent_update) {
  const size_t stride = RowStride(child.rows.size()), columns = static_cast<size_t>(parent.columns);
  for (size_t c = 0; c < child.rows.size(); ++c) {
    const size_t to_column = child.in_parent[c];
    const bool in_panel = to_column < columns;
    const size_t first = in_panel ? 0 : columns;  // the block at the top left of where it goes
    const size_t to_stride = in_panel ? PanelStride(parent) : RowStride(parent.rows.size());
    double* to = (in_panel ? panels_.data() + parent.panel : parent_update) +
                 kBlockSize * (to_column - first) * to_stride;
    for (size_t r = c; r < child.rows.size(); ++r) {
      AddBlock(update + kBlockSize * (c * stride + r), stride, to + kBlockSize * (child.in_parent[r] - first),
               to_stride);
    }
  }
}

// Children stand right before their parent, so what they hand on lies on top of the stack. The parent's own
// update is built above and then takes their place.
bool BlockCholesky::FactorizeFronts() {
  std::vector<size_t> waiting;  // fronts whose updates are on the stack
  size_t top = 0;
  for (size_t f = 0; f < fronts_.size(); ++f) {
    const Front& front = fronts_[f];
    double* update = updates_.data() + top;
    std::fill(update, update + UpdateSize(front), 0);
    while (!waiting.empty() && fronts_[waiting.back()].parent == static_cast<int>(f)) {
      const Front& child = fronts_[waiting.back()];
      top -= UpdateSize(child);
      AddUpdate(child, updates_.data() + top, front, update);
      waiting.pop_back();
    }
    const int rows = front.columns + static_cast<int>(front.rows.size());
    if (!EliminatePivots(kBlockSize * rows, kBlockSize * front.columns, panels_.data() + front.panel,
                         update)) {
      return false;
    }
    double* base = updates_.data() + top;
    if (base != update) std::copy(update, update + UpdateSize(front), base);
    top += UpdateSize(front);
    waiting.push_back(f);
  }
  return true;
}

bool BlockCholesky::Factorize(const std::vector<Matrix6d>& diagonal, const std::vector<Matrix6d>& below) {
  StoreMatrix(diagonal, below);
  return FactorizeFronts();
}

Eigen::VectorXd BlockCholesky::Solve(const Eigen::VectorXd& b) const {
  Eigen::VectorXd x = b;
  for (size_t i = 0; i < new_index_.size(); ++i) Segment(x, new_index_[i]) = Segment(b, static_cast<int>(i));
  SolveForwards(x);
  SolveBackwards(x);
  Eigen::VectorXd solution = x;
  for (size_t i = 0; i < new_index_.size(); ++i) {
    Segment(solution, static_cast<int>(i)) = Segment(x, new_index_[i]);
  }
  return solution;
}

BlockCholesky::Panel BlockCholesky::PanelOf(const Front& front) const {
  return {panels_.data() + front.panel, static_cast<Eigen::Index>(PanelStride(front) - kRowPadding),
          Eigen::Index{kBlockSize} * front.columns,
          Eigen::OuterStride<>(static_cast<Eigen::Index>(PanelStride(front)))};
}

Eigen::Index BlockCholesky::FirstUnknown(const Front& front) {
  return Eigen::Index{kBlockSize} * front.first;
}

// L y = x, in place.
void BlockCholesky::SolveForwards(Eigen::VectorXd& x) const {
  Eigen::VectorXd product;
  for (const Front& front : fronts_) {
    const Panel L = PanelOf(front);
    auto pivots = x.segment(FirstUnknown(front), L.cols());
    L.topRows(L.cols()).triangularView<Eigen::Lower>().solveInPlace(pivots);
    product.setZero(L.rows() - L.cols());
    product += L.bottomRows(product.size()).lazyProduct(pivots);
    for (size_t r = 0; r < front.rows.size(); ++r) {
      Segment(x, front.rows[r]) -= Segment(product, static_cast<int>(r));
    }
  }
}

// L^T y = x, in place.
void BlockCholesky::SolveBackwards(Eigen::VectorXd& x) const {
  Eigen::VectorXd below;
  for (auto front = fronts_.rbegin(); front != fronts_.rend(); ++front) {
    const Panel L = PanelOf(*front);
    below.setZero(L.rows() - L.cols());
    for (size_t r = 0; r < front->rows.size(); ++r) {
      Segment(below, static_cast<int>(r)) = Segment(x, front->rows[r]);
    }
    auto pivots = x.segment(FirstUnknown(*front), L.cols());
    pivots -= L.bottomRows(below.size()).transpose().lazyProduct(below);
    L.topRows(L.cols()).transpose().triangularView<Eigen::Upper>().solveInPlace(pivots);
  }
}

}  // namespace armature
