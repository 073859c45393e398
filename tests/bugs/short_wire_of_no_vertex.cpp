// SPDX-License-Identifier: GPL-3.0-or-later
// A wire of one vertex that the mesh does not have was refused as too short, and the error named that vertex.
#include <gtest/gtest.h>

#include "test_meshes.h"

namespace wirewarp::short_wire_of_no_vertex_test {
namespace {

TEST(Bugs, AShortWireOfNoVertexIsOutOfRange) {
  FlattenInput input = test::flat_rectangle(1, 1, 1, 1);
  const auto beyond = static_cast<int>(input.vertices.rows());
  test::add_wire(input, {beyond});
  try {
    flatten(input);
    FAIL() << "not refused";
  } catch (const FlattenError& error) {
    EXPECT_EQ(error.code, ErrorCode::vertex_out_of_range) << error.what();
  }
}

}  // namespace
}  // namespace wirewarp::short_wire_of_no_vertex_test
