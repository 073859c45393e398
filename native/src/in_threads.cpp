// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_threads.h"

#include <thread>
#ifdef __linux__
#include <sched.h>
#endif

namespace wirewarp {

std::size_t num_cores() {
#ifdef __linux__  // where the standard library counts those of the machine, whatever a user or container allows
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return static_cast<std::size_t>(CPU_COUNT(&allowed));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace wirewarp
