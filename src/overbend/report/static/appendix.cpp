#include <fmt/format.h>

#include "report/page/listing.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

Table force_table(const StaticResults& r) {
  Table table{"Forces on the line", {TableColumn("Force"), {"east", "N", 3}, {"north", "N", 3}, {"up", "N", 3}}};
  const std::vector<std::pair<const char*, Vec3>> forces = {
      {"Weight", r.sum_weight}, {"Buoyancy", r.sum_buoyancy},  {"Current", r.sum_current},   {"Rollers", r.sum_rollers},
      {"Seabed", r.sum_seabed}, {"Tensioner", r.top_reaction}, {"Anchor", r.anchor_reaction}};
  Vec3 sum = Vec3::Zero();
  for (const auto& [name, force] : forces) {
    table.row({name, force.x(), force.y(), force.z()});
    sum += force;
  }
  table.row({"Sum", sum.x(), sum.y(), sum.z()}, RowMark::total);
  return table;
}

Table solver_table(const StaticResults& r) {
  const auto residual = [](double value) { return fmt::format("{:.1e}", value); };
  Listing list("Solver");
  list.add("Method", r.solve.method)
      .add("Newton iterations", std::to_string(r.solve.iterations))
      .add("Relaxation steps", std::to_string(r.solve.relaxation_steps))
      .add("Largest unbalanced nodal force", residual(r.force_residual), "of the line's weight")
      .add("Sum of all forces and reactions", residual(r.global_residual), "of the line's weight")
      .add("Weight of the line in air", shown_number(r.total_weight, "N", 2), shown_name("N"))
      .add("Stations", std::to_string(r.stations.size()))
      .add("Time in the solver", fixed(r.solve.wall_time * 1e3, 1), "ms");
  if (!r.supports.empty()) {
    list.add("Largest contact stiffness", fmt::format("{:.4g}", r.roller_stiffness * shown_unit("N/m").factor),
             shown_name("N/m"))
        .add("Largest penetration into a roller", shown_number(r.max_penetration, section_length(), 3),
             std::string(section_length().name));
  }
  return list.table();
}

}  // namespace

Blocks balance_section(const StaticResults& results) {
  if (!results.has_pipe()) return {};
  Blocks body = block::columns(force_table(results) + solver_table(results));
  if (!results.solve.history.empty()) {
    body += block::subheading("Solution history") + block::list(results.solve.history, true);
  }
  return block::section("balance", "Appendix: force balance and solver", body);
}

Blocks model_text_section(const std::string& model_text) {
  return block::section("model", "Appendix: model file",
                        block::folded("Model file as given", block::verbatim(model_text)));
}

}  // namespace overbend
