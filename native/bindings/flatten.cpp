// SPDX-License-Identifier: GPL-3.0-or-later
// Binds wirewarp.flatten and wirewarp.measure, which read the arrays, release the GIL and run the core.
#include "wirewarp/flatten.h"

#include "arguments.h"
#include "arrays.h"
#include "bind.h"
#include "progress.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

FlattenResult run_flatten(const py::object& vertices, const py::object& faces, const py::object& seams,
                          const py::object& wires, const py::object& options, const py::object& progress,
                          const py::object& cache, const py::object& eases) {
  const FlattenInput input = read_input(vertices, faces, seams, wires, eases);
  const Options checked_options = read_options(options);
  Cache* const solved_before = read_cache(cache);
  PythonProgress python_progress(progress);
  FlattenResult result;
  try {
    const py::gil_scoped_release no_gil;
    const auto report = [&](const std::string& stage, double fraction) {
      return python_progress.report(stage, fraction);
    };
    result = flatten(input, checked_options, report, solved_before);
  } catch (...) {
    python_progress.rethrow();
    throw;
  }
  python_progress.rethrow();
  return result;
}

FlattenResult run_measure(const py::object& vertices, const py::object& faces, const py::object& corner_uv,
                          const py::object& seams, const py::object& wires, const py::object& eases) {
  const FlattenInput input = read_input(vertices, faces, seams, wires, eases);
  const CornerUv corners = read_corner_uv(corner_uv);
  const py::gil_scoped_release no_gil;
  return measure(input, corners);
}

constexpr const char* kFlattenDoc =
    R"(Flattens every region between seams into a piece with the exact lengths of its outline and wires.

vertices: (n, 3) real numbers, scene units.
faces: (m, 3) whole numbers, triangles.
seams: (k, 2) vertex pairs along which the surface is cut.
wires: Wire objects. A wire along a seam or outline sets the length of that section, on all its sides.
eases: Ease objects. Each changes the length of one side of a seam, or of a section of the outline.
options: Options; None for the defaults.
progress: called as progress(stage, fraction), always in the calling thread. Returning False cancels the pieces that are
    not flat yet. In the first stage, "charts", and in the last stage, "measure", it cancels all pieces. It also cancels
    all pieces if flat pieces take long to measure. An exception cancels the run and is raised again.
cache: a Cache. Pieces that did not change since the last run with this cache are not solved again.

Raises FlattenError if the input is not a mesh with seams and wires. If a region cannot be flattened, its Piece.error is
the FlattenError, and the other pieces are not affected.)";

constexpr const char* kMeasureDoc =
    R"(Measures and checks a flattening from any program, by the same rules as flatten().

Nothing is solved: a million triangles take about a second, and the call cannot be canceled.

corner_uv: (m, 3, 2) flat position of each corner of each face, scene units; returned unchanged.
The other arguments are those of flatten().)";

}  // namespace

void bind_flatten(py::module_& module) {
  module.def("flatten", &run_flatten, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"),
             py::kw_only(), py::arg("seams") = py::none(), py::arg("wires") = py::tuple(),
             py::arg("options") = py::none(), py::arg("progress") = py::none(), py::arg("cache") = py::none(),
             py::arg("eases") = py::tuple(), kFlattenDoc);
  module.def("measure", &run_measure, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"),
             py::arg("corner_uv"), py::arg("seams") = py::none(), py::arg("wires") = py::tuple(),
             py::arg("eases") = py::tuple(), kMeasureDoc);
}

}  // namespace wirewarp::bindings
