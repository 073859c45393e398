// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_input/sentence.h"

#include <algorithm>

namespace wirewarp {
namespace {

constexpr std::size_t kNamed = 5;

std::string join(const std::string& noun, const std::vector<std::string>& names, std::size_t count) {
  if (count == 1) return noun + " " + names[0];
  std::string text = noun == "vertex" ? "vertices" : noun + "s";
  for (std::size_t i = 0; i < names.size(); ++i) {
    const bool is_last = i + 1 == count;
    text += (i == 0 ? " " : is_last ? " and " : ", ") + names[i];
  }
  if (count > names.size()) text += " and " + std::to_string(count - names.size()) + " more";
  return text;
}

}  // namespace

std::string name_elements(const std::string& noun, const std::vector<int>& indices) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, indices.size()); ++i) names.push_back(std::to_string(indices[i]));
  return join(noun, names, indices.size());
}

std::string name_elements(const std::string& noun, const std::vector<VertexPair>& edges) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kNamed, edges.size()); ++i) {
    names.push_back(std::to_string(edges[i][0]) + "-" + std::to_string(edges[i][1]));
  }
  return join(noun, names, edges.size());
}

}  // namespace wirewarp
