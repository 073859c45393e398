// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error_sentence.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/sentence.h"

namespace wirewarp {
namespace {

class Parts {
 public:
  Parts(const ErrorArguments& arguments, const ErrorElements& named) : elements(named), arguments_(arguments) {}

  const ErrorElements& elements;

  template <class T>
  const T& get(const char* name) const {
    return std::get<T>(arguments_.at(name));
  }
  bool has(const char* name) const { return arguments_.count(name) > 0; }
  bool is(const char* name) const { return get<bool>(name); }
  const std::string& text(const char* name) const { return get<std::string>(name); }
  int number(const char* name) const { return get<int>(name); }
  double real(const char* name) const { return get<double>(name); }

  std::string faces() const { return name_elements("face", elements.faces); }
  std::string edges() const { return name_elements("edge", elements.edges); }
  std::string vertices() const { return name_elements("vertex", elements.vertices); }
  std::string seams() const { return such_as_along(elements.proposed_seams); }

  /// Returns text such as "wire 2 (waist)" for the wires in the arguments.
  std::string wires() const { return name_wires(get<std::vector<int>>("wires"), names()); }
  const std::vector<std::string>& names() const { return get<std::vector<std::string>>("wire_names"); }

  /// Returns text such as "the piece around face 3". The error's faces must be the faces of the piece.
  std::string piece() const { return name_piece(elements.faces); }

