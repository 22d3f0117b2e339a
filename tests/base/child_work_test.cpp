#include "base/child_work.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <thread>
#include <vector>

#include "base/interruption.h"

namespace overbend {
namespace {

std::string done(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  return ChildWork(work, limits).result();
}

std::string failure(const std::function<std::string()>& work, const ChildLimits& limits = {}) {
  try {
    done(work, limits);
  } catch (const ChildError& error) {
    return error.what();
  }
  return "none";
}

TEST(child_work, hands_bytes_back) {
  EXPECT_EQ(done([] { return std::string("a\0b", 3); }), std::string("a\0b", 3));
  EXPECT_EQ(done([] { return std::string(); }), "");
  const std::string large(std::size_t{5} << 20U, 'x');  // more than a pipe holds
  EXPECT_EQ(done([&] { return large; }), large);
}

TEST(child_work, leaves_this_process_as_it_was) {
  int number = 1;
  EXPECT_EQ(done([&] { return std::to_string(++number); }), "2");
  EXPECT_EQ(number, 1);
}

TEST(child_work, what_is_thrown_comes_back_as_its_message) {
  const auto work = []() -> std::string { throw std::runtime_error("no such variable"); };
  EXPECT_THROW(
      {
        try {
          done(work);
        } catch (const std::runtime_error& thrown) {
          EXPECT_STREQ(thrown.what(), "no such variable");
          throw;
        }
      },
      std::runtime_error);
}

TEST(child_work, a_crash_is_an_error) {
  const auto ends_by = [](int number) {
    return failure([number]() -> std::string {
      std::raise(number);
      return "";
    });
  };
  EXPECT_EQ(ends_by(SIGSEGV), "reading it ended with signal 11");
  EXPECT_EQ(ends_by(SIGABRT), "reading it ended with signal 6");
  EXPECT_EQ(ends_by(SIGKILL), "reading it ended with signal 9");
  EXPECT_NE(failure([]() -> std::string { std::_Exit(0); }), "none");
}

TEST(child_work, work_without_end_is_ended) {
  volatile bool forever = true;
  const auto work = [&] {
    while (forever) {
    }
    return std::string();
  };
  EXPECT_EQ(failure(work, {.cpu_time = std::chrono::seconds(1)}), "reading it takes too long");
  const auto wait = [] {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return std::string();
  };
  EXPECT_EQ(failure(wait, {.wall_time = std::chrono::seconds(1)}), "reading it takes too long");
}

TEST(child_work, more_memory_than_allowed_is_an_error) {
  const auto work = [] { return std::to_string(std::vector<double>(std::size_t{1} << 29U, 1.0).back()); };  // 4 GB
  EXPECT_THROW(done(work, {.memory = std::size_t{1} << 28U}), std::runtime_error);
}

TEST(child_work, an_interruption_ends_the_wait) {
  bool stop = false;
  const InterruptionScope scope([&] { return stop; });
  ChildWork work(
      [] {
        std::this_thread::sleep_for(std::chrono::hours(1));
        return std::string();
      },
      {});
  stop = true;
  EXPECT_THROW(work.result(), Interrupted);
}

TEST(child_work, serves_several_threads_at_a_time) {
  std::vector<std::string> found(8);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < found.size(); ++i) {
    threads.emplace_back([&found, i] {
      for (int k = 0; k < 10; ++k) found[i] += done([i] { return std::to_string(i); });
    });
  }
  for (std::thread& thread : threads) thread.join();
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], std::string(10, static_cast<char>('0' + i)));
}

}  // namespace
}  // namespace overbend
