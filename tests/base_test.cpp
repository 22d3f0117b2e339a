#include <gtest/gtest.h>
TEST(base, build_works) { EXPECT_EQ(1, 1); }
