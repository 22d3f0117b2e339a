#include "dynamics/integrator/energy_account.h"

#include <cmath>
#include <utility>

namespace overbend {
namespace {

/// Visits every number of an instant in a fixed order, for writing and reading.
template <class Instant, class Visit>
void visit(Instant& e, const Visit& visit_one) {
  visit_one(e.line.kinetic);
  visit_one(e.line.strain);
  visit_one(e.line.gravity);
  visit_one(e.line.seabed);
  visit_one(e.line.fluid_power);
  visit_one(e.line.seabed_loss);
  visit_one(e.line.line_loss);
  visit_one(e.contact);
  visit_one(e.roller_power);
  visit_one(e.contact_loss);
  visit_one(e.friction_loss);
  visit_one(e.top_power);
  visit_one(e.anchor_power);
  visit_one(e.bending_heat);
  visit_one(e.bodies.kinetic);
  visit_one(e.bodies.stored);
  visit_one(e.bodies.power);
}

template <class Balance, class Visit>
void visit_balance(Balance& b, const Visit& visit_one) {
  visit_one(b.kinetic);
  visit_one(b.strain);
  visit_one(b.gravity);
  visit_one(b.contact);
  visit_one(b.seabed);
  visit_one(b.fluid);
  visit_one(b.rollers);
  visit_one(b.top);
  visit_one(b.anchor);
  visit_one(b.contact_loss);
  visit_one(b.friction_loss);
  visit_one(b.seabed_loss);
  visit_one(b.yielding_loss);
  visit_one(b.line_loss);
  visit_one(b.error);
  visit_one(b.throughput);
}

bool moves(const BodyEnergy& e) {
  return e.kinetic != 0.0 || e.stored != 0.0 || e.power != 0.0;
}

}  // namespace

void EnergyAccount::start(const Assembly& assembly, const SystemState& state, double min_energy, bool free_bodies) {
  start(assembly.energy(state), min_energy, free_bodies);
  find_work_points(assembly, state);
  last_ends_ = ends_;
  last_points_ = points_;
}

void EnergyAccount::find_work_points(const Assembly& assembly, const SystemState& state) {
  assembly.find_working_ends(state, ends_);
  points_.clear();
  for (std::size_t i = 0; i < state.lines.size(); ++i) {
    add_strain_points(assembly.line(i).elements(), state.lines[i].q.data(), state.lines[i].v.data(), points_);
  }
}

void EnergyAccount::start(const InstantEnergy& first, double min_energy, bool free_bodies) {
  first_ = last_ = first;
  balance_ = {};
  if (free_bodies) balance_.bodies = balance_.on_bodies = 0.0;
  balance_.throughput = min_energy;
}

/// Work on the last or the first ends along their displacement, in excess of the trapezoidal rule.
double EnergyAccount::work_along_displacement(bool last, double h) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < ends_.size(); ++i) {
    const WorkingEnd &from = last_ends_[i], &to = ends_[i];
    if (from.last != last) continue;
    sum -= 0.5 * h * (from.power + to.power);
    for (std::size_t k = 0; k < from.force.size(); ++k) {
      sum += 0.5 * (from.force[k] + to.force[k]) * (to.place[k] - from.place[k]);
    }
  }
  return sum;
}

/// Internal damping loss along the change of strains, in excess of the trapezoidal rule.
double EnergyAccount::damping_loss_along_strain(double h) const {
  double sum = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const StrainPoint &from = last_points_[i], &to = points_[i];
    sum += 0.5 * ((from.damping + to.damping) * (to.strain - from.strain) - h * (from.power + to.power));
  }
  return sum;
}

void EnergyAccount::add(const Assembly& assembly, const SystemState& state, double h) {
  find_work_points(assembly, state);
  add(assembly.energy(state), h);
  std::swap(last_ends_, ends_);
  std::swap(last_points_, points_);
}

