#include "resultfiles/summary/study_outputs.h"

#include <array>

#include "base/text.h"
#include "model/description/seek_operations.h"
#include "resultfiles/summary/named_dynamics.h"
#include "resultfiles/summary/named_results.h"
#include "resultfiles/summary/result_units.h"
#include "results/fields/object_names.h"

namespace overbend {
namespace {

constexpr const char* kStages = "operation.stages";

/// In a dynamic analysis the checks are those of the whole run, not of the static state.
std::string checks_path(StudyAnalysis analysis, const std::string& path) {
  return analysis == StudyAnalysis::dynamic && path.starts_with("checks.") ? "dynamic." + path : path;
}

bool is_minimum_result(const std::string& path) {
  const std::string last = path.substr(path.find_last_of('.') + 1);
  return last.starts_with("smallest") || last.starts_with("min");
}

/// "operation.stages[3].sagbend.max_strain" -> "static.sagbend.max_strain": every stage has the keys of a lay.
std::string stage_path(const std::string& path) {
  const std::size_t point = path.find("].");
  if (!path.starts_with(kStages) || point == std::string::npos) return path;
  const std::string below = path.substr(point + 2);
  return below.starts_with("checks.") ? below : "static." + below;
}

/// Unit of a stage's own member in addition to the keys of a lay: "operation.stages[3].barge_ahead".
std::optional<std::string> stage_member_unit(const std::string& path) {
  const std::size_t point = path.find("].");
  if (!path.starts_with(kStages) || point == std::string::npos) return std::nullopt;
  const auto unit = stage_units().find(path.substr(point + 2));
  if (unit == stage_units().end() || !unit->is_string()) return std::nullopt;
  return unit->get<std::string>();
}

std::string with_function(const ResultName& name, const std::string& path) {
  switch (name.function) {
    case ResultFunction::none:
      break;
    case ResultFunction::spread:
      return "spread(" + path + ")";
    case ResultFunction::mean:
      return "mean(" + path + ")";
    case ResultFunction::minimum:
      return "min(" + path + ")";
    case ResultFunction::maximum:
      return "max(" + path + ")";
  }
  return path;
}

std::optional<std::string> output_unit(StudyAnalysis analysis, std::string path) {
  if (analysis == StudyAnalysis::statics && path.starts_with(kStages)) return std::nullopt;
  if (analysis == StudyAnalysis::operation) {
    if (auto unit = stage_member_unit(path)) return unit;
    if (auto unit = result_unit(path)) return unit;  // in a stage of a lift
    path = stage_path(path);
  }
  for (const char* ending : {"", ".max"}) {
    const std::string name = path + ending;
    if (auto unit = analysis == StudyAnalysis::dynamic ? dynamic_result_unit(name) : result_unit(name)) return unit;
  }
  return std::nullopt;
}

using Names = std::vector<std::string>;

Names hull_outputs(bool dynamic) {
  return dynamic ? Names{"dynamic.vessel.offset",
                         "dynamic.vessel.roll",
                         "dynamic.vessel.pitch",
                         "max(dynamic.moorings[*].fairlead_tension.max)",
                         "min(dynamic.moorings[*].fairlead_tension.min)",
                         "max(dynamic.moorings[*].utilisation)"}
                 : Names{"static.vessel.surge",
                         "static.vessel.sway",
                         "static.vessel.yaw",
                         "max(static.moorings[*].fairlead_tension)",
                         "min(static.moorings[*].fairlead_tension)",
                         "max(static.moorings[*].utilisation)"};
}

Names line_outputs(bool dynamic) {
  const std::string lines = dynamic ? "dynamic.lines[*]." : "static.lines[*].";
  return {"max(" + lines + "largest_tension)", "min(" + lines + "least_tension)", "max(" + lines + "utilisation)"};
}

Names pipe_outputs(bool dynamic) {
  return dynamic ? Names{"dynamic.top_tension.min",        "dynamic.top_tension.max",       "dynamic.smallest_tension",
                         "dynamic.overbend.max_von_mises", "dynamic.sagbend.max_von_mises", "checks.governing"}
                 : Names{"static.top_tension",
                         "static.bottom_tension",
                         "static.lay_back",
                         "static.overbend.max_von_mises",
                         "static.sagbend.max_von_mises",
                         "static.largest_reaction.value",
                         "static.stinger_tip_clearance",
                         "checks.governing"};
}

/// Outputs over all stages of a lift.
Names lift_outputs() {
  const std::string stages = "operation.stages[*].";
  return {"max(" + stages + "lines[*].largest_bending_moment.value)",
          "max(" + stages + "lines[*].largest_bending_stress)",
          "max(" + stages + "davits[*].tension_upper)",
          "min(" + stages + "davits[*].tension_upper)",
          "max(" + stages + "davits[*].utilisation)",
          "checks.governing"};
}

/// Outputs over all stages of a pull along the seabed.
Names pull_outputs() {
  const std::string stages = "operation.stages[*].";
  return {"max(" + stages + "tension.winch)", "max(" + stages + "wire_utilisation)", "min(" + stages + "least_tension)",
          "max(" + stages + "sagbend.moment)", "checks.governing"};
}

constexpr std::array kOfSeek = {"seek.answer", "seek.slope", "seek.residual", "seek.evaluations"};

/// Unit of the slope of the first condition with the key, as in the summary.
std::string slope_unit(const SeekDescription& seek) {
  const std::string key = seek.vary.front().unit;
  std::string result = seek.until.empty() ? result_unit(seek.minimise).value_or("1") : seek.until.front().unit;
  if (key == "1") return result;
  if (key == result) return "1";
  return result + "/" + (key.find_first_of("/*-") == std::string::npos ? key : "(" + key + ")");
}

/// Outputs of a goal seek itself.
std::optional<StudyOutput> seek_output(const std::string& name, const std::optional<SeekDescription>& seek) {
  const bool single = seek && seek->vary.size() == 1;
  if (name == "seek.answer") return StudyOutput{name, single ? seek->vary.front().unit : "1", false};
  if (name == "seek.slope" && single) return StudyOutput{name, slope_unit(*seek), false};
  if (name == "seek.residual" || name == "seek.evaluations") return StudyOutput{name, "1", false};
  return std::nullopt;
}

}  // namespace

std::optional<StudyOutput> study_output(StudyAnalysis analysis, const std::string& name,
                                        const std::optional<SeekDescription>& seek) {
  if (name == "checks.governing") return StudyOutput{name, "", true};
  if (analysis == StudyAnalysis::seek && name.starts_with("seek.")) return seek_output(name, seek);
  const ResultName parsed = parsed_result_name(name);
  for (const std::string& path : summary_paths(parsed.path)) {
    if (const auto unit = output_unit(analysis, checks_path(analysis, path))) return StudyOutput{name, *unit, false};
  }
  return std::nullopt;
}

std::string nearest_output(StudyAnalysis analysis, const std::string& name) {
  std::vector<std::string> paths = analysis == StudyAnalysis::dynamic ? dynamic_result_paths() : result_paths();
  if (analysis == StudyAnalysis::seek) paths.insert(paths.end(), kOfSeek.begin(), kOfSeek.end());
  return nearest_word(parsed_result_name(name).path, paths);
}

std::vector<std::string> default_outputs(StudyAnalysis analysis, const Description& model) {
  const bool dynamic = analysis == StudyAnalysis::dynamic;
  const bool stages = is_seek_over_stages(model.operation.type) && !dynamic;
  const bool lift = stages && model.operation.type == OperationType::lift;
  Names names = lift                   ? lift_outputs()
                : stages               ? pull_outputs()
                : model.has_pipe       ? pipe_outputs(dynamic)
                : !model.lines.empty() ? line_outputs(dynamic)
                                       : hull_outputs(dynamic);
  if (analysis == StudyAnalysis::seek && !stages) names.insert(names.begin(), "seek.answer");
  return names;
}

std::optional<double> output_value(const Json& summary, StudyAnalysis analysis, const std::string& name) {
  const ResultName parsed = parsed_result_name(name);
  const std::string path = checks_path(analysis, parsed.path);
  if (const auto value = named_result(summary, with_function(parsed, path))) return value;
  return named_result(summary, with_function(parsed, path + (is_minimum_result(path) ? ".min" : ".max")));
}

}  // namespace overbend
