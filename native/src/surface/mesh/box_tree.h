// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the planar boxes that meet a given box, by a tree of bounding boxes. It works for any mix of sizes.
#pragma once

#include <Eigen/Geometry>
#include <vector>

namespace wirewarp {

using Box2 = Eigen::AlignedBox2d;

class BoxTree {
 public:
  /// Items are indices into boxes. Copies the boxes.
  explicit BoxTree(const std::vector<Box2>& boxes);

  /// Calls visit(item) for every item whose box meets or touches the query.
  template <typename Visit>
  void for_each_meeting(const Box2& query, Visit&& visit) const {
    if (!items_.empty()) descend(0, 0, static_cast<int>(items_.size()), query, visit);
  }

 private:
  static constexpr int kLeafSize = 4;  // up to this many boxes are faster to test one by one

  void build(const std::vector<Box2>& boxes, int node, int first, int last);

  // Node n has the items [first, last). Each of its children, nodes 2n+1 and 2n+2, has half of these items.
  template <typename Visit>
  void descend(int node, int first, int last, const Box2& query, Visit& visit) const {
    const Box2& box = node_boxes_[static_cast<std::size_t>(node)];
    if (!box.intersects(query)) return;
    if (last - first <= kLeafSize) {
      for (int i = first; i < last; ++i) {
        if (item_boxes_[static_cast<std::size_t>(i)].intersects(query)) visit(items_[static_cast<std::size_t>(i)]);
      }
      return;
    }
    const int middle = first + (last - first) / 2;
    descend(2 * node + 1, first, middle, query, visit);
    descend(2 * node + 2, middle, last, query, visit);
  }

  std::vector<Box2> node_boxes_;
  std::vector<int> items_;
  std::vector<Box2> item_boxes_;  // in the order of items_
};

}  // namespace wirewarp
