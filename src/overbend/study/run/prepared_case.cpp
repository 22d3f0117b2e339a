#include "study/run/prepared_case.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "dynamics/integrator/dynamics.h"
#include "dynamics/setup/unsupported_in_dynamics.h"
#include "model/description/operation_names.h"
#include "model/model_findings.h"
#include "model/vessel/mooring_queries.h"
#include "modelfile/yaml/input_place.h"
#include "seafiles/hydrodynamics_reader.h"
#include "statics/recovery/history_effect.h"
#include "study/run/static_analysis.h"

namespace overbend {
namespace {

std::string file_text(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Identifies a stage by the bits of its values in SI; its displayed values depend on the units shown.
std::string stage_text(const LayStageDescription& stage, OperationType type) {
  std::string text = fmt::format("stage '{}' of the operation {}:", stage.name, operation_name(type));
  for (const std::optional<double>& value : {stage.cable_out, stage.pipe_out, stage.passed, stage.ahead, stage.tension,
                                             stage.bottom_tension, stage.tank_weight, stage.tank_ballast}) {
    text += value ? fmt::format(" {:a}", *value) : " -";
  }
  return text;
}

/// Returns the files that the model names, including all hydrodynamic files of one stem that may be read.
std::vector<std::string> named_files(const Description& d) {
  std::vector<std::string> files = {d.vessel.motion_file};
  for (const WavesDescription& waves : d.environment.waves) files.push_back(waves.spectrum_file);
  files.push_back(d.environment.seabed.bathymetry_file);
  for (const WavesDescription& waves : d.environment.waves) files.push_back(waves.elevation_file);
  for (const BodyDescription& body : d.bodies) files.push_back(body.hull.motion_file);
  if (d.vessel.coupled) {
    files.push_back(d.vessel.coupled->current.table_file);
    files.push_back(d.vessel.coupled->wind.table_file);
    for (std::string& file : hydrodynamic_files(d.vessel.coupled->hydrodynamics)) files.push_back(std::move(file));
  }
  std::error_code error;
  std::erase_if(files, [&](const std::string& file) { return !std::filesystem::is_regular_file(file, error); });
  return files;
}

/// Notes differences between the dynamic run and a static analysis of the hull alone.
void add_dynamic_hull_notes(const Description& description, StaticResults& statics) {
  if (statics.moorings && statics.moorings->operation == "moored" && !statics.moorings->stages.empty()) {
    statics.findings.push_back(
        {FindingCode::stages_at_rest,
         "the stages of the operation are static states: the dynamic run starts from the equilibrium before them"});
  }
  if (hull_is_free(description) && description.vessel.motion != VesselMotion::coupled) {
    statics.findings.push_back(
        {FindingCode::vessel_moves_as_prescribed,
         "in the dynamic run the vessel follows vessel.motion from its equilibrium and does not respond to its lines: "
         "vessel.hydrostatics apply to statics only; use vessel.motion.coupled for a floating hull"});
  }
}

StaticResults statics_before_run(const Model& model, const ModelEquilibrium& equilibrium) {
  StaticResults statics = checked_statics(model, equilibrium);
  const bool pipe = equilibrium.solution->has_pipe();
  if (pipe) note_history_effect(model, *equilibrium.solution, statics);
  add_hull_results(model, statics);
  if (!pipe && (statics.moorings || hull_is_free(model.description))) {
    add_dynamic_hull_notes(model.description, statics);
  }
  return statics;
}

}  // namespace

std::string input_text(const Description& d) {
  std::string text = d.source_text;
  // The contents of the files, not their paths: these depend on how the path of the model was written.
  for (const std::string& file : named_files(d)) {
    text += "\n# " + std::to_string(file_text(file).size()) + " bytes\n" + file_text(file);
  }
  if (d.stage) {
    text += "\n# " + stage_text(*d.stage, d.operation.type) + "\n";
  }
  return text + fmt::format("\n# duration {:a}\n", d.dynamics ? d.dynamics->duration : 0.0);
}

void use_controllers(PreparedCase& prepared, std::vector<ControllerUse> controllers) {
  for (const ControllerUse& use : controllers) {
    prepared.input += fmt::format("\n# controller of '{}' every {:a} s\n", use.machine, use.interval);
  }
  prepared.controllers = std::move(controllers);
}

std::string failure_line(const StaticFailure& failure) {
  const std::string where = failure.where.empty() ? "" : " (" + failure.where + ")";
  return failure.what + where + ": " + failure.why;
}

RunResult failure_result(const StaticFailure& failure, const Description& description) {
  if (failure.input && !failure.key.empty()) {
    return {RunStatus::wrong_input,
            input_place(description.source_file, description.source_text, failure.key) + ": " + failure_line(failure)};
  }
  if (failure.input) return {RunStatus::wrong_input, failure_line(failure)};
  return {RunStatus::no_solution, "no solution: " + failure_line(failure)};
}

std::optional<RunResult> reject_calm_run(const Description& description) {
  for (const Finding& finding : model_findings(build_model(description))) {
    if (finding.code != FindingCode::nothing_moves) continue;
    return RunResult{RunStatus::wrong_input,
                     finding.message +
                         "; add waves, for example environment.waves: {type: jonswap, hs: 1.5 m, tp: 7 s}, "
                         "and vessel.motion"};
  }
  return std::nullopt;
}

std::variant<std::shared_ptr<const PreparedCase>, RunResult> prepare_case(
    const Description& description, const std::vector<ControllerUse>& controllers) {
  Model model = build_model(description);
  if (const std::optional<StaticFailure> unsupported = unsupported_in_dynamics(model)) {
    return failure_result(*unsupported, description);
  }
  ModelEquilibrium equilibrium = solve_equilibrium(model);
  if (equilibrium.failure) return failure_result(*equilibrium.failure, description);
  StaticResults statics = statics_before_run(model, equilibrium);
  const auto prepared = std::make_shared<PreparedCase>(PreparedCase{
      description, std::move(model), std::move(*equilibrium.solution), std::move(statics), input_text(description)});
  use_controllers(*prepared, controllers);
  return prepared;
}

}  // namespace overbend
