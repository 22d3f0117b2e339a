#include "study/run/lines_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/file_lock.h"
#include "base/interruption.h"
#include "base/shown_unit.h"
#include "checks/run_checks.h"
#include "dynamics/run/lines_in_time.h"
#include "dynamics/setup/dynamic_obstacle.h"
#include "dynamics/setup/start_leap.h"
#include "model/pipe/line_types.h"
#include "model/vessel/station.h"
#include "recording/reach_row.h"
#include "report/report.h"
#include "resultfiles/lines/lines_writer.h"
#include "runstore/run_store.h"
#include "runstore/staged_folder.h"
#include "statics/recovery/lines_recovery.h"
#include "study/run/prepared_case.h"
#include "study/run/run_findings.h"
#include "study/run/seeds_gather.h"

namespace overbend {
namespace {

/// A vessel that floats free moves by what the lines do to it, which is not computed here.
std::optional<StaticFailure> obstacle_of(const Description& description) {
  const VesselDescription& vessel = description.vessel;
  if (!vessel.coupled && !vessel.hydrostatics && vessel.motion != VesselMotion::coupled) return std::nullopt;
  return StaticFailure{"lines on a hull that floats free cannot be solved by themselves yet", "",
                       "give them under moorings, or another vessel.motion than coupled without vessel.hydrostatics",
                       true};
}

/// The lines of a model at rest, and what a run starts from.
struct RestOfModel {
  LinesSetup setup;
  SystemState state;
  LinesRest rest;
  LinesOutcome outcome;
};

StaticFailure failure_of(const Model& model, const LinesRest& rest) {
  const auto worst = std::find_if(rest.lines.begin(), rest.lines.end(), [](const auto& l) { return !l.converged(); });
  const std::string name = model.description.lines[static_cast<std::size_t>(worst - rest.lines.begin())].name;
  return {"no equilibrium was found", "line \"" + name + "\"",
          "its forces do not balance; a longer line or a finer `element` may help"};
}

RestOfModel rest_of(const Model& model) {
  RestOfModel found{lines_setup(model), {}, {}, {}};
  found.state = start_of(found.setup, 0.0);
  Assembly assembly(found.setup.system);
  found.rest = rest_lines(assembly, found.state);
  if (found.rest.converged()) {
    found.outcome.results = recover_lines(model, assembly, found.state, found.rest);
  } else {
    found.outcome.failure = failure_of(model, found.rest);
  }
  return found;
}

void add_history(const LineHistory& history, LineResult& line) {
  const std::vector<double> deviation = history.ends.standard_deviation();
  line.first.in_time = {history.least_first, history.most_first, history.ends.mean()[0], deviation[0]};
  line.second.in_time = {history.least_last, history.most_last, history.ends.mean()[1], deviation[1]};
  line.first_history = history.first;
  line.second_history = history.last;
  for (std::size_t node = 0; node < line.nodes.size(); ++node) {
    line.nodes[node].least_tension = history.least_tension[node];
    line.nodes[node].largest_tension = history.most_tension[node];
  }
  line.least_in_time = *std::min_element(history.least_tension.begin(), history.least_tension.end());
  line.largest_in_time = *std::max_element(history.most_tension.begin(), history.most_tension.end());
}

constexpr double kSlack = 0.01;      ///< Of the largest tension at rest: less is slack.
constexpr double kPushed = 0.01;     ///< Compression, of the largest tension: worth a word [-].
constexpr double kSmallLeap = 1e-3;  ///< Of an end at t = 0, not worth a word [m].

/// Largest share of a breaking load over the run, each segment by its own: not that used most at rest need be the one.
/// None where no segment says.
std::optional<double> use_in_time(const FreeLineDescription& description, const LineResult& line) {
  std::optional<double> use;
  double from = 0.0;
  for (const LineSegmentDescription& segment : description.segments) {
    const double to = from + segment.length.value_or(0.0);
    for (const LineNodeResult& node : line.nodes) {
      if (!segment.type.breaking_load || node.s < from - 1e-9 || node.s > to + 1e-9) continue;
      use = std::max(use.value_or(0.0), node.largest_tension / *segment.type.breaking_load);
    }
    from = to;
  }
  return use;
}

/// What in the run calls for a second look.
void warn_of_motion(const Model& model, const DynamicOptions& options, LinesResults& results) {
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    const LineResult& line = results.lines[i];
    if (const double use = line.utilisation_in_time.value_or(0.0); use > 1.0) {
      results.findings.push_back(Finding{
          FindingCode::breaking_load_exceeded,
          fmt::format("line \"{}\": its largest tension of the run is {:.2f} times its breaking load", line.name, use)}
                                     .on("line " + line.name)
                                     .with("utilisation", use, "1"));
    }
    const auto& segments = model.description.lines[i].segments;
    const bool only_pulls =
        std::ranges::none_of(segments, [](const auto& segment) { return bears_compression(segment.type); });
    if (only_pulls && line.least_in_time < kSlack * line.largest_tension) {
      results.findings.push_back(
          Finding{FindingCode::line_snaps,
                  fmt::format("line \"{}\": falls slack and snaps tight, with up to {}: how hard hangs on its internal "
                              "damping, which is taken as 1 % of critical; do not let it fall slack",
                              line.name, shown_digits(line.largest_in_time, "N", 3))}
              .on("line " + line.name)
              .with("tension", line.largest_in_time, "N"));
    } else if (line.least_in_time < -kPushed * line.largest_in_time) {
      results.findings.push_back(
          Finding{FindingCode::line_compressed,
                  fmt::format("line \"{}\": falls slack, and where it is pushed bears {} of compression at most: it "
                              "may buckle, which the model represents only as far as its elements allow",
                              line.name, shown_digits(-line.least_in_time, "N", 3))}
              .on("line " + line.name)
              .with("tension", line.least_in_time, "N"));
    }
  }
  if (const double leap = line_leap_at_start(model, options); leap > kSmallLeap) {
    results.findings.push_back(
        Finding{FindingCode::start_without_build_up,
                fmt::format("without build-up an end leaps by {} from where statics have it: what rings after t = 0 "
                            "comes from that; give some periods (analysis.dynamic.build_up)",
                            shown_digits(leap, "m", 3))}
            .with("distance", leap, "m"));
  }
  DynamicResults run;
  run.duration = options.duration;
  run.build_up = options.build_up;
  run.seed = options.seed;
  warn_of_sea(model.description, run);
  warn_of_energy(results.energy_drift, model.description.dynamics && model.description.dynamics->step, run);
  results.findings.insert(results.findings.end(), run.findings.begin(), run.findings.end());
}

}  // namespace

