// SPDX-License-Identifier: GPL-3.0-or-later
#include "inner/elimination_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

#include "index.h"

namespace wirewarp {
namespace {

constexpr std::size_t kLeafSize = 8;  // edges

class Dissection {
 public:
  Dissection(const Eq1& eq1, const WireNetwork& network)
      : eq1_(eq1), network_(network), side_(network.edges.size(), kOutside) {}

  /// edges: of one region; loops: those with all their edges in it.
  void dissect(std::vector<int> edges, const std::vector<int>& loops) {
    if (edges.size() <= kLeafSize) {
      append(edges, loops);
      return;
    }
    const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
    const int axis = longest_axis(edges);
    std::nth_element(edges.begin(), middle, edges.end(), [&](int a, int b) {
      const double x = network_.edges[at(a)].middle[axis];
      const double y = network_.edges[at(b)].middle[axis];
      return x < y || (x == y && a < b);
    });
    std::vector<int> lower(edges.begin(), middle);
    std::vector<int> upper;
    std::vector<int> separator;
    for (int e : lower) side_[at(e)] = kLower;
    for (auto e = middle; e != edges.end(); ++e) (touches_lower(*e) ? separator : upper).push_back(*e);
    for (int e : upper) side_[at(e)] = kUpper;

    std::vector<int> lower_loops;
    std::vector<int> upper_loops;
    std::vector<int> separator_loops;
    for (int loop : loops) {
      const char side = common_side(loop);
      (side == kLower ? lower_loops : side == kUpper ? upper_loops : separator_loops).push_back(loop);
    }
    for (int e : edges) side_[at(e)] = kOutside;
    dissect(std::move(lower), lower_loops);
    dissect(std::move(upper), upper_loops);
    append(separator, separator_loops);
  }

  std::vector<int> order;

 private:
  static constexpr char kOutside = 0, kLower = 1, kUpper = 2;

  void append(const std::vector<int>& edges, const std::vector<int>& loops) {
    order.insert(order.end(), edges.begin(), edges.end());
    for (int loop : loops) {
      order.push_back(eq1_.num_edges() + 2 * loop);
      order.push_back(eq1_.num_edges() + 2 * loop + 1);
    }
  }

  int longest_axis(const std::vector<int>& edges) const {
    Eigen::AlignedBox3d box;
    for (int e : edges) box.extend(network_.edges[at(e)].middle);
    int axis = 0;
    box.sizes().maxCoeff(&axis);
    return axis;
  }

  bool touches_lower(int edge) const {
    for (Eigen::SparseMatrix<double>::InnerIterator it(eq1_.laplacian(), edge); it; ++it) {
      if (side_[at(static_cast<int>(it.row()))] == kLower) return true;
    }
    return false;
  }

  char common_side(int loop) const {
    const std::vector<int>& edges = eq1_.loop_edges(loop);
    const char first = side_[at(edges[0])];
    const bool all = std::all_of(edges.begin(), edges.end(), [&](int e) { return side_[at(e)] == first; });
    return all ? first : kOutside;
  }

  const Eq1& eq1_;
  const WireNetwork& network_;
  std::vector<char> side_;  // of each edge while its region is halved
};

}  // namespace

std::vector<int> order_elimination(const Eq1& eq1, const WireNetwork& network) {
  std::vector<int> edges(at(eq1.num_edges()));
  std::vector<int> loops(at(eq1.num_closures() / 2));
  std::iota(edges.begin(), edges.end(), 0);
  std::iota(loops.begin(), loops.end(), 0);
  Dissection dissection(eq1, network);
  dissection.dissect(std::move(edges), loops);
  return std::move(dissection.order);
}

}  // namespace wirewarp
