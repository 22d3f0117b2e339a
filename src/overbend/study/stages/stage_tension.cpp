#include "study/stages/stage_tension.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

constexpr double kTensionStep = 1.08;  ///< Ratio of successive trial tensions until a limit is bracketed.
constexpr double kCoarseStep = 1.36;   ///< Ratio of successive trial tensions of a stage without a solution, before the
                                       ///< interval is narrowed.
constexpr int kMaxCoarseSteps = 10;    ///< Maximum number of these trials: up to twenty times the weight of the
                                       ///< vertically hanging line.
constexpr double kTensionAccuracy = 2.5e-3;  ///< Relative accuracy of a sought tension [-].
constexpr double kMinWeightFactor = 1.2;     ///< Minimum trial tension over the weight of the vertically hanging line
                                             ///< [-].
constexpr int kMaxIterations = 40;
/// Minimum bottom tension over top tension [-]: below it the line hangs almost vertically, and a small change of the
/// tension moves the barge far. Sought tensions keep this margin.
constexpr double kMinBottomFraction = 0.2;
constexpr double kBottomAccuracy = 1e-5;  ///< Relative accuracy of a bottom tension [-].

StageFailure make_stage_failure(const StaticFailure& failure) {
  return {failure.what, failure.where, failure.why, {}};
}

/// Returns the highest utilisation of all limits.
template <class Uses>
auto max_use(const Uses& uses) {
  return *std::max_element(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.used < b.used; });
}

}  // namespace

StageSolver::StageSolver(const Description& description) : description_(description) {}

StageSolver::Trial StageSolver::solve_at(LayStageDescription stage, std::optional<double> tension) {
  if (tension) stage.tension = tension;
  Model model = build_model(make_stage_description(description_, stage));
  ModelEquilibrium outcome = solve_lay(model, last_ ? &*last_ : nullptr, find_history(stage));
  if (!outcome.solution) return {std::nullopt, std::move(outcome.failure)};
  Trial tried{checked_statics(model, outcome), std::nullopt};
  last_ = std::move(outcome.solution);
  return tried;
}

/// Length by which a stage has moved the line away from the top [m].
double StageSolver::moved_length(const LayStageDescription& stage) const {
  if (stage.cable_out) return *stage.cable_out + description_.operation.lay.head->length;
  return stage.pipe_out.value_or(stage.ahead.value_or(stage.passed.value_or(0.0)));
}

/// Before the first stage the line lies as laid; before a start-up there is none.
LoadHistory StageSolver::find_history(const LayStageDescription& stage) {
  if (!yields_) {
    Model model = build_model(description_);
    yields_ = std::any_of(model.sections.begin(), model.sections.end(), [](const Section& s) { return s.bending; });
    if (*yields_ && !stage.pipe_out) {
      ModelEquilibrium lay = solve_lay(model);
      if (lay.solution) before_ = std::make_shared<const StaticSolution>(std::move(*lay.solution));
    }
  }
  return before_ ? LoadHistory{before_, moved_length(stage) - moved_length_} : LoadHistory{};
}

/// Keeps the solution as the history of the next stage. Its own history is no longer needed.
void StageSolver::keep_history(const LayStageDescription& stage) {
  if (!*yields_) return;
  StaticSolution previous = *last_;
  previous.past = {};
  before_ = std::make_shared<const StaticSolution>(std::move(previous));
  moved_length_ = moved_length(stage);
}

double StageSolver::min_stage_tension(const LayStageDescription& stage) const {
  const Model model = build_model(make_stage_description(description_, stage));
  return min_stage_top_tension(model, lay_plane(model, model.mean_pose));
}

double StageSolver::find_max_tension() const {
  const LayOperationDescription& lay = description_.operation.lay;
  if (lay.program && lay.program->tension_to) return *lay.program->tension_to;
  if (description_.tensioner.range_high) return *description_.tensioner.range_high;
  return 5.0 * description_.tensioner.tension.value_or(1e6);
}

