// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/in_threads.h"

#include <thread>
#include <utility>
#ifdef __linux__
#include <sched.h>

#include "base/cpu_quota.h"
#endif

namespace wirewarp {
namespace {

thread_local bool is_on_one_core = false;

}  // namespace

OnOneCore::OnOneCore() : was_on_one_core_(std::exchange(is_on_one_core, true)) {}

OnOneCore::~OnOneCore() { is_on_one_core = was_on_one_core_; }

namespace {

std::size_t cores_of_process() {
#ifdef __linux__  // hardware_concurrency() ignores the limits of users and containers
  static const std::optional<std::size_t> quota = cpu_quota("/");
  cpu_set_t allowed;
  if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) {
    const auto count = static_cast<std::size_t>(CPU_COUNT(&allowed));
    return quota ? std::min(*quota, count) : count;
  }
#endif
  return std::max(1U, std::thread::hardware_concurrency());
}

}  // namespace

std::size_t num_cores() { return is_on_one_core ? 1 : cores_of_process(); }

}  // namespace wirewarp
