// SPDX-License-Identifier: GPL-3.0-or-later
// Binds propose_darts, propose_seams, plan_cuts and simplify_seams, and the functions that run them as jobs:
// start_darts, start_seams, start_plan and start_simplify.
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

using Plan = std::vector<DartProposal> (*)(const FlattenInput&, const Options&, const CutTarget&, const Progress&);

constexpr const char* kDartsDoc =
    R"(Returns darts that lower the stretch that a flat piece needs, sorted by the stretch that they leave in the model.

- A dart leads from the outline to a point inside, along smooth chains of edges, and does not cross wires.
- All figures come from flatten(..., seams=[*seams, *proposal.edges]). strain is that of the worst of the num_pieces
  parts.
- If a dart helps only together with its mirror image, strain_with_twin is below strain_before.
- Darts that leave a strain of 100% or more are not returned.

piece: index of the piece to cut in the result of flatten(); None: the piece with the best cut.
count: maximum number of proposals, with mirror images counted once.
strain: accepted strain; None for 0.005. Pieces with at most this strain (DartProposal.strain) are ignored.
longest: maximum length of a cut on the surface, scene units; None for any length.
no_seam: (k, 2) vertex pairs, edges along which no cut may run.
smooth: True for smooth lines across triangles, as paths without edges. They are straight unless a bend gains clearly
    more. The mean strain around the tip is at most 3%, or the strain of the uncut piece if that is larger. The best
    dart along edges is added if it leaves at least 5% less strain than all smooth darts. To make edges, call vertices,
    faces, edges, sources = cut_mesh(vertices, faces, proposal.paths). The figures are those of flatten(vertices, faces,
    seams=[*seams, *edges]).
no_crossing: (k, 2) vertex pairs, edges that no smooth dart may cross or touch. Darts along edges may touch them.
progress: called as progress("cuts", fraction). Returning False cancels the search and raises FlattenError "cancelled".
The other arguments are those of flatten().

Raises the errors of flatten(). If the requested piece has no flat shape, raises its error, with seams that fix the
piece. Raises FlattenError "no_proposal" if the piece is flat already, has no room for a cut, or gains nothing from a
cut.)";

constexpr const char* kSeamsDoc =
    R"(Returns seams across a piece that lower the stretch that it needs, or cut sets for a piece that lacks seams.

Arguments, figures and errors are those of propose_darts(). Seams across one piece follow edges, even with smooth.

A piece lacks seams in three cases. If no piece is requested, the largest piece that lacks seams is cut.

- It is closed (a ball), has handles, or has an outline that is too short (a tube).
- Its flat shape is flipped or overlaps itself.
- It has no wires inside, and no shape with its lengths and a strain below 1 was found.

A cut set consists of seams and darts with which all parts have a flat shape:

- The first set brings every part to the accepted strain (None for 0.05), unless no further cut helps, or 160 cuts
  follow the first seams. With None, 40 cuts are enough if the strain is then at most 20%. A cut and its mirror image
  count as one. If the accepted strain is not reached, the sets are returned with the strain that they leave.
- Each later set is shorter and leaves more strain. If there are more than count, the first set is listed, and the
  shortest for each limit: the accepted strain, twice as much and so on.
- Sets are symmetric if the piece is symmetric, and may cross wires.
- A piece joined from two covers at least 45% of its convex hull, unless one of the two covers no more of its own.
- edges has one line after the other, energy is the energy of all parts, and strain is the strain of the worst part.
- energy_before and strain_before are infinite.
- longest limits the length of the whole set.

narrowest: least width of the flat pieces of a cut set, scene units; 0 for any width. Two pieces are not joined if the
    joined piece would be narrower than this, unless one of the two is equally narrow. Use a little more than twice the
    allowance: see pattern.piece_width() and pattern.has_room().
smooth: True for cut sets of smooth lines, as paths without edges. Lines turn by less than 30 degrees at each vertex
    between their ends. They keep bends, or stay on edges, if smoother lines would meet, leave too much strain, or make
    pieces narrow. A set may leave less strain than an earlier set. If a strain is given, cuts along edges go down to
    half of it, because smoother lines may double it. Otherwise, the first set may leave more than 0.05. A closed piece
    with necks, or without long sharp edges, is first divided into parts such as a head and limbs. This step needs an
    input without wires, eases and thickness.
no_crossing: (k, 2) vertex pairs, edges that no smooth line may cross. Smooth lines do not cross wires and edges of
    no_seam either.

If progress returns False, the cut sets found by then are returned, with their figures. Some sets may not be smooth yet.
FlattenError "cancelled" is raised only before the first set is found.

