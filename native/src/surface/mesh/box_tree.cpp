// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/mesh/box_tree.h"

#include <algorithm>
#include <numeric>

namespace wirewarp {

BoxTree::BoxTree(const std::vector<Box2>& boxes) : items_(boxes.size()) {
  std::iota(items_.begin(), items_.end(), 0);
  if (boxes.empty()) return;
  build(boxes, 0, 0, static_cast<int>(boxes.size()));
  item_boxes_.reserve(items_.size());
  for (const int item : items_) item_boxes_.push_back(boxes[static_cast<std::size_t>(item)]);
}

void BoxTree::build(const std::vector<Box2>& boxes, int node, int first, int last) {
  Box2 bounds;
  for (int i = first; i < last; ++i) {
    bounds.extend(boxes[static_cast<std::size_t>(items_[static_cast<std::size_t>(i)])]);
  }
  if (static_cast<std::size_t>(node) >= node_boxes_.size()) node_boxes_.resize(static_cast<std::size_t>(node) + 1);
  node_boxes_[static_cast<std::size_t>(node)] = bounds;
  if (last - first <= kLeafSize) return;

  const int axis = bounds.sizes().x() >= bounds.sizes().y() ? 0 : 1;
  const int middle = first + (last - first) / 2;
  std::nth_element(items_.begin() + first, items_.begin() + middle, items_.begin() + last, [&](int a, int b) {
    const Box2& box_a = boxes[static_cast<std::size_t>(a)];
    const Box2& box_b = boxes[static_cast<std::size_t>(b)];
    return box_a.min()[axis] + box_a.max()[axis] < box_b.min()[axis] + box_b.max()[axis];
  });
  build(boxes, 2 * node + 1, first, middle);
  build(boxes, 2 * node + 2, middle, last);
}

}  // namespace wirewarp
