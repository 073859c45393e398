// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/share_fronts.h"

#include <algorithm>
#include <numeric>

#include "cholesky/front_kernels.h"
#include "index.h"

namespace wirewarp {
namespace {

constexpr int kMostSplits = 32;

int num_fronts(const FrontLayout& layout) { return static_cast<int>(layout.fronts.size()) - 1; }

/// Multiplications of tiles.
double work(const Front& front) {
  const double m = front.pivot_tiles, r = front.row_tiles;
  return m * m * m / 6 + m * m * r / 2 + m * r * r / 2 + (m + r) * (m + r);
}

/// The work of each front with all its descendants, and the first of them.
struct Subtree {
  double work;
  int first;
};

std::vector<Subtree> subtrees(const FrontLayout& layout) {
  std::vector<Subtree> result;
  for (int f = 0; f < num_fronts(layout); ++f) {
    result.push_back({work(layout.fronts[at(f)]), f});
    for (int c = layout.fronts[at(f)].first_child; c < layout.fronts[at(f) + 1].first_child; ++c) {
      const Subtree& child = result[at(layout.children[at(c)])];
      result.back().work += child.work;
      result.back().first = std::min(result.back().first, child.first);
    }
  }
  return result;
}

struct Shares {
  std::vector<std::vector<int>> roots;  // of each thread's subtrees
  double longest;                       // work of the busiest thread
};

/// Each subtree, the largest first, to the thread that has the least to do.
Shares share(std::vector<int> roots, const std::vector<Subtree>& trees, int num_threads) {
  std::sort(roots.begin(), roots.end(), [&](int a, int b) { return trees[at(a)].work > trees[at(b)].work; });
  Shares shares{std::vector<std::vector<int>>(at(num_threads)), 0};
  std::vector<double> load(at(num_threads), 0.0);
  for (int root : roots) {
    const std::size_t thread = at(static_cast<int>(std::min_element(load.begin(), load.end()) - load.begin()));
    shares.roots[thread].push_back(root);
    load[thread] += trees[at(root)].work;
  }
  shares.longest = *std::max_element(load.begin(), load.end());
  return shares;
}

}  // namespace

void share_fronts(FrontLayout& layout, int num_threads) {
  const std::vector<Subtree> trees = subtrees(layout);
  std::vector<int> roots;
  for (int f = 0; f < num_fronts(layout); ++f) {
    if (layout.fronts[at(f)].parent == -1) roots.push_back(f);
  }
  Shares best = share(roots, trees, num_threads);
  double best_time = best.longest, time_of_last = 0;
  std::vector<int> last;
  for (int split = 0; num_threads > 1 && split < kMostSplits && !roots.empty(); ++split) {
    const auto heaviest = std::max_element(roots.begin(), roots.end(),
                                           [&](int a, int b) { return trees[at(a)].work < trees[at(b)].work; });
    const Front* front = &layout.fronts[at(*heaviest)];
    time_of_last += work(*front);
    last.push_back(*heaviest);
    roots.erase(heaviest);
    roots.insert(roots.end(), layout.children.begin() + front[0].first_child,
                 layout.children.begin() + front[1].first_child);
    Shares shares = share(roots, trees, num_threads);
    if (time_of_last + shares.longest >= best_time) continue;
    best_time = time_of_last + shares.longest;
    best = std::move(shares);
    layout.last_fronts = last;
  }
  std::sort(layout.last_fronts.begin(), layout.last_fronts.end());
  for (std::vector<int>& mine : best.roots) {
    std::sort(mine.begin(), mine.end());
    std::vector<int>& fronts = layout.fronts_of_thread.emplace_back();
    for (int root : mine) {
      for (int f = trees[at(root)].first; f <= root; ++f) fronts.push_back(f);
    }
  }
}

namespace {

/// Stacks for fronts that are eliminated in the given order, at even and at odd depth of the tree.
class SchurStacks {
 public:
  SchurStacks(FrontLayout& layout, const std::vector<int>& depth) : layout_(layout), depth_(depth) {}

  void place(const std::vector<int>& fronts) {
    std::array<std::size_t, 2> top{}, most{};
    std::vector<char>& mine = mine_;
    mine.assign(layout_.fronts.size(), 0);
    for (int f : fronts) {
      mine[at(f)] = 1;
      Front& front = layout_.fronts[at(f)];
      const std::size_t parity = at(depth_[at(f)] % 2);
      front.schur = top[parity];
      top[parity] += triangle_size(front.row_tiles);
      most[parity] = std::max(most[parity], top[parity]);
      for (int c = front.first_child; c < layout_.fronts[at(f) + 1].first_child; ++c) {
        const int child = layout_.children[at(c)];
        if (mine[at(child)]) top[1 - parity] -= triangle_size(layout_.fronts[at(child)].row_tiles);
      }
    }
    for (int f : fronts) layout_.fronts[at(f)].schur += layout_.schur_tiles + at(depth_[at(f)] % 2) * most[0];
    layout_.schur_tiles += most[0] + most[1];
  }

 private:
  FrontLayout& layout_;
  const std::vector<int>& depth_;
  std::vector<char> mine_;
};

}  // namespace

void place_schur_complements(FrontLayout& layout) {
  std::vector<int> depth(at(num_fronts(layout)), 0);
  for (int f = num_fronts(layout); f-- > 0;) {
    if (const int parent = layout.fronts[at(f)].parent; parent != -1) depth[at(f)] = depth[at(parent)] + 1;
  }
  SchurStacks stacks(layout, depth);
  for (const std::vector<int>& fronts : layout.fronts_of_thread) stacks.place(fronts);
  stacks.place(layout.last_fronts);
}

}  // namespace wirewarp
