#include "base/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "base/interruption.h"

namespace overbend {
namespace {

TEST(threads, all_do_the_work_this_one_among_them) {
  std::mutex mutex;
  std::set<std::thread::id> seen;
  std::atomic<int> shifted{0};
  work_in_threads(4, [&] {
    ++shifted;
    while (shifted < 4) std::this_thread::yield();  // all at a time
    const std::lock_guard<std::mutex> hold(mutex);
    seen.insert(std::this_thread::get_id());
  });
  EXPECT_EQ(seen.size(), 4U);
  EXPECT_TRUE(seen.contains(std::this_thread::get_id()));
}

TEST(threads, what_one_throws_is_thrown_when_all_have_ended) {
  std::atomic<int> begun{0}, ended{0};
  const auto work = [&] {
    if (begun++ == 0) throw std::runtime_error("the first");
    ++ended;
  };
  EXPECT_THROW(work_in_threads(3, work), std::runtime_error);
  EXPECT_EQ(ended, 2);
}

TEST(threads, what_interrupts_one_interrupts_all) {
  const InterruptionScope scope([] { return true; });
  std::atomic<int> heard{0};
  work_in_threads(3, [&] { heard += interruption_wanted() ? 1 : 0; });
  EXPECT_EQ(heard, 3);
}

TEST(threads, are_as_many_as_asked_for_but_no_more_than_there_is_to_do) {
  EXPECT_EQ(useful_threads(3, 100), 3U);
  EXPECT_EQ(useful_threads(8, 2), 2U);
  EXPECT_EQ(useful_threads(8, 0), 1U);
  EXPECT_GE(useful_threads(0, 1000), 1U);
}

}  // namespace
}  // namespace overbend
