#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/moored/mooring_hdf5.h"
#include "results/fields/moored_fields.h"

namespace overbend {
namespace {

template <class Row, class Function>
void write_rows(DatasetSink& file, const std::string& group, const char* description, const std::vector<Row>& rows,
                Function visit_row) {
  TableWriter table;
  for (const Row& row : rows) {
    table(index_field("Number of the row, from 0"), table.rows());
    visit_row(row, table);
    table.end_row();
  }
  table.write(file, group, description);
}

template <class Row, class Function>
void read_rows(const Hdf5Reader& file, const std::string& group, std::vector<Row>& rows, Function visit_row) {
  TableReader table(file, group);
  rows.resize(table.rows("index"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.start_row(i);
    visit_row(rows[i], table);
  }
}

constexpr auto kEntry = [](auto& row, auto& visit) { visit_radiation_entry(row, visit); };
constexpr auto kGroup = [](auto& row, auto& visit) { visit_radiation_group(row, visit); };
constexpr auto kDamping = [](auto& row, auto& visit) { visit_mode_damping(row, visit); };

}  // namespace

void write_hull(DatasetSink& file, const HullResults& hull) {
  file.group("/hull", "The hull's radiated waves, damping and steady loads");
  ValueWriter values{file, "/hull"};
  visit_hull(hull, values);
  visit_steady_loads(hull, values);
  write_rows(file, "/hull/radiation", "Accuracy of the fit for each pair of modes", hull.entries, kEntry);
  write_rows(file, "/hull/fit", "Groups of modes fitted together", hull.groups, kGroup);
  write_rows(file, "/hull/damping", "Damping ratios of the low-frequency motions and their contributions", hull.damping,
             kDamping);
}

std::optional<HullResults> read_hull(const Hdf5Reader& file) {
  if (!file.has("/hull")) return std::nullopt;
  HullResults hull;
  ValueReader values{file, "/hull"};
  visit_hull(hull, values);
  visit_steady_loads(hull, values);
  read_rows(file, "/hull/radiation", hull.entries, kEntry);
  read_rows(file, "/hull/fit", hull.groups, kGroup);
  read_rows(file, "/hull/damping", hull.damping, kDamping);
  return hull;
}

}  // namespace overbend
