// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/sentence.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace wirewarp {
namespace {

std::string join(const std::string& noun, const std::vector<std::string>& names, std::size_t count) {
  const std::string plural = noun == "vertex" ? "vertices" : noun + "s";
  return (count == 1 ? noun : plural) + " " + listed(names, count);
}

}  // namespace

std::string listed(const std::vector<std::string>& names, std::size_t count) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) text += (i == 0 ? "" : i + 1 == count ? " and " : ", ") + names[i];
  return names.size() < count ? text + " and " + std::to_string(count - names.size()) + " more" : text;
}

std::string name_elements(const std::string& noun, const std::vector<int>& indices) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kMostNamed, indices.size()); ++i) names.push_back(std::to_string(indices[i]));
  return join(noun, names, indices.size());
}

std::string name_elements(const std::string& noun, const std::vector<VertexPair>& edges) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < std::min(kMostNamed, edges.size()); ++i) {
    names.push_back(std::to_string(edges[i][0]) + "-" + std::to_string(edges[i][1]));
  }
  return join(noun, names, edges.size());
}

std::string such_as_along(const std::vector<VertexPair>& edges) {
  return edges.empty() ? "" : ", such as along " + name_elements("edge", edges);
}

std::string name_wires(const std::vector<int>& indices, const std::vector<std::string>& names) {
  const std::string text = name_elements("wire", indices);
  return indices.size() == 1 && !names[0].empty() ? text + " (" + names[0] + ")" : text;
}

std::string name_piece(const std::vector<int>& faces) {
  return "the piece around face " + std::to_string(faces.front());
}

std::string introduce_piece(const std::vector<int>& faces) {
  return capitalized(name_piece(faces)) + " (" + std::to_string(faces.size()) + " triangles)";
}

std::string capitalized(std::string sentence) {
  sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence[0])));
  return sentence;
}

std::string shortest(double value) {
  if (std::isnan(value)) return "nan";
  char text[32];
  for (int digits = 15; digits <= 17; ++digits) {
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::strtod(text, nullptr) == value) break;
  }
  return text;
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

std::string percent(double fraction) { return rounded(100 * std::abs(fraction)) + "%"; }

}  // namespace wirewarp
