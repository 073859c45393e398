// SPDX-License-Identifier: GPL-3.0-or-later
#include "refine/vertex_matrix.h"

#include <algorithm>

#include "index.h"

namespace wirewarp {

VertexMatrix::VertexMatrix(int num_vertices, std::vector<VertexPair> pairs) {
  // Each pair by its smaller vertex, which is the column.
  for (VertexPair& pair : pairs) std::sort(pair.begin(), pair.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());

  lower_.resize(2 * num_vertices, 2 * num_vertices);
  lower_.resizeNonZeros(static_cast<Eigen::Index>(4 * pairs.size()) + 3 * num_vertices);
  int* begin = lower_.outerIndexPtr();
  int* rows = lower_.innerIndexPtr();
  int next = 0;
  auto pair = pairs.begin();
  for (int v = 0; v < num_vertices; ++v) {
    const auto first = pair;
    for (int k = 0; k < 2; ++k) {  // the columns of x and of y
      begin[2 * v + k] = next;
      for (int row = k; row < 2; ++row) rows[next++] = 2 * v + row;
      for (pair = first; pair != pairs.end() && (*pair)[0] == v; ++pair) {
        rows[next++] = 2 * (*pair)[1];
        rows[next++] = 2 * (*pair)[1] + 1;
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
  return std::max(value[diagonal_[at(vertex)].left], value[diagonal_[at(vertex)].right]);
}

}  // namespace wirewarp
