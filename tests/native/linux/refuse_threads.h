// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wirewarp::test {

/// While an object of this class exists, the system starts no more threads.
class RefuseThreads {
 public:
  RefuseThreads();
  ~RefuseThreads();
  RefuseThreads(const RefuseThreads&) = delete;
  RefuseThreads& operator=(const RefuseThreads&) = delete;

  /// Number of threads that were requested and refused.
  int num_refused() const;
};

}  // namespace wirewarp::test
