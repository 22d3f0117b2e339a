#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "base/shown_unit.h"
#include "resultfiles/studies/lay_table_writer.h"
#include "runstore/staged_folder.h"
#include "seafiles/route_depths_reader.h"
#include "statics/solver/static_obstacle.h"
#include "study/lay_table/lay_table.h"
#include "study/lay_table/lay_table_range.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

/// The table that model and options ask for. Throws std::invalid_argument, with what to tell.
LayTableDescription asked_table(const Description& description, const LayTableArguments& arguments) {
  LayTableDescription asked = description.lay_table.value_or(LayTableDescription{});
  if (!arguments.tension.empty()) take_range(LayTableVary::tension, arguments.tension, asked);
  if (!arguments.lay_back.empty()) take_range(LayTableVary::lay_back, arguments.lay_back, asked);
  if (!arguments.depth.empty()) take_range(LayTableVary::depth, arguments.depth, asked);
  if (!arguments.depths_file.empty()) {
    Diagnostics diagnostics;
    asked.profile = read_route_depths(arguments.depths_file, diagnostics);
    std::string faults;
    for (const std::string& line : diagnostics.lines(Severity::error)) faults += (faults.empty() ? "" : "\n") + line;
    if (!faults.empty()) throw std::invalid_argument(faults);
  }
  if (arguments.least) asked.tension = RouteTension::least;
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

std::string verdict_words(const LayTableRow& row) {
  const std::string kind = row.kind == LayRowKind::step ? "" : row.kind == LayRowKind::least ? "least, " : "largest, ";
  return kind + lay_verdict(row) + (remark_of(row).empty() ? "" : ": " + remark_of(row));
}

void print_row(const LayTable& table, const LayTableRow& row) {
  const std::string first =
      table.route ? shown_number(row.distance.value_or(0.0), route_length(), 3) : shown_number(row.depth, "m", 3);
  if (!row.lay) {
    const bool of_tension = table.vary == LayTableVary::tension && !table.route;
    const std::string of = of_tension ? shown_number(row.varied, "N", 1) : "-";
    const std::string lay_back = table.vary == LayTableVary::lay_back ? shown_number(row.varied, "m", 2) : "-";
    std::cout << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>55}  {}\n", first, of, "-", lay_back, "",
                             verdict_words(row));
    return;
  }
  const LayTableValues& v = *row.lay;
  std::cout << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}  {}\n", first,
                           shown_number(v.top_tension, "N", 1), shown_number(v.bottom_tension, "N", 1),
                           shown_number(v.lay_back, "m", 2), shown_number(v.departure_angle, "rad", 2),
                           v.tip_separation ? shown_number(*v.tip_separation, "m", 3) : "-",
                           shown_number(v.overbend_bending_stress, "Pa", 1),
                           shown_number(v.sagbend_bending_stress, "Pa", 1), shown_number(v.largest_reaction, "N", 1),
                           v.utilisation ? fmt::format("{:.3f}", *v.utilisation) : "-", verdict_words(row));
}

void print_table(const LayTable& table) {
  print_head(table);
  for (const LayTableRow& row : table.rows) print_row(table, row);
  std::cout << fmt::format("  overbend and sagbend: largest bending stress; {} equilibria in {:.2f} s\n", table.solves,
                           table.wall_time)
            << finding_lines(table.findings);
}

}  // namespace

int run_lay_table(const LayTableArguments& arguments) {
  const std::optional<Description> description = load_model(arguments.model_file);
  if (!description) return kWrongInput;
  if (const auto obstacle = pipe_obstacle(*description, "a lay table")) {
    return tell({RunEnding::wrong_input, *obstacle});
  }
  LayTableDescription asked;
  try {
    asked = asked_table(*description, arguments);
  } catch (const std::invalid_argument& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
  const fs::path folder = arguments.output.empty()
                              ? fs::path(fs::path(arguments.model_file).stem().string() + ".lay-table")
                              : fs::path(arguments.output);
  if (const std::optional<RunEnd> lost = files_in_the_way(arguments.model_file, folder)) return tell(*lost);
  const LayTable table = make_lay_table(*description, asked);
  try {
    write_lay_table_run(table, *description, folder);
  } catch (const UnusableFolder& fault) {
    return tell({RunEnding::wrong_input, fault.what()});
  }
  print_table(table);
  std::cout << "The lay table is in " << folder.string() << "\n";
  return kDone;
}

}  // namespace overbend
