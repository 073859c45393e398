// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels for any processor, with sixteen registers of two numbers.
namespace {
constexpr int kLanes = 2;
constexpr int kRowsAtOnce = 1;  // 8 registers of sums; two rows would use all registers
constexpr int kRowsSummed = 2;  // uses 4 registers for x and one for sums
}  // namespace

#include "numerics/cholesky/front_kernels_body.h"

namespace wirewarp {

const FrontKernels kPlainKernels = kKernels;

}  // namespace wirewarp
