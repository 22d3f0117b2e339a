#include "modelfile/fields/field_table.h"

#include "modelfile/fields/field_rows.h"
#include "modelfile/fields/field_rows_fatigue.h"
#include "modelfile/schema/make_field_tree.h"

namespace overbend {
namespace {

using namespace field_rows;

std::vector<Field> head() {
  return {
      {.path = "overbend",
       .member = read_elsewhere(),
       .kind = FieldKind::integer,
       .text = "Version of the model file's format.",
       .required = true,
       .range = {.low = kFormatVersion, .high = kFormatVersion}},
      {.path = "title",
       .member = fills(&Description::title),
       .kind = FieldKind::text,
       .text = "Title of the report.",
       .fallback_text = "name of the file"},
  };
}

Field report_entry(const std::string& key, std::string ReportDescription::*member, const char* text) {
  return {.path = "report." + key,
          .member = fills(member),
          .kind = FieldKind::text,
          .text = text,
          .fallback_text = "not shown"};
}

std::vector<Field> report() {
  return {
      {.path = "report",
       .member = enters(&Description::report),
       .text = "Document control on the first page of the report."},
      report_entry("client", &ReportDescription::client, "Client of the analysis."),
      report_entry("project", &ReportDescription::project, "Name or number of the project."),
      report_entry("document", &ReportDescription::document, "Number of the document."),
      report_entry("revision", &ReportDescription::revision, "Revision of the document."),
      report_entry("prepared", &ReportDescription::prepared, "Name of the author, and date."),
      report_entry("checked", &ReportDescription::checked, "Name of the checker, and date."),
  };
}

}  // namespace

const std::vector<Field>& field_table() {
  static const std::vector<Field> kTable = [] {
    std::vector<Field> table;
    for (auto* part : {head,      report,    environment, waves,    pipe,     vessel,  hull,         motion_convention,
                       tensioner, rollers,   supports,    route,    moorings, bodies,  free_lines,   station_keeping,
                       operation, lay_table, seek,        analysis, checks,   fatigue, sensitivities}) {
      append(table, part());
    }
    for (Field& row : table) complete_from_member(row);
    return table;
  }();
  return kTable;
}

const FieldNode& field_tree() {
  static const FieldNode kTree = [] {
    static const Field kRoot{.path = "", .kind = FieldKind::map, .text = "The model file."};
    FieldNode root = make_field_tree(field_table(), kRoot);
    check_types(root, typeid(Description));
    return root;
  }();
  return kTree;
}

const FieldNode& field_node(const std::string& path) {
  return place_in(field_tree(), path);
}

}  // namespace overbend