bool is_lines_alone(const Description& description) {
  return !description.has_pipe && !has_mooring_lines(description) && !description.lines.empty();
}

LinesOutcome solve_lines(const Model& model) {
  if (const auto obstacle = obstacle_of(model.description)) return {std::nullopt, *obstacle};
  LinesOutcome outcome = rest_of(model).outcome;
  if (outcome.results) {
    fill_checks(model, *outcome.results);
    accept(outcome.results->findings, model.description.checks.accepted_findings);
  }
  return outcome;
}

LinesOutcome run_lines(const Model& model, const DynamicOptions& options, const LinesSitting& sitting) {
  if (const auto obstacle = obstacle_of(model.description)) return {std::nullopt, *obstacle};
  if (const auto obstacle = lines_obstacle(model, options)) return {std::nullopt, *obstacle};
  RestOfModel found = rest_of(model);
  if (found.outcome.failure) return found.outcome;
  const EnvironmentDescription& around = model.description.environment;
  const Sea sea = make_sea(around.waves, around.water_depth, options.seed);
  System system = std::move(found.setup.system);
  LeadEnds lead = moving_ends(model, make_vessel_motion(model, sea), options.build_up);
  LineRecorder recorder(system);
  SystemState start = resting_lines(system, found.state, found.rest, -options.build_up);
  SystemRun run(std::move(system), std::move(lead), sea, std::move(start), options);
  run.observe(recorder);
  if (sitting.from != nullptr) run.restore(*sitting.from);
  while (!run.finished()) {
    if (!reach_row(run)) return {std::nullopt, std::nullopt, true};
    if (run.failure()) return {std::nullopt, run.failure()};
    if (!sitting.control) continue;
    const DynamicControl wanted =
        sitting.control({run.time(), run.end(), run.report().steps, run.end_force(0, LineEnd::last).norm()});
    if (wanted != DynamicControl::go_on) sitting.keep(run.checkpoint());
    if (wanted == DynamicControl::stop && !run.finished()) return {std::nullopt, std::nullopt, true};
  }
  LinesResults& results = *found.outcome.results;
  results.moved = true;
  results.steps = static_cast<int>(run.report().steps);
  results.energy_drift = run.energy().drift();
  results.time = recorder.histories().front().time;
  for (std::size_t i = 0; i < results.lines.size(); ++i) {
    add_history(recorder.histories()[i], results.lines[i]);
    results.lines[i].utilisation_in_time = use_in_time(model.description.lines[i], results.lines[i]);
  }
  warn_of_motion(model, options, results);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
  return found.outcome;
}

