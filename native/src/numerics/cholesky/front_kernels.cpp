// SPDX-License-Identifier: GPL-3.0-or-later
#include "numerics/cholesky/front_kernels.h"

#ifdef __x86_64__
#include <cpuid.h>
#endif

namespace wirewarp {

#ifdef __x86_64__
// This function does not use __builtin_cpu_supports, because the runtimes of some compilers do not implement it.
bool has_avx2() {
  unsigned a = 0, b = 0, c = 0, d = 0;
  constexpr unsigned kNeeded = bit_FMA | bit_AVX | bit_OSXSAVE;
  if (!__get_cpuid(1, &a, &b, &c, &d) || (c & kNeeded) != kNeeded) return false;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d) || (b & bit_AVX2) == 0) return false;
  unsigned saved = 0, high = 0;
  __asm__("xgetbv" : "=a"(saved), "=d"(high) : "c"(0));
  constexpr unsigned kWideRegisters = 0b110;          // the bits of SSE and AVX
  return (saved & kWideRegisters) == kWideRegisters;  // the system saves these registers when it switches threads
}
#else
bool has_avx2() { return false; }
#endif

const FrontKernels& fastest_kernels() {
  // The processor is examined only once, because CPUID takes microseconds in a virtual machine.
  static const FrontKernels& fastest = has_avx2() ? kAvx2Kernels : kPlainKernels;
  return fastest;
}

}  // namespace wirewarp
