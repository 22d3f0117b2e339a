#include "results/result_enum_names.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

template <class Enum>
void expect_names_round_trip() {
  for (const auto& [value, text] : ResultEnumNames<Enum>::list) {
    Enum found{};
    EXPECT_TRUE(from_enum_name(word(value), found)) << text;
    EXPECT_EQ(found, value) << text;
  }
}

TEST(label, lead_back_to_their_enumerators) {
  expect_names_round_trip<Region>();
  expect_names_round_trip<CheckRegion>();
  expect_names_round_trip<CheckStatus>();
  expect_names_round_trip<RollerPosition>();
  expect_names_round_trip<Structure>();
  Region unchanged = Region::sagbend;
  EXPECT_FALSE(from_enum_name("nowhere", unchanged));
  EXPECT_EQ(unchanged, Region::sagbend);
}

}  // namespace
}  // namespace overbend
