// SPDX-License-Identifier: GPL-3.0-or-later
// The documented meaning, remedy and arguments of every error code.
#include "wirewarp/error.h"

#include <cstddef>

namespace wirewarp {
namespace {

struct Entry {
  ErrorCode code;
  ErrorDescription description;
};

// Several codes share these arguments.
#define WIREWARP_NAMED_WIRES \
  "wires: indices of the wires; wire_names: their names, an empty string for a wire without a name"
#define WIREWARP_WRONG_ARRAY                                                                                        \
  "name: name of the array or value; wanted: what it must be, missing if numpy cannot read it; found: what it is, " \
  "or numpy's message if numpy cannot read it"

constexpr Entry kEntries[] = {
    {ErrorCode::invalid_shape,
     {"invalid_shape", "An array has the wrong number of rows or columns.",
      "Pass vertices as n by 3, faces as m by 3, seams as k by 2 and corner coordinates as m by 3 by 2.",
      WIREWARP_WRONG_ARRAY}},
    {ErrorCode::invalid_type,
     {"invalid_type", "A value has the wrong type.",
      "Pass numbers for coordinates, whole numbers for indices and Wire objects for wires.", WIREWARP_WRONG_ARRAY}},
    {ErrorCode::invalid_option,
     {"invalid_option", "The value of an option is unknown or out of range.", "Use a value that the message allows.",
      "name: the option; value: its value as text; allowed: the words after \"must\" in the message; wires: indices "
      "of the wires that do not fit the option, if there are any; wire_names: their names"}},
    {ErrorCode::empty_mesh,
     {"empty_mesh", "The mesh has no vertices or no faces, so there is nothing to flatten.",
      "Pass a mesh with at least one triangle.",
      "num_vertices: number of vertices of the mesh; num_faces: number of its triangles"}},
    {ErrorCode::vertex_out_of_range,
     {"vertex_out_of_range", "A face, seam or wire names a vertex that the mesh does not have.",
      "Number the vertices from 0 to one less than their count.",
      "name: the wire or list that names the vertex; num_vertices: number of vertices of the mesh; found: the index as "
      "text, instead of num_vertices, if it exceeds 32 bits"}},
    {ErrorCode::non_finite_coordinates,
     {"non_finite_coordinates", "A vertex has a coordinate that is not finite, or 1e60 or more in magnitude.",
      "Move the named vertices back into the scene or delete them.",
      "limit: coordinates must be below this magnitude"}},
    {ErrorCode::loose_faces,
     {"loose_faces", "More than a thousand faces share almost no edges, as in a file that lists every face separately.",
      "Merge vertices by distance, so that neighboring faces share their edges.",
      "num_faces: number of triangles of the mesh; num_parts: number of parts that share no edge"}},
    {ErrorCode::seam_not_an_edge,
     {"seam_not_an_edge", "A seam joins two vertices that no edge of the mesh joins.",
      "Mark seams along edges of the mesh, and mark them again after editing the mesh.", ""}},
    {ErrorCode::wire_not_an_edge,
     {"wire_not_an_edge", "Two consecutive vertices of a wire are not joined by an edge of the mesh.",
      "Use wires that run along edges of the mesh, and mark them again after editing the mesh.", WIREWARP_NAMED_WIRES}},
    {ErrorCode::wire_too_short,
     {"wire_too_short", "A wire has fewer than two vertices, so it has no length.",
      "Give the wire at least one edge, or remove it.", WIREWARP_NAMED_WIRES}},
    {ErrorCode::edge_in_two_wires,
     {"edge_in_two_wires", "An edge is in two wires, or twice in one wire.",
      "Clear the shared edges from all wires but one.", WIREWARP_NAMED_WIRES}},
    {ErrorCode::invalid_tolerance,
     {"invalid_tolerance", "A wire's tolerance is negative or not a number.",
      "Use 0 for a rigid wire, a fraction such as 0.03 for an elastic wire, or infinity for a free wire.",
      WIREWARP_NAMED_WIRES "; tolerance: the tolerance"}},
    {ErrorCode::invalid_ease,
     {"invalid_ease", "An ease is not a finite number, or is -1 or less, so that no length would remain.",
      "Use a fraction above -1, such as 0.05 for a side that is 5% longer.",
      WIREWARP_NAMED_WIRES ", both missing for the ease of a side; ease: the ease"}},
    {ErrorCode::ease_without_side,
     {"ease_without_side", "An ease names two vertices that are not a side of a seam or of the outline.",
      "Name each side by its edge, with the vertices in the order of the triangle on that side.", ""}},
    {ErrorCode::side_in_two_eases,
     {"side_in_two_eases", "A side of an edge is in two eases, or twice in one ease.",
      "Put each side in only one ease.", ""}},
    {ErrorCode::repeated_vertex_in_face,
     {"repeated_vertex_in_face", "A face uses the same vertex twice.", "Delete the named faces.", ""}},
    {ErrorCode::repeated_face,
     {"repeated_face", "Two faces have the same three vertices.", "Delete all but one of the named faces.", ""}},
    {ErrorCode::zero_area_face,
     {"zero_area_face", "A face has no area: its vertices are on a line or at one point.",
      "Dissolve the named faces or move their vertices apart.", ""}},
    {ErrorCode::non_manifold_edge,
     {"non_manifold_edge", "Three or more faces meet at an edge that is not a seam.",
      "Mark the named edges as seams, or delete the extra faces.", ""}},
    {ErrorCode::non_manifold_vertex,
     {"non_manifold_vertex", "Parts of a piece touch in a single vertex, with no edge between them.",
      "Split the named vertices, or join the parts along an edge.", ""}},
    {ErrorCode::inconsistent_orientation,
     {"inconsistent_orientation", "Neighboring faces point to opposite sides of the surface.",
      "Recalculate the normals, so that all faces of the piece point to the same side. If the piece is one-sided like "
      "a Mobius strip, mark the named edges as seams.",
      "is_one_sided: whether the piece is one-sided, so that only a seam helps"}},
    {ErrorCode::closed_chart,
     {"closed_chart", "A piece has no outline: it is closed like a ball.",
      "Mark a seam along which the surface can be opened.", ""}},
    {ErrorCode::handles,
     {"handles", "A piece has a handle, like a ring or a cup, so it cannot be flattened.",
      "Mark a seam around the handle and a seam along it.", "num_handles: number of handles"}},
    {ErrorCode::boundary_too_short,
     {"boundary_too_short",
      "The outline of a piece, such as a tube, is too short to enclose the piece's area in the plane.",
      "Mark a seam that opens the piece or cuts it in two, such as the proposed seams.",
      "lengths: length of each outline, longest first (vertex i of the error is on outline i); share: largest fraction "
      "of the piece's area that the outlines can enclose; least_energy: least distortion (ARAP energy over area) of "
      "any shape with these outlines"}},
    {ErrorCode::infeasible_lengths,
     {"infeasible_lengths", "No flat shape has all the lengths that were set.",
      "Give the named wires a tolerance, use less stretch, or cut the piece with a seam.",
      "reason: \"wires\" if the proposed tolerances help, \"outline\" if only a seam helps, \"stretch\" if no shape "
      "was found with the lengths that the fabric's stretch requires, \"method\" if the refined method flattens "
      "the piece; " WIREWARP_NAMED_WIRES
      ", in the order of the proposed tolerances (reason \"wires\"); is_refined: whether the "
      "method was refined (reason \"wires\"); has_wires: whether wires run inside the piece (reason \"outline\"); "
      "is_good_unstretched: whether the piece's shape without the stretch is free of flips and overlaps (reason "
      "\"stretch\"); max_factorizations: value of the option, if the solver reached it while the lengths were still "
      "improving"}},
    {ErrorCode::not_solvable,
     {"not_solvable",
      "WireWarp cannot calculate the shape of a piece, because rounding errors are too large, for example if its faces "
      "differ too much in size.",
      "Merge very close vertices of the named faces, remesh the piece more evenly, or use the refined method.",
      "reason: \"sizes\", \"precision\" or \"helper_wires\"; face: a face of the piece"}},
    {ErrorCode::cancelled, {"cancelled", "The work was canceled before it ended.", "Start the work again.", ""}},
    {ErrorCode::uv_discontinuous,
     {"uv_discontinuous",
      "The flattening is torn: two faces that share an edge inside a piece place its ends at different points.",
      "Mark the named edges as seams, or flatten again with the same seams.", ""}},
    {ErrorCode::no_layout,
     {"no_layout", "Some faces have no usable flat coordinates.", "Flatten the named faces first, then measure.",
      "limit: coordinates must be below this magnitude"}},
    {ErrorCode::lengths_not_kept,
     {"lengths_not_kept", "An edge of the outline or of a wire is longer or shorter in the flat piece than allowed.",
      "Do not cut this piece as it is: add a seam where the piece curves most, or give its wires a tolerance.",
      WIREWARP_NAMED_WIRES
      ", both empty if the worst edge is on the outline; difference: fraction by which the first "
      "named edge is too long (above 0) or too short; tolerance: the tolerance that the wire exceeds, instead of "
      "difference; num_flipped, num_overlapping: number of flipped and of overlapping triangles; has_wires: whether "
      "wires run inside the piece"}},
    {ErrorCode::flipped_faces,
     {"flipped_faces", "Some faces are flipped in the flat piece: the fabric would have to fold there.",
      "Add a seam or a dart near the named faces, remove a wire there, or give the wire more tolerance.",
      "num_overlapping: number of triangles that overlap others; has_wires: whether wires run inside the piece"}},
    {ErrorCode::overlapping_faces,
     {"overlapping_faces", "The flat piece overlaps itself, so it cannot be cut from one layer.",
      "Cut the piece in two with a seam, or add a dart near the named faces.", ""}},
    {ErrorCode::no_proposal,
     {"no_proposal",
      "No dart or seam was found that helps a piece: it is flat enough, has no room for a cut, or gains nothing.",
      "Leave the piece as it is, mark a seam by hand, or clear wires that are in the way.",
      "reason: \"unfolded\", \"strain\", \"too_long\", \"no_room\", \"no_gain\", \"no_set\" or \"too_strained\"; "
      "strain: the strain of "
      "the piece, and limit: the accepted strain (reason \"strain\"); length: the length of the seams, and limit: the "
      "longest allowed (reason \"too_long\"); kind: \"dart\" or \"seam\" (reasons \"no_room\", \"no_gain\"); wires: "
      "indices of the rigid and elastic wires inside the piece (reason \"no_gain\"); is_restricted: whether some edges "
      "must have no seam (reasons \"no_room\", \"no_set\")"}},
};

#undef WIREWARP_NAMED_WIRES
#undef WIREWARP_WRONG_ARRAY

constexpr std::size_t kCount = sizeof(kEntries) / sizeof(kEntries[0]);

constexpr bool in_declaration_order() {
  for (std::size_t i = 0; i < kCount; ++i) {
    if (static_cast<std::size_t>(kEntries[i].code) != i) return false;
  }
  return true;
}

static_assert(in_declaration_order() && static_cast<std::size_t>(ErrorCode::no_proposal) + 1 == kCount,
              "every ErrorCode needs one entry, in declaration order");

}  // namespace

const ErrorDescription& describe(ErrorCode code) { return kEntries[static_cast<std::size_t>(code)].description; }

const std::vector<ErrorCode>& all_error_codes() {
  static const std::vector<ErrorCode> codes = [] {
    std::vector<ErrorCode> result;
    for (const Entry& entry : kEntries) result.push_back(entry.code);
    return result;
  }();
  return codes;
}

}  // namespace wirewarp
