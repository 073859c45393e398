// SPDX-License-Identifier: GPL-3.0-or-later
// libFuzzer on the whole of flatten(): any bytes are a mesh with seams, wires and options, legal or not. What is not a
// typed error must keep every promise.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "judge.h"

namespace wirewarp::test {
namespace {

constexpr int kMostVertices = 40;

struct Asked {
  FlattenInput input;
  Options options;
};

double any_coordinate(FuzzedDataProvider& bytes) {
  if (bytes.ConsumeIntegralInRange(0, 60) == 60) return bytes.ConsumeFloatingPoint<double>();
  return bytes.ConsumeIntegral<std::int8_t>() / 16.0;
}

/// Mostly a vertex of the mesh.
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

Options any_options(FuzzedDataProvider& bytes) {
  Options options;
  options.method = bytes.PickValueInArray({Method::refined, Method::wirewarp_plus_plus, Method::wirewarping});
  options.node_weight = bytes.PickValueInArray({NodeWeight::length, NodeWeight::uniform});
  options.inner = bytes.PickValueInArray({Inner::minimum, Inner::least_norm});
  options.fairness = bytes.ConsumeBool() ? 0.1 : bytes.ConsumeFloatingPointInRange<double>(0, 11);
  options.max_factorizations = bytes.ConsumeIntegralInRange(0, 100);
  options.gap = bytes.ConsumeFloatingPointInRange<double>(0, 1.01);
  options.mirror = bytes.ConsumeBool();
  options.layout = bytes.PickValueInArray({PieceLayout::packed, PieceLayout::row});
  options.orientation = bytes.PickValueInArray({Orientation::wire, Orientation::boundary, Orientation::up});
  options.grain = bytes.ConsumeIntegralInRange(-1, 3);
  for (double& x : options.up) x = any_coordinate(bytes);
  return options;
}

Asked any_case(FuzzedDataProvider& bytes) {
  Asked result;
  result.options = any_options(bytes);
  const int num_vertices = bytes.ConsumeIntegralInRange(0, kMostVertices);
  FlattenInput& input = result.input;
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
  return result;
}

void demand_none(const std::vector<std::string>& broken) {
  if (broken.empty()) return;
  for (const std::string& sentence : broken) std::fprintf(stderr, "%s\n", sentence.c_str());
  std::abort();
}

}  // namespace
}  // namespace wirewarp::test

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  FuzzedDataProvider bytes(data, size);
  const wirewarp::test::Asked asked = wirewarp::test::any_case(bytes);
  try {
    wirewarp::test::demand_none(
        wirewarp::test::broken_promises(asked.input, asked.options, flatten(asked.input, asked.options)));
  } catch (const wirewarp::FlattenError& error) {
    wirewarp::test::demand_none(wirewarp::test::faults_of_error(error, asked.input));
  }
  return 0;
}
