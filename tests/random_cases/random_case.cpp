// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_case.h"

#include "random_cloth.h"
#include "random_faults.h"
#include "random_mesh.h"
#include "random_network.h"
#include "touching_parts.h"

namespace wirewarp::test {
namespace {

Options random_options(RandomStream& random) {
  Options options;
  const int method = random.below(5);
  options.method = method == 0 ? Method::wirewarping : method == 1 ? Method::wirewarp_plus_plus : Method::refined;
  if (random.chance(0.3)) options.node_weight = NodeWeight::uniform;
  if (random.chance(0.1)) options.inner = Inner::least_norm;
  if (random.chance(0.3)) options.fairness = random.across_scales(Options::least_fairness, Options::most_fairness);
  if (random.chance(0.1)) options.max_factorizations = random.whole(1, 5);
  return options;
}

void choose_layout(RandomStream& random, std::size_t num_wires, Options& options) {
  if (random.chance(0.3)) options.layout = PieceLayout::row;
  if (random.chance(0.2)) options.gap = random.uniform();
  options.mirror = random.chance(0.2);
  options.orientation =
      random.pick(std::vector<Orientation>{Orientation::wire, Orientation::boundary, Orientation::up});
  if (random.chance(0.5)) options.grain = random.whole(-1, static_cast<int>(num_wires) - 1);
  if (random.chance(0.5)) {
    const double length = random.across_scales(1e-100, 1e100);
    for (double& x : options.up) x = length * random.between(-1, 1);
  }
}

const char* name_of(Method method) {
  return method == Method::refined ? "refined" : method == Method::wirewarping ? "wirewarping" : "wirewarp++";
}

}  // namespace

RandomCase make_random_case(std::uint64_t seed) {
  RandomStream random(seed);
  RandomCase result;
  result.options = random_options(random);
  result.description = name_of(result.options.method);
  result.input = random_mesh(random, result.description);
  add_random_seams(random, result.input, result.description);
  add_random_wires(random, result.input, result.description);
  choose_layout(random, result.input.wires.size(), result.options);
  if (random.chance(0.15)) {
    result.fault = add_random_fault(random, result.input, result.options);
    result.description += std::string(" with ") + describe(*result.fault).name;
  }
  if (!result.fault && random.chance(0.1) && let_parts_touch(random, result.input)) result.description += " touching";
  result.options.large_chart = static_cast<std::size_t>(random.across_scales(50, 8'000));
  if (!result.fault && result.options.method == Method::refined && random.chance(0.5)) {
    add_random_stretch(random, result.input, result.options, result.description);
  }
  return result;
}

}  // namespace wirewarp::test
