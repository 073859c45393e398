// SPDX-License-Identifier: GPL-3.0-or-later
#include "docs.h"

#include <stdexcept>

namespace wirewarp::bindings {
namespace {

struct Doc {
  const char* name;
  const char* text;
};

#include "written_docs.h"

}  // namespace

const char* doc_of(const std::string& name) {
  for (const Doc& doc : kDocs) {
    if (doc.name == name) return doc.text;
  }
  throw std::logic_error("no comment in the public headers says what " + name + " is");
}

}  // namespace wirewarp::bindings
