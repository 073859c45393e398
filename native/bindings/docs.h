// SPDX-License-Identifier: GPL-3.0-or-later
// Docstrings: the comments of the public headers, from the table that write_docs.py makes of them.
#pragma once

#include <cstddef>
#include <string>

#include "enums.h"

namespace wirewarp::bindings {

/// The comment on "Struct", "Struct.field" or "Enum.0", the first enumerator. Throws std::logic_error if there is none.
const char* doc_of(const std::string& name);

/// Of a field that is an enum: what it is, and what each of its strings stands for.
template <class Enum, std::size_t N>
std::string doc_of(const std::string& field, const std::string& enumeration, const Named<Enum> (&names)[N]) {
  std::string text = doc_of(field);
  for (const Named<Enum>& entry : names) {
    const std::string meaning = doc_of(enumeration + "." + std::to_string(static_cast<int>(entry.value)));
    text += "\n\n- `'" + std::string(entry.name) + "'`: " + meaning;
  }
  return text;
}

}  // namespace wirewarp::bindings
