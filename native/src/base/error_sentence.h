// SPDX-License-Identifier: GPL-3.0-or-later
// The English sentence of an error, for users of the library.
#pragma once

#include <string>

#include "wirewarp/error.h"

namespace wirewarp {

/// Returns the sentence for a code: fault, place, remedy. Throws std::out_of_range if an argument of the code is
/// missing, and std::bad_variant_access if an argument has the wrong type.
std::string error_sentence(ErrorCode code, const ErrorArguments& arguments, const ErrorElements& elements);

}  // namespace wirewarp
