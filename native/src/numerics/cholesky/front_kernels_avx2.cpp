// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels for processors with AVX2 and FMA, which have sixteen registers of four numbers. CMakeLists.txt compiles this
// file for such processors only, so call nothing here before has_avx2() has returned true.
namespace {
constexpr int kLanes = 4;
constexpr int kRowsAtOnce = 3;  // 12 registers of sums and four of operands
constexpr int kRowsSummed = 4;  // uses 4 registers for x and one for sums
}  // namespace

#include "numerics/cholesky/front_kernels_body.h"

namespace wirewarp {

const FrontKernels kAvx2Kernels = kKernels;

}  // namespace wirewarp
