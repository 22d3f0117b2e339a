#include "orcaflex/import_orcaflex.h"

#include "base/text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

/// Groups of objects without a counterpart.
void report_other_objects(Translation& translation) {
  for (const char* group : {"6DBuoys", "3DBuoys", "Links", "Shapes", "Constraints", "FlexJoints", "Turbines"}) {
    for (const Object& object : translation.objects(group)) {
      translation.left_out(std::string(group) + " " + for_display(object.name()), true);
    }
  }
}

std::string analysis_text(Translation& translation) {
  const Line* pipe = translation.laid_pipe();
  if (pipe == nullptr) return "";
  const std::string policy = pipe->object->text("StaticsSeabedFrictionPolicy", "None");
  if (policy == "None") {
    translation.approximated(
        "no seabed friction in statics: the pipe lies straight, where friction has nothing to hold");
  }
  return "analysis:\n  static: {laying: static}\n";
}

}  // namespace

std::optional<ImportedModel> import_orcaflex(const std::filesystem::path& file, const ImportOptions& options,
                                             Diagnostics& diagnostics, const FileText& file_text) {
  const Document document = read_document(file, file_text, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  Translation translation(document, options, diagnostics);
  const std::optional<Object> general = translation.group("General");
  translation.units = read_units(general);
  if (const std::optional<Object> environment = translation.group("Environment")) {
    translation.water_level = environment->number("WaterSurfaceZ").value_or(0.0) * translation.units.length;
  }
  read_vessel(translation);
  if (diagnostics.has_errors()) return std::nullopt;
  read_lines(translation);
  if (diagnostics.has_errors()) return std::nullopt;
  if (translation.lines.empty()) {
    diagnostics.add(
        {Severity::error, file.string(), 0, 0, "Lines", "no line", "a pipe, a mooring line or another line", ""});
    return std::nullopt;
  }
  const std::string title = options.title.empty() ? file.stem().string() : options.title;
  std::string text = "overbend: 1\ntitle: " + name_text(title) + "\n\n";
  for (const auto part : {environment_text, pipe_text, vessel_text, tensioner_text, supports_text, moorings_text,
                          lines_text, analysis_text}) {
    text += part(translation);
  }
  report_other_objects(translation);
  translation.left_out("solver, time step and log settings");
  if (diagnostics.has_errors()) return std::nullopt;
  const std::string head = "# Translated from " + for_display(file.filename().string(), 200) + " of OrcaFlex.\n";
  return ImportedModel{head + text, std::move(translation.account)};
}

}  // namespace overbend::orcaflex
