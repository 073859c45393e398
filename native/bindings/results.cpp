// SPDX-License-Identifier: GPL-3.0-or-later
// Binds the results of flatten() and measure(), field by field as in wirewarp/result.h.
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

/// Returns the error of a piece, or None. As long as a piece lives, calls return the same error object.
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

/// Reads the entries of run_report() that no other field contains.
void read_run_report(FlattenResult& result, py::handle report) {
  result.method = report["method"].cast<std::string>();
  result.reused_pieces = report["reused_pieces"].cast<int>();
  result.seconds = report["seconds"].cast<std::map<std::string, double>>();
}

void bind_lengths(py::module_& module) {
  Record<WireReport>(module, "WireReport")
      .field("name", &WireReport::name)
      .field("wire_index", &WireReport::wire_index)
      .field("part", &WireReport::part)
      .field("kind", &WireReport::kind, "WireKind", kWireKinds)
      .field("tolerance", &WireReport::tolerance)
      .field("length_3d", &WireReport::length_3d)
      .field("length_2d", &WireReport::length_2d)
      .field("variation", &WireReport::variation)
      .field("max_edge_error", &WireReport::max_edge_error)
      .field("vertices", &WireReport::vertices)
      .picklable();

  Record<HelperWire>(module, "HelperWire")
      .field("length_3d", &HelperWire::length_3d)
      .field("length_2d", &HelperWire::length_2d)
      .field("variation", &HelperWire::variation)
      .field("points_3d", &HelperWire::points_3d)
      .field("points_2d", &HelperWire::points_2d)
      .picklable();

  Record<BoundaryReport>(module, "BoundaryReport")
      .field("vertices", &BoundaryReport::vertices)
      .field("length_3d", &BoundaryReport::length_3d)
      .field("length_2d", &BoundaryReport::length_2d)
      .field("max_edge_error", &BoundaryReport::max_edge_error)
      .field("seam", &BoundaryReport::seam)
      .picklable();

  Record<SeamReport>(module, "SeamReport")
      .field(
          "pieces", [](const SeamReport& seam, py::handle) { return tuple_of(seam.pieces); },
          [](SeamReport& seam, py::handle pieces) { seam.pieces = pieces.cast<std::vector<int>>(); })
      .field("edges", &SeamReport::edges)
      .field("length_3d", &SeamReport::length_3d)
      .field(
          "length_2d", [](const SeamReport& seam, py::handle) { return tuple_of(seam.length_2d); },
          [](SeamReport& seam, py::handle lengths) { seam.length_2d = lengths.cast<std::vector<double>>(); })
      .field("variation", &SeamReport::variation)
      .field(
          "eases", [](const SeamReport& seam, py::handle) { return tuple_of(seam.eases); },
          [](SeamReport& seam, py::handle eases) { seam.eases = eases.cast<std::vector<double>>(); })
      .field("mismatch", &SeamReport::mismatch)
      .picklable();
}

void bind_piece_parts(py::module_& module) {
  Record<Metrics>(module, "Metrics")
      .field("arap_energy", &Metrics::arap_energy)
      .field("face_arap", &Metrics::face_arap)
      .field("face_aspect_ratio", &Metrics::face_aspect_ratio)
      .field("cloth_energy", &Metrics::cloth_energy)
      .field("face_weft_strain", &Metrics::face_weft_strain)
      .field("face_warp_strain", &Metrics::face_warp_strain)
      .field("face_shear_angle", &Metrics::face_shear_angle)
      .field("wire_edges", &Metrics::wire_edges)
      .field("edge_length_variation", &Metrics::edge_length_variation)
      .field("flipped_faces", &Metrics::flipped_faces)
      .field("overlapping_faces", &Metrics::overlapping_faces)
      .field("angle_deviation_rms", &Metrics::angle_deviation_rms)
      .field("angle_deviation_max", &Metrics::angle_deviation_max)
      .field("area_3d", &Metrics::area_3d)
      .field("area_2d", &Metrics::area_2d)
      .picklable();

  Record<PieceReport>(module, "PieceReport")
      .field("termination", &PieceReport::termination, "Termination", kTerminations)
      .field("message", &PieceReport::message)
      .field("warnings", &PieceReport::warnings)
      .field("start", &PieceReport::start)
      .field("inner_solves", &PieceReport::inner_solves)
      .field("outer_iterations", &PieceReport::outer_iterations)
      .field("gradient_evaluations", &PieceReport::gradient_evaluations)
      .field("factorizations", &PieceReport::factorizations)
      .field("constraint_residual", &PieceReport::constraint_residual)
      .field("projected_gradient", &PieceReport::projected_gradient)
      .field("objective", &PieceReport::objective)
      .field("seconds", &PieceReport::seconds)
      .picklable();
}

}  // namespace

void bind_results(py::module_& module) {
  bind_lengths(module);
  bind_piece_parts(module);

  Record<Piece>(module, "Piece")
      .field("vertices", &Piece::vertices)
      .field("faces", &Piece::faces)
      .field("source_vertex", &Piece::source_vertex)
      .field("source_face", &Piece::source_face)
      .field("wires", &Piece::wires)
      .field("boundaries", &Piece::boundaries)
      .field("helper_wires", &Piece::helper_wires)
      .field("metrics", &Piece::metrics)
      .field("report", &Piece::report)
      .field(
          "error",
          [errors = py::module_::import("weakref").attr("WeakKeyDictionary")()](const Piece& piece, py::handle owner) {
            return error_or_none(piece, owner, errors);
          },
          [](Piece& piece, py::handle error) {
            if (!error.is_none()) piece.error = from_python_error(error);
          })
      .picklable();

  Record<FlattenResult>(module, "FlattenResult")
      .field("pieces", &FlattenResult::pieces)
      .field("corner_uv", &FlattenResult::corner_uv)
      .field("seams", &FlattenResult::seams)
      .field("wires", &FlattenResult::wires)
      .field(
          "report", [](const FlattenResult& result, py::handle) { return run_report(result); }, &read_run_report,
          "A dict with method, seconds, and the numbers pieces, failed_pieces, reused_pieces (taken from the cache) "
          "and faces. seconds is a dict with the time of each stage, summed over pieces that are solved in parallel.")
      .picklable();
}

}  // namespace wirewarp::bindings
