#include <fmt/format.h>

#include <algorithm>

#include "report/dynamic/dynamic_sections.h"
#include "report/page/listing.h"

namespace overbend {
namespace {

std::string statistics_text(const SummaryStatistics& spread, std::string_view si, int digits) {
  return fmt::format("{} to {}, mean {}", shown_number(spread.min, si, digits), shown_number(spread.max, si, digits),
                     shown_number(spread.mean, si, digits));
}

/// `on`: object on which the work is done.
Blocks energy_tables(const EnergyBalance& e, const std::string& on) {
  const auto row = [](Table& table, const char* name, double value, RowMark mark = RowMark::none) {
    table.row({name, value}, mark);
  };
  const std::vector<TableColumn> columns = {TableColumn("Energy"), {"Value", "J", 3}};
  Table in{"Energy: work done on " + on + ", and losses", columns};
  row(in, "Work of the water", e.fluid);
  row(in, "Work of the rollers' motion", e.rollers);
  row(in, "Work at the tensioner", e.top);
  row(in, "Work at the anchor", e.anchor);
  if (e.on_bodies) row(in, "Work of waves, wind and machines on floating bodies", *e.on_bodies);
  row(in, "Total work done", e.fluid + e.rollers + e.top + e.anchor + e.on_bodies.value_or(0.0), RowMark::total);
  row(in, "Dissipated in contacts", e.contact_loss);
  row(in, "Dissipated by friction", e.friction_loss);
  row(in, "Dissipated in the seabed", e.seabed_loss);
  if (e.yielding_loss > 0.0) row(in, "Dissipated in yielding steel", e.yielding_loss);
  if (e.line_loss > 0.0) row(in, "Dissipated in ropes and chains", e.line_loss);
  row(in, "Lost", e.contact_loss + e.friction_loss + e.seabed_loss + e.yielding_loss + e.line_loss, RowMark::total);
  Table stored{"Energy: stored, change since the start", columns};
  row(stored, "Motion", e.kinetic);
  row(stored, "Strain", e.strain);
  row(stored, "Height", e.gravity);
  row(stored, "Contacts", e.contact);
  row(stored, "Seabed", e.seabed);
  if (e.bodies) row(stored, "Floating bodies, kinetic and potential energy", *e.bodies);
  row(stored, "Stored", e.kinetic + e.strain + e.gravity + e.contact + e.seabed + e.bodies.value_or(0.0),
      RowMark::total);
  row(stored, "Stored + dissipated - work done", e.error);
  row(stored, "Total energy exchanged (sum of absolute values)", e.throughput);
  stored.row({"Drift, error relative to energy exchanged", fixed(100.0 * e.drift(), 4) + " %"}, RowMark::total);
  return in + stored;
}

Table run_table(const DynamicResults& r) {
  const DynamicRunReport& run = r.run;
  const double steps = static_cast<double>(std::max<std::int64_t>(run.steps, 1));
  return Listing("Time integration")
      .add("Simulated, build-up and storm", fixed(r.build_up + r.duration, 1), "s")
      .add("Steps", std::to_string(run.steps))
      .add("Steps rejected", std::to_string(run.rejected_steps))
      .add("Smallest step", fmt::format("{:.4g}", run.min_step_taken), "s")
      .add("Largest step", fmt::format("{:.4g}", run.max_step_taken), "s")
      .add("Newton iterations", std::to_string(run.newton_iterations))
      .add("Newton iterations per step", fixed(static_cast<double>(run.newton_iterations) / steps, 2))
      .add("Factorisations of the tangent matrix", std::to_string(run.factorisations))
      .add("Output step of histories", fmt::format("{:.4g}", r.output_step), "s")
      .add("Wall time of the time loop", fixed(run.wall_time, 1), "s")
      .add("Simulated time divided by elapsed time", fmt::format("{:.3g}", run.real_time_ratio))
      .table();
}

}  // namespace

Blocks tensioner_section(const StaticResults& statics, const DynamicResults& results) {
  if (!statics.has_pipe()) return {};
  const TensionerDynamics& t = results.tensioner;
  const auto share = [&](double time) {
    return fixed(time, 1) + " s, " + fixed(results.duration > 0.0 ? 100.0 * time / results.duration : 0.0, 1) + " %";
  };
  const auto times = [&](double time, std::int64_t count) { return fmt::format("{}, {} times", share(time), count); };
  Listing listing("");
  listing.add("Mode", t.mode)
      .add("Static tension", shown_number(statics.top_tension, "N", 2), shown_name("N"))
      .add("Tension", statistics_text(t.tension, "N", 1), shown_name("N"))
      .add("Tension, standard deviation", shown_number(t.tension.std, "N", 2), shown_name("N"));
  if (t.range_high > t.range_low) {
    listing
        .add("Operational range", shown_number(t.range_low, "N", 1) + " to " + shown_number(t.range_high, "N", 1),
             shown_name("N"))
        .add("Time out of the operational range", share(t.time_out_of_range));
  }
  if (t.mode != "locked") {
    listing.add("Travel, positive when paid out", statistics_text(t.travel, "m", 3), shown_name("m"));
  }
  if (t.mode == "controlled") {
    listing.add("Travel limit", t.travel_limit > 0.0 ? shown_number(t.travel_limit, "m", 2) : "none", shown_name("m"))
        .add("Time holding", share(t.time_holding))
        .add("Time waiting during the delay", share(t.time_delayed))
        .add("Time paying out", times(t.time_paying_out, t.pay_out_count))
        .add("Time hauling in", times(t.time_hauling_in, t.haul_in_count))
        .add("Time at its travel limit", times(t.time_at_limit, t.limit_count));
  }
  return block::section("tensioner", "Tensioner", listing.table());
}

Blocks dynamic_run_section(const DynamicResults& results) {
  const char* const on = results.station_s.empty() ? "hull and lines"
                         : results.energy.bodies   ? "pipe, lines and floating bodies"
                                                   : "the pipe";
  return block::section("run", "Appendix: energy balance and run",
                        block::columns(energy_tables(results.energy, on) + run_table(results)) +
                            block::remark("Time integration: " + results.run.integrator + "."));
}

}  // namespace overbend
