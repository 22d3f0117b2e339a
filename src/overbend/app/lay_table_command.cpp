#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/print_findings.h"
#include "base/shown_unit.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "runstore/staged_folder.h"
#include "seafiles/route_depths_reader.h"
#include "statics/solver/unsupported_statics.h"
#include "study/lay_table/lay_table.h"
#include "study/lay_table/lay_table_range.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// Returns the table requested by model and options. Throws std::invalid_argument with a message for the user.
LayTableDescription requested_table(const Description& description, const LayTableArguments& arguments) {
  LayTableDescription asked = description.lay_table.value_or(LayTableDescription{});
  if (!arguments.tension.empty()) take_range(LayTableVary::tension, arguments.tension, asked);
  if (!arguments.lay_back.empty()) take_range(LayTableVary::lay_back, arguments.lay_back, asked);
  if (!arguments.depth.empty()) take_range(LayTableVary::depth, arguments.depth, asked);
  if (!arguments.depths_file.empty()) {
    Diagnostics diagnostics;
    asked.profile = read_route_depths(arguments.depths_file, diagnostics);
    std::string errors;
    for (const std::string& line : diagnostics.lines(Severity::error)) errors += (errors.empty() ? "" : "\n") + line;
    if (!errors.empty()) throw std::invalid_argument(errors);
  }
  if (arguments.min_tension) asked.tension = RouteTension::minimum;
  return asked;
}

void print_head(const LayTable& table) {
  std::cout << table.title << "\n"
            << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}  {}\n",
                           table.route ? "distance" : "depth", "top", "bottom", "lay-back", "departure", "tip",
                           "overbend", "sagbend", "reaction", "util.", "verdict")
            << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}\n",
                           table.route ? route_length().name : shown_unit("m").name, shown_name("N"), shown_name("N"),
                           shown_name("m"), shown_name("rad"), shown_name("m"), shown_name("Pa"), shown_name("Pa"),
                           shown_name("N"), "-");
}

std::string row_verdict_text(const LayTableRow& row) {
  const std::string kind = row.kind == LayRowKind::step      ? ""
                           : row.kind == LayRowKind::minimum ? "least, "
                                                             : "largest, ";
  return kind + lay_verdict(row) + (make_remark(row).empty() ? "" : ": " + make_remark(row));
}

void print_row(const LayTable& table, const LayTableRow& row) {
  const std::string first =
      table.route ? shown_number(row.distance.value_or(0.0), route_length(), 3) : shown_number(row.depth, "m", 3);
  if (!row.lay) {
    const bool of_tension = table.vary == LayTableVary::tension && !table.route;
    const std::string tension_text = of_tension ? shown_number(row.varied, "N", 1) : "-";
    const std::string lay_back = table.vary == LayTableVary::lay_back ? shown_number(row.varied, "m", 2) : "-";
    std::cout << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>55}  {}\n", first, tension_text, "-", lay_back, "",
                             row_verdict_text(row));
    return;
  }
  const LayTableValues& v = *row.lay;
  std::cout << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}  {}\n", first,
                           shown_number(v.top_tension, "N", 1), shown_number(v.bottom_tension, "N", 1),
                           shown_number(v.lay_back, "m", 2), shown_number(v.departure_angle, "rad", 2),
                           v.tip_separation ? shown_number(*v.tip_separation, "m", 3) : "-",
                           shown_number(v.overbend_bending_stress, "Pa", 1),
                           shown_number(v.sagbend_bending_stress, "Pa", 1), shown_number(v.max_reaction, "N", 1),
                           v.utilisation ? fmt::format("{:.3f}", *v.utilisation) : "-", row_verdict_text(row));
}

void print_table(const LayTable& table) {
  print_head(table);
  for (const LayTableRow& row : table.rows) print_row(table, row);
  std::cout << fmt::format("  overbend and sagbend: maximum bending stress; {} equilibria in {:.2f} s\n", table.solves,
                           table.wall_time)
            << finding_lines(table.findings);
}

}  // namespace

int run_lay_table(const LayTableArguments& arguments) {
  const std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  if (const auto unsupported = missing_pipe_message(*description, "a lay table")) {
    return report_status({RunStatus::wrong_input, *unsupported});
  }
  LayTableDescription asked;
  try {
    asked = requested_table(*description, arguments);
  } catch (const std::invalid_argument& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".lay-table")
                              : fs::path(arguments.output);
  if (const std::optional<RunResult> lost = find_output_conflict(arguments.model_file, folder)) {
    return report_status(*lost);
  }
  const LayTable table = make_lay_table(*description, asked);
  try {
    write_lay_table_run(table, *description, folder);
  } catch (const UnusableFolder& error) {
    return report_status({RunStatus::wrong_input, error.what()});
  }
  print_table(table);
  std::cout << "The lay table is in " << folder.string() << "\n";
  return kDone;
}

}  // namespace overbend
