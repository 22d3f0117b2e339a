#include "base/interruption.h"

#include <gtest/gtest.h>

#include <thread>

namespace overbend {
namespace {

TEST(interruption, nobody_asks_for_it_at_first) {
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

TEST(interruption, of_the_process_is_heard_by_all_threads) {
  interrupt_process(true);
  bool heard = false;
  std::thread([&] { heard = interruption_wanted(); }).join();
  EXPECT_TRUE(heard && interruption_wanted());
  interrupt_process(false);
  EXPECT_FALSE(interruption_wanted());
}

}  // namespace
}  // namespace overbend
