// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "judged.h"

namespace wirewarp::test {

/// Pieces do not touch: their boxes lie the gap apart, in a row in their order where that was asked for.
void check_room(Judged& judged);

/// What Options::orientation asks for points up in piece `number`, which has a layout.
void check_orientation(Judged& judged, int number);

/// Two results of the same input that differ in how pieces are laid out alone: the same errors and the same shapes.
void check_same_shapes(Judged& judged, const FlattenResult& other);

}  // namespace wirewarp::test
