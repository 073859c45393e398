// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/partition_subtrees.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "numerics/cholesky/front_kernels.h"

namespace wirewarp {
namespace {

// Maximum number of times that the heaviest subtree is split. After 32 splits, each subtree has about a thirtieth of
// the work, so that the shares are even enough.
constexpr int kMostSplits = 32;

int num_fronts(const FrontLayout& layout) { return static_cast<int>(layout.fronts.size()) - 1; }

/// The work of a front with all its descendants, and the first descendant.
struct Subtree {
  double work;
  int first;
};

std::vector<Subtree> subtrees(const FrontLayout& layout) {
  std::vector<Subtree> result;
  for (int f = 0; f < num_fronts(layout); ++f) {
    result.push_back({layout.fronts[f].work(), f});
    for (int c = layout.fronts[f].first_child; c < layout.fronts[f + 1].first_child; ++c) {
      const Subtree& child = result[layout.children[c]];
      result.back().work += child.work;
      result.back().first = std::min(result.back().first, child.first);
    }
  }
  return result;
}

struct Shares {
  std::array<std::vector<int>, FrontSet::num_shares> roots;
  double largest;  // work of the larger share
};

/// Assigns each subtree, largest first, to the share with the least work.
Shares share(std::vector<int> roots, const std::vector<Subtree>& trees) {
  std::sort(roots.begin(), roots.end(), [&](int a, int b) { return trees[a].work > trees[b].work; });
  Shares shares{};
  std::array<double, FrontSet::num_shares> load{};
  for (int root : roots) {
    const std::size_t least = (std::min_element(load.begin(), load.end()) - load.begin());
    shares.roots[least].push_back(root);
    load[least] += trees[root].work;
  }
  shares.largest = *std::max_element(load.begin(), load.end());
  return shares;
}

}  // namespace

void partition_subtrees(FrontLayout& layout) {
  const std::vector<Subtree> trees = subtrees(layout);
  std::vector<int> roots;
  for (int f = 0; f < num_fronts(layout); ++f) {
    if (f != layout.kept_root && layout.fronts[f].parent == layout.kept_root) roots.push_back(f);
  }
  Shares best = share(roots, trees);
  double best_time = best.largest, time_of_last = 0;
  std::vector<int> last;
  for (int split = 0; split < kMostSplits && !roots.empty(); ++split) {
    const auto heaviest =
        std::max_element(roots.begin(), roots.end(), [&](int a, int b) { return trees[a].work < trees[b].work; });
    const Front* front = &layout.fronts[*heaviest];
    time_of_last += front->work();
    last.push_back(*heaviest);
    roots.erase(heaviest);
    roots.insert(roots.end(), layout.children.begin() + front[0].first_child,
                 layout.children.begin() + front[1].first_child);
    Shares shares = share(roots, trees);
    if (time_of_last + shares.largest >= best_time) continue;
    best_time = time_of_last + shares.largest;
    best = std::move(shares);
    layout.all_fronts.ancestors = last;
  }
  std::sort(layout.all_fronts.ancestors.begin(), layout.all_fronts.ancestors.end());
  for (std::size_t i = 0; i < best.roots.size(); ++i) {
    std::sort(best.roots[i].begin(), best.roots[i].end());
    for (int root : best.roots[i]) {
      for (int f = trees[root].first; f <= root; ++f) layout.all_fronts.subtrees[i].push_back(f);
    }
  }
}

namespace {

/// Places Schur complements on two stacks, for even and odd depth in the tree, in the order of elimination. A front and
/// its children are on different stacks, so the space of the children can be reused after the front is placed.
class SchurStacks {
 public:
  SchurStacks(FrontLayout& layout, const std::vector<int>& depth) : layout_(layout), depth_(depth) {}

  void place(const std::vector<int>& fronts) {
    std::array<std::size_t, 2> top{}, most{};
    std::vector<char>& mine = mine_;
    mine.assign(layout_.fronts.size(), 0);
    for (int f : fronts) {
      mine[f] = 1;
      Front& front = layout_.fronts[f];
      const std::size_t parity = (depth_[f] % 2);
      front.schur = top[parity];
      top[parity] += triangle_size(front.row_tiles);
      most[parity] = std::max(most[parity], top[parity]);
      for (int c = front.first_child; c < layout_.fronts[f + 1].first_child; ++c) {
        const int child = layout_.children[c];
        if (mine[child]) top[1 - parity] -= triangle_size(layout_.fronts[child].row_tiles);
      }
    }
    for (int f : fronts) layout_.fronts[f].schur += layout_.schur_tiles + (depth_[f] % 2) * most[0];
    layout_.schur_tiles += most[0] + most[1];
  }

 private:
  FrontLayout& layout_;
  const std::vector<int>& depth_;
  std::vector<char> mine_;
};

}  // namespace

void place_schur_complements(FrontLayout& layout) {
  std::vector<int> depth(num_fronts(layout), 0);
  for (int f = num_fronts(layout); f-- > 0;) {
    if (const int parent = layout.fronts[f].parent; parent != -1) depth[f] = depth[parent] + 1;
  }
  SchurStacks stacks(layout, depth);
  for (const std::vector<int>& fronts : layout.all_fronts.subtrees) stacks.place(fronts);
  stacks.place(layout.all_fronts.ancestors);
}

/// The ancestors of a share's subtrees are eliminated last, so their pivots are the last rows of a front.
void list_shared_vertices(FrontLayout& layout) {
  std::vector<int> place(layout.front_of_vertex.size(), -1);
  std::vector<int> shared_fronts = layout.all_fronts.ancestors;
  if (layout.kept_root != -1) shared_fronts.push_back(layout.kept_root);
  for (int f : shared_fronts) {
    const Front& front = layout.fronts[f];
    for (int i = 0; i < front.num_pivots; ++i) {
      const int v = layout.vertices[front.first_vertex + i];
      place[v] = static_cast<int>(layout.shared_vertices.size());
      layout.shared_vertices.push_back(v);
    }
  }
  for (const std::vector<int>& fronts : layout.all_fronts.subtrees) {
    for (int f : fronts) {
      Front& front = layout.fronts[f];
      const auto rows = layout.vertices.begin() + front.first_vertex + front.num_pivots;
      const auto is_own = [&](int v) { return place[v] == -1; };
      const auto shared = std::find_if_not(rows, rows + front.num_rows, is_own);
      front.num_own_rows = static_cast<int>(shared - rows);
      std::transform(shared, rows + front.num_rows, shared, [&](int v) { return place[v]; });
    }
  }
}

}  // namespace wirewarp
