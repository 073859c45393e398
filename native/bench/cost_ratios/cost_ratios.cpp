// SPDX-License-Identifier: GPL-3.0-or-later
// Compares expensive runs (many wires, fabrics, elastic seams) with plain runs. Prints a Markdown table with the
// medians of alternating runs. Times are user seconds, which depend little on other programs.
//
//   wirewarp_cost_ratios [ROUNDS [PART_OF_A_NAME]]
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bumpy_sheet.h"
#include "wirewarp/cache.h"
#include "wirewarp/cloth.h"

namespace wirewarp {
namespace {

constexpr double kTolerance = 0.03;
constexpr int kPiece = 3'000, kNet = 40'000, kCached = 10'000, kSmallNet = 360;  // approximate numbers of triangles

struct Comparison {
  std::string name;
  std::function<void()> run;
  std::function<void()> plain;  // run to compare with; empty: only `run` is measured
};

double user_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) + 1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

double seconds_of(const std::function<void()>& work) {
  const double begin = user_seconds();
  work();
  return user_seconds() - begin;
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::function<void()> flattening(const FlattenInput& input, const Options& options = {}) {
  return [=] { flatten(input, options); };
}

Options woven(Orientation orientation) {
  Options options;
  options.cloth = cloth_preset("woven").cloth;
  options.orientation = orientation;
  return options;
}

/// Returns a sheet that seams cut into nine pieces. tolerance: tolerance of wires along the seams; 0: no wires.
FlattenInput nine_pieces(double tolerance) {
  FlattenInput input = bumpy_sheet(kPiece, 4, tolerance);
  std::vector<int> ends;
  for (const Wire& wire : input.wires) {
    for (std::size_t i = 1; i < wire.vertices.size(); ++i) {
      ends.insert(ends.end(), {wire.vertices[i - 1], wire.vertices[i]});
    }
  }
  input.seams = Eigen::Map<const VertexPairs>(ends.data(), static_cast<Eigen::Index>(ends.size() / 2), 2);
  if (tolerance == 0) input.wires.clear();
  return input;
}

/// Returns a small sheet with an elastic wire on every edge. The eases of the wires contradict one another.
FlattenInput every_edge_a_wire() {
  FlattenInput input = bumpy_sheet(kSmallNet, 0, 0);
  std::set<VertexPair> edges;
  for (const auto& face : input.faces.rowwise()) {
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax(face[i], face[(i + 1) % 3]);
      edges.insert({a, b});
    }
  }
  for (const auto& [a, b] : edges) {
    Wire wire;
    wire.vertices = {a, b};
    wire.tolerance = kTolerance;
    wire.ease = 0.1 * std::sin(static_cast<double>(input.wires.size()));
    input.wires.push_back(wire);
  }
  return input;
}

std::vector<Comparison> comparisons() {
  const auto plain = flattening(bumpy_sheet(kPiece, 2, 0));
  const FlattenInput cached = bumpy_sheet(kCached, 8, kTolerance);
  const auto cache = std::make_shared<Cache>();
  flatten(cached, {}, {}, cache.get());
  return {
      {"128 wires over 8 wires", flattening(bumpy_sheet(kNet, 128, kTolerance)),
       flattening(bumpy_sheet(kNet, 8, kTolerance))},
      {"woven over no fabric", flattening(bumpy_sheet(kPiece, 2, 0), woven(Orientation::wire)), plain},
      {"best orientation over no fabric", flattening(bumpy_sheet(kPiece, 2, 0), woven(Orientation::best)), plain},
      {"elastic seams over rigid ones", flattening(nine_pieces(kTolerance)), flattening(nine_pieces(0))},
      {"unchanged piece from a cache over a solved one", [=] { flatten(cached, {}, {}, cache.get()); },
       flattening(cached)},
      {"every edge a wire", flattening(every_edge_a_wire()), {}},
  };
}

void write_row(const Comparison& comparison, int rounds) {
  std::vector<double> run, plain;
  for (int i = 0; i < rounds; ++i) {
    run.push_back(seconds_of(comparison.run));
    if (comparison.plain) plain.push_back(seconds_of(comparison.plain));
  }
  std::printf("| %s | %.4f |", comparison.name.c_str(), median(run));
  if (comparison.plain) {
    std::printf(" %.4f | %.2f |\n", median(plain), median(run) / median(plain));
  } else {
    std::printf("  |  |\n");
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace wirewarp

int main(int count, char** arguments) {
  try {
    const int rounds = count > 1 ? std::stoi(arguments[1]) : 5;
    const std::string part = count > 2 ? arguments[2] : "";
    std::printf("| case | seconds | plain | ratio |\n| :-- | --: | --: | --: |\n");
    for (const wirewarp::Comparison& comparison : wirewarp::comparisons()) {
      if (comparison.name.find(part) != std::string::npos) wirewarp::write_row(comparison, rounds);
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "wirewarp_cost_ratios: %s\n", error.what());
    return 1;
  }
}
