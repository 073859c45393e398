// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.straighten_path, which returns a smooth line beside a path of edges.
#include "wirewarp/straighten.h"

#include <pybind11/eigen.h>

#include "arguments.h"
#include "arrays.h"
#include "bind.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

py::tuple run_straighten(const py::object& vertices, const py::object& faces, const py::object& path,
                         const py::object& seams, const py::object& wires) {
  const FlattenInput input = read_input(vertices, faces, seams, wires, py::tuple());
  const std::vector<int> chain = read_chain(path, "Path");
  std::vector<LinePoint> line;
  {
    const py::gil_scoped_release no_gil;
    line = straighten_path(input, chain);
  }
  VertexPairs edges(line.size(), 2);
  Eigen::VectorXd t(line.size());
  for (Eigen::Index i = 0; i < t.size(); ++i) {
    edges.row(i) << line[i].edge[0], line[i].edge[1];
    t[i] = line[i].t;
  }
  return py::make_tuple(edges, t);
}

constexpr const char* kStraightenDoc =
    R"(Returns the shortest line through the triangles that touch a path of edges, with the same ends. Use it for darts.

path: different vertices, each joined to the next by an edge that is not on a seam or outline. A future seam must not
    be among the seams yet.
seams, wires: as in flatten(). The line meets them at the same vertices as the path.

Returns (edges, t), one row for each point of the line, including its ends: edges (k, 2) vertices, t (k,) numbers. The
point is vertices[edges[i, 0]] + t[i] (vertices[edges[i, 1]] - vertices[edges[i, 0]]), with t in [0.05, 0.95]. If the
line would cross an edge closer to an end, it passes through this end. If a point is a vertex, its row of edges has
this vertex twice, and t is 0.

Raises the errors of flatten() for the mesh, and FlattenError "invalid_option" if path passes a vertex twice or does not
follow edges. This error names the vertices.)";

}  // namespace

void bind_straighten(py::module_& module) {
  module.def("straighten_path", &run_straighten, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"),
             py::arg("path"), py::kw_only(), py::arg("seams") = py::none(), py::arg("wires") = py::tuple(),
             kStraightenDoc);
}

}  // namespace wirewarp::bindings
