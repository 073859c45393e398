// SPDX-License-Identifier: GPL-3.0-or-later
// Solved charts kept from one run of flatten() to the next, so that only those that changed are solved again.
#pragma once

#include <memory>
#include <mutex>

namespace wirewarp {

struct CachedCharts;

/// Handed to flatten() again and again, it holds the charts of the last run: a chart whose geometry, order of vertices
/// and faces, outline, wires, tolerances and solver options are the same bit for bit takes its shape from there. The
/// result is the one that a run without a cache gives, but for the seconds that such a chart did not take. Charts that
/// were cancelled are not kept, failed ones are; of a cloth that is worn stretched the shapes from before that are. It
/// holds each chart's mesh and its shape, together about as much memory as the pieces take. Several threads may use one
/// cache at once; it then holds the charts of the run that ended last.
class Cache {
 public:
  Cache();

  /// Charts held.
  int size() const;

  /// Forgets them.
  void clear();

 private:
  friend class CacheSession;

  std::shared_ptr<const CachedCharts> solved() const;
  void hold(std::shared_ptr<const CachedCharts> solved);

  mutable std::mutex mutex_;
  std::shared_ptr<const CachedCharts> solved_;  // never null
};

}  // namespace wirewarp
