#include "platform/machine.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(machine, runs_at_least_one_thread) {
  EXPECT_GE(hardware_threads(), 1U);
  EXPECT_LT(hardware_threads(), 100'000U);
}

TEST(machine, has_a_name_of_system_release_and_architecture) {
  const std::string name = machine_name();
  EXPECT_NE(name.find(' '), std::string::npos) << name;
  EXPECT_NE(name.find("64"), std::string::npos) << name;
}

TEST(machine, local_time_is_that_of_the_time_zone) {
  const std::time_t time = 1'700'000'000;  // 14 November 2023, 22:13:20 UTC
  std::tm local = local_time(time);
  EXPECT_EQ(local.tm_year, 123);
  EXPECT_EQ(local.tm_sec, 20);
  EXPECT_EQ(std::mktime(&local), time);
}

}  // namespace
}  // namespace overbend
