// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_case.h"

#include <exception>

#include "judge.h"
#include "random_input.h"
#include "wirewarp/cache.h"

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
  options.orientation = random.pick(
      std::vector<Orientation>{Orientation::wire, Orientation::boundary, Orientation::up, Orientation::grain});
  if (random.chance(0.5)) options.grain = random.whole(-1, static_cast<int>(num_wires) - 1);
  if (random.chance(0.5)) {
    const double length = random.across_scales(1e-100, 1e100);
    for (double& x : options.up) x = length * random.between(-1, 1);
  }
}

const char* name_of(Method method) {
  return method == Method::refined ? "refined" : method == Method::wirewarping ? "wirewarping" : "wirewarp++";
}

/// Returns the options with the default layout. The options of the solver do not change, so the cache has all shapes.
InternalOptions with_plain_layout(InternalOptions options) {
  const Options plain;
  options.layout = plain.layout;
  options.gap = plain.gap;
  options.mirror = plain.mirror;
  if (options.cloth) return options;  // the shape depends on the direction
  options.orientation = plain.orientation;
  options.grain = plain.grain;
  options.up = plain.up;
  return options;
}

/// Returns the result without the stretch, because the directions of its edges determine the stretched lengths. Returns
/// nullopt if there is no stretch.
std::optional<FlattenResult> without_stretch(const FlattenInput& input, InternalOptions options, Cache& cache) {
  if (!options.cloth || options.cloth->stretch == Cloth{}.stretch) return std::nullopt;
  options.cloth->stretch = Cloth{}.stretch;
  return flatten_with(input, options, {}, &cache);
}

Outcome judge_errors(const RandomCase& random_case, const FlattenResult& result) {
  Outcome outcome{"flat", {}};
  bool found = false;
  for (const Piece& piece : result.pieces) {
    if (!piece.error) continue;
    outcome.name = describe(piece.error->code).name;
    found = found || piece.error->code == random_case.fault;
  }
  if (random_case.fault && !found) {
    outcome.broken.push_back(std::string("expected ") + describe(*random_case.fault).name + ", got " + outcome.name);
  }
  return outcome;
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

Outcome judge(const RandomCase& random_case) {
  try {
    const FlattenInput& input = random_case.input;
    const InternalOptions& options = random_case.options;
    Cache cache;
    const FlattenResult result = flatten_with(input, options, {}, &cache);
    const FlattenResult again = flatten_with(input, with_plain_layout(options), {}, &cache);
    const std::optional<FlattenResult> unstretched = without_stretch(input, options, cache);
    const FlattenResult* relaxed = unstretched ? &*unstretched : nullptr;
    Outcome outcome = judge_errors(random_case, result);
    for (const Piece& piece : result.pieces) {
      if (!piece.error && !piece.report.start.empty()) ++outcome.starts[piece.report.start];
    }
    outcome.add(broken_guarantees(input, options, result, relaxed));
    outcome.add(broken_expectations(input, options, result, random_case.fault, relaxed));
    outcome.add(differences_of_layout(input, options, result, again));
    return outcome;
  } catch (const FlattenError& error) {
    Outcome outcome{describe(error.code).name, faults_of_error(error, random_case.input)};
    if (random_case.fault != error.code) {
      outcome.broken.push_back(std::string("unexpected error: ") + error.what());
    }
    return outcome;
  } catch (const std::exception& error) {
    return {"exception", {std::string("untyped exception: ") + error.what()}};
  }
}

}  // namespace wirewarp::test
