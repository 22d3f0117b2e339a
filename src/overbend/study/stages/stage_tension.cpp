#include "study/stages/stage_tension.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/shown_unit.h"
#include "model/lay_stage.h"
#include "statics/initial_shape/stage_shape.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

constexpr double kTensionStep = 1.08;  ///< Between the tensions that are tried until a limit is bracketed.
constexpr double kCoarseStep = 1.36;   ///< Between those at which a stage that fell is tried, before it is narrowed.
constexpr int kMostCoarse = 10;        ///< Of them: up to twenty times the weight that hangs plumb.
constexpr double kTensionAccuracy = 2.5e-3;  ///< Of a sought tension.
constexpr double kAboveWeight = 1.2;         ///< Least tension that is tried, over the weight that hangs plumb.
constexpr int kMostTries = 40;
/// Of the tension at the top: with less at the bottom a line hangs all but plumb, and a small change of the tension
/// moves the barge far. Sought tensions leave it that much.
constexpr double kLeastBottom = 0.2;
constexpr double kBottomAccuracy = 1e-5;  ///< Of a bottom tension.

StageFailure told_failure(const StaticFailure& failure) {
  return {failure.what, failure.where, failure.why, {}};
}

/// The largest use of what is limited.
template <class Uses>
auto largest(const Uses& uses) {
  return *std::max_element(uses.begin(), uses.end(), [](const auto& a, const auto& b) { return a.used < b.used; });
}

}  // namespace

StageSolver::StageSolver(const Description& description) : description_(description) {}

StageSolver::Tried StageSolver::solve_at(LayStageDescription stage, std::optional<double> tension) {
  if (tension) stage.tension = tension;
  Model model = build_model(at_stage(description_, stage));
  ModelEquilibrium outcome = solve_lay(model, last_ ? &*last_ : nullptr, past_of(stage));
  if (!outcome.solution) return {std::nullopt, std::move(outcome.failure)};
  Tried tried{checked_statics(model, outcome), std::nullopt};
  last_ = std::move(outcome.solution);
  return tried;
}

/// How far a stage has moved the line away from the top [m].
double StageSolver::gone(const LayStageDescription& stage) const {
  if (stage.cable_out) return *stage.cable_out + description_.operation.lay.head->length;
  return stage.pipe_out.value_or(stage.ahead.value_or(stage.passed.value_or(0.0)));
}

/// Before the first stage the line lay as it is laid; before a start-up there was none.
LinePast StageSolver::past_of(const LayStageDescription& stage) {
  if (!yields_) {
    Model model = build_model(description_);
    yields_ = std::any_of(model.sections.begin(), model.sections.end(), [](const Section& s) { return s.bending; });
    if (*yields_ && !stage.pipe_out) {
      ModelEquilibrium lay = solve_lay(model);
      if (lay.solution) before_ = std::make_shared<const StaticSolution>(std::move(*lay.solution));
    }
  }
  return before_ ? LinePast{before_, gone(stage) - gone_} : LinePast{};
}

/// What follows comes from here. Its own past is not needed any more.
void StageSolver::keep_past(const LayStageDescription& stage) {
  if (!*yields_) return;
  StaticSolution now = *last_;
  now.past = {};
  before_ = std::make_shared<const StaticSolution>(std::move(now));
  gone_ = gone(stage);
}

double StageSolver::least_weight(const LayStageDescription& stage) const {
  const Model model = build_model(at_stage(description_, stage));
  return least_stage_tension(model, lay_plane(model, model.mean_pose));
}

double StageSolver::most_tension() const {
  const LayOperationDescription& lay = description_.operation.lay;
  if (lay.program && lay.program->tension_to) return *lay.program->tension_to;
  if (description_.tensioner.range_high) return *description_.tensioner.range_high;
  return 5.0 * description_.tensioner.tension.value_or(1e6);
}

StageSolver::Use StageSolver::worst_use(const LayStageDescription& stage, double tension) {
  const Tried tried = solve_at(stage, tension);
  if (!tried.lay) return {tried.failure->what, 2.0};
  const StaticResults& r = *tried.lay;
  const StageLimits limits = description_.operation.lay.program->limits;
  std::vector<Use> uses{{"bottom tension of a fifth of the top's", kLeastBottom * r.top_tension / r.bottom_tension}};
  if (limits.sagbend_strain) uses.push_back({"sagbend strain", r.sagbend.strain.value / *limits.sagbend_strain});
  if (limits.sagbend_stress) uses.push_back({"sagbend stress", r.sagbend.von_mises.value / *limits.sagbend_stress});
  if (limits.roller_load) uses.push_back({"roller load", r.largest_reaction / *limits.roller_load});
  if (limits.tip_clearance && r.stinger_tip_clearance) {
    const double missing = *limits.tip_clearance - *r.stinger_tip_clearance;
    uses.push_back({"tip clearance", 1.0 + missing / std::max(*limits.tip_clearance, 0.1)});
  }
  if (const CheckRow* check = worst_check(r.checks)) {
    uses.push_back({check->name, check->utilisation / limits.utilisation});
  }
  return largest(uses);
}

PlannedStage StageSolver::hopeless(const LayStageDescription& stage, const Use& nearest, double tension, double most) {
  return {stage,
          {},
          StageFailure{"no tension keeps every limit",
                       "",
                       fmt::format("up to {} were tried; nearest is {}, where '{}' is at {:.2f} of what is allowed",
                                   shown(most, "N", 1), shown(tension, "N", 1), nearest.limit, nearest.used),
                       {}},
          nullptr};
}

