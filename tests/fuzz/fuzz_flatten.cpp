// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzes the whole of flatten() with libFuzzer: bytes become a mesh with seams, wires, options and the moment of a
// cancellation. Half of them are a slightly changed small mesh, because random lists of faces are rarely a surface;
// half are random faces. A result that is not a typed error must keep every guarantee, and measure() must agree.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "judge.h"
#include "random_network.h"
#include "small_mesh.h"

namespace wirewarp::test {
namespace {

constexpr int kMostVertices = 40;

struct Asked {
  FlattenInput input;
  Options options;
  int steps_until_cancelled = std::numeric_limits<int>::max();
};

double any_coordinate(FuzzedDataProvider& bytes) {
  if (bytes.ConsumeIntegralInRange(0, 60) == 60) return bytes.ConsumeFloatingPoint<double>();
  return bytes.ConsumeIntegral<std::int8_t>() / 16.0;
}

/// Returns a number that usually is a vertex of the mesh.
int any_vertex(FuzzedDataProvider& bytes, int num_vertices) { return bytes.ConsumeIntegralInRange(-1, num_vertices); }

double any_tolerance(FuzzedDataProvider& bytes) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  switch (bytes.ConsumeIntegralInRange(0, 5)) {
    case 0:
      return kInfinity;
    case 1:
      return bytes.ConsumeFloatingPoint<double>();
    case 2:
      return bytes.ConsumeProbability<double>();
    default:
      return 0;
  }
}

/// Returns options that are usually legal; the defaults if no bytes are left.
Options any_options(FuzzedDataProvider& bytes) {
  Options options;
  options.method = bytes.PickValueInArray({Method::refined, Method::wirewarp_plus_plus, Method::wirewarping});
  options.node_weight = bytes.PickValueInArray({NodeWeight::length, NodeWeight::uniform});
  options.inner = bytes.PickValueInArray({Inner::minimum, Inner::least_norm});
  if (bytes.ConsumeBool()) options.fairness = bytes.ConsumeFloatingPointInRange<double>(0, 10);
  options.max_factorizations = 100 - bytes.ConsumeIntegralInRange(0, 100);
  options.gap = bytes.ConsumeProbability<double>();
  options.mirror = bytes.ConsumeBool();
  options.layout = bytes.PickValueInArray({PieceLayout::packed, PieceLayout::row});
  options.orientation = bytes.PickValueInArray({Orientation::wire, Orientation::boundary, Orientation::up});
  if (bytes.ConsumeBool()) {
    for (double& x : options.up) x = any_coordinate(bytes);
  }
  return options;
}

FlattenInput any_input(FuzzedDataProvider& bytes) {
  FlattenInput input;
  const int num_vertices = bytes.ConsumeIntegralInRange(0, kMostVertices);
  input.vertices.resize(num_vertices, 3);
  for (int i = 0; i < 3 * num_vertices; ++i) input.vertices.data()[i] = any_coordinate(bytes);
  input.seams.resize(bytes.ConsumeIntegralInRange(0, 12), 2);
  for (int i = 0; i < input.seams.size(); ++i) input.seams.data()[i] = any_vertex(bytes, num_vertices);
  const int num_wires = bytes.ConsumeIntegralInRange(0, 5);
  for (int w = 0; w < num_wires; ++w) {
    Wire wire{{}, any_tolerance(bytes), "wire"};
    const int length = bytes.ConsumeIntegralInRange(0, 8);
    for (int i = 0; i < length; ++i) wire.vertices.push_back(any_vertex(bytes, num_vertices));
    input.wires.push_back(wire);
  }
  input.faces.resize(bytes.ConsumeIntegralInRange(0, 2 * kMostVertices), 3);
  for (int i = 0; i < input.faces.size(); ++i) input.faces.data()[i] = any_vertex(bytes, num_vertices);
  return input;
}

/// Returns a mesh whose seams and wires are walks along edges; a flat sheet without them if no bytes are left.
FlattenInput changed_mesh(FuzzedDataProvider& bytes) {
  RandomStream random([&] { return 1 - (bytes.ConsumeIntegral<std::uint16_t>() + 1) / 65536.0; });
  FlattenInput input = small_mesh(random);
  change_faces(random, input);
  std::string description;
  add_random_seams(random, input, description);
  add_random_wires(random, input, description);
  return input;
}

Asked any_case(FuzzedDataProvider& bytes) {
  Asked asked;
  asked.options = any_options(bytes);
  if (bytes.ConsumeBool()) asked.steps_until_cancelled = bytes.ConsumeIntegralInRange(0, 200);
  asked.options.grain = bytes.ConsumeIntegralInRange(-1, 3);
  asked.input = bytes.ConsumeBool() ? any_input(bytes) : changed_mesh(bytes);
  // The index of the grain wire is at most one too large.
  asked.options.grain = std::min(asked.options.grain, static_cast<int>(asked.input.wires.size()));
  if (bytes.ConsumeBool()) asked.options.large_chart = bytes.ConsumeIntegralInRange(1, kMostVertices);
  return asked;
}

/// Returns the differences between the result and the report of measure(), which must confirm every guarantee.
std::vector<std::string> differences_of_measure(const Asked& asked, const FlattenResult& result) {
  std::vector<std::string> differences;
  if (asked.options.mirror) return differences;  // all faces are flipped
  const FlattenResult measured = measure(asked.input, result.corner_uv);
  for (std::size_t p = 0; p < result.pieces.size(); ++p) {
    const auto& error = measured.pieces.at(p).error;
    if (!result.pieces[p].error && error) differences.push_back(std::string("measure() says: ") + error->what());
  }
  return differences;
}

void demand_none(const std::vector<std::string>& broken) {
  if (broken.empty()) return;
  for (const std::string& sentence : broken) std::fprintf(stderr, "%s\n", sentence.c_str());
  std::abort();
}

void flatten_and_judge(const Asked& asked) {
  int steps = 0;
  const Progress progress = [&](const std::string&, double) { return steps++ < asked.steps_until_cancelled; };
  try {
    const FlattenResult result = flatten_with(asked.input, asked.options, progress);
    demand_none(broken_guarantees(asked.input, asked.options, result));
    demand_none(differences_of_measure(asked, result));
  } catch (const FlattenError& error) {
    demand_none(faults_of_error(error, asked.input));
  }
}

}  // namespace
}  // namespace wirewarp::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  wirewarp::test::flatten_and_judge(wirewarp::test::any_case(bytes));
  return 0;
}