Raises FlattenError "no_proposal" if no_seam or longest allow no set.)";

constexpr const char* kStartDartsDoc =
    R"(Starts propose_darts() with these arguments and returns a Job immediately, like start().)";

constexpr const char* kStartSeamsDoc =
    R"(Starts propose_seams() with these arguments and returns a Job immediately, like start().

After cancel(), result() returns the cut sets found by then.)";

constexpr const char* kPlanDoc =
    R"(Returns cuts to make in this order until the strain is low enough, each in the worst piece that a cut helps.

kind: "dart" or "seam", as in propose_darts() and propose_seams().
strain: the target, 0.05 for 5%. Pieces with at most this strain (DartProposal.strain) are ignored.
most: maximum number of cuts, 1 or more; a cut set (see propose_seams()) counts as one.
longest: maximum length of a cut on the surface, scene units; None for any length.
total_length: maximum length of all cuts together on the surface, scene units; None for any length.
piece: index of the only piece to cut, in the result of flatten(); None for any piece.
twins: adds the mirror image of a cut if both cuts are allowed, and if both together leave less strain than one of them.
    They count as two consecutive cuts.
no_seam: (k, 2) vertex pairs, edges along which no cut may run.
The other arguments are those of flatten(); progress is called as in propose_darts().

The figures of each cut and the number of its piece refer to the model with all earlier cuts. strain_left is the strain
of the worst part after the cut. If there are fewer cuts than allowed, the target is met or no further cut helps.
Raises the errors of propose_darts() for the first cut, and FlattenError "no_proposal" if the target is met already.)";

constexpr const char* kStartPlanDoc =
    R"(Starts plan_cuts() with these arguments and returns a Job immediately, like start().)";

constexpr const char* kSimplifyDoc =
    R"(Leaves out seams that a model can do without: fewer and larger pieces with little more stretch.

Sections of seams are removed one by one, the longest first, and then parts of sections:

- Removing a section joins the pieces beside it. The joined piece must have a flat shape with at most the given strain.
  The strain that the worst of these pieces has with the given seams is allowed, too.
- In a symmetric part of the model between the remaining seams, mirrored sections are removed together.
- Seams with an ease on one side and seams with three sides or more remain.
- Seams of a part that has no flat shape for other reasons than missing seams, such as a Moebius strip, remain.

seams: the seams of a user or of any unwrapping tool, in the form that flatten() accepts.
strain: accepted strain (DartProposal.strain); 0.05 for 5%.
progress: called as progress("cuts", fraction). If it returns False, the search ends with the seams that remain by then,
    and was_stopped is True. FlattenError "cancelled" is raised only before the model with the given seams is flat.
The other arguments are those of flatten(). Every figure comes from flatten(..., seams=proposal.edges).

Raises the errors of flatten().)";

constexpr const char* kStartSimplifyDoc =
    R"(Starts simplify_seams() with these arguments and returns a Job immediately, like start().

If the job is canceled, its result has the seams that remain by then.)";

CutOptions read_cut_options(std::optional<int> piece, int count, std::optional<double> strain,
                            std::optional<double> longest, const py::object& no_seam, bool smooth,
                            const py::object& no_crossing) {
  CutOptions cut_options;
  cut_options.piece = piece;
  cut_options.count = count;
  cut_options.strain = strain;
  cut_options.longest = longest.value_or(cut_options.longest);
  cut_options.no_seam = read_edges(no_seam, "no_seam");
  cut_options.is_smooth = smooth;
  cut_options.no_crossing = read_edges(no_crossing, "no_crossing");
  return cut_options;
}

CutTarget read_cut_target(double strain, int most, std::optional<double> longest, std::optional<double> total_length,
                          std::optional<int> piece, bool twins, const py::object& no_seam) {
  return {strain, most,  longest.value_or(CutTarget().longest), total_length.value_or(CutTarget().total_length),
          piece,  twins, read_edges(no_seam, "no_seam")};
}

Plan plan_of(const std::string& kind) {
  if (kind == "dart") return plan_darts;
  if (kind == "seam") return plan_seams;
  throw FlattenError(ErrorCode::invalid_option,
                     ErrorArguments{{"name", "kind"}, {"value", kind}, {"allowed", "be dart or seam"}});
}

template <class Find>
auto find_now(const Find& find, const py::object& progress) {
  PythonProgress python_progress(progress);
  decltype(find(Progress())) proposals;
  try {
    const py::gil_scoped_release no_gil;
    proposals =
        find([&](const std::string& stage, double fraction) { return python_progress.report(stage, fraction); });
  } catch (...) {
    python_progress.rethrow();
    throw;
  }
  python_progress.rethrow();
  return proposals;
}

