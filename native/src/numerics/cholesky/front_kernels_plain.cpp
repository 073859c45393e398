// SPDX-License-Identifier: GPL-3.0-or-later
// For any processor: two numbers in a register, and sixteen registers.
namespace {
constexpr int kLanes = 2;
constexpr int kRowsAtOnce = 1;  // 8 registers of sums; two rows would take all
}  // namespace

#include "numerics/cholesky/front_kernels_body.h"

namespace wirewarp {

const FrontKernels kPlainKernels = kKernels;

}  // namespace wirewarp