StageSolver::LimitUse StageSolver::worst_use(const LayStageDescription& stage, double tension) {
  const Trial tried = solve_at(stage, tension);
  if (!tried.lay) return {tried.failure->what, 2.0};
  const StaticResults& r = *tried.lay;
  const StageLimits limits = description_.operation.lay.program->limits;
  std::vector<LimitUse> uses{
      {"bottom tension of a fifth of the top's", kMinBottomFraction * r.top_tension / r.bottom_tension}};
  if (limits.sagbend_strain) uses.push_back({"sagbend strain", r.sagbend.strain.value / *limits.sagbend_strain});
  if (limits.sagbend_stress) uses.push_back({"sagbend stress", r.sagbend.von_mises.value / *limits.sagbend_stress});
  if (limits.roller_load) uses.push_back({"roller load", r.max_reaction / *limits.roller_load});
  if (limits.tip_clearance && r.stinger_tip_clearance) {
    const double missing = *limits.tip_clearance - *r.stinger_tip_clearance;
    uses.push_back({"tip clearance", 1.0 + missing / std::max(*limits.tip_clearance, 0.1)});
  }
  if (const CheckRow* check = find_governing_check(r.checks)) {
    uses.push_back({check->name, check->utilisation / limits.utilisation});
  }
  return max_use(uses);
}

PlannedStage StageSolver::infeasible(const LayStageDescription& stage, const LimitUse& nearest, double tension,
                                     double max_tension) {
  return {stage,
          {},
          StageFailure{"no tension keeps every limit",
                       "",
                       fmt::format("tensions up to {} were tried; the best is {}, with '{}' at {:.2f} of its limit",
                                   shown(max_tension, "N", 1), shown(tension, "N", 1), nearest.limit, nearest.used),
                       {}},
          nullptr};
}

PlannedStage StageSolver::with_min_tension(const LayStageDescription& stage, double near) {
  const StageProgram& program = *description_.operation.lay.program;
  const double min_tension = std::max(program.tension_from.value_or(0.0), kMinWeightFactor * min_stage_tension(stage)),
               max_tension = find_max_tension();
  double good = std::clamp(near, std::min(min_tension, max_tension), max_tension);
  LimitUse use = worst_use(stage, good), broken{"lower bound of the tension", 0.0};
  LimitUse nearest = use;
  double bad = good, nearest_tension = good;
  for (int i = 0; use.used > 1.0 && i < kMaxIterations; ++i) {  // up, until every limit is kept
    broken = use;
    bad = good;
    if (use.used < nearest.used) {
      nearest = use;
      nearest_tension = good;
    }
    if (good >= max_tension) return infeasible(stage, nearest, nearest_tension, max_tension);
    good = std::min(good * kTensionStep, max_tension);
    use = worst_use(stage, good);
  }
  for (int i = 0; bad == good && i < kMaxIterations; ++i) {  // down, until one is exceeded
    const double lower = std::max(good / kTensionStep, min_tension);
    if (lower >= good) break;
    const LimitUse below = worst_use(stage, lower);
    (below.used > 1.0 ? bad : good) = lower;
    if (below.used > 1.0) {
      broken = below;
    } else {
      bad = good;
    }
  }
  while (good - bad > kTensionAccuracy * good) {
    const double middle = 0.5 * (good + bad);
    const LimitUse between = worst_use(stage, middle);
    if (between.used > 1.0) broken = between;
    (between.used > 1.0 ? bad : good) = middle;
  }
  PlannedStage planned{stage, broken.limit, {}, last_ ? std::make_shared<const StaticSolution>(*last_) : nullptr};
  planned.stage.tension = good;
  return planned;
}

