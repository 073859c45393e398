// SPDX-License-Identifier: GPL-3.0-or-later
// Tests that random input of every topology, valid or not, keeps all guarantees. The step `random` runs more cases.
#include <gtest/gtest.h>

#include "random_case.h"

namespace wirewarp::test_random_cases {
namespace {

constexpr int kSeeds = 20;  // seeds for each test, so that several tests can run at once

class RandomCases : public testing::TestWithParam<int> {};

TEST_P(RandomCases, KeepEveryGuarantee) {
  for (int seed = kSeeds * GetParam(); seed < kSeeds * (GetParam() + 1); ++seed) {
    const test::RandomCase random_case = test::make_random_case(static_cast<std::uint64_t>(seed));
    const test::Outcome outcome = test::judge(random_case);
    EXPECT_EQ(outcome.broken, std::vector<std::string>{}) << "seed " << seed << ": " << random_case.description;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCases, testing::Range(0, 20));

}  // namespace
}  // namespace wirewarp::test_random_cases
