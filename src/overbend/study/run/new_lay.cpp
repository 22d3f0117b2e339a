#include "study/run/new_lay.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

constexpr double kMinTowerAngle = 45.0 * kDegree;  ///< Minimum angle of a J-lay tower from horizontal [rad].
constexpr int kTrials = 16;                        ///< Maximum number of lays calculated; most take two or three.

/// Reasons against a lay; empty if it has a solution and passes.
struct LayIssues {
  std::string no_solution;
  std::vector<CheckRow> exceeded;
  double top_inclination = 0.0;  ///< Inclination of the pipe at the tensioner [rad].

  bool passed() const { return no_solution.empty() && exceeded.empty(); }
  std::string message() const {
    if (!no_solution.empty()) return no_solution;
    const auto worst = ranges::max_element(exceeded, {}, &CheckRow::utilisation);
    return fmt::format("{} ({}) is exceeded, utilisation {:.2f}", worst->name, worst->code, worst->utilisation);
  }
};

LayIssues evaluate_lay(const Description& description) {
  Model model = build_model(description);
  const ModelEquilibrium outcome = solve_lay(model);
  LayIssues issues;
  if (!outcome.solution) {
    issues.no_solution = outcome.failure->what;
    return issues;
  }
  const StaticResults results = checked_statics(model, outcome);
  issues.top_inclination = results.stations.back().inclination;
  for (const CheckRow& row : results.checks.rows) {
    if (row.governing && row.status == CheckStatus::exceeded) issues.exceeded.push_back(row);
  }
  return issues;
}

/// True for the quantities that the user left open.
struct OpenQuantities {
  bool wall, tension, radius;
};

/// Quantity that corrects an exceeded check: a wider stinger over the supports, more tension if the sagbend bends too
/// sharply, else a thicker wall: at the seabed, where the pipe is nearly straight, pressure alone governs.
enum class Correction { wall, tension, radius };

Correction find_correction(const CheckRow& row, const LayIssues& issues) {
  if (row.region == CheckRegion::overbend || row.region == CheckRegion::tip) return Correction::radius;
  if (row.region != CheckRegion::sagbend) return Correction::wall;
  const bool straight_too = ranges::any_of(issues.exceeded, [](const CheckRow& check) {
    return check.region == CheckRegion::seabed || check.region == CheckRegion::line;
  });
  return straight_too ? Correction::wall : Correction::tension;
}

/// Adjusts the margins for exceeded checks: each quantity once, by the worst check that requires it. False if none of
/// them may be changed.
bool adjust_margins(NewMargins& margins, const LayIssues& issues, const OpenQuantities& free) {
  double wall = 0.0, tension = 0.0, radius = 0.0;
  for (const CheckRow& row : issues.exceeded) {
    Correction correction = find_correction(row, issues);
    if (correction == Correction::tension && !free.tension) correction = Correction::wall;
    if (correction == Correction::wall && !free.wall && row.region == CheckRegion::sagbend) {
      correction = Correction::tension;
    }
    double& asked = correction == Correction::wall ? wall : correction == Correction::tension ? tension : radius;
    asked = std::max(asked, row.utilisation);
  }
  const NewMargins before = margins;
  if (free.wall && wall > 0.0) margins.walls += wall > 1.25 ? 2 : 1;
  if (free.tension && tension > 0.0) margins.tension *= std::clamp(1.05 * tension, 1.1, 2.0);
  if (free.radius && radius > 0.0) margins.radius *= std::clamp(1.02 * radius, 1.05, 1.5);
  return margins.walls > before.walls || margins.tension > before.tension || margins.radius > before.radius;
}

bool is_tower_feasible(const NewModel& model) {
  return model.stinger || model.departure_angle >= kMinTowerAngle;
}

std::string tower_angle_message(const NewModel& model) {
  return fmt::format(
      "--lay: with a tension of {}, which the sagbend checks require, the pipe leaves at {:.0f} degrees from "
      "horizontal, but no tower is inclined below {:.0f}; expected s, or deeper water",
      shown_digits(model.tension, "N", 4), model.departure_angle / kDegree, kMinTowerAngle / kDegree);
}

}  // namespace

std::variant<NewLay, std::string> choose_lay(const NewOptions& options) {
  const OpenQuantities free{options.wall.empty(), options.tension.empty(), options.stinger_radius.empty()};
  NewMargins margins;
  NewLay lay;
  std::string against;
  for (int trial = 0; trial < kTrials; ++trial) {
    std::variant<NewModel, std::string> chosen = choose_model(options, margins);
    if (auto* why = std::get_if<std::string>(&chosen)) {
      return against.empty() ? *why : fmt::format("{} (with the previous values, {})", *why, against);
    }
    lay.model = std::get<NewModel>(chosen);
    lay.text = model_text(lay.model);
    const ModelReading reading = read_model_text(lay.text, "model.yaml");
    if (!reading.description) {
      return "these values do not make a valid model:\n" + reading.diagnostics.lines(Severity::error).front();
    }
    const LayIssues issues = evaluate_lay(*reading.description);
    if (!lay.model.stinger &&
        issues.no_solution.empty()) {  // the tower takes the inclination of the pipe at its pinned guide
      lay.model.departure_angle = issues.top_inclination;
      lay.text = model_text(lay.model);
    }
    if (issues.passed()) {
      return is_tower_feasible(lay.model) ? std::variant<NewLay, std::string>(lay) : tower_angle_message(lay.model);
    }
    against = issues.message();
    if (!issues.no_solution.empty() || !adjust_margins(margins, issues, free)) break;
  }
  if (free.wall && free.tension && free.radius) {
    return fmt::format("no wall, tension and stinger radius pass the checks of this lay: {}", against);
  }
  lay.model.note = "with the values given, " + against;
  lay.text = model_text(lay.model);
  return lay;
}

}  // namespace overbend
