#include "dynamics/energy_account.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

/// A mass of 2 kg pulled by 3 N from rest, resisted by friction of 1 N: v = t, s = t^2/2.
InstantEnergy pulled(double t) {
  InstantEnergy now;
  now.line.kinetic = t * t;
  now.top_power = 3.0 * t;
  now.friction_loss = 1.0 * t;
  return now;
}

EnergyAccount account_until(double end, int steps) {
  EnergyAccount account;
  account.start(pulled(0.0), 1e-9);
  for (int i = 1; i <= steps; ++i) account.add(pulled(end * i / steps), end / steps);
  return account;
}

TEST(energy_account, closes_where_work_in_is_motion_and_friction) {
  const EnergyBalance balance = account_until(4.0, 7).balance();
  EXPECT_NEAR(balance.kinetic, 16.0, 1e-12);
  EXPECT_NEAR(balance.top, 24.0, 1e-12);  // powers are linear in time: the trapezoidal rule is exact
  EXPECT_NEAR(balance.friction_loss, 8.0, 1e-12);
  EXPECT_NEAR(balance.error, 0.0, 1e-12);
  EXPECT_NEAR(balance.throughput, 32.0, 1e-8);
}

TEST(energy_account, shows_energy_that_nothing_accounts_for) {
  EnergyAccount account;
  account.start(pulled(0.0), 1e-9);
  InstantEnergy heated = pulled(1.0);
  heated.line.strain = 0.5;
  account.add(heated, 1.0);
  EXPECT_NEAR(account.balance().error, 0.5, 1e-12);
  EXPECT_NEAR(account.balance().drift(), 0.5 / 2.0, 1e-8);
}

TEST(energy_account, what_material_brings_with_it_is_no_error) {
  const auto heavier = [](double t) {  // something that moves and is stretched joins
    InstantEnergy now = pulled(t);
    now.line.kinetic += 0.3;
    now.line.strain += 5.0;
    now.line.gravity -= 2.0;
    return now;
  };
  EnergyAccount account = account_until(2.0, 3);
  account.carry(pulled(2.0), heavier(2.0));
  account.add(heavier(3.0), 1.0);
  EXPECT_NEAR(account.balance().error, 0.0, 1e-12);
  EXPECT_NEAR(account.balance().kinetic, 9.0, 1e-12);
  EXPECT_NEAR(account.balance().strain, 0.0, 1e-12);
}

TEST(energy_account, goes_on_from_what_was_saved) {
  const EnergyAccount before = account_until(2.0, 3);
  EnergyAccount restored;
  restored.restore(before.save());
  EnergyAccount straight = before;
  straight.add(pulled(3.0), 1.0);
  restored.add(pulled(3.0), 1.0);
  EXPECT_EQ(straight.save(), restored.save());
}

}  // namespace
}  // namespace overbend
