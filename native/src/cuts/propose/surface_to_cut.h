// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "wirewarp/flatten.h"

namespace wirewarp {

/// A checked input, moved to the middle of its material.
class SurfaceToCut {
 public:
  /// input: kept by reference. Throws the errors of flatten().
  SurfaceToCut(const FlattenInput& input, const Options& options);

  /// The input as the user gave it.
  const FlattenInput& given() const { return input_; }

  const FlattenInput& middle() const { return middle_ ? *middle_ : input_; }

 private:
  const FlattenInput& input_;
  std::optional<FlattenInput> middle_;
};

}  // namespace wirewarp
