#include "base/require.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace overbend {
namespace {

TEST(require, a_promise_that_holds_costs_nothing_and_says_nothing) {
  EXPECT_NO_THROW(require(true, "one is one"));
}

// Also in release builds, where assert is silent.
TEST(require, a_broken_promise_stops_with_its_message_and_its_place) {
  try {
    require(false, "the file has been flushed");
    FAIL() << "it went on";
  } catch (const std::logic_error& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("the file has been flushed"), std::string::npos) << said;
    EXPECT_NE(said.find("require_test.cpp:" + std::to_string(__LINE__ - 5)), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace overbend
