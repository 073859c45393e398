// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton/refine_problem.h"

#include <algorithm>
#include <limits>

#include "newton/refine_constants.h"
#include "surface/mesh/geometry.h"
#include "surface/network/length_variation.h"

namespace wirewarp {

RefineProblem::RefineProblem(const RefineTask& task, Injectivity injectivity, const Positions2& layout)
    : chart_(task.chart),
      constraints_(task.chart, task.network, task.cloth, layout),
      objective_(task, injectivity, layout),
      worthwhile_(task.target == Target::minimum ? RefineConstants::worthwhile
                                                 : RefineConstants::worthwhile_on_the_way) {
  // What rounding leaves of f is felt on slivers and edges of 1e-8 of the piece.
  const double extent = (layout.colwise().maxCoeff() - layout.colwise().minCoeff()).maxCoeff();
  isometric_value_ = std::max(RefineConstants::isometric * surface_area(task.chart.mesh),
                              objective_.value_of_rounding(std::numeric_limits<double>::epsilon() * extent));
}

RefineIterate RefineProblem::iterate_at(const Positions2& uv) const {
  return {uv, constraints_.within_tolerance(constraints_.variation(uv)), objective_.value(uv)};
}

double RefineProblem::length_error(const RefineIterate& iterate) const {
  return constraints_.largest_error(constraints_.residual(iterate.uv, iterate.variation));
}

double RefineProblem::worthwhile_decrease(const RefineIterate& iterate) const {
  return std::max(worthwhile_ * iterate.value, isometric_value_);
}

RefinedShape RefineProblem::describe(const RefineIterate& iterate) const {
  RefinedShape shape;
  shape.uv = iterate.uv;
  shape.variation = length_variation(chart_, iterate.uv);
  for (int i = 0; i < shape.variation.size(); ++i) {
    const int elastic = constraints_.elastic_of_part()[i];
    if (chart_.wire_parts[i].kind != WireKind::super_elastic) shape.variation[i] = 0;
    if (elastic >= 0) shape.variation[i] = iterate.variation[elastic];
  }
  shape.objective = iterate.value / surface_area(chart_.mesh);
  shape.length_error = length_error(iterate);
  return shape;
}

}  // namespace wirewarp
