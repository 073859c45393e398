// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Checks that pieces do not touch: their boxes are the gap apart and, if requested, in a row in their order.
void check_room(Judged& judged);

/// Checks that the direction chosen by Options::orientation is up in piece `number`, which has a layout.
void check_orientation(Judged& judged, int number);

/// Checks that two results of the same input that differ only in the placement of pieces have equal errors and shapes.
void check_same_shapes(Judged& judged, const FlattenResult& other);

}  // namespace wirewarp::test
