#include <fmt/format.h>

#include <algorithm>

#include "report/dynamic/dynamic_sections.h"
#include "report/page/html.h"
#include "report/page/quantity.h"

namespace overbend {
namespace {

using html::fixed;

html::Table listing(const std::string& caption) {
  return html::Table(caption, {{"Quantity", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain");
}

std::string spread_words(const Spread& spread, std::string_view si, int digits) {
  return fmt::format("{} to {}, mean {}", shown_number(spread.min, si, digits), shown_number(spread.max, si, digits),
                     shown_number(spread.mean, si, digits));
}

html::Table energy_listing(const std::string& caption) {
  return html::Table(caption, {{"Energy", "", true}, {"Value", shown_name("J")}}, "plain");
}

/// `on`: what the work is done on.
std::string energy_tables(const EnergyBalance& e, const std::string& on) {
  const auto row = [](html::Table& table, const char* name, double value, const char* css = "") {
    table.row({name, quantity("energy", "J").text(value, 3)}, css);
  };
  html::Table in = energy_listing("Energy: work done on " + on + ", and losses");
  row(in, "Work of the water", e.fluid);
  row(in, "Work of the rollers' motion", e.rollers);
  row(in, "Work at the tensioner", e.top);
  row(in, "Work at the anchor", e.anchor);
  if (e.on_bodies) row(in, "Work of waves, wind and machines on what floats", *e.on_bodies);
  row(in, "Work in", e.fluid + e.rollers + e.top + e.anchor + e.on_bodies.value_or(0.0), "total");
  row(in, "Lost in contacts", e.contact_loss);
  row(in, "Lost to friction", e.friction_loss);
  row(in, "Lost in the seabed", e.seabed_loss);
  if (e.yielding_loss > 0.0) row(in, "Lost in yielding steel", e.yielding_loss);
  if (e.line_loss > 0.0) row(in, "Lost in ropes and chains", e.line_loss);
  row(in, "Lost", e.contact_loss + e.friction_loss + e.seabed_loss + e.yielding_loss + e.line_loss, "total");
  html::Table stored = energy_listing("Energy: stored, change since the start");
  row(stored, "Motion", e.kinetic);
  row(stored, "Strain", e.strain);
  row(stored, "Height", e.gravity);
  row(stored, "Contacts", e.contact);
  row(stored, "Seabed", e.seabed);
  if (e.bodies) row(stored, "What floats, its motion and place", *e.bodies);
  row(stored, "Stored", e.kinetic + e.strain + e.gravity + e.contact + e.seabed + e.bodies.value_or(0.0), "total");
  row(stored, "Stored + lost - work in", e.error);
  row(stored, "Total energy exchanged (sum of absolute values)", e.throughput);
  stored.row({"Drift, error relative to energy exchanged", fixed(100.0 * e.drift(), 4) + " %"}, "total");
  return in.str() + stored.str();
}

std::string run_table(const DynamicResults& r) {
  const DynamicRunReport& run = r.run;
  const double steps = static_cast<double>(std::max<std::int64_t>(run.steps, 1));
  html::Table table = listing("Time integration");
  table.row({"Simulated, build-up and storm", fixed(r.build_up + r.duration, 1), "s"})
      .row({"Steps", std::to_string(run.steps), ""})
      .row({"Steps rejected", std::to_string(run.rejected_steps), ""})
      .row({"Smallest step", fmt::format("{:.4g}", run.smallest_step), "s"})
      .row({"Largest step", fmt::format("{:.4g}", run.largest_step), "s"})
      .row({"Newton iterations", std::to_string(run.newton_iterations), ""})
      .row({"Newton iterations per step", fixed(static_cast<double>(run.newton_iterations) / steps, 2), ""})
      .row({"Factorisations of the whole tangent", std::to_string(run.factorisations), ""})
      .row({"Output step of histories", fmt::format("{:.4g}", r.output_step), "s"})
      .row({"Time in the loop", fixed(run.wall_time, 1), "s"})
      .row({"Simulated time divided by elapsed time", fmt::format("{:.3g}", run.real_time_ratio), ""});
  return table.str();
}

}  // namespace

std::string tensioner_section(const StaticResults& statics, const DynamicResults& results) {
  if (!statics.has_pipe()) return "";
  const TensionerDynamics& t = results.tensioner;
  const auto share = [&](double time) {
    return fixed(time, 1) + " s, " + fixed(results.duration > 0.0 ? 100.0 * time / results.duration : 0.0, 1) + " %";
  };
  html::Table table = listing("");
  table.row({"Mode", t.mode, ""})
      .row({"Static tension", forces().text(statics.top_tension, 2), shown_name("N")})
      .row({"Tension", spread_words(t.tension, "N", 1), shown_name("N")})
      .row({"Tension, standard deviation", forces().text(t.tension.std, 2), shown_name("N")});
  if (t.range_high > t.range_low) {
    table
        .row({"Operational range", forces().text(t.range_low, 1) + " to " + forces().text(t.range_high, 1),
              shown_name("N")})
        .row({"Time out of the operational range", share(t.time_out_of_range), ""});
  }
  if (t.mode != "locked") {
    table.row({"Travel, positive when paid out", spread_words(t.travel, "m", 3), shown_name("m")});
  }
  if (t.mode == "controlled") {
    table.row({"Travel limit", t.travel_limit > 0.0 ? shown_number(t.travel_limit, "m", 2) : "none", shown_name("m")})
        .row({"Time holding", share(t.time_holding), ""})
        .row({"Time waiting for its delay", share(t.time_delayed), ""})
        .row({"Time paying out", share(t.time_paying_out) + ", " + std::to_string(t.pay_out_count) + " times", ""})
        .row({"Time hauling in", share(t.time_hauling_in) + ", " + std::to_string(t.haul_in_count) + " times", ""})
        .row(
            {"Time at its travel limit", share(t.time_at_limit) + ", " + std::to_string(t.limit_count) + " times", ""});
  }
  return html::section("tensioner", "Tensioner", table.str());
}

std::string dynamic_run_section(const DynamicResults& results) {
  return html::section("run", "Appendix: energy balance and run",
                       "<div class=\"columns\">\n" +
                           energy_tables(results.energy, results.station_s.empty() ? "hull and lines"
                                                         : results.energy.bodies   ? "pipe, lines and what floats"
                                                                                   : "the pipe") +
                           run_table(results) + "</div>\n<p class=\"small\">Time integration: " +
                           html::escape(results.run.integrator) + ".</p>\n");
}

}  // namespace overbend
