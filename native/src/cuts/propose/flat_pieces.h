// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates cuts exactly: flattens the pieces that a cut changes, as flatten() does.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/attempt.h"
#include "base/internal_options.h"
#include "base/stop_token.h"
#include "cuts/feasibility/part_map.h"
#include "cuts/propose/needed_stretch.h"
#include "surface/charts/chart.h"

namespace wirewarp {

/// Merging, smoothing and limits of sets ignore smaller differences between strains, because shapes are exact only to
/// about this value.
inline constexpr double kStrainError = 1e-6;

struct FlatPiece {
  Chart chart;                      // its sources are the input's vertices and faces
  PartMap edges;                    // inner edges of the chart
  std::vector<VertexPair> outline;  // input vertices at the ends of each outline edge, sorted
  std::optional<FlattenError> error;
  double energy = 0;              // E of Eq. (4), or the energy of the fabric, scene units squared
  double area = 0;                // in 3D, scene units squared
  double strain = 0;              // as in DartProposal::strain
  double faulty_strain = 0;       // the strain if the layout breaks a guarantee; 0 for other pieces
  Eigen::VectorXd face_strain{};  // strain of each face of the chart
  Positions2 uv{};                // the flat shape, one row per vertex of the chart
  bool is_final = false;          // whether the shape is certain to stay the same with more factorizations
};

/// All pieces of an input, in flatten()'s order. States of a search share the pieces that a cut does not change.
using FlatPieces = std::vector<std::shared_ptr<const FlatPiece>>;

/// Figures of a piece, or of all its parts together.
struct PieceFigures {
  double energy = 0;  // energy over the 3D area
  double strain = 0;  // strain of the most strained part
  double area = 0;    // in 3D, scene units squared
  int num_pieces = 0;
  std::optional<FlattenError> error;  // error of one of the parts
};

/// Sorts pieces in flatten()'s order.
void sort_pieces(FlatPieces& pieces);

FlatPieces parts_of(const FlatPieces& pieces, const Chart& chart);

/// Returns the figures of all pieces together. If a piece has no flat shape, energy and strain are infinite.
PieceFigures figures_of(const FlatPieces& pieces);

PieceFigures figures_of(const FlatPieces& pieces, const Chart& chart);

/// Returns whether cutting a chart makes another piece lose its flat shape, or strains it more than any piece before. A
/// cut can change other pieces, because elastic seams and stretched fabric couple them. before, after: all pieces of
/// the input.
bool spoils_others(const FlatPieces& before, const FlatPieces& after, const Chart& chart);

/// Pieces on a mesh that divides the faces of a surface.
struct PiecesOnMesh {
  const FlatPieces& pieces;
  const std::vector<int>& faces;  // face of the surface that contains each face of the mesh
};

/// Returns the pieces of `here` that fail on the mesh of `there`. Each piece of `there` is the counterpart of the piece
/// of `here` with which it shares most area. Pieces fail if:
/// - they do not have exactly one counterpart
/// - their counterpart has no flat shape, or more strain than `most_strain`
FlatPieces failed_on_mesh(const PiecesOnMesh& here, const PiecesOnMesh& there, double most_strain);

/// Returns the largest strain of the pieces with a flat shape; 0 if there are none.
double most_strain(const FlatPieces& pieces);

/// Returns whether sorted input faces include the faces of a part. Tests one face only, so they must include all faces
/// of the part or none.
bool is_among(const std::vector<int>& faces, const Chart& part);

/// Returns whether a chart contains a part, by is_among(). Both must have sorted source faces of one input.
bool is_part_of(const Chart& part, const Chart& chart);

/// Returns whether the outline of a chart runs through a piece.
bool cuts_inside(const FlatPiece& piece, const Chart& chart);

/// Returns the pieces with at least one of the given edges on their outline.
FlatPieces pieces_beside(const FlatPieces& pieces, const std::vector<VertexPair>& edges);

/// A checked input, and its surface moved to the middle of the material.
class SurfaceToCut {
 public:
  /// The input must outlive the object. Throws the errors of flatten().
  SurfaceToCut(const FlattenInput& input, const Options& options);

  const FlattenInput& given() const { return input_; }

  const FlattenInput& middle() const { return middle_ ? *middle_ : input_; }

  /// Returns the fan of each corner of the input without seams.
  const std::vector<int>& fans() const { return fans_; }

 private:
  const FlattenInput& input_;
  std::vector<int> fans_;
  std::optional<FlattenInput> middle_;
};

/// The pieces that change if seams are added or removed, before they are flattened. Faces are sorted faces of the
/// input.
struct ChangedPieces {
  std::vector<int> touched_faces;  // of the pieces beside these seams, and of all pieces coupled with them
  std::vector<int> changed_faces;  // of all pieces whose shapes change
  Charts charts;                   // all charts on which these shapes depend
};

class ExactEvaluation {
 public:
  /// The surface must outlive the object. stop: polled in any thread.
  ExactEvaluation(const SurfaceToCut& surface, const InternalOptions& options, StopToken stop);

  /// Returns the pieces of the input with its own seams. Throws Stopped.
  FlatPieces uncut() const;

  /// Returns all pieces after adding the seams `edges`. Flattens only pieces that may change. May be called in any
  /// thread. Throws Stopped.
  FlatPieces with_cut(const FlatPieces& before, const std::vector<VertexPair>& edges) const {
    return with_changed(before, changed_by(before, edges, {}));
  }

  /// Returns the pieces that change if the seams `edges` are added and the seams `opened` are removed. May be called in
  /// any thread. Throws Stopped.
  ChangedPieces changed_by(const FlatPieces& before, const std::vector<VertexPair>& edges,
                           const std::vector<VertexPair>& opened) const;

  /// Returns all pieces after flattening the changed pieces. before: as for changed_by(). May be called in any thread.
  /// Throws Stopped.
  FlatPieces with_changed(const FlatPieces& before, ChangedPieces changed) const;

  /// Returns the error of a piece, with the seams or tolerances that flatten() suggests. Throws Stopped.
  FlattenError explain(const FlatPieces& pieces, int piece) const;

  const SurfaceToCut& surface() const { return surface_; }
  const InternalOptions& options() const { return options_; }
  const StopToken& stop() const { return stop_; }

 private:
  FlatPieces flatten_along_seams(Charts charts) const;
  Charts cut_chosen(const FlatPieces& pieces, const std::vector<char>& chosen, const std::vector<VertexPair>& edges,
                    const std::vector<VertexPair>& opened) const;

  const SurfaceToCut& surface_;
  const FlattenInput& input_;  // the surface in the middle of the material
  const NeededStretch needed_;
  InternalOptions options_;
  StopToken stop_;
};

/// Calls a search for cuts with an evaluation of the input, and returns the result of the search. Throws the errors of
/// flatten(), and cancelled if the caller cancels.
template <typename Search>
auto search_cuts(const FlattenInput& input, const Options& options, const StopToken& stop, const Search& search) {
  const SurfaceToCut surface(input, options);
  try {
    return search(ExactEvaluation(surface, options, stop));
  } catch (const Stopped&) {
    throw FlattenError(ErrorCode::cancelled, ErrorArguments{});
  }
}

}  // namespace wirewarp
