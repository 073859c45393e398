// SPDX-License-Identifier: GPL-3.0-or-later
// Keeps solved charts between runs of flatten(), so that only changed charts are solved again.
#pragma once

#include <memory>
#include <mutex>

namespace wirewarp {

struct CachedCharts;

/// Keeps the charts of the last run of flatten() with this cache. The next run solves only charts that have changed.
///
/// - A chart is reused if its geometry, numbering, outline, wires, tolerances and solver options are equal in every
///   bit.
/// - Except for the seconds, the result equals the result of a run without a cache.
/// - Failed charts are kept. Canceled charts are not kept.
/// - For a cloth with stretch, charts are kept without the stretch, and the stretched shapes are solved again.
/// - The cache needs about as much memory as the pieces.
/// - Several threads may use one cache at the same time. It then keeps the charts of the run that ended last.
class Cache {
 public:
  Cache();

  /// Returns the number of charts in the cache.
  int size() const;

  /// Removes all charts.
  void clear();

 private:
  friend class CacheSession;

  std::shared_ptr<const CachedCharts> solved() const;
  void hold(std::shared_ptr<const CachedCharts> solved);

  mutable std::mutex mutex_;
  std::shared_ptr<const CachedCharts> solved_;  // never null
};

}  // namespace wirewarp