 private:
  const ErrorArguments& arguments_;
};

std::string chosen(std::size_t count, const char* one, const char* many) { return count == 1 ? one : many; }

std::string wrong_shape(const Parts& parts) {
  if (!parts.has("wanted")) return parts.text("name") + " cannot be read as an array: " + parts.text("found");
  return parts.text("name") + " has the shape " + parts.text("found") + ": it must be " + parts.text("wanted") + ".";
}

std::string wrong_type(const Parts& parts) {
  if (!parts.has("wanted")) return parts.text("name") + " cannot be read as an array: " + parts.text("found");
  return parts.text("name") + " must be " + parts.text("wanted") + ", not " + parts.text("found") + ".";
}

std::string wrong_option(const Parts& parts) {
  return "The option " + parts.text("name") + " is " + parts.text("value") + ": it must " + parts.text("allowed") + ".";
}

std::string empty_mesh(const Parts& parts) {
  return std::string("The mesh has no ") + (parts.number("num_vertices") == 0 ? "vertices" : "faces") +
         ", so there is nothing to flatten: pass at least one triangle.";
}

std::string out_of_range(const Parts& parts) {
  const bool is_int = !parts.has("found");
  const std::string what = is_int ? parts.vertices() : "vertex " + parts.text("found");
  const int last = is_int ? parts.number("num_vertices") - 1 : std::numeric_limits<int>::max();
  const std::string limit = (is_int ? ", but the mesh has vertices 0 to " : ", outside 0 to ") + std::to_string(last);
  const std::string owner = parts.elements.faces.empty() ? parts.text("name") : parts.faces();
  return capitalized(owner) + chosen(std::max<std::size_t>(parts.elements.faces.size(), 1), " names ", " name ") +
         what + limit + ": use indices of this mesh.";
}

std::string loose_faces(const Parts& parts) {
  return "The " + std::to_string(parts.number("num_faces")) + " triangles of the mesh are " +
         std::to_string(parts.number("num_parts")) + " separate parts, such as " + parts.faces() +
         ": merge vertices by distance, so that neighboring faces share their edges.";
}

std::string wire_off_edges(const Parts& parts) {
  return "The " + parts.wires() + " runs along " + parts.edges() +
         chosen(parts.elements.edges.size(), ", which is not an edge", ", which are not edges") +
         " of the mesh: join all consecutive vertices of a wire by edges of the mesh.";
}

std::string edge_in_two_wires(const Parts& parts) {
  const std::vector<int>& wires = parts.get<std::vector<int>>("wires");
  const std::string where = wires.size() == 1 ? parts.wires() + " twice" : "two wires, " + parts.wires();
  return capitalized(parts.edges()) + " is in " + where + ": an edge has one length, so leave it in one wire only.";
}

/// Returns text such as "wire 2 (waist)", or "wire (waist)" if the wire is not part of an input yet.
std::string label_of_wire(const Parts& parts) {
  if (!parts.get<std::vector<int>>("wires").empty()) return parts.wires();
  return parts.names().empty() ? "wire" : "wire (" + parts.names().front() + ")";
}

std::string wire_too_short(const Parts& parts) {
  return "The " + label_of_wire(parts) + " has fewer than two vertices: give it at least one edge.";
}

std::string wrong_tolerance(const Parts& parts) {
  return "The " + label_of_wire(parts) + " has a tolerance of " + shortest(parts.real("tolerance")) +
         ": use 0 (rigid), a positive fraction such as 0.03 (3%), or infinity (free).";
}

std::string wrong_ease(const Parts& parts) {
  const std::string where = parts.elements.edges.empty() ? "" : " along " + parts.edges();
  return (parts.has("wires") ? "The " + label_of_wire(parts) + " has an ease of " : "An ease" + where + " is ") +
         shortest(parts.real("ease")) + ": use a finite fraction above -1, such as 0.05 (5% longer).";
}

std::string ease_without_side(const Parts& parts) {
  return "An ease names " + parts.edges() +
         ", but no seam or outline has a side there. Pass the vertices of each edge in the order of the triangle on "
         "that side.";
}

std::string side_in_two_eases(const Parts& parts) {
  return "The sides along " + parts.edges() + " are in two eases: a side has one length, so leave it in one ease only.";
}

std::string inconsistent_orientation(const Parts& parts) {
  const bool is_one_sided = parts.is("is_one_sided");
  return "The faces on the two sides of " + parts.edges() + " point to opposite sides of the surface" +
         (is_one_sided ? ". The surface is one-sided like a Mobius strip: mark these edges as seams."
                       : ": recalculate the normals, or mark these edges as seams.");
}

std::string handles(const Parts& parts) {
  const int count = parts.number("num_handles");
  return introduce_piece(parts.elements.faces) + " has " + std::to_string(count) +
         (count == 1 ? " handle" : " handles") + " like a torus: mark seams that cut every handle" + parts.seams() +
         ".";
}

std::string fault_of_outlines(std::size_t num_loops) {
  if (num_loops == 1) return "cannot be flattened: mark another seam";
  if (num_loops == 2) return "is a tube: mark a seam from one opening to the other";
  return "cannot be flattened: mark seams between its " + std::to_string(num_loops) + " openings";
}

std::string boundary_too_short(const Parts& parts) {
  const std::vector<double>& lengths = parts.get<std::vector<double>>("lengths");
  std::vector<std::string> loops;
  for (std::size_t i = 0; i < std::min(lengths.size(), kMostNamed); ++i) {
    loops.push_back(rounded(lengths[i]) + " units long at vertex " + std::to_string(parts.elements.vertices[i]));
  }
  return introduce_piece(parts.elements.faces) + " " + fault_of_outlines(lengths.size()) + parts.seams() + ". Its " +
         chosen(lengths.size(), "outline, ", "outlines, ") + listed(loops, lengths.size()) +
         ", can enclose no more than " + percent(parts.real("share")) + " of its area in the plane.";
}

/// Returns text such as "with a tolerance of 0.3% to 1.2% on wires 3 and 4 and with wire 7 (waist) free".
std::string with_tolerances(const Parts& parts) {
  const std::vector<std::string>& names = parts.names();
  std::vector<int> elastic, free;
  std::vector<std::string> elastic_names, free_names;
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto [wire, tolerance] = parts.elements.proposed_tolerances[i];
    const bool is_free = std::isinf(tolerance);
    (is_free ? free : elastic).push_back(wire);
    (is_free ? free_names : elastic_names).push_back(names[i]);
    if (is_free) continue;
    least = std::min(least, tolerance);
    most = std::max(most, tolerance);
  }
  std::string text;
  if (!elastic.empty()) {
    text = "with a tolerance of " + (least < most ? percent(least) + " to " : "") + percent(most) + " on " +
           name_wires(elastic, elastic_names);
  }
  if (free.empty()) return text;
  return text + (text.empty() ? "" : " and ") + "with " + name_wires(free, free_names) + " free";
}

std::string infeasible_lengths(const Parts& parts) {
  const std::string& reason = parts.text("reason");
  if (reason == "method") {
    return "The wires of " + parts.piece() +
           " have no flat shape with WireWarping++: use the refined method, which keeps them within their "
           "tolerances.";
  }
  std::string remedy;
  if (reason == "wires") {
    remedy =
        "flatten the piece " + with_tolerances(parts) + (parts.is("is_refined") ? "." : ", by the refined method.");
    if (!parts.has("max_factorizations")) {
      return "Not all wires of " + parts.piece() + " can keep their lengths in the plane: " + remedy;
    }
  } else if (reason == "stretch") {
    remedy =
        (parts.is("is_good_unstretched") ? "use less stretch, or mark a seam" : "mark a seam") + parts.seams() + ".";
  } else {
    remedy = "mark a seam" + parts.seams() + ".";
  }
  const std::string none = "No flat shape of " + parts.piece();
  if (parts.has("max_factorizations")) {
    return none + " with all lengths was found within max_factorizations = " +
           std::to_string(parts.number("max_factorizations")) + ": raise it, or " + remedy;
  }
  if (reason == "stretch") return none + " was found with the lengths that the fabric's stretch requires: " + remedy;
  return none + " was found that keeps the length of its outline" +
         (parts.is("has_wires") ? ", even with its wires free: " : ": ") + remedy;
}

std::string not_solvable(const Parts& parts) {
  const std::string piece = "the piece around face " + std::to_string(parts.number("face"));
  const std::string& reason = parts.text("reason");
  if (reason == "helper_wires") {
    return "Rounding errors leave no room for helper wires between " + parts.edges() + " of " + piece +
           ". Remesh the piece, or use the refined method, which needs no helper wires.";
  }
  if (reason == "sizes") {
    return "WireWarp cannot calculate the shape of " + piece +
           ", because its faces differ too much in size. Merge very close vertices of " + parts.faces() +
           ", or remesh the piece.";
  }
  return "WireWarp cannot calculate the shape of " + piece + ". Remesh it, or cut it in two with a seam.";
}

std::string counted(int count, const std::string& noun) {
  return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Returns text such as ", has 3 flipped faces and overlaps itself at 1 face", for the faults that the error's code
/// does not name.
std::string also(int num_flipped, int num_overlapping) {
  const std::string flips = "has " + counted(num_flipped, "flipped face");
  const std::string overlaps = "overlaps itself at " + counted(num_overlapping, "face");
  if (num_flipped > 0 && num_overlapping > 0) return ", " + flips + " and " + overlaps;
  return num_flipped > 0 ? ", and " + flips : num_overlapping > 0 ? ", and " + overlaps : "";
}

std::string lengths_not_kept(const Parts& parts) {
  const std::string line = parts.get<std::vector<int>>("wires").empty() ? "the outline" : parts.wires();
  const std::string fault = parts.has("tolerance")
                                ? "The piece does not keep the length of " + line + " within its tolerance of " +
                                      percent(parts.real("tolerance"))
                                : "The piece does not keep the length of " + parts.edges() + " (the worst, on " + line +
                                      ", is " + percent(parts.real("difference")) + " too " +
                                      (parts.real("difference") > 0 ? "long)" : "short)");
  return fault + also(parts.number("num_flipped"), parts.number("num_overlapping")) +
         ". Add a seam where the piece curves most" +
         (parts.is("has_wires") ? ", or give its wires more tolerance." : ".");
}

std::string mark_seams_or(const Parts& parts) {
  return parts.elements.proposed_seams.empty() ? ": " : ": mark seams" + parts.seams() + ", or ";
}

std::string flipped_faces(const Parts& parts) {
  return "The piece is flipped at " + parts.faces() + also(0, parts.number("num_overlapping")) + mark_seams_or(parts) +
         "add a seam or a dart there" +
         (parts.is("has_wires") ? ", or remove a nearby wire or give it more tolerance." : ".");
}

std::string no_proposal(const Parts& parts) {
  const std::string piece = introduce_piece(parts.elements.faces);
  const std::string& reason = parts.text("reason");
  if (reason == "unfolded") return piece + " is flat enough: it is unfolded without distortion.";
  if (reason == "strain") {
    return piece + " is flat enough: its stretch is " + percent(parts.real("strain")) + ", and " +
           percent(parts.real("limit")) + " is accepted.";
  }
  if (reason == "too_long") {
    return piece + " can be flattened with seams of " + rounded(parts.real("length")) + " units, but no more than " +
           rounded(parts.real("limit")) + " units are allowed.";
  }
  if (reason == "no_gain") {
    const std::string& kind = parts.text("kind");
    return piece + " gains nothing from a " + kind + ": no " + kind + " that was tried lowers the stretch of " +
           percent(parts.real("strain")) + " that the piece needs. " +
           (kind == "dart" ? "Divide it by a seam" : "Move one of its seams to the place where the piece curves most") +
           (parts.get<std::vector<int>>("wires").empty() ? "." : ", or give its wires more tolerance.");
  }
  if (reason == "too_strained") {
    return piece + " needs fabric that stretches by over 100% with every set of seams that was found. Mark a first " +
           "seam by hand.";
  }
  const std::string along = parts.is("is_restricted") ? "edges that may have a seam" : "edges";
  if (reason == "no_set") {
    return "No set of seams along " + along + " was found that flattens all of " + name_piece(parts.elements.faces) +
           ". Mark a first seam by hand.";
  }
  const bool is_dart = parts.text("kind") == "dart";
  return piece + " has no room for a " + parts.text("kind") + ". No line along " + along + " leads " +
         (is_dart ? "from its outline to a point inside" : "across it") +
         " without meeting a wire or the outline on the way. Subdivide the piece, or mark a seam by hand.";
}

}  // namespace

std::string error_sentence(ErrorCode code, const ErrorArguments& arguments, const ErrorElements& elements) {
  const Parts parts(arguments, elements);
  switch (code) {
    case ErrorCode::invalid_shape:
      return wrong_shape(parts);
    case ErrorCode::invalid_type:
      return wrong_type(parts);
    case ErrorCode::invalid_option:
      return wrong_option(parts);
    case ErrorCode::empty_mesh:
      return empty_mesh(parts);
    case ErrorCode::vertex_out_of_range:
      return out_of_range(parts);
    case ErrorCode::non_finite_coordinates:
      return "The coordinates of " + parts.vertices() +
             " are not all finite and below 1e60 in magnitude: move these vertices back or delete them.";
    case ErrorCode::loose_faces:
      return loose_faces(parts);
    case ErrorCode::seam_not_an_edge:
      return "Seam " + parts.edges() + chosen(elements.edges.size(), " is not an edge", " are not edges") +
             " of the mesh: mark seams on existing edges.";
    case ErrorCode::wire_not_an_edge:
      return wire_off_edges(parts);
    case ErrorCode::wire_too_short:
      return wire_too_short(parts);
    case ErrorCode::edge_in_two_wires:
      return edge_in_two_wires(parts);
    case ErrorCode::invalid_tolerance:
      return wrong_tolerance(parts);
    case ErrorCode::invalid_ease:
      return wrong_ease(parts);
    case ErrorCode::ease_without_side:
      return ease_without_side(parts);
    case ErrorCode::side_in_two_eases:
      return side_in_two_eases(parts);
    case ErrorCode::repeated_vertex_in_face:
      return capitalized(parts.faces()) + chosen(elements.faces.size(), " uses", " use") +
             " the same vertex twice: delete such faces.";
    case ErrorCode::repeated_face:
      return capitalized(parts.faces()) + chosen(elements.faces.size(), " has", " have") +
             " the vertices of another face: delete the copies.";
    case ErrorCode::zero_area_face:
      return capitalized(parts.faces()) + chosen(elements.faces.size(), " has", " have") +
             " no area: dissolve such faces or move their vertices apart.";
    case ErrorCode::non_manifold_edge:
      return "Three or more faces meet at " + parts.edges() + ": mark such edges as seams or delete the extra faces.";
    case ErrorCode::non_manifold_vertex:
      return "The piece touches itself at " + parts.vertices() +
             " without sharing an edge there: split such vertices, or join the parts along an edge.";
    case ErrorCode::inconsistent_orientation:
      return inconsistent_orientation(parts);
    case ErrorCode::closed_chart:
      return introduce_piece(elements.faces) + " is closed: mark a seam that opens it" + parts.seams() + ".";
    case ErrorCode::handles:
      return handles(parts);
    case ErrorCode::boundary_too_short:
      return boundary_too_short(parts);
    case ErrorCode::infeasible_lengths:
      return infeasible_lengths(parts);
    case ErrorCode::not_solvable:
      return not_solvable(parts);
    case ErrorCode::cancelled:
      return "Canceled before the piece was flat: run it again.";
    case ErrorCode::uv_discontinuous:
      return "The flattening is torn along " + parts.edges() + " without a seam: pass these edges as seams.";
    case ErrorCode::no_layout:
      return "The coordinates at the corners of " + parts.faces() +
             " are not all finite and below 1e60 in magnitude: flatten the whole piece.";
    case ErrorCode::lengths_not_kept:
      return lengths_not_kept(parts);
    case ErrorCode::flipped_faces:
      return flipped_faces(parts);
    case ErrorCode::overlapping_faces:
      return "The piece overlaps itself at " + parts.faces() + mark_seams_or(parts) +
             "cut it in two with a seam, or add a dart there.";
    case ErrorCode::no_proposal:
      return no_proposal(parts);
  }
  return {};
}

FlattenError::FlattenError(ErrorCode error_code, ErrorArguments details, ErrorElements named, bool with_layout)
    : std::runtime_error(error_sentence(error_code, details, named)),
      code(error_code),
      arguments(std::move(details)),
      elements(std::move(named)),
      has_layout(with_layout) {}

}  // namespace wirewarp
