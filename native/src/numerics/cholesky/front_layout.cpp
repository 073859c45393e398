// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/front_layout.h"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <utility>

#include "numerics/cholesky/front_kernels.h"
#include "numerics/cholesky/partition_subtrees.h"

namespace wirewarp {
namespace {

int tiles_for(int unknowns) { return (unknowns + kTile - 1) / kTile; }

class Builder {
 public:
  Builder(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree, int unknowns_per_vertex)
      : lower_(lower), tree_(tree), k_(unknowns_per_vertex) {
    if (lower.rows() != lower.cols() || lower.rows() % k_ != 0 || !lower.isCompressed()) {
      throw std::invalid_argument(
          "multifrontal Cholesky: the matrix must be square and compressed, and its size a multiple of the unknowns "
          "per vertex");
    }
    layout_.unknowns_per_vertex = k_;
    layout_.num_unknowns = lower.rows();
  }

  FrontLayout build() {
    number_vertices();
    sort_entries_by_front();
    for (int node = 0; node < num_fronts(); ++node) add_front(node);
    layout_.fronts.push_back({-1, end_of(layout_.vertices), 0, 0, 0, 0, 0, end_of(layout_.entries), 0, 0});
    link_to_parents();
    return std::move(layout_);
  }

 private:
  template <typename T>
  static int end_of(const std::vector<T>& list) {
    return static_cast<int>(list.size());
  }
  int num_fronts() const { return static_cast<int>(tree_.nodes.size()); }
  int vertex_of(int unknown) const { return k_ == 2 ? unknown / 2 : unknown / k_; }  // division by a variable is slow
  bool is_earlier(int a, int b) const { return elimination_[a] < elimination_[b]; }

  void number_vertices() {
    const std::size_t num_vertices = (lower_.rows() / k_);
    layout_.front_of_vertex.assign(num_vertices, -1);
    elimination_.resize(num_vertices);
    int count = 0;
    for (int node = 0; node < num_fronts(); ++node) {
      const int parent = tree_.nodes[node].parent;
      if (parent != -1 && (parent <= node || parent >= num_fronts())) refuse("a node comes after its parent");
      for (int v : tree_.nodes[node].vertices) {
        if (v < 0 || static_cast<std::size_t>(v) >= num_vertices || layout_.front_of_vertex[v] != -1)
          refuse("a vertex is out of range or in two nodes");
        layout_.front_of_vertex[v] = node;
        elimination_[v] = count++;
      }
    }
    if (static_cast<std::size_t>(count) != num_vertices) refuse("a vertex is missing");
  }

  /// Sorts the entries of the matrix by front. An entry couples two vertices, and belongs to the front that eliminates
  /// the first of them.
  void sort_entries_by_front() {
    entry_start_.assign(num_fronts() + 1, 0);
    const auto front_of = [this](int row, int column) {
      return std::min(layout_.front_of_vertex[vertex_of(row)], layout_.front_of_vertex[vertex_of(column)]);
    };
    for_each_entry([&](int row, int column, int) { ++entry_start_[front_of(row, column) + 1]; });
    for (std::size_t node = 1; node < entry_start_.size(); ++node) entry_start_[node] += entry_start_[node - 1];
    entries_.resize(entry_start_.back());
    std::vector<int> next(entry_start_.begin(), entry_start_.end() - 1);
    for_each_entry([&](int row, int column, int source) {
      entries_[next[front_of(row, column)]++] = {row, column, source};
    });
    layout_.entries.reserve(entries_.size());
    seen_by_.assign(elimination_.size(), -1);
    place_.resize(elimination_.size());
  }

  template <typename Function>
  void for_each_entry(Function&& function) const {
    for (int column = 0; column < lower_.outerSize(); ++column) {
      for (int i = lower_.outerIndexPtr()[column]; i < lower_.outerIndexPtr()[column + 1]; ++i) {
        function(lower_.innerIndexPtr()[i], column, i);
      }
    }
  }

  void add_front(int node) {
    Front front{};
    front.parent = tree_.nodes[node].parent;
    front.first_vertex = end_of(layout_.vertices);
    front.first_entry = end_of(layout_.entries);
    front.num_pivots = end_of(tree_.nodes[node].vertices);
    add_vertices(node);
    front.num_rows = front.num_own_rows = end_of(layout_.vertices) - front.first_vertex - front.num_pivots;
    front.pivot_tiles = tiles_for(k_ * front.num_pivots);
    front.row_tiles = tiles_for(k_ * front.num_rows);
    front.panel = layout_.panel_tiles;
    layout_.panel_tiles += panel_row(front.pivot_tiles + front.row_tiles, front.pivot_tiles);
    layout_.largest_front = std::max(layout_.largest_front, front.pivot_tiles + front.row_tiles);
    add_entries(front, node);
    layout_.fronts.push_back(front);
    if (front.parent != -1) children_of_[front.parent].push_back(node);
  }

