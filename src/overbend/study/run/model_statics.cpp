#include "study/run/model_statics.h"

#include "base/require.h"
#include "checks/run_checks.h"
#include "statics/moored/moored_lay.h"
#include "statics/moored/moored_statics.h"
#include "study/run/lines_run.h"
#include "study/run/mooring_run.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

ModelStatics lines_alone(const Model& model) {
  ModelStatics found;
  LinesOutcome outcome = solve_lines(model);
  found.lines = std::move(outcome.results);
  found.failure = std::move(outcome.failure);
  return found;
}

ModelStatics hull_alone(Model& model) {
  ModelStatics found;
  LayOutcome outcome = solve_moored_hull(model);
  found.moorings = std::move(outcome.moorings);
  if (found.moorings) {
    fill_checks(model, *found.moorings);
    accept(found.moorings->findings, model.description.checks.accepted_findings);
  }
  found.failure = std::move(outcome.failure);
  return found;
}

}  // namespace

ModelStatics solve_model(Model& model, const StaticSolution* start) {
  if (is_lines_alone(model.description)) return lines_alone(model);
  if (is_moored_hull(model.description)) return hull_alone(model);
  ModelStatics found;
  LayOutcome outcome = solve_lay(model, start);
  if (outcome.failure) {
    found.failure = std::move(outcome.failure);
    return found;
  }
  found.lay = checked_statics(model, outcome);
  found.solution = std::move(outcome.solution);
  return found;
}

void tell_hull(const Model& model, ModelStatics& statics) {
  if (statics.lay) tell_hull(model, *statics.lay);
  if (statics.moorings) tell_hull(model, *statics.moorings);
}

void write_model_statics(const ModelStatics& statics, const Description& description,
                         const std::filesystem::path& folder) {
  require(!statics.failure, "there are results to write");
  if (statics.lines) {
    write_lines_run(*statics.lines, description, folder);
  } else if (statics.moorings) {
    write_mooring_run(*statics.moorings, description, folder);
  } else {
    write_static_run(*statics.lay, description, folder);
  }
}

}  // namespace overbend