template <class Search, class Wanted>
auto search_of(Search search, const py::object& vertices, const py::object& faces, const py::object& seams,
               const py::object& wires, const py::object& options, const py::object& eases, Wanted wanted) {
  return [search, input = read_input(vertices, faces, seams, wires, eases), checked_options = read_options(options),
          wanted = std::move(wanted)](const Progress& progress) {
    return search(input, checked_options, wanted, progress);
  };
}

std::vector<DartProposal> run_darts(const py::object& vertices, const py::object& faces, const py::object& seams,
                                    const py::object& wires, const py::object& options, const py::object& eases,
                                    std::optional<int> piece, int count, std::optional<double> strain,
                                    std::optional<double> longest, const py::object& no_seam, bool smooth,
                                    const py::object& no_crossing, const py::object& progress) {
  const CutOptions cut_options = read_cut_options(piece, count, strain, longest, no_seam, smooth, no_crossing);
  return find_now(search_of(propose_darts, vertices, faces, seams, wires, options, eases, cut_options), progress);
}

std::unique_ptr<Job> start_darts(const py::object& vertices, const py::object& faces, const py::object& seams,
                                 const py::object& wires, const py::object& options, const py::object& eases,
                                 std::optional<int> piece, int count, std::optional<double> strain,
                                 std::optional<double> longest, const py::object& no_seam, bool smooth,
                                 const py::object& no_crossing) {
  const CutOptions cut_options = read_cut_options(piece, count, strain, longest, no_seam, smooth, no_crossing);
  return std::make_unique<Job>(
      work_that(search_of(propose_darts, vertices, faces, seams, wires, options, eases, cut_options)));
}

std::vector<DartProposal> run_seams(const py::object& vertices, const py::object& faces, const py::object& seams,
                                    const py::object& wires, const py::object& options, const py::object& eases,
                                    std::optional<int> piece, int count, std::optional<double> strain,
                                    std::optional<double> longest, const py::object& no_seam, bool smooth,
                                    const py::object& no_crossing, double narrowest, const py::object& progress) {
  CutOptions cut_options = read_cut_options(piece, count, strain, longest, no_seam, smooth, no_crossing);
  cut_options.narrowest = narrowest;
  return find_now(search_of(propose_seams, vertices, faces, seams, wires, options, eases, cut_options), progress);
}

std::unique_ptr<Job> start_seams(const py::object& vertices, const py::object& faces, const py::object& seams,
                                 const py::object& wires, const py::object& options, const py::object& eases,
                                 std::optional<int> piece, int count, std::optional<double> strain,
                                 std::optional<double> longest, const py::object& no_seam, bool smooth,
                                 const py::object& no_crossing, double narrowest) {
  CutOptions cut_options = read_cut_options(piece, count, strain, longest, no_seam, smooth, no_crossing);
  cut_options.narrowest = narrowest;
  return std::make_unique<Job>(
      work_that(search_of(propose_seams, vertices, faces, seams, wires, options, eases, cut_options)));
}

std::vector<DartProposal> run_plan(const py::object& vertices, const py::object& faces, const py::object& seams,
                                   const py::object& wires, const py::object& options, const py::object& eases,
                                   const std::string& kind, double strain, int most, std::optional<double> longest,
                                   std::optional<double> total_length, std::optional<int> piece, bool twins,
                                   const py::object& no_seam, const py::object& progress) {
  const CutTarget target = read_cut_target(strain, most, longest, total_length, piece, twins, no_seam);
  return find_now(search_of(plan_of(kind), vertices, faces, seams, wires, options, eases, target), progress);
}

std::unique_ptr<Job> start_plan(const py::object& vertices, const py::object& faces, const py::object& seams,
                                const py::object& wires, const py::object& options, const py::object& eases,
                                const std::string& kind, double strain, int most, std::optional<double> longest,
                                std::optional<double> total_length, std::optional<int> piece, bool twins,
                                const py::object& no_seam) {
  const CutTarget target = read_cut_target(strain, most, longest, total_length, piece, twins, no_seam);
  return std::make_unique<Job>(
      work_that(search_of(plan_of(kind), vertices, faces, seams, wires, options, eases, target)));
}

SeamProposal run_simplify(const py::object& vertices, const py::object& faces, const py::object& seams,
                          const py::object& wires, const py::object& options, const py::object& eases, double strain,
                          const py::object& progress) {
  return find_now(search_of(simplify_seams, vertices, faces, seams, wires, options, eases, strain), progress);
}

