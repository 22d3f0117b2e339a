#include "base/random.h"

#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <vector>

namespace overbend {
namespace {

// The lists below come from the authors' reference programs splitmix64.c and xoshiro256plusplus.c, as the test suites
// of other implementations hold them too.

TEST(random, splitmix64_gives_the_published_numbers) {
  std::uint64_t state = 1477776061723855037U;
  for (const std::uint64_t expected : {1985237415132408290U, 2979275885539914483U, 13511426838097143398U,
                                       8488337342461049707U, 15141737807933549159U}) {
    EXPECT_EQ(splitmix64(state), expected);
  }
}

TEST(random, xoshiro256pp_gives_the_published_numbers) {
  Random random(Random::State{1, 2, 3, 4});
  for (const std::uint64_t expected : std::initializer_list<std::uint64_t>{
           41943041U, 58720359U, 3588806011781223U, 3591011842654386U, 9228616714210784205U, 9973669472204895162U,
           14011001112246962877U, 12406186145184390807U, 15849039046786891736U, 10450023813501588000U}) {
    EXPECT_EQ(random.bits(), expected);
  }
}

TEST(random, a_seed_gives_the_same_numbers_for_ever) {
  // splitmix64 then xoshiro256++ for the seed 42, computed once outside this program.
  Random random(42);
  EXPECT_EQ(random.bits(), 15021278609987233951U);
  EXPECT_EQ(random.bits(), 5881210131331364753U);
  EXPECT_EQ(random.bits(), 18149643915985481100U);
}

TEST(random, uniform_numbers_are_the_upper_bits_exactly) {
  Random bits(7), numbers(7);
  for (int i = 0; i < 1000; ++i) {
    const double number = numbers.uniform();
    EXPECT_EQ(number * 0x1p53, static_cast<double>(bits.bits() >> 11U));
    EXPECT_GE(number, 0.0);
    EXPECT_LT(number, 1.0);
  }
}

TEST(random, uniform_numbers_have_mean_and_variance_of_the_uniform_law) {
  constexpr int kCount = 100000;
  Random random(3);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double off = random.uniform() - 0.5;
    sum += off;
    squares += off * off;
  }
  // Four standard errors: of the mean sqrt(1/12/n), of the variance sqrt(1/180/n).
  EXPECT_NEAR(sum / kCount, 0.0, 4.0 * std::sqrt(1.0 / 12.0 / kCount));
  EXPECT_NEAR(squares / kCount, 1.0 / 12.0, 4.0 * std::sqrt(1.0 / 180.0 / kCount));
}

TEST(random, whole_numbers_below_a_count_are_equally_likely) {
  constexpr int kDraws = 60000, kSides = 6;
  Random random(11);
  std::vector<int> seen(kSides, 0);
  for (int i = 0; i < kDraws; ++i) ++seen.at(random.below(kSides));
  const double share = 1.0 / kSides;
  for (const int count : seen) {
    EXPECT_NEAR(count, kDraws * share, 4.0 * std::sqrt(kDraws * share * (1.0 - share)));
  }
}

TEST(random, neighbouring_seeds_share_nothing) {
  Random a(1), b(2);
  int equal_bits = 0;
  constexpr int kEnumNames = 1000;
  for (int i = 0; i < kEnumNames; ++i) equal_bits += 64 - __builtin_popcountll(a.bits() ^ b.bits());
  EXPECT_NEAR(equal_bits, 32 * kEnumNames, 4.0 * std::sqrt(16.0 * kEnumNames));
}

}  // namespace
}  // namespace overbend
