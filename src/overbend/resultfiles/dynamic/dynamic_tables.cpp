#include <algorithm>
#include <stdexcept>

#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/static/csv_tables.h"
#include "resultfiles/tables/csv_fields.h"
#include "results/fields/dynamic_tables.h"

namespace overbend {
namespace {

/// Two neighbours in an ascending list and the interpolation weight between them.
struct Between {
  std::size_t left = 0, right = 0;
  double share = 0.0;

  Between(const std::vector<double>& s, double arc_length) {
    right = static_cast<std::size_t>(std::lower_bound(s.begin(), s.end(), arc_length) - s.begin());
    right = std::min(right, s.size() - 1);
    left = (right == 0 || s[right] <= arc_length) ? right : right - 1;
    share = left == right ? 0.0 : (arc_length - s[left]) / (s[right] - s[left]);
  }
  double of(const std::vector<double>& values) const {
    return values.at(left) + share * (values.at(right) - values.at(left));
  }
};

/// Writes the envelopes at an arc length of the line.
struct EnvelopeCells {
  CsvCells cells;
  Between between;

  void spread(const ResultField& field, const Envelope& e) {
    if (field.heading.empty()) return;
    cells.spread(field, {between.of(e.min), between.of(e.max), between.of(e.mean), between.of(e.std)});
  }
  template <class List>
  void operator()(const ResultField&, const List&) {}  // the static state is already in the row
};

struct EnvelopeHead {
  CsvHead cells;

  void spread(const ResultField& field, const Envelope& e) { cells.spread(field, e); }
  template <class List>
  void operator()(const ResultField&, const List&) {}
};

void append(std::vector<std::string>& head, const std::vector<std::string>& names) {
  head.insert(head.end(), names.begin(), names.end());
}

const RollerDynamics* find_roller(const SupportDynamics& support, std::size_t row, RollerPosition position) {
  for (const RollerDynamics& roller : support.rollers) {
    if (roller.row == static_cast<int>(row) && roller.position == position) return &roller;
  }
  return nullptr;
}

/// Writes the support and the roller of an impact; cells stay empty without one.
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
  if (dynamics.station_s.empty()) throw std::runtime_error("a dynamic analysis without stations");
  EnvelopeHead envelopes;
  visit_dynamic_stations(dynamics, envelopes);
  std::vector<std::string> head = pipe_head();
  append(head, envelopes.cells.names);
  CsvTable table(head);
  for (const Station& station : statics.stations) {
    pipe_cells(table, statics, station);
    EnvelopeCells cells{{table}, Between(dynamics.station_s, station.s)};
    visit_dynamic_stations(dynamics, cells);
    table.end_row();
  }
  return table.text();
}

std::string dynamic_supports_table(const StaticResults& statics, const DynamicResults& dynamics) {
  CsvHead over_time;
  const RollerDynamics example{};
  visit_dynamic_roller(example, over_time);
  std::vector<std::string> head = supports_head();
  append(head, over_time.names);
  CsvTable table(head);
  CsvCells cells{table};
  for (std::size_t b = 0; b < statics.supports.size(); ++b) {
    const SupportResult& support = statics.supports[b];
    for (std::size_t i = 0; i < support.rows.size(); ++i) {
      for (const RollerResult& roller : support.rows[i].rollers) {
        const RollerDynamics* found = find_roller(dynamics.supports.at(b), i, roller.position);
        if (found == nullptr) throw std::runtime_error("a roller of '" + support.name + "' without dynamics");
        roller_cells(table, statics, support, i, roller);
        visit_dynamic_roller(*found, cells);
        table.end_row();
      }
    }
  }
  return table.text();
}

std::string impacts_table(const DynamicResults& results) {
  CsvHead head{{"support", "row", "position"}};
  const Impact example{};
  visit_impact(example, head);
  CsvTable table(head.names);
  CsvCells cells{table};
  for (const Impact& impact : results.hardest_impacts) {
    place_cells(table, results, impact.roller);
    visit_impact(impact, cells);
    table.end_row();
  }
  return table.text();
}

}  // namespace overbend
