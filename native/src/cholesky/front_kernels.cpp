// SPDX-License-Identifier: GPL-3.0-or-later
#include "cholesky/front_kernels.h"

namespace wirewarp {

#ifdef __x86_64__
bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
#else
bool has_avx2() { return false; }
#endif

const FrontKernels& fastest_kernels() { return has_avx2() ? kAvx2Kernels : kPlainKernels; }

}  // namespace wirewarp
