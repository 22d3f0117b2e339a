#include <algorithm>
#include <array>

#include "resultfiles/dynamic_writer.h"
#include "resultfiles/result_field.h"
#include "resultfiles/result_tables.h"

namespace overbend {
namespace {

/// A quantity of the tables with its factor from SI.
struct Quantity {
  const char* name;
  const char* units;
  double factor;
};

void add_heads(std::vector<std::string>& head, const Quantity& q) {
  for (const char* part : {"min", "max", "mean", "std"}) {
    head.push_back(std::string(q.name) + " " + part + " [" + q.units + "]");
  }
}

void spread_cells(CsvTable& table, const Spread& spread, double factor) {
  for (const double value : {spread.min, spread.max, spread.mean, spread.std}) table.cell(value * factor);
}

constexpr std::array<Quantity, 5> kEnvelopes = {{{"tension", "kN", kKilo},
                                                 {"bending moment", "kN m", kKilo},
                                                 {"bending stress", "MPa", kMega},
                                                 {"von Mises stress", "MPa", kMega},
                                                 {"strain", "%", kPercent}}};

std::array<const Envelope*, kEnvelopes.size()> envelopes(const DynamicResults& r) {
  return {&r.effective_tension, &r.bending_moment, &r.bending_stress, &r.von_mises, &r.strain};
}

/// Two neighbours in an ascending list and where between them.
struct Between {
  std::size_t left = 0, right = 0;
  double share = 0.0;

  Between(const std::vector<double>& s, double at) {
    right = static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), at) - s.begin());
    right = std::min(right, s.size() - 1);
    left = (right == 0 || s[right] <= at) ? right : right - 1;
    share = left == right ? 0.0 : (at - s[left]) / (s[right] - s[left]);
  }
  double of(const std::vector<double>& values) const {
    return values.at(left) + share * (values.at(right) - values.at(left));
  }
};

constexpr Quantity kReaction = {"reaction normal", "kN", kKilo}, kSeparation = {"separation", "m", 1.0};
const std::vector<std::string> kRollerHead = {
    "contact share [-]",      "impacts",         "largest impact force [kN]", "largest approach velocity [m/s]",
    "largest impulse [kN s]", "dent depth [mm]", "line load [kN/m]"};

const RollerDynamics* find_roller(const SupportDynamics& support, std::size_t row, RollerPosition position) {
  for (const RollerDynamics& roller : support.rollers) {
    if (roller.row == static_cast<int>(row) && roller.position == position) return &roller;
  }
  return nullptr;
}

void dynamic_cells(CsvTable& table, const RollerDynamics& r) {
  spread_cells(table, r.reaction, kReaction.factor);
  spread_cells(table, r.separation, kSeparation.factor);
  table.cell(r.contact_share).cell(std::to_string(r.impact_count)).cell(r.largest_impact_force * kKilo);
  table.cell(r.largest_approach_velocity).cell(r.largest_impulse * kKilo);
  table.cell(r.dent_depth * kMillimetres).cell(r.line_load * kKilo);
}

/// The support and the roller that an impact hit; cells stay empty where there is none such.
void place_cells(CsvTable& table, const DynamicResults& results, int index) {
  for (const SupportDynamics& support : results.supports) {
    for (const RollerDynamics& roller : support.rollers) {
      if (roller.roller != index) continue;
      table.cell(support.name).cell(std::to_string(roller.row + 1)).cell(std::string(word(roller.position)));
      return;
    }
  }
  for (int i = 0; i < 3; ++i) table.cell(std::string());
}

}  // namespace

std::string dynamic_pipe_table(const StaticResults& statics, const DynamicResults& dynamics) {
  std::vector<std::string> head = pipe_head();
  if (dynamics.station_s.empty()) throw std::runtime_error("a dynamic analysis without stations");
  for (const Quantity& quantity : kEnvelopes) add_heads(head, quantity);
  CsvTable table(head);
  for (const Station& station : statics.stations) {
    pipe_cells(table, statics, station);
    const Between between(dynamics.station_s, station.s);
    for (std::size_t i = 0; i < kEnvelopes.size(); ++i) {
      const Envelope& e = *envelopes(dynamics)[i];
      spread_cells(table, {between.of(e.min), between.of(e.max), between.of(e.mean), between.of(e.std)},
                   kEnvelopes[i].factor);
    }
    table.end_row();
  }
  return table.text();
}

std::string dynamic_supports_table(const StaticResults& statics, const DynamicResults& dynamics) {
  std::vector<std::string> head = supports_head();
  add_heads(head, kReaction);
  add_heads(head, kSeparation);
  head.insert(head.end(), kRollerHead.begin(), kRollerHead.end());
  CsvTable table(head);
  for (std::size_t b = 0; b < statics.supports.size(); ++b) {
    const SupportResult& support = statics.supports[b];
    for (std::size_t i = 0; i < support.rows.size(); ++i) {
      for (const RollerResult& roller : support.rows[i].rollers) {
        const RollerDynamics* found = find_roller(dynamics.supports.at(b), i, roller.position);
        if (found == nullptr) throw std::runtime_error("a roller of '" + support.name + "' without dynamics");
        roller_cells(table, statics, support, i, roller);
        dynamic_cells(table, *found);
        table.end_row();
      }
    }
  }
  return table.text();
}

std::string impacts_table(const DynamicResults& results) {
  CsvTable table({"support", "row", "position", "time [s]", "approach velocity [m/s]", "peak force [kN]",
                  "duration [s]", "impulse [kN s]", "dent depth [mm]", "line load [kN/m]"});
  for (const Impact& impact : results.hardest_impacts) {
    place_cells(table, results, impact.roller);
    table.cell(impact.time).cell(impact.approach_velocity).cell(impact.peak_force * kKilo).cell(impact.duration);
    table.cell(impact.impulse * kKilo).cell(impact.dent_depth * kMillimetres).cell(impact.line_load * kKilo);
    table.end_row();
  }
  return table.text();
}

}  // namespace overbend
