// SPDX-License-Identifier: GPL-3.0-or-later
// Replaces fastest_kernels() in the whole test program, as count_allocations.cpp replaces malloc. The returned kernels
// count their calls and then call the fastest kernels.
#include "count_fronts.h"

#include <atomic>

#include "numerics/cholesky/front_kernels.h"

// fastest_kernels() returns a reference, which is a pointer in C. The linker option --wrap requires these names.
// NOLINTBEGIN(bugprone-reserved-identifier, readability-identifier-naming)
extern "C" const wirewarp::FrontKernels* __real__ZN8wirewarp15fastest_kernelsEv();
extern "C" const wirewarp::FrontKernels* __wrap__ZN8wirewarp15fastest_kernelsEv();
// NOLINTEND(bugprone-reserved-identifier, readability-identifier-naming)

namespace wirewarp {
namespace {

std::atomic<long> factored{0}, substituted_forward{0}, substituted_back{0};

const FrontKernels& real() {
  static const FrontKernels& kernels = *__real__ZN8wirewarp15fastest_kernelsEv();
  return kernels;
}

constexpr FrontKernels kCountingKernels{
    [](Tile* panel, Tile* schur, int m, int r) {
      ++factored;
      return real().factor(panel, schur, m, r);
    },
    [](Tile* lower, Tile* lower_schur, Tile* upper, Tile* upper_schur, int m, int r) {
      ++factored;
      return real().factor_lu(lower, lower_schur, upper, upper_schur, m, r);
    },
    [](const Tile* panel, int m, int r, double* x) {
      ++substituted_forward;
      real().solve_lower(panel, m, r, x);
    },
    [](const Tile* panel, int m, int r, double* x) {
      ++substituted_forward;
      real().solve_lower_4(panel, m, r, x);
    },
    [](const Tile* panel, int m, int r, double* x, Tile* sums) {
      ++substituted_back;
      real().solve_upper(panel, m, r, x, sums);
    },
    [](const Tile* panel, int m, int r, double* x) {
      ++substituted_back;
      real().solve_upper_4(panel, m, r, x);
    }};

}  // namespace

FrontCounts count_fronts() { return {factored, substituted_forward, substituted_back}; }

}  // namespace wirewarp

const wirewarp::FrontKernels* __wrap__ZN8wirewarp15fastest_kernelsEv() { return &wirewarp::kCountingKernels; }
