// SPDX-License-Identifier: GPL-3.0-or-later
#include "energy/outline_barrier.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/planar.h"
#include "energy/log_barrier.h"
#include "surface/mesh/box_tree.h"
#include "surface/mesh/geometry.h"

namespace wirewarp {
namespace {

// κ: at a distance of about d̂/2, the force of the barrier is as large as the force of a strain of 1.
constexpr double kWeight = 1;
// d̂ divided by the length of the edge. With this value, the two sides of a corner of more than 6° are not a contact.
constexpr double kReach = 0.1;
// The Hessian contains the contacts up to this multiple of d̂, so that it lasts for several steps.
constexpr double kCovered = 8;
// Distance over an edge's length. A vertex that passes the edge's end at a smaller distance touches the edge.
// The distance is far above rounding errors, so that these let no vertex pass.
constexpr double kAside = 1e-9;

Box2 box_around(const Eigen::Vector2d& a, const Eigen::Vector2d& b, double margin) {
  return Box2(a.cwiseMin(b).array() - margin, a.cwiseMax(b).array() + margin);
}

/// Returns the real roots of a + bt + ct²; 0 if the polynomial is 0 everywhere.
std::vector<double> roots(double a, double b, double c) {
  if (c == 0 && b == 0) return a == 0 ? std::vector<double>{0} : std::vector<double>{};
  const double discriminant = b * b - 4 * a * c;
  if (discriminant < 0) return {};
  const double q = -(b + std::copysign(std::sqrt(discriminant), b)) / 2;  // the sign of the root avoids cancellation
  std::vector<double> times;
  if (q != 0) times.push_back(a / q);
  if (c != 0) times.push_back(q / c);
  return times;
}

}  // namespace

OutlineBarrier::OutlineBarrier(const Chart& chart, const Positions2& layout)
    : reach_(chart.mesh.n_vertices(), std::numeric_limits<double>::infinity()),
      outline_length_(chart.mesh.n_vertices(), 0) {
  for (const HalfEdgeChain& loop : chart.boundary_loops) {
    for (const HalfedgeHandle h : loop) {
      const int a = chart.mesh.from_vertex_handle(h).idx(), b = chart.mesh.to_vertex_handle(h).idx();
      const double length = edge_length(chart.mesh, h);
      for (const int v : {a, b}) {
        reach_[v] = std::min(reach_[v], kReach * length);
        outline_length_[v] += length / 2;
      }
      edges_.push_back({a, b, 0});
      vertices_.push_back(a);
    }
  }
  for (Edge& edge : edges_) edge.reach = std::min(reach_[edge.a], reach_[edge.b]);
  covered_ = find_contacts(layout, kCovered);
}

bool OutlineBarrier::comes_before(const Contact& a, const Contact& b) {
  return std::tie(a.p, a.edge) < std::tie(b.p, b.edge);
}

OutlineBarrier::Distance OutlineBarrier::distance(const Positions2& uv, const Contact& contact) const {
  const Edge& edge = edges_[contact.edge];
  const Eigen::Vector2d from_a = uv.row(contact.p) - uv.row(edge.a), side = uv.row(edge.b) - uv.row(edge.a);
  const double square = side.squaredNorm();
  const double along = square > 0 ? std::clamp(from_a.dot(side) / square, 0.0, 1.0) : 0;
  const Eigen::Vector2d apart = from_a - along * side;
  return {apart.norm(), apart.normalized(), along};
}

/// Returns the contacts nearer than `reaches` times d̂, sorted by comes_before().
std::vector<OutlineBarrier::Contact> OutlineBarrier::find_contacts(const Positions2& uv, double reaches) const {
  std::vector<Box2> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& edge : edges_) boxes.push_back(box_around(uv.row(edge.a), uv.row(edge.b), reaches * edge.reach));
  const BoxTree tree(boxes);
  std::vector<Contact> found;
  for (const int p : vertices_) {
    tree.for_each_meeting(box_around(uv.row(p), uv.row(p), 0), [&](int e) {
      if (edges_[e].a == p || edges_[e].b == p) return;
      const Contact contact{p, e, std::min(edges_[e].reach, reach_[p])};
      if (distance(uv, contact).value < reaches * contact.reach) found.push_back(contact);
    });
  }
  std::sort(found.begin(), found.end(), comes_before);
  return found;
}

