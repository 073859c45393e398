// SPDX-License-Identifier: GPL-3.0-or-later
// What flatten() and measure() return, field by field as in wirewarp/result.h.
#include <algorithm>

#include "bind.h"
#include "enums.h"
#include "errors.h"
#include "record.h"
#include "wirewarp/result.h"

namespace wirewarp::bindings {
namespace {

template <class Value>
py::object tuple_of(const std::vector<Value>& values) {
  return py::tuple(py::cast(values));
}

/// By piece, as long as that lives: its error is one object however often it is asked for.
py::object error_or_none(const Piece& piece, py::handle owner, const py::object& errors) {
  if (!piece.error) return py::none();
  if (!errors.contains(owner)) errors[owner] = to_python_error(*piece.error);
  return errors[owner];
}

py::dict run_report(const FlattenResult& result) {
  const auto failed = std::count_if(result.pieces.begin(), result.pieces.end(),
                                    [](const Piece& piece) { return piece.error.has_value(); });
  py::dict report;
  report["method"] = result.method;
  report["pieces"] = result.pieces.size();
  report["failed_pieces"] = failed;
  report["reused_pieces"] = result.reused_pieces;
  report["faces"] = result.corner_uv.rows();
  report["seconds"] = result.seconds;
  return report;
}

/// What run_report() says that the other fields do not.
void read_run_report(FlattenResult& result, py::handle report) {
  result.method = report["method"].cast<std::string>();
  result.reused_pieces = report["reused_pieces"].cast<int>();
  result.seconds = report["seconds"].cast<std::map<std::string, double>>();
}

void bind_lengths(py::module_& module) {
  Record<WireReport>(module, "WireReport", "Length of one part of a wire in one piece, or of a whole wire.")
      .field("name", &WireReport::name, "The wire's name.")
      .field("wire_index", &WireReport::wire_index, "Index into the wires that were passed.")
      .field("part", &WireReport::part, "Counted along the wire; -1: the whole wire.")
      .field(
          "kind", [](const WireReport& wire, py::handle) { return py::str(name_of(wire.kind, kWireKinds)); },
          [](WireReport& wire, py::handle kind) { wire.kind = value_of(py::str(kind), kWireKinds); },
          "'boundary', 'rigid', 'elastic' or 'super_elastic'.")
      .field("tolerance", &WireReport::tolerance, "Dimensionless; 0 on the boundary.")
      .field("length_3d", &WireReport::length_3d, "Scene units.")
      .field("length_2d", &WireReport::length_2d, "Scene units; NaN without a layout.")
      .field("variation", &WireReport::variation, "h: the lengths aimed at are (1 + h) times the 3D ones.")
      .field("max_edge_error", &WireReport::max_edge_error, "Largest |l2 - (1 + h) l| / l of its edges.")
      .field("vertices", &WireReport::vertices, "(n,) input vertices in order; a closed wire repeats its first.")
      .picklable();

  Record<HelperWire>(module, "HelperWire", "A free wire that the method added; it runs across faces.")
      .field("length_3d", &HelperWire::length_3d, "Scene units.")
      .field("length_2d", &HelperWire::length_2d, "Scene units.")
      .field("variation", &HelperWire::variation, "h: the flat length is (1 + h) times the 3D one.")
      .field("points_3d", &HelperWire::points_3d, "(n, 3) on the surface, in order along the wire.")
      .field("points_2d", &HelperWire::points_2d, "(n, 2) in the piece.")
      .picklable();

  Record<BoundaryReport>(module, "BoundaryReport", "One chain of a piece's outline between junctions.")
      .field("vertices", &BoundaryReport::vertices, "(n,) input vertices in order, the piece on the left.")
      .field("length_3d", &BoundaryReport::length_3d, "Scene units.")
      .field("length_2d", &BoundaryReport::length_2d, "Scene units; NaN without a layout.")
      .field("max_edge_error", &BoundaryReport::max_edge_error, "Largest |l2 - l| / l of its edges.")
      .field("seam", &BoundaryReport::seam, "Index into FlattenResult.seams, None where it is no seam.")
      .picklable();

  Record<SeamReport>(module, "SeamReport", "One chain of seam edges between junctions, all its sides.")
      .field(
          "pieces", [](const SeamReport& seam, py::handle) { return tuple_of(seam.pieces); },
          [](SeamReport& seam, py::handle pieces) { seam.pieces = pieces.cast<std::vector<int>>(); },
          "The piece of each side; the same piece twice along a dart.")
      .field("edges", &SeamReport::edges, "(k, 2) input vertices, in order along the chain.")
      .field("length_3d", &SeamReport::length_3d, "Scene units.")
      .field(
          "length_2d", [](const SeamReport& seam, py::handle) { return tuple_of(seam.length_2d); },
          [](SeamReport& seam, py::handle lengths) { seam.length_2d = lengths.cast<std::vector<double>>(); },
          "Scene units, one per side; NaN where the piece has no layout.")
      .field("mismatch", &SeamReport::mismatch,
             "Largest difference between two sides that have a layout; NaN if fewer than two have one.")
      .picklable();
}

void bind_piece_parts(py::module_& module) {
  Record<Metrics>(module, "Metrics",
                  "Distortion of a piece, on the input's own triangles and edges; without a layout only area_3d is "
                  "known, the other numbers are NaN.")
      .field("arap_energy", &Metrics::arap_energy, "As-rigid-as-possible energy over the 3D area.")
      .field("face_arap", &Metrics::face_arap, "(q,); sums to arap_energy * area_3d.")
      .field("face_aspect_ratio", &Metrics::face_aspect_ratio,
             "(q,) max(s1, 1 / s2) of the singular values of each face's map; 1 where nothing is stretched.")
      .field("cloth_energy", &Metrics::cloth_energy, "Of Options.cloth over the 3D area; NaN without a cloth.")
      .field("face_weft_strain", &Metrics::face_weft_strain,
             "(q,) of threads along x, from flat to worn: 0.1 is 10 % longer.")
      .field("face_warp_strain", &Metrics::face_warp_strain, "(q,) the same along y.")
      .field("face_shear_angle", &Metrics::face_shear_angle,
             "(q,) how far worn threads leave the right angle, radians; positive where x and y come nearer.")
      .field("wire_edges", &Metrics::wire_edges, "(e, 2) input vertices: wires first, then the boundary.")
      .field("edge_length_variation", &Metrics::edge_length_variation, "(e,) |l2 - l| / l of wire_edges.")
      .field("flipped_faces", &Metrics::flipped_faces, "Input faces that are turned over.")
      .field("overlapping_faces", &Metrics::overlapping_faces, "Input faces that cover the piece a second time.")
      .field("angle_deviation_rms", &Metrics::angle_deviation_rms, "Of planar minus surface angles, radians.")
      .field("angle_deviation_max", &Metrics::angle_deviation_max, "Radians.")
      .field("area_3d", &Metrics::area_3d, "Square scene units.")
      .field("area_2d", &Metrics::area_2d, "Square scene units.")
      .picklable();

  Record<PieceReport>(module, "PieceReport", "What the solver did for one piece, for one that failed too.")
      .field(
          "termination",
          [](const PieceReport& report, py::handle) { return py::str(name_of(report.termination, kTerminations)); },
          [](PieceReport& report, py::handle name) { report.termination = value_of(py::str(name), kTerminations); },
          "'converged', 'stalled' (short of the method's criterion: see warnings), 'failed', 'cancelled' or "
          "'measured'.")
      .field("message", &PieceReport::message, "One sentence.")
      .field("warnings", &PieceReport::warnings, "Sentences.")
      .field("start", &PieceReport::start,
             "Where the refined method began: 'unfolded', 'sewn' (slits sewn up first), 'coarse', 'free' (ARAP without "
             "wires), 'wires' (flattened alone first), 'injective' (nothing turned over on the way) or 'relaxed' (the "
             "least broken lengths). Empty where no shape was found, and for other "
             "methods.")
      .field("inner_solves", &PieceReport::inner_solves, "Factorizations of the inner problem.")
      .field("outer_iterations", &PieceReport::outer_iterations, "Steps over the wires' lengths.")
      .field("gradient_evaluations", &PieceReport::gradient_evaluations, "Gradients with respect to them.")
      .field("factorizations", &PieceReport::factorizations,
             "Of the placement of the vertices between wires and the free flattening; refined: of all its Newton "
             "systems, as Options.max_factorizations counts them.")
      .field("constraint_residual", &PieceReport::constraint_residual,
             "Largest gap of a wire loop over its length; refined: largest error of an edge's length over that length "
             "plus 1e-5 of the root of the piece's area. NaN where no shape was found, and for measured pieces.")
      .field("projected_gradient", &PieceReport::projected_gradient,
             "Of the inner problem at the end, where a node of mean length weighs 1; NaN with inner=\"least-norm\" and "
             "refined.")
      .field("objective", &PieceReport::objective,
             "What the refined method minimizes: arap_energy plus the angle term, plus a barrier where triangles are "
             "about to turn over; NaN for other methods.")
      .field("seconds", &PieceReport::seconds, "Per stage.")
      .picklable();
}

}  // namespace

void bind_results(py::module_& module) {
  bind_lengths(module);
  bind_piece_parts(module);

  Record<Piece>(module, "Piece", "One flat piece and everything measured on it.")
      .field("vertices", &Piece::vertices, "(p, 2) scene units; NaN without a layout.")
      .field("faces", &Piece::faces, "(q, 3) indices into this piece's vertices.")
      .field("source_vertex", &Piece::source_vertex, "(p,) input vertices.")
      .field("source_face", &Piece::source_face, "(q,) input faces.")
      .field("wires", &Piece::wires, "One WireReport per part of a wire in this piece.")
      .field("boundaries", &Piece::boundaries, "One BoundaryReport per stretch of the outline.")
      .field("helper_wires", &Piece::helper_wires, "The wires that the method added, one HelperWire each.")
      .field("metrics", &Piece::metrics, "Distortion.")
      .field("report", &Piece::report, "What the solver did.")
      .field(
          "error",
          [errors = py::module_::import("weakref").attr("WeakKeyDictionary")()](const Piece& piece, py::handle owner) {
            return error_or_none(piece, owner, errors);
          },
          [](Piece& piece, py::handle error) {
            if (!error.is_none()) piece.error = from_python_error(error);
          },
          "None: every promise is kept. Otherwise the FlattenError that says which is not.")
      .picklable();

  Record<FlattenResult>(module, "FlattenResult", "All pieces of a flattening and how they fit together.")
      .field("pieces", &FlattenResult::pieces, "One Piece per region between seams.")
      .field("corner_uv", &FlattenResult::corner_uv,
             "(m, 3, 2) flat position of each corner of each input face, scene units; NaN without a layout.")
      .field("seams", &FlattenResult::seams, "One SeamReport per chain of seam edges.")
      .field("wires", &FlattenResult::wires, "One WireReport per whole wire.")
      .field(
          "report", [](const FlattenResult& result, py::handle) { return run_report(result); }, &read_run_report,
          "method, numbers of pieces, failed_pieces, reused_pieces (taken from the cache) and faces, and seconds per "
          "stage, summed over pieces that are solved side by side.")
      .picklable();
}

}  // namespace wirewarp::bindings
