// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <random>
#include <utility>
#include <vector>

namespace wirewarp::test {

/// Random numbers of several kinds. A seed leads to the same numbers on every platform. The class uses no
/// distributions, because the C++ standard does not define their results.
class RandomStream {
 public:
  explicit RandomStream(std::uint64_t seed)
      : next_([engine = std::mt19937_64(seed)]() mutable {
          return std::ldexp(static_cast<double>(engine() >> 11), -53);
        }) {}

  /// next: returns a number in [0, 1), for example from a fuzzer.
  explicit RandomStream(std::function<double()> next) : next_(std::move(next)) {}

  /// Returns a number in [0, 1).
  double uniform() { return next_(); }

  /// Returns a number in [low, high).
  double between(double low, double high) { return low + (high - low) * uniform(); }

  /// Returns a number in [low, high) with equal probability for every power of ten. low must be above 0.
  double across_scales(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }

  /// Returns a whole number in [0, count).
  int below(int count) { return static_cast<int>(uniform() * count); }

  /// Returns a whole number in [low, high].
  int whole(int low, int high) { return low + below(high - low + 1); }

  bool chance(double probability) { return uniform() < probability; }

  template <typename T>
  const T& pick(const std::vector<T>& values) {
    return values[below(static_cast<int>(values.size()))];
  }

  template <typename T>
  void shuffle(std::vector<T>& values) {
    for (int i = static_cast<int>(values.size()) - 1; i > 0; --i) {
      using std::swap;
      swap(values[i], values[below(i + 1)]);
    }
  }

 private:
  std::function<double()> next_;
};

}  // namespace wirewarp::test