StageSolver::Trial StageSolver::with_bottom_tension(LayStageDescription& stage) {
  const double wanted = *stage.bottom_tension;
  double tension = wanted + min_stage_tension(stage);
  for (int i = 0; i < kMaxIterations; ++i) {  // they differ by the suspended weight, which hardly changes
    Trial tried = solve_at(stage, tension);
    stage.tension = tension;
    if (!tried.lay) return tried;
    const double missing = wanted - tried.lay->bottom_tension;
    if (std::abs(missing) <= kBottomAccuracy * wanted) return tried;
    tension += missing;
  }
  return {std::nullopt,
          StaticFailure{"the bottom tension is not reached", "", "it does not follow the tension at the top"}};
}

StageSolver::Trial StageSolver::at_given_tension(LayStageDescription& stage) {
  return stage.bottom_tension ? with_bottom_tension(stage) : solve_at(stage, {});
}

/// Raises each tension to the maximum of its neighbours, then averages: never below the required tension.
void StageSolver::smooth_tensions(std::vector<PlannedStage>& stages) {
  const std::size_t count = stages.size();
  const auto around = [&](const std::vector<double>& values, std::size_t i, const auto& take) {
    for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, count - 1); ++k) take(values[k]);
  };
  std::vector<double> min_tensions(count, 0.0), raised(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) min_tensions[i] = stages[i].stage.tension.value_or(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    around(min_tensions, i, [&](double value) { raised[i] = std::max(raised[i], value); });
  }
  for (std::size_t i = 0; i < count; ++i) {
    if (!stages[i].stage.tension) continue;
    double sum = 0.0;
    int terms = 0;
    around(raised, i, [&](double value) {
      sum += value;
      ++terms;
    });
    const double even = sum / terms;
    if (even > min_tensions[i] && worst_use(stages[i].stage, even).used <= 1.0) stages[i].stage.tension = even;
  }
}

std::vector<PlannedStage> StageSolver::plan(const std::vector<LayStageDescription>& stages) {
  const std::optional<StageProgram>& program = description_.operation.lay.program;
  const bool sought = program && program->tension == StageTension::seek;
  std::vector<PlannedStage> planned;
  double near = description_.tensioner.tension.value_or(find_max_tension());
  for (const LayStageDescription& stage : stages) {
    if (sought) {
      planned.push_back(with_min_tension(stage, near));
      near = planned.back().stage.tension.value_or(near);
    } else {
      planned.push_back({stage, {}, {}, {}});
    }
  }
  if (sought) smooth_tensions(planned);
  return planned;
}

std::optional<double> StageSolver::min_feasible_tension(const LayStageDescription& stage) {
  const double from = std::max(1.02 * min_stage_tension(stage), 1.0), to = 2.0 * find_max_tension();
  double infeasible_tension = 0.0, feasible = from;
  for (int i = 0; !solve_at(stage, feasible).lay; ++i) {
    infeasible_tension = feasible;
    feasible *= kCoarseStep;
    if (feasible > to || i == kMaxCoarseSteps) return std::nullopt;
  }
  while (infeasible_tension > 0.0 && feasible > kTensionStep * infeasible_tension) {
    const double between = std::sqrt(infeasible_tension * feasible);
    (solve_at(stage, between).lay ? feasible : infeasible_tension) = between;
  }
  return feasible;
}

StageResult StageSolver::solve(const PlannedStage& planned) {
  StageResult result;
  result.stage = planned.stage;
  result.governing = planned.governing;
  result.failure = planned.infeasible;
  if (result.failure) return result;
  if (planned.close) last_ = *planned.close;
  Trial tried = at_given_tension(result.stage);
  if (tried.failure && !tried.failure->input && last_) {
    // The previous stage may be another of several equilibria, on other rollers, from which this one is not reached.
    std::optional<StaticSolution> before;
    before.swap(last_);
    result.stage = planned.stage;
    tried = at_given_tension(result.stage);
    if (tried.failure) last_ = std::move(before);
  }
  result.lay = std::move(tried.lay);
  if (!tried.failure) {
    keep_history(planned.stage);
    return result;
  }
  result.failure = make_stage_failure(*tried.failure);
  if (!tried.failure->input) result.failure->min_tension = min_feasible_tension(planned.stage);
  return result;
}

}  // namespace overbend
