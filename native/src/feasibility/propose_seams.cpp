// SPDX-License-Identifier: GPL-3.0-or-later
#include "feasibility/propose_seams.h"

#include <utility>

#include "charts/chart_faults.h"
#include "errors/sentence.h"
#include "feasibility/cut_to_disk.h"
#include "feasibility/open_further.h"

namespace wirewarp {
namespace {

CutMask propose_cut(const Chart& chart) {
  if (count_handles(chart) > 0) return cut_to_disk(chart.mesh);
  const bool is_tube = chart.boundary_loops.size() > 1;
  return opened_or_halved(chart.mesh, is_tube ? cut_to_disk(chart.mesh) : slit_to_far_end(chart.mesh));
}

}  // namespace

std::vector<VertexPair> propose_seams(const Chart& chart) {
  const CutMask cut = propose_cut(chart);
  std::vector<VertexPair> seams;
  for (const EdgeHandle e : chart.mesh.edges()) {
    if (cut[e.idx()]) seams.push_back(source_edge(chart, chart.mesh.halfedge_handle(e, 0)));
  }
  return seams;
}

FlattenError with_proposed_seams(FlattenError error, const Chart& chart) {
  if (error.code != ErrorCode::closed_chart && error.code != ErrorCode::handles) return error;
  error.elements.proposed_seams = propose_seams(chart);
  std::string sentence = error.what();
  sentence.pop_back();
  sentence += ", such as along " + name_elements("edge", error.elements.proposed_seams) + ".";
  return FlattenError(error.code, sentence, std::move(error.elements));
}

}  // namespace wirewarp
