#include "base/interruption.h"

#include <gtest/gtest.h>

#include <thread>

namespace overbend {
namespace {

TEST(interruption, is_not_asked_for_at_first) {
  EXPECT_FALSE(interruption_wanted());
  EXPECT_NO_THROW(check_interruption());
}

TEST(interruption, a_scope_speaks_for_its_thread_and_for_what_it_contains) {
  bool stop = false;
  const InterruptionScope outer([&] { return stop; });
  EXPECT_FALSE(interruption_wanted());
  {
    const InterruptionScope inner([] { return false; });
    stop = true;
    EXPECT_THROW(check_interruption(), Interrupted);
  }
  EXPECT_THROW(check_interruption(), Interrupted);
  std::thread([] { EXPECT_FALSE(interruption_wanted()); }).join();
}

TEST(interruption, what_a_scope_asks_for_ends_with_it) {
  {
    const InterruptionScope scope([] { return true; });
  }
  EXPECT_FALSE(interruption_wanted());
}

TEST(interruption, what_was_interrupted_is_put_away_without_further_ones) {
  const InterruptionScope scope([] { return true; });
  {
    const UninterruptedScope put_away;
    EXPECT_FALSE(interruption_wanted());
    const InterruptionScope inner([] { return false; });
    EXPECT_FALSE(interruption_wanted());
  }
  EXPECT_TRUE(interruption_wanted());
}

TEST(interruption, of_a_thread_is_heard_by_those_it_starts) {
  bool stop = false;
  const InterruptionScope scope([&] { return stop; });
  const auto work = [&, asked = caller_interruption()] {
    const InterruptionScope interruption_scope(asked);
    return interruption_wanted();
  };
  bool before = true, after = false;
  std::thread([&] { before = work(); }).join();
  stop = true;
  std::thread([&] { after = work(); }).join();
  EXPECT_FALSE(before);
  EXPECT_TRUE(after);
}

}  // namespace
}  // namespace overbend
