// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/vertex_matrix.h"

#include <algorithm>
#include <iterator>
#include <numeric>

namespace wirewarp {
namespace {

struct Columns {
  std::vector<int> begin;  // index into `row` at which each column begins, then the size of `row`
  std::vector<int> row;    // increasing in each column
};

/// Returns, for each vertex, the larger vertices with which it forms pairs, without duplicates. Omits pairs of a vertex
/// with itself.
Columns columns_of(int num_vertices, const std::vector<VertexPair>& pairs) {
  std::vector<int> end(num_vertices + 1, 0);
  for (const VertexPair& pair : pairs) ++end[std::min(pair[0], pair[1]) + 1];
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<int> larger(pairs.size());
  for (const VertexPair& pair : pairs) larger[end[std::min(pair[0], pair[1])]++] = std::max(pair[0], pair[1]);

  Columns columns;
  auto first = larger.begin();
  for (int v = 0; v < num_vertices; ++v) {
    const auto last = larger.begin() + end[v];
    std::sort(first, last);
    columns.begin.push_back(static_cast<int>(columns.row.size()));
    std::unique_copy(std::upper_bound(first, last, v), last, std::back_inserter(columns.row));
    first = last;
  }
  columns.begin.push_back(static_cast<int>(columns.row.size()));
  return columns;
}

}  // namespace

VertexMatrix::VertexMatrix(int num_vertices, const std::vector<VertexPair>& pairs) {
  const Columns columns = columns_of(num_vertices, pairs);
  lower_.resize(2 * num_vertices, 2 * num_vertices);
  lower_.resizeNonZeros(static_cast<Eigen::Index>(4 * columns.row.size()) + 3 * num_vertices);
  int* begin = lower_.outerIndexPtr();
  int* rows = lower_.innerIndexPtr();
  int next = 0;
  for (int v = 0; v < num_vertices; ++v) {
    for (int k = 0; k < 2; ++k) {  // the columns of x and of y
      begin[2 * v + k] = next;
      for (int row = k; row < 2; ++row) rows[next++] = 2 * v + row;
      for (int i = columns.begin[v]; i < columns.begin[v + 1]; ++i) {
        rows[next++] = 2 * columns.row[i];
        rows[next++] = 2 * columns.row[i] + 1;
      }
    }
    diagonal_.push_back({begin[2 * v], begin[2 * v + 1]});
  }
  begin[2 * num_vertices] = next;
  set_zero();
}

VertexMatrix::Block VertexMatrix::block(int row, int column) const {
  const int* begin = lower_.outerIndexPtr();
  const int* rows = lower_.innerIndexPtr();
  const int left = begin[2 * column], right = begin[2 * column + 1];
  const int place = static_cast<int>(std::lower_bound(rows + left + 2, rows + right, 2 * row) - rows);
  return {place, right + 1 + (place - left - 2)};
}

double VertexMatrix::largest_diagonal(int vertex) const {
  const double* value = lower_.valuePtr();
  return std::max(value[diagonal_[vertex].left], value[diagonal_[vertex].right]);
}

}  // namespace wirewarp
