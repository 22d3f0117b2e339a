#include "study/prepared_case.h"

#include <gtest/gtest.h>

#include "study/case.h"
#include "support/bgl1_in_time.h"

namespace overbend {
namespace {

class Nothing : public Controller {
 public:
  MachineCommand command(const MachineReading& /*seen*/) override { return {}; }
};

std::string input_with(const std::vector<ControllerUse>& controllers) {
  return std::get<0>(prepare_case(testing::workable(), controllers))->input;
}

TEST(prepared_case, is_another_input_with_controllers_and_with_each_machine_and_interval) {
  Nothing nothing;
  const std::string alone = input_with({});
  const std::string driven = input_with({{"tensioner", &nothing, 0.1}});
  EXPECT_NE(driven, alone);
  EXPECT_EQ(driven, input_with({{"tensioner", &nothing, 0.1}}));
  EXPECT_NE(driven, input_with({{"tensioner", &nothing, 0.2}}));
  EXPECT_NE(driven, input_with({{"bow", &nothing, 0.1}}));
}

TEST(prepared_case, of_cases_with_controllers_is_never_shared) {
  Nothing nothing;
  Case first, second;
  EXPECT_TRUE(same_model(first, second));
  second.controllers = {{"tensioner", &nothing, 0.1}};
  EXPECT_FALSE(same_model(first, second));
  first.controllers = second.controllers;
  EXPECT_FALSE(same_model(first, second));
}

}  // namespace
}  // namespace overbend
