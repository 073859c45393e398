// SPDX-License-Identifier: GPL-3.0-or-later
// Kernels for any processor: two numbers in a register, and sixteen registers.
namespace {
constexpr int kLanes = 2;
constexpr int kRowsAtOnce = 1;  // 8 registers of sums; two rows would use all registers
constexpr int kRowsSummed = 2;  // 4 registers of x and one of sums at a time
}  // namespace

#include "numerics/cholesky/front_kernels_body.h"

namespace wirewarp {

const FrontKernels kPlainKernels = kKernels;

}  // namespace wirewarp