std::unique_ptr<Job> start_simplify(const py::object& vertices, const py::object& faces, const py::object& seams,
                                    const py::object& wires, const py::object& options, const py::object& eases,
                                    double strain) {
  return std::make_unique<Job>(
      work_that(search_of(simplify_seams, vertices, faces, seams, wires, options, eases, strain)));
}

template <class Function, class... Own>
void define(py::module_& module, const char* name, Function function, const char* doc, const Own&... own) {
  module.def(name, function, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"), py::kw_only(),
             py::arg("seams") = py::none(), py::arg("wires") = py::tuple(), py::arg("options") = py::none(),
             py::arg("eases") = py::tuple(), own..., doc);
}

template <class Function, class... More>
void define_proposals(py::module_& module, const char* name, Function function, const char* doc, const More&... more) {
  define(module, name, function, doc, py::arg("piece") = py::none(), py::arg("count") = CutOptions().count,
         py::arg("strain") = py::none(), py::arg("longest") = py::none(), py::arg("no_seam") = py::none(), more...);
}

template <class Function, class... More>
void define_plan(py::module_& module, const char* name, Function function, const char* doc, const More&... more) {
  const CutTarget target;
  define(module, name, function, doc, py::arg("kind") = "dart", py::arg("strain") = target.strain,
         py::arg("most") = target.most, py::arg("longest") = py::none(), py::arg("total_length") = py::none(),
         py::arg("piece") = py::none(), py::arg("twins") = target.twins, py::arg("no_seam") = py::none(), more...);
}

template <class Function, class... More>
void define_simplify(py::module_& module, const char* name, Function function, const char* doc, const More&... more) {
  module.def(name, function, py::call_guard<RunningCall>(), py::arg("vertices"), py::arg("faces"), py::kw_only(),
             py::arg("seams"), py::arg("wires") = py::tuple(), py::arg("options") = py::none(),
             py::arg("eases") = py::tuple(), py::arg("strain") = 0.05, more..., doc);
}

}  // namespace

void bind_propose(py::module_& module) {
  Record<DartProposal>(module, "DartProposal")
      .field("piece", &DartProposal::piece)
      .field("edges", &DartProposal::edges)
      .field("paths", &DartProposal::paths)
      .field("length", &DartProposal::length)
      .field("num_pieces", &DartProposal::num_pieces)
      .field("energy", &DartProposal::energy)
      .field("energy_before", &DartProposal::energy_before)
      .field("strain", &DartProposal::strain)
      .field("strain_before", &DartProposal::strain_before)
      .field("twin", &DartProposal::twin)
      .field("energy_with_twin", &DartProposal::energy_with_twin)
      .field("strain_with_twin", &DartProposal::strain_with_twin)
      .field("strain_left", &DartProposal::strain_left)
      .picklable();
  Record<SeamProposal>(module, "SeamProposal")
      .field("edges", &SeamProposal::edges)
      .field("opened", &SeamProposal::opened)
      .field("paths", &SeamProposal::paths)
      .field("length", &SeamProposal::length)
      .field("length_before", &SeamProposal::length_before)
      .field("num_pieces", &SeamProposal::num_pieces)
      .field("num_pieces_before", &SeamProposal::num_pieces_before)
      .field("energy", &SeamProposal::energy)
      .field("energy_before", &SeamProposal::energy_before)
      .field("strain", &SeamProposal::strain)
      .field("strain_before", &SeamProposal::strain_before)
      .field("was_stopped", &SeamProposal::was_stopped)
      .picklable();
  const py::arg_v progress = py::arg("progress") = py::none(), smooth = py::arg("smooth") = false,
                  no_crossing = py::arg("no_crossing") = py::none(),
                  narrowest = py::arg("narrowest") = CutOptions().narrowest;
  define_proposals(module, "propose_darts", &run_darts, kDartsDoc, smooth, no_crossing, progress);
  define_proposals(module, "propose_seams", &run_seams, kSeamsDoc, smooth, no_crossing, narrowest, progress);
  define_plan(module, "plan_cuts", &run_plan, kPlanDoc, progress);
  define_simplify(module, "simplify_seams", &run_simplify, kSimplifyDoc, progress);
  define_proposals(module, "start_darts", &start_darts, kStartDartsDoc, smooth, no_crossing);
  define_proposals(module, "start_seams", &start_seams, kStartSeamsDoc, smooth, no_crossing, narrowest);
  define_plan(module, "start_plan", &start_plan, kStartPlanDoc);
  define_simplify(module, "start_simplify", &start_simplify, kStartSimplifyDoc);
}

}  // namespace wirewarp::bindings