  /// Lists the pivots of a front. Then lists, in elimination order, the other vertices that are coupled with the pivots
  /// or are rows of the front's children.
  void add_vertices(int node) {
    std::vector<int>& vertices = layout_.vertices;
    for (int v : tree_.nodes[node].vertices) {
      vertices.push_back(v);
      seen_by_[v] = node;
    }
    const std::size_t first_row = vertices.size();
    const auto add = [&](int v) {
      if (std::exchange(seen_by_[v], node) != node) vertices.push_back(v);
    };
    for (int e = entry_start_[node]; e < entry_start_[node + 1]; ++e) {
      add(vertex_of(entries_[e].row));
      add(vertex_of(entries_[e].column));
    }
    for (int child : children_of_[node]) {
      const Front& front = layout_.fronts[child];
      for (int i = 0; i < front.num_rows; ++i) add(vertices[front.first_vertex + front.num_pivots + i]);
    }
    std::sort(vertices.begin() + static_cast<std::ptrdiff_t>(first_row), vertices.end(),
              [this](int a, int b) { return is_earlier(a, b); });
    if (first_row == vertices.size()) return;
    const int parent = tree_.nodes[node].parent;
    if (parent == -1 || layout_.front_of_vertex[vertices[first_row]] < parent) {
      refuse("the matrix joins vertices that the tree separates");
    }
  }

  void add_entries(const Front& front, int node) {
    if (panel_row(front.pivot_tiles + front.row_tiles, front.pivot_tiles) > kMostTiles) {
      throw std::length_error("multifrontal Cholesky: a front is too large");
    }
    for (int i = 0; i < front.num_pivots + front.num_rows; ++i) {
      place_[layout_.vertices[front.first_vertex + i]] = i;
    }
    const auto row_of = [&](int unknown) {
      const int vertex = vertex_of(unknown);
      return layout_.row_of(front, place_[vertex]) + unknown - k_ * vertex;
    };
    for (int e = entry_start_[node]; e < entry_start_[node + 1]; ++e) {
      const auto [column, row] = std::minmax({row_of(entries_[e].row), row_of(entries_[e].column)});
      const std::size_t tile = panel_row(row / kTile, front.pivot_tiles) + (column / kTile);
      layout_.entries.push_back(
          {entries_[e].source, static_cast<std::uint32_t>(16 * tile + (kTile * (column % kTile) + row % kTile))});
    }
  }

  /// Fills rows_in_parent. The rows of a child are among its parent's vertices, in the same order.
  void link_to_parents() {
    for (int node = 0; node < num_fronts(); ++node) {
      Front& front = layout_.fronts[node];
      front.first_child = end_of(layout_.children);
      layout_.children.insert(layout_.children.end(), children_of_[node].begin(), children_of_[node].end());
      front.first_row = end_of(layout_.rows_in_parent);
      if (front.num_rows == 0) continue;
      const Front& parent = layout_.fronts[front.parent];
      int place = 0;
      for (int i = front.first_vertex + front.num_pivots; i < layout_.fronts[node + 1].first_vertex; ++i) {
        while (layout_.vertices[parent.first_vertex + place] != layout_.vertices[i]) ++place;
        for (int unknown = 0; unknown < k_; ++unknown) {
          layout_.rows_in_parent.push_back(layout_.row_of(parent, place) + unknown);
        }
      }
    }
    layout_.fronts.back().first_child = end_of(layout_.children);
    layout_.fronts.back().first_row = end_of(layout_.rows_in_parent);
  }

  [[noreturn]] static void refuse(const char* reason) {
    throw std::invalid_argument(std::string("multifrontal Cholesky, dissection tree: ") + reason);
  }

  struct Entry {
    int row, column, source;
  };
  // A panel has at most this many tiles of 16 entries, because MatrixEntry::place indexes the entries by 32 bits.
  static constexpr std::size_t kMostTiles = std::numeric_limits<std::uint32_t>::max() / 16;

  const Eigen::SparseMatrix<double>& lower_;
  const DissectionTree& tree_;
  const int k_;
  FrontLayout layout_;
  std::vector<int> elimination_;  // position of each vertex in the elimination order
  std::vector<int> entry_start_;  // index in entries_ of the first entry of each front
  std::vector<Entry> entries_;
  std::vector<std::vector<int>> children_of_{tree_.nodes.size()};
  std::vector<int> seen_by_;  // last front that visited each vertex
  std::vector<int> place_;    // position of each vertex in the current front
};

}  // namespace

FrontLayout lay_out_fronts(const Eigen::SparseMatrix<double>& lower, const DissectionTree& tree,
                           int unknowns_per_vertex, bool keeps_root) {
  FrontLayout layout = Builder(lower, tree, unknowns_per_vertex).build();
  if (keeps_root) layout.kept_root = static_cast<int>(tree.nodes.size()) - 1;
  partition_subtrees(layout);
  place_schur_complements(layout);
  list_shared_vertices(layout);
  return layout;
}

}  // namespace wirewarp
