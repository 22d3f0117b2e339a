#include "report/stages/operation_report.h"

#include "report/page/calculation_sheet.h"
#include "report/page/listing.h"
#include "report/page/make_front_page.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"
#include "report/stages/lift_report.h"
#include "report/stages/operation_verdict.h"
#include "report/stages/procedure_section.h"
#include "report/stages/stage_labels.h"
#include "report/stages/stages_data.h"
#include "report/stages/stages_section.h"
#include "report/static/passage_section.h"
#include "results/findings.h"

namespace overbend {
namespace {

Assumptions all_assumptions(const OperationResults& results) {
  Assumptions all = results.assumptions;
  for (const StageResult& stage : results.stages) {
    if (stage.lay) all = merge(std::move(all), stage.lay->assumptions);
  }
  return all;
}

void add_head(const HeadDescription& head, Listing& table) {
  table.add("Head, length", head.length, "m")
      .add("Head, weight in air", head.weight_in_air, "N")
      .add("Head, submerged weight", head.weight_submerged, "N");
}

void add_cable(const CableDescription& cable, Listing& table) {
  table.add("Cable, diameter", cable.diameter, section_length())
      .add("Cable, weight in air", cable.weight_in_air, line_weight())
      .add("Cable, submerged weight", cable.weight_submerged, line_weight())
      .add("Cable, axial stiffness", cable.axial_stiffness, "N");
  if (cable.breaking_load) table.add("Cable, breaking load", *cable.breaking_load, "N");
  if (cable.length) table.add("Cable, length", *cable.length, "m");
  if (cable.friction) table.add("Cable, friction on the seabed", *cable.friction, "1");
}

/// Head, cable, winch and anchor as the model gives them.
Blocks gear_section(const std::optional<Description>& description) {
  if (!description) return {};
  const LayOperationDescription& lay = description->operation.lay;
  if (!lay.head && !lay.cable) return {};
  Listing table("");
  if (lay.head) add_head(*lay.head, table);
  if (lay.cable) add_cable(*lay.cable, table);
  const bool away = drags_along_bed(description->operation.type);
  if (lay.winch && away) {
    table.add("Winch, distance astern", lay.winch->distance, "m").add("Winch, depth", lay.winch->depth, "m");
  } else if (lay.winch) {
    table.add("Winch, x", lay.winch->x, "m").add("Winch, z", lay.winch->z, "m");
  }
  if (lay.anchor) table.add("Anchor, depth", lay.anchor->depth, "m");
  return block::section("gear", "Head and cable", table.table());
}

Blocks passage_part(const OperationResults& results) {
  const std::optional<PassageResults> passage = find_passage_maxima(results);
  return passage ? passage_section(*passage) : Blocks();
}

FrontPage front_of_operation(const OperationResults& results, const std::optional<Description>& description,
                             const StaticResults* lay) {
  const char* of =
      results.type == OperationType::lift ? " of lines, static analysis" : " of a pipeline, static analysis";
  FrontPage front = make_front_page(operation_title(results.type) + of, results.title, description, {});
  front.findings = operation_findings(results);
  front.reach = "Static states of all stages: the effect of waves needs a dynamic analysis of the stage.";
  if (lay != nullptr && lay->has_pipe()) front.entries = subject_entries(*lay);
  front.entries.emplace_back("Stages", std::to_string(results.stages.size()));
  front.entries.emplace_back("Program", "Overbend " + results.version);
  front.entries.emplace_back("Written", written_now());
  return front;
}

/// The rows of all stages in one table, each with the name of its stage.
CheckTable checks_of_stages(const OperationResults& results) {
  CheckTable all;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    if (!results.stages[i].lay) continue;
    for (CheckRow row : results.stages[i].lay->checks.rows) {
      row.name += ", stage " + stage_title(results, i);
      all.rows.push_back(std::move(row));
    }
  }
  return all;
}

}  // namespace

Document operation_report_document(const OperationResults& results, const std::string& model_text,
                                   const FirstSection* first) {
  const std::optional<Description> description = read_description(model_text);
  const StaticResults* lay = first_lay(results);
  const bool lift = results.type == OperationType::lift;
  Document document;
  document.title = results.title + " - " + operation_title(results.type);
  document.front =
      front_page(front_of_operation(results, description, lay), verdict_with_stage(results), operation_bars(results),
                 std::string("The mark on the bar is the full capacity. ") + kBasisOfChecks + " ");
  document.data = lift ? Json::object() : stages_data(results, description);
  if (first != nullptr) {
    document.body = first->body;
    document.data.update(first->data);
  }
  document.body += lift ? lift_sections(results, description)
                        : procedure_section(results, description) + stages_section(results) + passage_part(results);
  document.body += stage_checks_section(results) + gear_section(description);
  if (lay != nullptr) document.body += inputs_section(*lay, description, nullptr);
  document.body += assumptions_section(all_assumptions(results)) +
                   calculation_sheet_section(checks_of_stages(results)) + model_text_section(model_text);
  return document;
}

void write_operation_report(const OperationResults& results, const std::string& model_text,
                            const std::filesystem::path& file, const FirstSection* first) {
  write_page(operation_report_document(results, model_text, first), file);
}

}  // namespace overbend
