// SPDX-License-Identifier: GPL-3.0-or-later
// Fuzzes flatten() with libFuzzer. flatten() must throw a FlattenError, or keep every guarantee and agree with
// measure(). Half of the meshes are small valid meshes with a few changes, because random faces are rarely a surface.
#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "base/planar.h"
#include "flatten.h"
#include "judge.h"
#include "random_input.h"

namespace wirewarp::test {
namespace {

constexpr int kMostVertices = 40;

struct Asked {
  FlattenInput input;
  InternalOptions options;
  int steps_until_cancelled = std::numeric_limits<int>::max();
};

double any_coordinate(FuzzedDataProvider& bytes) {
  if (bytes.ConsumeIntegralInRange(0, 60) == 60) return bytes.ConsumeFloatingPoint<double>();
  return bytes.ConsumeIntegral<std::int8_t>() / 16.0;
}

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

/// Returns options that are usually valid. If no bytes are left, most options have their defaults.
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
  options.orientation =
      bytes.PickValueInArray({Orientation::wire, Orientation::boundary, Orientation::up, Orientation::grain});
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

int any_vertex(RandomStream& random, const FlattenInput& input) {
  return random.below(static_cast<int>(input.vertices.rows()));
}

void take_out(FlattenInput& input, int face) {
  input.faces.row(face) = input.faces.row(input.faces.rows() - 1).eval();
  input.faces.conservativeResize(input.faces.rows() - 1, 3);
}

/// Divides a face into three, around a new vertex.
void split(FlattenInput& input, int face) {
  const int a = input.faces(face, 0), b = input.faces(face, 1), c = input.faces(face, 2);
  const int middle = add_vertex(input, (input.vertices.row(a) + input.vertices.row(b) + input.vertices.row(c)) / 3);
  input.faces(face, 2) = middle;
  add_face(input, b, c, middle);
  add_face(input, c, a, middle);
}

void weld(FlattenInput& input, int kept, int replaced) {
  std::replace(input.faces.data(), input.faces.data() + input.faces.size(), replaced, kept);
}

void change_one(RandomStream& random, FlattenInput& input) {
  const int face = random.below(static_cast<int>(input.faces.rows()));
  const int a = any_vertex(random, input), b = any_vertex(random, input);
  switch (random.below(10)) {
    case 0:
      return std::swap(input.faces(face, 0), input.faces(face, 1));
    case 1:
      return weld(input, a, b);
    case 2:
      return add_face(input, a, b, any_vertex(random, input));
    case 3:
      input.faces(face, random.below(3)) = a;
      return;
    case 4:
      input.vertices.row(a) = input.vertices.row(b);
      return;
    case 5:
      input.vertices.row(a) *= random.across_scales(1e-9, 1e9);
      return;
    case 6:
      return split(input, face);
    default:
      return take_out(input, face);
  }
}

/// Returns a valid sheet, tube or torus of a few quads, with a random shape and without seams and wires.
FlattenInput small_mesh(RandomStream& random) {
  const int nx = random.whole(1, 5), ny = random.whole(1, 5);
  const bool wraps_x = nx > 2 && random.chance(0.3), wraps_y = ny > 2 && random.chance(0.3);
  const int columns = wraps_x ? nx : nx + 1, rows = wraps_y ? ny : ny + 1;
  FlattenInput input;
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double x = i + 0.4 * random.between(-1, 1), y = j + 0.4 * random.between(-1, 1);
      const double s = 2 * kPi * x / nx, t = 2 * kPi * y / ny, high = random.between(-1, 1);
      const double radius = wraps_y ? 2 + 0.5 * std::cos(t) : 2;
      add_vertex(input, wraps_x
                            ? Eigen::RowVector3d(radius * std::cos(s), radius * std::sin(s), wraps_y ? std::sin(t) : y)
                        : wraps_y ? Eigen::RowVector3d(x, 2 * std::cos(t), 2 * std::sin(t))
                                  : Eigen::RowVector3d(x, y, high));
    }
  }
  const auto index = [&](int i, int j) { return i % columns + columns * (j % rows); };
  for (int j = 0; j < ny; ++j) {
    for (int i = 0; i < nx; ++i) {
      const int a = index(i, j), b = index(i + 1, j), c = index(i + 1, j + 1), d = index(i, j + 1);
      const bool turned = random.chance(0.5);  // whether the diagonal connects b and d
      add_face(input, a, b, turned ? d : c);
      add_face(input, turned ? b : a, c, d);
    }
  }
  return input;
}

/// Returns a small mesh, in half of the cases with one to eight random changes. Its seams and wires are random walks or
/// shortest paths along edges. If no bytes are left, the mesh is a flat sheet without seams and wires.
FlattenInput changed_mesh(FuzzedDataProvider& bytes) {
  RandomStream random([&] { return 1 - (bytes.ConsumeIntegral<std::uint16_t>() + 1) / 65536.0; });
  FlattenInput input = small_mesh(random);
  for (int changes = random.chance(0.5) ? random.whole(1, 8) : 0; changes > 0 && input.faces.rows() > 1; --changes) {
    change_one(random, input);
  }
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
  // The index of the grain wire is at most one too large. A random index would make most cases invalid.
  asked.options.grain = std::min(asked.options.grain, static_cast<int>(asked.input.wires.size()));
  if (bytes.ConsumeBool()) asked.options.large_chart = bytes.ConsumeIntegralInRange(1, kMostVertices);
  return asked;
}

/// Returns a sentence for each piece that has no error in the result, but has an error according to measure().
std::vector<std::string> differences_of_measure(const Asked& asked, const FlattenResult& result) {
  std::vector<std::string> differences;
  if (asked.options.mirror) return differences;  // measure() reports all faces of a mirror image as flipped
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
    std::vector<std::string> broken = broken_guarantees(asked.input, asked.options, result);
    if (steps > asked.steps_until_cancelled) {  // canceled, maybe before the search found seams or tolerances
      const auto misses_fix = [](const std::string& s) { return s.find(" is proposed") != std::string::npos; };
      broken.erase(std::remove_if(broken.begin(), broken.end(), misses_fix), broken.end());
    }
    demand_none(broken);
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