void EnergyAccount::add(const InstantEnergy& instant, double h) {
  EnergyBalance& b = balance_;
  b.kinetic = instant.line.kinetic - first_.line.kinetic;
  b.strain = instant.line.strain - first_.line.strain;
  b.gravity = instant.line.gravity - first_.line.gravity;
  b.contact = instant.contact - first_.contact;
  b.seabed = instant.line.seabed - first_.line.seabed;
  const auto integrate = [&](double& sum, double before, double after, double beyond = 0.0) {
    const double part = 0.5 * h * (before + after) + beyond;
    sum += part;
    b.throughput += std::abs(part);
  };
  integrate(b.fluid, last_.line.fluid_power, instant.line.fluid_power);
  integrate(b.rollers, last_.roller_power, instant.roller_power);
  integrate(b.top, last_.top_power, instant.top_power, work_along_displacement(true, h));
  integrate(b.anchor, last_.anchor_power, instant.anchor_power, work_along_displacement(false, h));
  // A body that has energy is free, even if not declared so at the start.
  if (!b.bodies && moves(instant.bodies)) b.bodies = b.on_bodies = 0.0;
  if (b.bodies && b.on_bodies) {
    b.bodies = instant.bodies.kinetic + instant.bodies.stored - first_.bodies.kinetic - first_.bodies.stored;
    integrate(*b.on_bodies, last_.bodies.power, instant.bodies.power);
  }
  integrate(b.contact_loss, last_.contact_loss, instant.contact_loss);
  integrate(b.friction_loss, last_.friction_loss, instant.friction_loss);
  integrate(b.seabed_loss, last_.line.seabed_loss, instant.line.seabed_loss);
  integrate(b.line_loss, last_.line.line_loss, instant.line.line_loss, damping_loss_along_strain(h));
  b.yielding_loss = instant.bending_heat - first_.bending_heat;
  b.throughput += instant.bending_heat - last_.bending_heat;
  b.error = b.kinetic + b.strain + b.gravity + b.contact + b.seabed + b.contact_loss + b.friction_loss + b.seabed_loss +
            b.yielding_loss + b.line_loss - b.fluid - b.rollers - b.top - b.anchor +
            (b.bodies.value_or(0.0) - b.on_bodies.value_or(0.0));
  last_ = instant;
}

void EnergyAccount::carry(const InstantEnergy& before, const Assembly& assembly, const SystemState& state) {
  carry(before, assembly.energy(state));
  find_work_points(assembly, state);
  for (std::size_t i = 0; i < ends_.size(); ++i) last_ends_[i].place = ends_[i].place;
  last_points_ = points_;
}

void EnergyAccount::carry(const InstantEnergy& before, const InstantEnergy& after) {
  first_.line.kinetic += after.line.kinetic - before.line.kinetic;
  first_.line.strain += after.line.strain - before.line.strain;
  first_.line.gravity += after.line.gravity - before.line.gravity;
  first_.line.seabed += after.line.seabed - before.line.seabed;
  first_.contact += after.contact - before.contact;
  first_.bending_heat += after.bending_heat - before.bending_heat;
  last_ = after;
  // Keep the power at the end: at the instant itself a kink between the pipe and the incoming material causes forces
  // there that no step has balanced yet.
  last_.top_power = before.top_power;
  last_.anchor_power = before.anchor_power;
}

std::vector<double> EnergyAccount::save() const {
  std::vector<double> out;
  const auto put = [&](double value) { out.push_back(value); };
  visit(first_, put);
  visit(last_, put);
  visit_balance(balance_, put);
  for (const WorkingEnd& end : last_ends_) {
    out.insert(out.end(), end.force.begin(), end.force.end());
    out.insert(out.end(), end.place.begin(), end.place.end());
    out.push_back(end.power);
  }
  put(static_cast<double>(last_points_.size()));
  for (const StrainPoint& point : last_points_) out.insert(out.end(), {point.strain, point.damping, point.power});
  put(balance_.bodies ? 1.0 : 0.0);
  put(balance_.bodies.value_or(0.0));
  put(balance_.on_bodies.value_or(0.0));
  return out;
}

void EnergyAccount::restore(const std::vector<double>& saved) {
  std::size_t i = 0;
  const auto take = [&](double& value) { value = saved.at(i++); };
  visit(first_, take);
  visit(last_, take);
  visit_balance(balance_, take);
  for (WorkingEnd& end : last_ends_) {
    for (double& value : end.force) take(value);
    for (double& value : end.place) take(value);
    take(end.power);
  }
  last_points_.resize(static_cast<std::size_t>(saved.at(i++)));
  for (StrainPoint& point : last_points_) {
    for (double* value : {&point.strain, &point.damping, &point.power}) take(*value);
  }
  const bool free_bodies = saved.at(i++) != 0.0;
  double bodies = 0.0, on_bodies = 0.0;
  take(bodies);
  take(on_bodies);
  balance_.bodies = free_bodies ? std::optional(bodies) : std::nullopt;
  balance_.on_bodies = free_bodies ? std::optional(on_bodies) : std::nullopt;
}

}  // namespace overbend
