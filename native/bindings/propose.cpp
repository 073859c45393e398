// SPDX-License-Identifier: GPL-3.0-or-later
// wirewarp.propose_darts and wirewarp.propose_seams: where to cut. And as jobs wirewarp.start_darts and start_seams.
#include "wirewarp/propose.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arguments.h"
#include "arrays.h"
#include "bind.h"
#include "job.h"
#include "progress.h"
#include "record.h"
#include "running_call.h"

namespace wirewarp::bindings {
namespace {

using Propose = std::vector<DartProposal> (*)(const FlattenInput&, const Options&, const CutWishes&, const Progress&);

constexpr const char* kDartsDoc =
    R"(Darts that lower the distortion of a piece that lies flat, those that take most from the model first.

Each runs from the outline to a point inside, along edges that run on smoothly, and cuts no wire. Every figure is of a
run of flatten() with the edges of the dart as seams: flatten(..., seams=[*seams, *proposal.edges]).

piece: the piece to cut, as flatten() numbers them; None for any, whichever gains most.
count: proposals at most, the mirror images of one another counted once.
strain: what may stay: pieces with no more (DartProposal.strain) are left as they are; None for 0.005.
longest: no cut is longer on the surface, scene units; None for any length.
no_seam: (k, 2) vertex pairs, edges along which no cut is to run.
progress: called as progress("cuts", fraction); returning False cancels, which raises FlattenError.
The other arguments are those of flatten().

Raises what flatten() raises; the error of the piece asked for, if it does not lie flat, with the seams that mend it;
FlattenError "no_proposal" where a piece is flat already, has no room or gains nothing.)";

constexpr const char* kSeamsDoc =
    R"(Seams across a piece, from outline to outline, that lower its distortion, those that take most first.

Arguments, figures and errors are those of propose_darts().

First cuts: where the piece has no flat shape for want of seams (it is closed, such as a ball, has handles, or an outline
that cannot hold it, such as a tube), each proposal is a set of seams and darts under which all parts lie flat. Of all pieces
the largest such one comes first. The first set has as many cuts as bring every part to the strain that may stay (None
for 0.05), as far as further ones help, forty and their mirror images at most; each set after it has fewer. Sets are
symmetric where the piece is, and may cross wires. Of a set, edges is one line after the other, energy that of all
parts, strain that of the part with most, longest is of the whole set; energy_before and strain_before are infinite.
"no_proposal" is raised where no_seam or longest leaves none.)";

constexpr const char* kStartDartsDoc =
    R"(Starts propose_darts() with these arguments and returns a Job at once, as start() does.)";

constexpr const char* kStartSeamsDoc =
    R"(Starts propose_seams() with these arguments and returns a Job at once, as start() does.)";

CutWishes read_wishes(std::optional<int> piece, int count, std::optional<double> strain, std::optional<double> longest,
                      const py::object& no_seam) {
  return {piece, count, strain, longest.value_or(CutWishes().longest), read_no_seam(no_seam)};
}

template <Propose propose>
std::vector<DartProposal> run(const py::object& vertices, const py::object& faces, const py::object& seams,
                              const py::object& wires, const py::object& options, const py::object& eases,
                              std::optional<int> piece, int count, std::optional<double> strain,
                              std::optional<double> longest, const py::object& no_seam, const py::object& progress) {
  const FlattenInput input = read_input(vertices, faces, seams, wires, eases);
  const Options checked_options = read_options(options);
  const CutWishes wishes = read_wishes(piece, count, strain, longest, no_seam);
  PythonProgress python_progress(progress);
  const RunningCall running;
  std::vector<DartProposal> proposals;
  try {
    const py::gil_scoped_release no_gil;
    const auto report = [&](const std::string& stage, double fraction) {
      return python_progress.report(stage, fraction);
    };
    proposals = propose(input, checked_options, wishes, report);
  } catch (...) {
    python_progress.rethrow();
    throw;
  }
  python_progress.rethrow();
  return proposals;
}

template <Propose propose>
std::unique_ptr<Job> start(const py::object& vertices, const py::object& faces, const py::object& seams,
                           const py::object& wires, const py::object& options, const py::object& eases,
                           std::optional<int> piece, int count, std::optional<double> strain,
                           std::optional<double> longest, const py::object& no_seam) {
  auto find = [input = read_input(vertices, faces, seams, wires, eases), checked_options = read_options(options),
               wishes = read_wishes(piece, count, strain, longest, no_seam)](const Progress& progress) {
    return propose(input, checked_options, wishes, progress);
  };
  return std::make_unique<Job>(work_that(std::move(find)));
}

/// more: of arguments that follow those that both have.
template <class Function, class... Extra>
void define(py::module_& module, const char* name, Function function, const char* doc, const Extra&... more) {
  module.def(name, function, py::arg("vertices"), py::arg("faces"), py::kw_only(), py::arg("seams") = py::none(),
             py::arg("wires") = py::tuple(), py::arg("options") = py::none(), py::arg("eases") = py::tuple(),
             py::arg("piece") = py::none(), py::arg("count") = CutWishes().count, py::arg("strain") = py::none(),
             py::arg("longest") = py::none(), py::arg("no_seam") = py::none(), more..., doc);
}

}  // namespace

void bind_propose(py::module_& module) {
  Record<DartProposal>(module, "DartProposal")
      .field("piece", &DartProposal::piece)
      .field("edges", &DartProposal::edges)
      .field("length", &DartProposal::length)
      .field("energy", &DartProposal::energy)
      .field("energy_before", &DartProposal::energy_before)
      .field("strain", &DartProposal::strain)
      .field("strain_before", &DartProposal::strain_before)
      .field("twin", &DartProposal::twin)
      .field("energy_with_twin", &DartProposal::energy_with_twin)
      .field("strain_with_twin", &DartProposal::strain_with_twin)
      .picklable();
  const py::arg_v progress = py::arg("progress") = py::none();
  define(module, "propose_darts", &run<propose_darts>, kDartsDoc, progress);
  define(module, "propose_seams", &run<propose_seams>, kSeamsDoc, progress);
  define(module, "start_darts", &start<propose_darts>, kStartDartsDoc);
  define(module, "start_seams", &start<propose_seams>, kStartSeamsDoc);
}

}  // namespace wirewarp::bindings
