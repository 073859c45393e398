// SPDX-License-Identifier: GPL-3.0-or-later
// The error type for all faults of input and for all pieces that cannot be flattened.
#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "wirewarp/types.h"

namespace wirewarp {

/// The kind of an error. describe(code) returns its meaning and remedy.
enum class ErrorCode {
  // These errors are raised if the input is not a mesh with seams and wires, or if an option is out of range. There is
  // no result.
  invalid_shape,
  invalid_type,
  invalid_option,
  empty_mesh,
  vertex_out_of_range,
  non_finite_coordinates,
  loose_faces,
  seam_not_an_edge,
  wire_not_an_edge,
  wire_too_short,
  edge_in_two_wires,
  invalid_tolerance,
  invalid_ease,
  ease_without_side,
  side_in_two_eases,
  // These errors are stored in Piece::error. Other pieces are not affected.
  repeated_vertex_in_face,
  repeated_face,
  zero_area_face,
  non_manifold_edge,
  non_manifold_vertex,
  inconsistent_orientation,
  closed_chart,
  handles,
  boundary_too_short,
  infeasible_lengths,
  not_solvable,
  cancelled,
  uv_discontinuous,
  no_layout,
  lengths_not_kept,
  flipped_faces,
  overlapping_faces,
  // The functions that propose cuts raise this error.
  no_proposal,
};

struct ErrorDescription {
  const char* name;       // the code as Python and JSON write it: "zero_area_face"
  const char* meaning;    // one sentence
  const char* remedy;     // one sentence: what the user can do
  const char* arguments;  // "name: meaning" of each argument, separated by semicolons; empty without arguments
};

/// Returns the documented meaning, remedy and arguments of a code.
const ErrorDescription& describe(ErrorCode code);

/// Returns every code, in declaration order.
const std::vector<ErrorCode>& all_error_codes();

/// A wire and a tolerance with which its length can be kept.
struct ProposedTolerance {
  int wire;          // index into the input's wires
  double tolerance;  // dimensionless, as in Wire
};

/// One argument of an error. Lengths are in scene units, fractions are dimensionless.
using ErrorArgument =
    std::variant<bool, int, double, std::string, std::vector<int>, std::vector<double>, std::vector<std::string>>;

/// The arguments of an error's sentence, by the names that describe(code).arguments documents.
using ErrorArguments = std::map<std::string, ErrorArgument>;

/// The elements that an error is about, and a proposed fix. All indices refer to the input mesh.
struct ErrorElements {
  std::vector<int> vertices;
  std::vector<VertexPair> edges;
  std::vector<int> faces;
  std::vector<VertexPair> proposed_seams{};              // edges to add to the input's seams; empty without a proposal
  std::vector<ProposedTolerance> proposed_tolerances{};  // one per contradicting wire; empty without a proposal
};

/// Invalid input, or a piece that cannot be flattened. what() is an English sentence with fault, place and remedy.
/// Other programs can make their own texts from code, arguments and elements.
class FlattenError : public std::runtime_error {
 public:
  /// Makes an error and its sentence from the arguments. with_layout: see has_layout.
  FlattenError(ErrorCode error_code, ErrorArguments details, ErrorElements named = {}, bool with_layout = false);

  /// Makes an error with a given sentence, for example the sentence of a stored error.
  FlattenError(ErrorCode error_code, const std::string& message, ErrorElements named = {}, bool with_layout = false,
               ErrorArguments details = {})
      : std::runtime_error(message),
        code(error_code),
        arguments(std::move(details)),
        elements(std::move(named)),
        has_layout(with_layout) {}

  ErrorCode code;
  ErrorArguments arguments;
  ErrorElements elements;
  bool has_layout;  // true: the piece has a layout although it breaks a guarantee
};

}  // namespace wirewarp
