#include "dynamics/integrator/energy_account.h"

#include <gtest/gtest.h>

#include <cmath>

namespace overbend {
namespace {

/// A mass of 2 kg pulled by 3 N from rest, resisted by friction of 1 N: v = t, s = t^2/2.
InstantEnergy pulled(double t) {
  InstantEnergy instant_energy;
  instant_energy.line.kinetic = t * t;
  instant_energy.top_power = 3.0 * t;
  instant_energy.friction_loss = 1.0 * t;
  return instant_energy;
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
    InstantEnergy instant_energy = pulled(t);
    instant_energy.line.kinetic += 0.3;
    instant_energy.line.strain += 5.0;
    instant_energy.line.gravity -= 2.0;
    return instant_energy;
  };
  EnergyAccount account = account_until(2.0, 3);
  account.carry(pulled(2.0), heavier(2.0));
  account.add(heavier(3.0), 1.0);
  EXPECT_NEAR(account.balance().error, 0.0, 1e-12);
  EXPECT_NEAR(account.balance().kinetic, 9.0, 1e-12);
  EXPECT_NEAR(account.balance().strain, 0.0, 1e-12);
}

TEST(energy_account, what_holds_the_ends_does_no_work_by_a_kink_that_comes_in) {
  const auto kinked = [](double t) {
    InstantEnergy instant_energy = pulled(t);
    instant_energy.line.strain += 5.0;
    return instant_energy;
  };
  EnergyAccount account = account_until(2.0, 3);
  InstantEnergy at_once = kinked(2.0);
  at_once.top_power = -4e6;
  at_once.anchor_power = 3e5;
  account.carry(pulled(2.0), at_once);
  account.add(kinked(3.0), 1.0);
  EXPECT_NEAR(account.balance().error, 0.0, 1e-12);
  EXPECT_NEAR(account.balance().top, 13.5, 1e-12);
}

/// The same, and a free body of 4 kg that waves push with 8 N from rest.
InstantEnergy account_with_body(double t) {
  InstantEnergy instant_energy = pulled(t);
  instant_energy.bodies.kinetic = 8.0 * t * t;
  instant_energy.bodies.power = 16.0 * t;
  return instant_energy;
}

double shown_in(const EnergyBalance& b) {
  return b.fluid + b.rollers + b.top + b.anchor + b.on_bodies.value_or(0.0);
}
double shown_stored(const EnergyBalance& b) {
  return b.kinetic + b.strain + b.gravity + b.contact + b.seabed + b.bodies.value_or(0.0);
}
double shown_lost(const EnergyBalance& b) {
  return b.contact_loss + b.friction_loss + b.seabed_loss + b.yielding_loss;
}

TEST(energy_account, reports_what_free_bodies_hold_and_were_given_so_that_its_parts_make_its_error) {
  EnergyAccount account;
  account.start(account_with_body(0.0), 1e-9, true);
  for (int i = 1; i <= 4; ++i) account.add(account_with_body(0.5 * i), 0.5);
  InstantEnergy heated = account_with_body(3.0);
  heated.line.strain = 0.5;
  account.add(heated, 1.0);
  const EnergyBalance& b = account.balance();
  EXPECT_NEAR(b.bodies.value(), 72.0, 1e-12);
  EXPECT_NEAR(b.on_bodies.value(), 72.0, 1e-12);
  EXPECT_NEAR(b.error, 0.5, 1e-12);
  EXPECT_NEAR(shown_stored(b) + shown_lost(b) - shown_in(b), b.error, 1e-12);
  EXPECT_FALSE(account_until(1.0, 2).balance().bodies);

  EnergyAccount untold;  // that a body is free is seen by its energy
  untold.start(account_with_body(0.0), 1e-9);
  untold.add(account_with_body(2.0), 2.0);
  EXPECT_NEAR(untold.balance().bodies.value(), 32.0, 1e-12);
  EXPECT_NEAR(untold.balance().error, 0.0, 1e-12);
}

TEST(energy_account, goes_on_from_what_was_saved) {
  const EnergyAccount before = account_until(2.0, 3);
  EnergyAccount restored;
  restored.restore(before.save());
  EnergyAccount straight = before;
  straight.add(pulled(3.0), 1.0);
  restored.add(pulled(3.0), 1.0);
  EXPECT_EQ(straight.save(), restored.save());

  EnergyAccount with_body;
  with_body.start(account_with_body(0.0), 1e-9, true);
  with_body.add(account_with_body(1.0), 1.0);
  restored.restore(with_body.save());
  EXPECT_EQ(restored.balance().on_bodies, with_body.balance().on_bodies);
}

}  // namespace
}  // namespace overbend
