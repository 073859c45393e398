// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_threads.h"

#include <thread>
#include <utility>
#ifdef __linux__
#include <sched.h>
#endif

namespace wirewarp {
namespace {

thread_local bool is_on_one_core = false;

}  // namespace

OnOneCore::OnOneCore() : was_on_one_core_(std::exchange(is_on_one_core, true)) {}

OnOneCore::~OnOneCore() { is_on_one_core = was_on_one_core_; }

std::size_t num_cores() {
  if (is_on_one_core) return 1;
#ifdef __linux__  // where the standard library counts those of the machine, whatever a user or container allows
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return static_cast<std::size_t>(CPU_COUNT(&allowed));
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace wirewarp
