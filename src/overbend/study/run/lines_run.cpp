#include "study/run/lines_run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/file_lock.h"
#include "base/interruption.h"
#include "base/shown_unit.h"
#include "checks/run_checks.h"
#include "dynamics/setup/dynamic_obstacle.h"
#include "model/vessel/station.h"
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
  std::shared_ptr<LinesAtRest> lines;
  LinesOutcome outcome;
};

StaticFailure failure_of(const Model& model, const LinesRest& rest) {
  const auto worst = std::find_if(rest.lines.begin(), rest.lines.end(), [](const auto& l) { return !l.converged(); });
  const std::string name = model.description.lines[static_cast<std::size_t>(worst - rest.lines.begin())].name;
  return {"no equilibrium was found", "line \"" + name + "\"",
          "its forces do not balance; a longer line or a finer `element` may help"};
}

RestOfModel rest_of(const Model& model) {
  RestOfModel found{std::make_shared<LinesAtRest>(LinesAtRest{lines_setup(model), {}, {}}), {}};
  LinesAtRest& lines = *found.lines;
  lines.state = start_of(lines.setup, 0.0);
  Assembly assembly(lines.setup.system);
  lines.rest = rest_lines(assembly, lines.state);
  if (lines.rest.converged()) {
    found.outcome.results = recover_lines(model, assembly, lines.state, lines.rest);
  } else {
    found.outcome.failure = failure_of(model, lines.rest);
  }
  return found;
}

void add_motion(const LineDynamics& motion, LineResult& line) {
  line.first.in_time = motion.first_tension;
  line.second.in_time = motion.second_tension;
  for (std::size_t node = 0; node < line.nodes.size(); ++node) {
    line.nodes[node].least_tension = motion.least_at_nodes[node];
    line.nodes[node].largest_tension = motion.largest_at_nodes[node];
  }
  line.least_in_time = motion.least_tension;
  line.largest_in_time = motion.largest_tension;
  line.utilisation_in_time = motion.utilisation;
}

/// What in the sea and the balance of energy of a run calls for a second look.
void warn_of_run(const Model& model, DynamicResults& run, LinesResults& results) {
  warn_of_sea(model.description, run);
  warn_of_energy(results.energy_drift, model.description.dynamics && model.description.dynamics->step, run);
  append(results.findings, run.findings);
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

LinesOutcome run_lines(const Model& model, const DynamicOptions& options, DynamicSink& sink,
                       const DynamicCheckpoint* from,
                       const std::function<DynamicControl(const DynamicProgress&)>& control) {
  if (const auto obstacle = obstacle_of(model.description)) return {std::nullopt, *obstacle};
  if (const auto obstacle = lines_obstacle(model, options)) return {std::nullopt, *obstacle};
  RestOfModel found = rest_of(model);
  if (found.outcome.failure) return found.outcome;
  LinesResults& results = *found.outcome.results;
  StaticSolution start;
  start.lines = found.lines;
  StaticResults statics;
  statics.lines = results.lines;
  DynamicOutcome run = run_dynamics(model, start, statics, options, sink, from, control);
  if (!run.results || run.stopped) return {std::nullopt, run.failure, run.stopped};
  results.moved = true;
  results.steps = static_cast<int>(run.results->run.steps);
  results.energy_drift = run.results->energy.drift();
  for (std::size_t i = 0; i < results.lines.size(); ++i) add_motion(run.results->lines[i], results.lines[i]);
  warn_of_run(model, *run.results, results);
  fill_checks(model, results);
  accept(results.findings, model.description.checks.accepted_findings);
  return found.outcome;
}

namespace {

std::vector<double> column_named(const RunStore& store, const std::string& name) {
  for (std::size_t i = 0; i < store.columns().size(); ++i) {
    if (store.columns()[i].name == name) return store.column(i);
  }
  return {};
}

}  // namespace

LinesOutcome run_lines_in(const std::filesystem::path& folder, const Model& model, const DynamicOptions& options,
                          bool resume, const std::function<DynamicControl(const DynamicProgress&)>& control) {
  const std::string input = input_text(model.description);
  std::optional<ResumedRun> resumed = resume ? RunStore::resume(folder, input, options.seed) : std::nullopt;
  RunStore store = resumed ? std::move(resumed->store) : RunStore::create(folder, input, options.seed);
  LinesOutcome outcome;
  try {
    outcome = run_lines(model, options, store, resumed ? &resumed->state : nullptr, control);
  } catch (const Interrupted&) {
    if (!resumed) store.remove();  // before its first step
    throw;
  }
  if (outcome.stopped) {
    if (!RunStore::find(folder)) store.remove();
    return outcome;
  }
  if (outcome.results) {
    outcome.results->time = store.column(0);
    for (LineResult& line : outcome.results->lines) {
      line.first_history = column_named(store, "line/" + line.name + "/first_tension");
      line.second_history = column_named(store, "line/" + line.name + "/second_tension");
    }
    write_lines_run(*outcome.results, model.description, folder);
  }
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
