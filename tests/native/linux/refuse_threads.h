// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp::test {

/// While one lives, the system gives no more threads.
class RefuseThreads {
 public:
  RefuseThreads();
  ~RefuseThreads();
  RefuseThreads(const RefuseThreads&) = delete;
  RefuseThreads& operator=(const RefuseThreads&) = delete;

  /// How many were asked for.
  int num_refused() const;
};

}  // namespace wirewarp::test
