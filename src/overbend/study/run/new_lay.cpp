#include "study/run/new_lay.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "base/constants.h"
#include "base/shown_unit.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

constexpr double kFlattestTower = 45.0 * kDegree;  ///< A J-lay tower leans no further from upright than this.
constexpr int kTrials = 16;  ///< Lays calculated before none is believed to pass; most take two or three.

/// What the calculation says against a lay; empty where it stands and passes.
struct LayObjections {
  std::string no_solution;
  std::vector<CheckRow> exceeded;
  double top_inclination = 0.0;  ///< Of the pipe at the tensioner [rad].

  bool passed() const { return no_solution.empty() && exceeded.empty(); }
  std::string words() const {
    if (!no_solution.empty()) return no_solution;
    const auto worst = std::ranges::max_element(exceeded, {}, &CheckRow::utilisation);
    return fmt::format("{} ({}) is exceeded, utilisation {:.2f}", worst->name, worst->code, worst->utilisation);
  }
};

LayObjections judge(const Description& description) {
  Model model = build_model(description);
  const ModelEquilibrium outcome = solve_lay(model);
  LayObjections objections;
  if (!outcome.solution) {
    objections.no_solution = outcome.failure->what;
    return objections;
  }
  const StaticResults results = checked_statics(model, outcome);
  objections.top_inclination = results.stations.back().inclination;
  for (const CheckRow& row : results.checks.rows) {
    if (row.governing && row.status == CheckStatus::exceeded) objections.exceeded.push_back(row);
  }
  return objections;
}

/// Which of the margins are the user's, not ours.
struct Free {
  bool wall, tension, radius;
};

/// What mends a check: a wider stinger over the supports, more tension where the sagbend bends too sharply, else a
/// thicker wall: at the seabed, where the pipe is nearly straight, pressure alone is too much for it.
enum class Cure { wall, tension, radius };

Cure cure_of(const CheckRow& row, const LayObjections& objections) {
  if (row.region == CheckRegion::overbend || row.region == CheckRegion::tip) return Cure::radius;
  if (row.region != CheckRegion::sagbend) return Cure::wall;
  const bool straight_too = std::ranges::any_of(objections.exceeded, [](const CheckRow& other) {
    return other.region == CheckRegion::seabed || other.region == CheckRegion::line;
  });
  return straight_too ? Cure::wall : Cure::tension;
}

/// Margins after objections to a lay: every cure once, by the worst that asks for it. False where none is ours to take.
bool mend(NewMargins& margins, const LayObjections& objections, const Free& free) {
  double wall = 0.0, tension = 0.0, radius = 0.0;
  for (const CheckRow& row : objections.exceeded) {
    Cure cure = cure_of(row, objections);
    if (cure == Cure::tension && !free.tension) cure = Cure::wall;
    if (cure == Cure::wall && !free.wall && row.region == CheckRegion::sagbend) cure = Cure::tension;
    double& asked = cure == Cure::wall ? wall : cure == Cure::tension ? tension : radius;
    asked = std::max(asked, row.utilisation);
  }
  const NewMargins before = margins;
  if (free.wall && wall > 0.0) margins.walls += wall > 1.25 ? 2 : 1;
  if (free.tension && tension > 0.0) margins.tension *= std::clamp(1.05 * tension, 1.1, 2.0);
  if (free.radius && radius > 0.0) margins.radius *= std::clamp(1.02 * radius, 1.05, 1.5);
  return margins.walls > before.walls || margins.tension > before.tension || margins.radius > before.radius;
}

bool tower_stands(const NewModel& model) {
  return model.stinger || model.departure_angle >= kFlattestTower;
}

std::string leaning(const NewModel& model) {
  return fmt::format(
      "--lay: with the {} that keep the sagbend within its checks the pipe hangs at {:.0f} degrees from horizontal, "
      "and no tower is inclined beyond {:.0f}; expected s, or deeper water",
      shown_digits(model.tension, "N", 4), model.departure_angle / kDegree, kFlattestTower / kDegree);
}

}  // namespace

std::variant<NewLay, std::string> choose_lay(const NewOptions& options) {
  const Free free{options.wall.empty(), options.tension.empty(), options.stinger_radius.empty()};
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
      return "these values do not give a valid model:\n" + reading.diagnostics.lines(Severity::error).front();
    }
    const LayObjections objections = judge(*reading.description);
    if (!lay.model.stinger &&
        objections.no_solution.empty()) {  // the tower stands as the pipe hangs from its pinned guide
      lay.model.departure_angle = objections.top_inclination;
      lay.text = model_text(lay.model);
    }
    if (objections.passed()) {
      return tower_stands(lay.model) ? std::variant<NewLay, std::string>(lay) : leaning(lay.model);
    }
    against = objections.words();
    if (!objections.no_solution.empty() || !mend(margins, objections, free)) break;
  }
  if (free.wall && free.tension && free.radius) {
    return fmt::format("no wall, tension and stinger radius were found that pass the checks of this lay: {}", against);
  }
  lay.model.note = "with the values given, " + against;
  lay.text = model_text(lay.model);
  return lay;
}

}  // namespace overbend
