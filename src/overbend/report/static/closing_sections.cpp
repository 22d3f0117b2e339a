#include <fmt/format.h>

#include "report/page/html.h"
#include "report/page/quantity.h"
#include "report/page/sections.h"

namespace overbend {
namespace {

using html::fixed;

std::string force_table(const StaticResults& r) {
  html::Table table(
      "Forces on the line",
      {{"Force", "", true}, {"east", shown_name("N")}, {"north", shown_name("N")}, {"up", shown_name("N")}}, "plain");
  const auto row = [&](const std::string& name, const Vec3& f, const std::string& css = "") {
    table.row({name, forces().text(f.x(), 3), forces().text(f.y(), 3), forces().text(f.z(), 3)}, css);
  };
  row("Weight", r.sum_weight);
  row("Buoyancy", r.sum_buoyancy);
  row("Current", r.sum_current);
  row("Rollers", r.sum_rollers);
  row("Seabed", r.sum_seabed);
  row("Tensioner", r.top_reaction);
  row("Anchor", r.anchor_reaction);
  row("Sum",
      r.sum_weight + r.sum_buoyancy + r.sum_current + r.sum_rollers + r.sum_seabed + r.top_reaction + r.anchor_reaction,
      "total");
  return table.str();
}

std::string solver_table(const StaticResults& r) {
  html::Table table("Solver", {{"Quantity", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain");
  table.row({"Method", r.solve.method, ""})
      .row({"Newton iterations", std::to_string(r.solve.iterations), ""})
      .row({"Relaxation steps", std::to_string(r.solve.relaxation_steps), ""})
      .row({"Largest unbalanced nodal force", fmt::format("{:.1e}", r.force_residual), "of the line's weight"})
      .row({"Sum of all forces and reactions", fmt::format("{:.1e}", r.global_residual), "of the line's weight"})
      .row({"Weight of the line in air", forces().text(r.total_weight, 2), shown_name("N")})
      .row({"Stations", std::to_string(r.stations.size()), ""})
      .row({"Time in the solver", fixed(r.solve.wall_time * 1e3, 1), "ms"});
  if (!r.supports.empty()) {
    table
        .row({"Largest contact stiffness", fmt::format("{:.4g}", r.roller_stiffness * shown_unit("N/m").factor),
              shown_name("N/m")})
        .row({"Largest penetration into a roller", clearances().text(r.largest_penetration, 3), clearances().unit});
  }
  return table.str();
}

}  // namespace

std::string balance_section(const StaticResults& results) {
  if (!results.has_pipe()) return "";
  std::string body = "<div class=\"columns\">\n" + force_table(results) + solver_table(results) + "</div>\n";
  if (!results.solve.history.empty()) {
    body += "<h3>Solution history</h3>\n<ol class=\"history\">\n";
    for (const std::string& stage : results.solve.history) {
      body += "<li>" + html::escape(stage) + "</li>\n";
    }
    body += "</ol>\n";
  }
  return html::section("balance", "Appendix: force balance and solver", body);
}

std::string model_text_section(const std::string& model_text) {
  return html::section("model", "Appendix: model file",
                       html::folded("Model file as given", "<pre>" + html::escape(model_text) + "</pre>"));
}

}  // namespace overbend
