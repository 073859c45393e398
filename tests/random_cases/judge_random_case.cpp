// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge_random_case.h"

#include <exception>
#include <optional>

#include "judge.h"
#include "wirewarp/cache.h"

namespace wirewarp::test {
namespace {

/// Returns options with the same solver and the default layout, so that a cache solves no chart again.
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

/// Returns the result without the stretch, whose directions determine the lengths; nullopt if there is no stretch.
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