double OutlineBarrier::value(const Positions2& uv) const {
  double sum = 0;
  for (const Contact& contact : find_contacts(uv, 1)) {
    sum += outline_length_[contact.p] * contact.reach * LogBarrier(distance(uv, contact).value / contact.reach).value;
  }
  return kWeight * sum;
}

double OutlineBarrier::add_gradient(const Positions2& uv, Positions2& gradient) const {
  double sum = 0;
  for (const Contact& contact : find_contacts(uv, 1)) {
    const Distance d = distance(uv, contact);
    const LogBarrier barrier(d.value / contact.reach);
    const Edge& edge = edges_[contact.edge];
    const Eigen::RowVector2d force = kWeight * outline_length_[contact.p] * barrier.slope * d.normal.transpose();
    gradient.row(contact.p) += force;
    gradient.row(edge.a) -= (1 - d.along) * force;
    gradient.row(edge.b) -= d.along * force;
    sum += outline_length_[contact.p] * contact.reach * barrier.value;
  }
  return kWeight * sum;
}

void OutlineBarrier::list_pairs(std::vector<VertexPair>& pairs) const {
  for (const Contact& contact : covered_) {
    pairs.push_back({contact.p, edges_[contact.edge].a});
    pairs.push_back({contact.p, edges_[contact.edge].b});
  }
}

void OutlineBarrier::add_hessian(const Positions2& uv, VertexMatrix& hessian) const {
  for (const Contact& contact : covered_) {
    const Distance d = distance(uv, contact);
    const double curvature = LogBarrier(d.value / contact.reach).curvature;
    if (curvature == 0) continue;
    const Eigen::Matrix2d block =
        kWeight * outline_length_[contact.p] / contact.reach * curvature * d.normal * d.normal.transpose();
    const int vertices[3] = {contact.p, edges_[contact.edge].a, edges_[contact.edge].b};
    const double shares[3] = {1, d.along - 1, -d.along};
    for (int i = 0; i < 3; ++i) {
      hessian.add_diagonal(vertices[i], shares[i] * shares[i] * block);
      for (int j = 0; j < 3; ++j) {
        if (vertices[i] <= vertices[j]) continue;
        hessian.add(hessian.block(vertices[i], vertices[j]), shares[i] * shares[j] * block);
      }
    }
  }
}

bool OutlineBarrier::covers_contacts(const Positions2& uv) const {
  const std::vector<Contact> contacts = find_contacts(uv, 1);
  return std::includes(covered_.begin(), covered_.end(), contacts.begin(), contacts.end(), comes_before);
}

/// p reaches the line through a and b when p − a and b − a span zero area. The shares of the step at which this happens
/// are the roots of a quadratic polynomial.
double OutlineBarrier::longest_step(const Positions2& uv, const Positions2& d) const {
  const Positions2 end = uv + d;
  const auto swept = [&](int v) { return box_around(uv.row(v), end.row(v), 0); };
  std::vector<Box2> boxes;
  boxes.reserve(edges_.size());
  for (const Edge& edge : edges_) boxes.push_back(swept(edge.a).merged(swept(edge.b)));
  const BoxTree tree(boxes);
  double longest = 1;
  for (const int p : vertices_) {
    tree.for_each_meeting(swept(p), [&](int e) {
      const Edge& edge = edges_[e];
      if (edge.a == p || edge.b == p) return;
      const Eigen::Vector2d to_p = uv.row(p) - uv.row(edge.a), side = uv.row(edge.b) - uv.row(edge.a);
      const Eigen::Vector2d p_moves = d.row(p) - d.row(edge.a), side_moves = d.row(edge.b) - d.row(edge.a);
      const double b = cross(side, p_moves) + cross(side_moves, to_p);
      for (const double t : roots(cross(side, to_p), b, cross(side_moves, p_moves))) {
        if (!(t >= 0 && t < longest)) continue;
        const Eigen::Vector2d side_then = side + t * side_moves;
        const double along = (to_p + t * p_moves).dot(side_then) / side_then.squaredNorm();
        if (along >= -kAside && along <= 1 + kAside) longest = t;
      }
    });
  }
  return longest;
}

}  // namespace wirewarp
