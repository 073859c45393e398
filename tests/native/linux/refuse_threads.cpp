// SPDX-License-Identifier: GPL-3.0-or-later
#include "refuse_threads.h"

#include <dlfcn.h>
#include <pthread.h>

#include <atomic>
#include <cerrno>

namespace {

std::atomic<bool> refuses{false};
std::atomic<int> num_refused_threads{0};

}  // namespace

/// Replaces the system's pthread_create for every library that this program loads.
extern "C" __attribute__((visibility("default"))) int create_or_refuse(pthread_t* thread,
                                                                       const pthread_attr_t* attributes,
                                                                       void* (*work)(void*), void* argument) noexcept
    __asm__("pthread_create");

int create_or_refuse(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                     void* argument) noexcept {
  if (refuses) {
    ++num_refused_threads;
    return EAGAIN;
  }
  static const auto create = reinterpret_cast<decltype(&pthread_create)>(dlsym(RTLD_NEXT, "pthread_create"));
  return create(thread, attributes, work, argument);
}

namespace wirewarp::test {

RefuseThreads::RefuseThreads() {
  num_refused_threads = 0;
  refuses = true;
}

RefuseThreads::~RefuseThreads() { refuses = false; }

int RefuseThreads::num_refused() const { return num_refused_threads; }

}  // namespace wirewarp::test