LinesOutcome run_lines_in(const std::filesystem::path& folder, const Model& model, const DynamicOptions& options,
                          bool resume, const std::function<DynamicControl(const DynamicProgress&)>& control) {
  const std::string input = input_text(model.description);
  std::optional<ResumedRun> resumed = resume ? RunStore::resume(folder, input, options.seed) : std::nullopt;
  RunStore store = resumed ? std::move(resumed->store) : RunStore::create(folder, input, options.seed);
  store.begin({{"time", "s", "Time; the histories are in the checkpoint"}}, {});
  const LinesSitting sitting{resumed ? &resumed->state : nullptr, control,
                             [&](const DynamicCheckpoint& state) { store.checkpoint(state); }};
  LinesOutcome outcome;
  try {
    outcome = run_lines(model, options, sitting);
  } catch (const Interrupted&) {
    if (!resumed) store.remove();  // before its first step
    throw;
  }
  if (outcome.stopped) {
    if (!RunStore::find(folder)) store.remove();
    return outcome;
  }
  if (outcome.results) write_lines_run(*outcome.results, model.description, folder);
  store.remove();
  return outcome;
}

LineSeeds run_line_seeds(const Description& description, const std::vector<std::uint64_t>& seeds,
                         const std::function<LinesOutcome(std::uint64_t, const std::string&)>& run) {
  LineSeeds all;
  std::vector<SeedRun> runs;
  std::vector<FailedSeed> failed;
  for (const std::uint64_t seed : seeds) {
    const std::string name = "seed-" + std::to_string(seed);
    LinesOutcome outcome = run(seed, name);
    if (outcome.stopped) {
      all.stopped = true;
      return all;
    }
    if (outcome.failure) {
      all.failure = outcome.failure;
      if (outcome.failure->input) return all;
      failed.push_back({seed, failed_end(*outcome.failure, description).why});
      continue;
    }
    runs.push_back({seed, name, lines_values(*outcome.results), outcome.results->findings,
                    verdict_kind(outcome.results->checks, outcome.results->findings)});
    all.last = std::move(*outcome.results);
  }
  if (runs.empty()) return all;
  all.failure.reset();
  all.seeds = gather_lines(description, runs);
  all.seeds.failed = std::move(failed);
  return all;
}

std::vector<double> lines_values(const LinesResults& results) {
  std::vector<double> values;
  for (const LineResult& line : results.lines) {
    for (const LineEndResult* end : {&line.first, &line.second}) {
      values.insert(values.end(), {end->in_time.max, end->in_time.min});
    }
    values.push_back(line.least_in_time);
  }
  return values;
}

SeedsResults gather_lines(const Description& description, const std::vector<SeedRun>& runs) {
  SeedsResults gathered;
  gathered.duration = description.dynamics->duration;
  gathered.build_up = description.dynamics->build_up;
  for (const FreeLineDescription& line : description.lines) {
    const auto add = [&](const char* what, const char* meaning, SeedExtreme extreme) {
      gathered.quantities.push_back({line.name + "/" + what, "N", meaning + (" of line " + line.name), extreme});
    };
    add("first_tension_max", "Largest tension at the first end", SeedExtreme::largest);
    add("first_tension_min", "Smallest tension at the first end", SeedExtreme::smallest);
    add("second_tension_max", "Largest tension at the second end", SeedExtreme::largest);
    add("second_tension_min", "Smallest tension at the second end", SeedExtreme::smallest);
    add("least_tension", "Smallest tension along the line", SeedExtreme::smallest);
  }
  gathered.runs = runs;
  fill_statistics(gathered);
  return gathered;
}

void write_lines_run(const LinesResults& results, const Description& description, const std::filesystem::path& folder) {
  const std::lock_guard hold(hdf5_lock());
  StagedFolder staged(folder);
  write_lines_files(results, description, staged.path());
  write_report(results, description.source_text, staged.path() / "report.html");
  staged.commit("summary.json");
}

}  // namespace overbend