PlannedStage StageSolver::with_least_tension(const LayStageDescription& stage, double near) {
  const StageProgram& program = *description_.operation.lay.program;
  const double least = std::max(program.tension_from.value_or(0.0), kAboveWeight * least_weight(stage)),
               most = most_tension();
  double good = std::clamp(near, std::min(least, most), most);
  Use at = worst_use(stage, good), broken{"lower bound of the tension", 0.0};
  Use nearest = at;
  double bad = good, nearest_tension = good;
  for (int i = 0; at.used > 1.0 && i < kMostTries; ++i) {  // up, until every limit is kept
    broken = at;
    bad = good;
    if (at.used < nearest.used) {
      nearest = at;
      nearest_tension = good;
    }
    if (good >= most) return hopeless(stage, nearest, nearest_tension, most);
    good = std::min(good * kTensionStep, most);
    at = worst_use(stage, good);
  }
  for (int i = 0; bad == good && i < kMostTries; ++i) {  // down, until one is broken
    const double lower = std::max(good / kTensionStep, least);
    if (lower >= good) break;
    const Use below = worst_use(stage, lower);
    (below.used > 1.0 ? bad : good) = lower;
    if (below.used > 1.0) {
      broken = below;
    } else {
      bad = good;
    }
  }
  while (good - bad > kTensionAccuracy * good) {
    const double middle = 0.5 * (good + bad);
    const Use between = worst_use(stage, middle);
    if (between.used > 1.0) broken = between;
    (between.used > 1.0 ? bad : good) = middle;
  }
  PlannedStage planned{stage, broken.limit, {}, last_ ? std::make_shared<const StaticSolution>(*last_) : nullptr};
  planned.stage.tension = good;
  return planned;
}

StageSolver::Tried StageSolver::with_bottom_tension(LayStageDescription& stage) {
  const double wanted = *stage.bottom_tension;
  double tension = wanted + least_weight(stage);
  for (int i = 0; i < kMostTries; ++i) {  // the two differ by the hanging weight, which hardly changes
    Tried tried = solve_at(stage, tension);
    stage.tension = tension;
    if (!tried.lay) return tried;
    const double missing = wanted - tried.lay->bottom_tension;
    if (std::abs(missing) <= kBottomAccuracy * wanted) return tried;
    tension += missing;
  }
  return {std::nullopt,
          StaticFailure{"the bottom tension is not reached", "", "it does not follow the tension at the top"}};
}

StageSolver::Tried StageSolver::as_asked(LayStageDescription& stage) {
  return stage.bottom_tension ? with_bottom_tension(stage) : solve_at(stage, {});
}

/// Each tension the largest of its neighbours', then their mean: never less than it has to be.
void StageSolver::even_out(std::vector<PlannedStage>& stages) {
  const std::size_t count = stages.size();
  const auto around = [&](const std::vector<double>& values, std::size_t i, const auto& take) {
    for (std::size_t k = i > 0 ? i - 1 : 0; k <= std::min(i + 1, count - 1); ++k) take(values[k]);
  };
  std::vector<double> least(count, 0.0), raised(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) least[i] = stages[i].stage.tension.value_or(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    around(least, i, [&](double value) { raised[i] = std::max(raised[i], value); });
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
    if (even > least[i] && worst_use(stages[i].stage, even).used <= 1.0) stages[i].stage.tension = even;
  }
}

std::vector<PlannedStage> StageSolver::plan(const std::vector<LayStageDescription>& stages) {
  const std::optional<StageProgram>& program = description_.operation.lay.program;
  const bool sought = program && program->tension == StageTension::seek;
  std::vector<PlannedStage> planned;
  double near = description_.tensioner.tension.value_or(most_tension());
  for (const LayStageDescription& stage : stages) {
    if (sought) {
      planned.push_back(with_least_tension(stage, near));
      near = planned.back().stage.tension.value_or(near);
    } else {
      planned.push_back({stage, {}, {}, {}});
    }
  }
  if (sought) even_out(planned);
  return planned;
}

std::optional<double> StageSolver::tension_that_stands(const LayStageDescription& stage) {
  const double from = std::max(1.02 * least_weight(stage), 1.0), to = 2.0 * most_tension();
  double falls = 0.0, stands = from;
  for (int i = 0; !solve_at(stage, stands).lay; ++i) {
    falls = stands;
    stands *= kCoarseStep;
    if (stands > to || i == kMostCoarse) return std::nullopt;
  }
  while (falls > 0.0 && stands > kTensionStep * falls) {
    const double between = std::sqrt(falls * stands);
    (solve_at(stage, between).lay ? stands : falls) = between;
  }
  return stands;
}

StageResult StageSolver::solve(const PlannedStage& planned) {
  StageResult result;
  result.stage = planned.stage;
  result.governing = planned.governing;
  result.failure = planned.hopeless;
  if (result.failure) return result;
  if (planned.close) last_ = *planned.close;
  Tried tried = as_asked(result.stage);
  if (tried.failure && !tried.failure->input && last_) {
    // The stage before may lie in another of several equilibria, on other rollers, from which no way leads here.
    std::optional<StaticSolution> before;
    before.swap(last_);
    result.stage = planned.stage;
    tried = as_asked(result.stage);
    if (tried.failure) last_ = std::move(before);
  }
  result.lay = std::move(tried.lay);
  if (!tried.failure) {
    keep_past(planned.stage);
    return result;
  }
  result.failure = told_failure(*tried.failure);
  if (!tried.failure->input) result.failure->least_tension = tension_that_stands(planned.stage);
  return result;
}

}  // namespace overbend
