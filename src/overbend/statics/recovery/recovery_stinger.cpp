#include "statics/recovery/recovery_stinger.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "statics/stinger/stinger_equilibrium.h"

namespace overbend {
namespace {

constexpr double kAtStop = 1e-9;  ///< [rad]

StingerTankResult recover_tank(const Model& model, std::size_t section, const StingerTankDescription& tank) {
  const FloatingTank floats = floating_tank(model, section, tank);
  const VesselDescription& vessel = model.description.vessel;
  const Vec3 shoe_V(vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z);
  const Vec3 from_shoe_V = model.mean_pose.R_WV.transpose() * (floats.buoyancy_at_W - model.mean_pose.p_WV) - shoe_V;
  StingerTankResult result;
  result.name = tank.name;
  result.weight = floats.weight;
  result.buoyancy = floats.buoyancy;
  result.at_x = -from_shoe_V.x();
  result.at_z = from_shoe_V.z();
  result.submerged = floats.submerged;
  result.draught = floats.draught;
  return result;
}

Vec3 sum_forces(const std::vector<PointForce>& forces) {
  Vec3 sum = Vec3::Zero();
  for (const PointForce& force : forces) sum += force.force_W;
  return sum;
}

Vec3 find_tip(const Model& model, std::size_t section) {
  Vec3 tip_S = model.supports.sections[section].hinge_S;
  for (const SupportRow& row : model.supports.rows) {
    if (model.supports.boxes[static_cast<std::size_t>(row.box)].section == static_cast<int>(section)) {
      tip_S = row.point_S;
    }
  }
  return point_from_ramp(model, model.mean_pose, tip_S);
}

/// True if a stop holds the section against its moment.
bool held_by_stop(const StingerSectionDescription& section, double angle, double moment) {
  if (!section.limits) return false;
  return (moment > 0.0 && angle > section.limits->down - kAtStop) ||
         (moment < 0.0 && angle < section.limits->up + kAtStop);
}

/// Natural period of small motions of one section with the others held.
void recover_period(StingerSectionResult& result, const Model& model, std::size_t section, double stiffness) {
  result.stiffness = stiffness;
  const double inertia = inertia_about_hinge(model, section);
  if (stiffness > 0.0 && inertia > 0.0) result.natural_period = 2.0 * std::numbers::pi * std::sqrt(inertia / stiffness);
}

StingerSectionResult recover_section(const Model& model, const StaticSolution& solution, std::size_t section,
                                     const std::vector<std::vector<PointForce>>& pipe) {
  const StingerSectionDescription& described = model.description.supports.sections[section];
  const HingeAxis hinge = hinge_axis(model, section);
  StingerSectionResult result;
  result.name = described.name;
  result.angle = model.supports.sections[section].angle;
  result.floats = described.floats() && !described.angle;
  result.hinge_W = hinge.at_W;
  double moment = 0.0;
  Vec3 force = Vec3::Zero();
  for (std::size_t behind = section; behind < pipe.size(); ++behind) {
    const std::vector<PointForce> others = section_forces(model, behind);
    result.roller_moment += moment_about(hinge, pipe[behind]);
    moment += moment_about(hinge, pipe[behind]) + moment_about(hinge, others);
    force += sum_forces(pipe[behind]) + sum_forces(others);
  }
  result.hinge_longitudinal = -force.dot(astern_direction(model.mean_pose));
  result.hinge_vertical = -force.z();
  result.hinge_force = force.norm();
  result.at_stop = result.floats && held_by_stop(described, result.angle, moment);
  if (result.at_stop || !result.floats) result.stop_moment = -moment;
  result.friction_moment = described.hinge_friction;
  const StingerEquilibrium& rest = solution.stinger;
  result.angle_up = section < rest.angle_up.size() ? rest.angle_up[section] : result.angle;
  result.angle_down = section < rest.angle_down.size() ? rest.angle_down[section] : result.angle;
  result.tip_W = find_tip(model, section);
  for (const StingerTankDescription& tank : described.tanks) {
    result.tanks.push_back(recover_tank(model, section, tank));
    result.draught = std::max(result.draught, result.tanks.back().draught);
  }
  return result;
}

std::string section_label(const StingerSectionResult& section) {
  return section.name.empty() ? "the stinger" : "stinger section '" + section.name + "'";
}

void add_section_findings(StaticResults& results, const StingerSectionResult& section, bool touched) {
  if (section.at_stop) {
    results.findings.push_back(Finding{
        FindingCode::stinger_at_stop,
        fmt::format("{} lies at its {} stop, which carries {}", section_label(section),
                    section.stop_moment < 0.0 ? "lower" : "upper", shown(std::abs(section.stop_moment), "N m", 0))}
                                   .on(section_label(section))
                                   .with("moment", section.stop_moment, "N m"));
  }
  if (section.floats && !touched) {
    results.findings.push_back(
        Finding{FindingCode::stinger_clear_of_pipe,
                fmt::format("{} hangs free at an angle of {:.2f} deg: the pipe does not touch its rollers",
                            section_label(section), section.angle / kDegree)}
            .on(section_label(section))
            .with("angle", section.angle, "rad"));
  }
  if (section.floats && section.stiffness <= 0.0) {
    results.findings.push_back(
        Finding{FindingCode::stinger_unstable,
                fmt::format("{} is in unstable equilibrium: a small rotation grows", section_label(section))}
            .on(section_label(section)));
  }
}

}  // namespace

void recover_stinger(StaticResults& results, const StaticSystem& system, const StaticSolution& solution) {
  const Model& model = system.model();
  const std::size_t count = model.supports.sections.size();
  if (count == 0) return;
  const std::vector<std::vector<PointForce>> pipe = pipe_on_sections(system);
  const std::vector<std::size_t> floating = floating_sections(model.description.supports);
  const bool measured = solution.stinger.stiffness.size() == floating.size() * floating.size();
  for (std::size_t i = 0; i < count; ++i) {
    StingerSectionResult section = recover_section(model, solution, i, pipe);
    const auto position = std::find(floating.begin(), floating.end(), i);
    if (measured && position != floating.end()) {
      const auto k = static_cast<std::size_t>(position - floating.begin());
      recover_period(section, model, i, solution.stinger.stiffness[k * floating.size() + k]);
    }
    add_section_findings(results, section, !pipe[i].empty());
    results.stinger.push_back(std::move(section));
  }
  results.findings.insert(results.findings.end(), solution.stinger.findings.begin(), solution.stinger.findings.end());
}

}  // namespace overbend
