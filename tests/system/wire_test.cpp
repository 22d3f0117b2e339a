#include "system/wire.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

TEST(wire_pull, grows_with_the_stretch) {
  const Wire wire{"wire", kGround, kGround, Vec3::Zero(), Vec3::Zero(), 10.0, 5000.0, std::nullopt};
  const WirePull pull = wire_pull(wire, Vec3(1.0, 2.0, 3.0), Vec3(1.0, 2.0, 13.5));
  EXPECT_NEAR(pull.tension, 250.0, 1e-9);
  EXPECT_NEAR((pull.force - Vec3(0.0, 0.0, 250.0)).norm(), 0.0, 1e-9);
  EXPECT_DOUBLE_EQ(pull.span, 10.5);
}

TEST(wire_pull, is_none_where_the_ends_are_nearer_than_its_length) {
  const Wire wire{"wire", kGround, kGround, Vec3::Zero(), Vec3::Zero(), 10.0, 5000.0, std::nullopt};
  for (const double span : {0.0, 9.0, 10.0}) {
    const WirePull pull = wire_pull(wire, Vec3::Zero(), Vec3(span, 0.0, 0.0));
    EXPECT_EQ(pull.tension, 0.0);
    EXPECT_EQ(pull.force, Vec3(Vec3::Zero()));
    EXPECT_EQ(pull.stiffness, Mat3(Mat3::Zero()));
  }
}

TEST(wire_pull, has_its_derivative_for_stiffness) {
  Wire wire{"wire", kGround, kGround, Vec3::Zero(), Vec3::Zero(), 3.0, 5000.0, std::nullopt};
  const Vec3 first(0.3, -0.2, 0.5), second(2.5, 1.8, 2.2);
  for (const std::optional<double> held : {std::optional<double>(), std::optional<double>(700.0)}) {
    wire.held_tension = held;
    const WirePull pull = wire_pull(wire, first, second);
    ASSERT_GT(pull.tension, 0.0);
    for (int i = 0; i < 3; ++i) {
      const Vec3 step = 1e-6 * Vec3::Unit(i);
      const Vec3 more = wire_pull(wire, first, second + step).force, less = wire_pull(wire, first, second - step).force;
      EXPECT_LT(((more - less) / 2e-6 - pull.stiffness.col(i)).norm(), 1e-8 * pull.stiffness.norm());
    }
  }
}

TEST(wire_pull, is_what_its_winch_holds_whatever_its_length) {
  const Wire wire{"wire", kGround, kGround, Vec3::Zero(), Vec3::Zero(), 10.0, 5000.0, 300.0};
  EXPECT_EQ(wire_pull(wire, Vec3::Zero(), Vec3(0.0, 8.0, 0.0)).force, Vec3(0.0, 300.0, 0.0));
}

}  // namespace
}  // namespace overbend
