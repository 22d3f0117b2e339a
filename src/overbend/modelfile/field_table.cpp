#include "modelfile/field_table.h"

#include <iterator>

#include "modelfile/field_rows.h"

namespace overbend {
namespace {

using namespace field_rows;

std::vector<Field> head() {
  return {
      {.path = "overbend",
       .kind = FieldKind::integer,
       .text = "Version of the model file's format.",
       .required = true,
       .range = {.low = kFormatVersion, .high = kFormatVersion}},
      {.path = "title", .kind = FieldKind::text, .text = "Title of the report.", .fallback_text = "name of the file"},
  };
}

Field report_entry(const char* path, const char* text) {
  return {.path = path, .kind = FieldKind::text, .text = text, .fallback_text = "not shown"};
}

std::vector<Field> report() {
  return {
      {.path = "report", .text = "Document control on the first page of the report."},
      report_entry("report.client", "For whom the analysis is made."),
      report_entry("report.project", "Name or number of the project."),
      report_entry("report.document", "Number of the document."),
      report_entry("report.revision", "Revision of the document."),
      report_entry("report.prepared", "Who prepared it, and when."),
      report_entry("report.checked", "Who checked it, and when."),
  };
}

}  // namespace

const std::vector<Field>& field_table() {
  static const std::vector<Field> kTable = [] {
    std::vector<Field> table;
    for (auto* part : {head, report, environment, waves, pipe, vessel, motion_convention, tensioner, rollers, supports,
                       analysis, checks}) {
      const std::vector<Field> rows = part();
      table.insert(table.end(), rows.begin(), rows.end());
    }
    return table;
  }();
  return kTable;
}

}  // namespace overbend
