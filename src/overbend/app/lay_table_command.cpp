#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/finding_lines.h"
#include "base/constants.h"
#include "resultfiles/lay_table_writer.h"
#include "runstore/staged_folder.h"
#include "seafiles/route_depths_reader.h"
#include "study/lay_table.h"
#include "study/lay_table_range.h"

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
            << fmt::format("  {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9} {:>7}\n", table.route ? "km" : "m",
                           "kN", "kN", "m", "deg", "m", "MPa", "MPa", "kN", "-");
}

std::string verdict_words(const LayTableRow& row) {
  const std::string kind = row.kind == LayRowKind::step ? "" : row.kind == LayRowKind::least ? "least, " : "largest, ";
  return kind + lay_verdict(row) + (remark_of(row).empty() ? "" : ": " + remark_of(row));
}

void print_row(const LayTable& table, const LayTableRow& row) {
  const double first = table.route ? 1e-3 * row.distance.value_or(0.0) : row.depth;
  if (!row.lay) {
    const std::string of = table.vary == LayTableVary::tension && !table.route
                               ? fmt::format("{:>9.1f}", 1e-3 * row.varied)
                               : fmt::format("{:>9}", "-");
    const std::string lay_back =
        table.vary == LayTableVary::lay_back ? fmt::format("{:>9.2f}", row.varied) : fmt::format("{:>9}", "-");
    std::cout << fmt::format("  {:>9.3f} {} {:>9} {} {:>55}  {}\n", first, of, "-", lay_back, "", verdict_words(row));
    return;
  }
  const LayTableValues& v = *row.lay;
  std::cout << fmt::format(
      "  {:>9.3f} {:>9.1f} {:>9.1f} {:>9.2f} {:>9.2f} {:>9} {:>9.1f} {:>9.1f} {:>9.1f} {:>7}  {}\n", first,
      1e-3 * v.top_tension, 1e-3 * v.bottom_tension, v.lay_back, kToDegrees * v.departure_angle,
      v.tip_separation ? fmt::format("{:.3f}", *v.tip_separation) : "-", 1e-6 * v.overbend_bending_stress,
      1e-6 * v.sagbend_bending_stress, 1e-3 * v.largest_reaction,
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
  if (!description->has_pipe) return tell({RunEnding::wrong_input, "a lay table needs a model with a pipe"});
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
