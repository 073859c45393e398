// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.SurfacePath and wirewarp.cut_mesh: lines across triangles, and meshes with these lines as edges.
#include "wirewarp/cut_mesh.h"

#include <pybind11/eigen.h>

#include <utility>
#include <vector>

#include "arguments.h"
#include "arrays.h"
#include "bind.h"
#include "record.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

SurfacePath make_path(const py::object& faces, const py::object& coordinates) {
  SurfacePath path{read_whole_numbers(faces, "SurfacePath faces"), read_coordinates(coordinates)};
  check_surface_path(path);
  return path;
}

py::tuple run_cut(const py::object& vertices, const py::object& faces, const py::object& paths,
                  const py::object& snap) {
  const Positions3 positions = read_vertices(vertices);
  const Triangles triangles = read_faces(faces);
  const std::vector<SurfacePath> lines = read_paths(paths);
  const double reach = read_number(snap, "snap");
  CutMesh cut;
  {
    const py::gil_scoped_release no_gil;
    cut = cut_mesh(positions, triangles, lines, reach);
  }
  VertexPairs edges(static_cast<Eigen::Index>(cut.edges.size()), 2);
  for (Eigen::Index i = 0; i < edges.rows(); ++i) edges.row(i) << cut.edges[i][0], cut.edges[i][1];
  return py::make_tuple(std::move(cut.vertices), std::move(cut.faces), std::move(edges), std::move(cut.sources));
}

constexpr const char* kCutDoc =
    R"(Divides triangles so that lines on the surface become edges, for example seams for flatten().

The surface does not change: each new vertex is on an edge or in a triangle of the input. Vertices keep their numbers,
and new vertices follow. Faces keep their orientation. Faces without a path keep their number. One part of a divided
face keeps the number of the face. The other parts follow after all faces. Paths may cross each other.

paths: a list of SurfacePath. Consecutive points must be in one triangle, so a path has a point on each edge it crosses.
snap: 0.0001 to 0.25. To avoid slivers, points move in three cases. A point moves to an edge if the barycentric
    coordinate of the opposite corner is less than snap. A point on an edge moves to an end if the weight of the other
    end is less than snap. A point moves to another point if all their coordinates differ by less than snap. A snapped
    path does not move again.

Returns (vertices, faces, edges, sources). edges (k, 2) are the edges of the paths in order, one path after the other,
each edge once. sources is a CutSources. If of_vertices (n, d), of_faces (m, ...) and of_corners (m, 3, d) are
attributes of the input, the attributes of the new mesh are
    (sources.vertex_weights[:, :, None] * of_vertices[sources.vertices]).sum(axis=1),
    of_faces[sources.faces], and
    np.einsum("fij,fjk->fik", sources.corner_weights, of_corners[sources.faces]).
Seams and wires that a path crosses then run along the vertices in sources.divided_edges.

Raises the errors of flatten() for vertices and faces. Raises FlattenError "invalid_option" for a path that is not on
the mesh, that has two consecutive points without a common triangle, or whose points all snap together.)";

py::object as_arrays(const std::vector<std::vector<int>>& lists, py::handle owner) {
  py::list arrays;
  for (const std::vector<int>& values : lists) arrays.append(to_python(values, owner));
  return arrays;
}

}  // namespace

void bind_cut_mesh(py::module_& module) {
  Record<SurfacePath> path(module, "SurfacePath");
  path.def(
      py::init(&make_path), py::call_guard<RunningCall>(), py::arg("faces"), py::arg("coordinates"),
      "faces: (k,) whole numbers, two or more. coordinates: (k, 3) numbers of 0 or more, each row with the sum 1.");
  path.field("faces", &SurfacePath::faces).field("coordinates", &SurfacePath::coordinates).picklable();
  Record<CutSources>(module, "CutSources")
      .field("vertices", &CutSources::vertices)
      .field("vertex_weights", &CutSources::vertex_weights)
      .field("faces", &CutSources::faces)
      .field(
          "corner_weights",
          [](const CutSources& sources, py::handle owner) {
            return view(sources.corner_weights.data(), {sources.corner_weights.rows(), 3, 3}, owner);
          },
          [](CutSources& sources, py::handle value) { from_python(value, sources.corner_weights); })
      .field("edge_paths", &CutSources::edge_paths)
      .field(
          "divided_edges",
          [](const CutSources& sources, py::handle owner) { return as_arrays(sources.divided_edges, owner); },
          [](CutSources& sources, py::handle value) {
            for (const py::handle item : value) from_python(item, sources.divided_edges.emplace_back());
          })
      .picklable();
  module.def("cut_mesh", &run_cut, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"),
             py::arg("paths"), py::kw_only(), py::arg("snap") = 0.05, kCutDoc);
}

}  // namespace wirewarp::bindings
