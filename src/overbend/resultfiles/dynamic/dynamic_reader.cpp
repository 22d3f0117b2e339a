#include "resultfiles/dynamic/dynamic_reader.h"

#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/dynamic/fatigue_files.h"
#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/moored_dynamics_hdf5.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/stinger_dynamics_fields.h"

namespace overbend {
namespace {

void read_region(const Hdf5Reader& file, const std::string& group, DynamicRegion& region) {
  visit_dynamic_region(region, [&](const ResultField& field, DynamicExtreme& extreme) {
    ValueReader visit{file, group + "/" + field.name};
    visit_dynamic_extreme(field, extreme, visit);
  });
}

/// Reads whole columns of the table of stations.
struct ColumnReader {
  const Hdf5Reader& file;

  void operator()(const ResultField& field, std::vector<double>& values) const {
    values = file.doubles("/dynamic/stations/" + field.name);
  }
  void operator()(const ResultField& field, std::vector<Vec3>& places) const {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      (*this)(ResultField{component_name(field, axis)}, values);
      if (axis == 0) places.resize(values.size());
      for (std::size_t i = 0; i < places.size(); ++i) places[i](axis) = element(values, i, component_name(field, axis));
    }
  }
};

template <class Row, class Function>
void read_rows(const Hdf5Reader& file, const std::string& group, std::vector<Row>& rows, Function visit_row) {
  TableReader table(file, group);
  rows.resize(table.rows("index"));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    table.start_row(i);
    visit_row(rows[i], table);
  }
}

void read_supports(const Hdf5Reader& file, std::vector<SupportDynamics>& supports) {
  read_rows(file, "/dynamic/supports", supports, [](auto& row, auto& t) { visit_dynamic_support(row, t); });
  std::vector<SupportDynamics*> boxes;
  for (SupportDynamics& support : supports) boxes.push_back(&support);
  TableReader rollers(file, "/dynamic/rollers");
  for (std::size_t i = 0, count = rollers.rows("index"); i < count; ++i) {
    rollers.start_row(i);
    int box = -1;
    rollers(ResultField{"support"}, box);
    visit_dynamic_roller(owner(boxes, box, "roller").rollers.emplace_back(), rollers);
  }
}

void read_summaries(const Hdf5Reader& file, std::vector<HistorySummary>& histories) {
  const std::string group = "/dynamic/thinned";
  if (!file.has(group)) return;
  const std::vector<double> low = file.doubles(group + "/low"), high = file.doubles(group + "/high");
  read_rows(file, group, histories, [&](HistorySummary& h, auto& t) {
    std::int64_t first = 0, count = 0;
    t(ResultField{"name"}, h.name);
    t(ResultField{"units"}, h.units);
    t(ResultField{"meaning"}, h.description);
    t(ResultField{"first"}, first);
    t(ResultField{"count"}, count);
    visit_spread(ResultField{}, h.over_time, t);
    for (std::int64_t i = first; i < first + count; ++i) {
      h.low.push_back(element(low, static_cast<std::size_t>(i), group + "/low"));
      h.high.push_back(element(high, static_cast<std::size_t>(i), group + "/high"));
    }
  });
}

void read_spectra(const Hdf5Reader& file, std::vector<Spectrum>& spectra) {
  read_rows(file, "/dynamic/spectrum_list", spectra, [&](Spectrum& spectrum, auto& t) {
    t(ResultField{"name"}, spectrum.name);
    t(ResultField{"units"}, spectrum.units);
    const std::string group = "/dynamic/spectra/" + dataset_path(spectrum.name);
    spectrum.frequency = file.doubles(group + "/frequency");
    spectrum.density = file.doubles(group + "/density");
  });
}

/// Parts that exist only with a laid pipe.
void read_pipe_in_time(const Hdf5Reader& file, DynamicResults& results) {
  ValueReader visit{file, "/dynamic"};
  visit_pipe_over_time(results, visit, file.has("/dynamic/stinger_tip_clearance_min"));
  visit.group = "/dynamic/tensioner";
  visit_tensioner(results.tensioner, visit);
  if (file.has("/dynamic/overbend")) read_region(file, "/dynamic/overbend", results.overbend);
  visit.group = "/dynamic/smallest_tension";
  visit_dynamic_extreme(min_effective_tension_field(), results.min_effective_tension, visit);
  if (file.has("/dynamic/tower")) read_region(file, "/dynamic/tower", results.tower);
  read_region(file, "/dynamic/sagbend", results.sagbend);
  const ColumnReader stations{file};
  visit_dynamic_stations(results, stations);
  read_supports(file, results.supports);
  read_rows(file, "/dynamic/hardest_impacts", results.hardest_impacts,
            [](auto& row, auto& t) { visit_impact(row, t); });
  if (file.has("/dynamic/stinger")) {
    read_rows(file, "/dynamic/stinger", results.stinger, [](auto& row, auto& t) { visit_stinger_dynamics(row, t); });
  }
  read_fatigue(file, results);
  results.design = read_design(file);
}

DynamicResults read_dynamics(const Hdf5Reader& file) {
  DynamicResults results;
  ValueReader visit{file, "/dynamic"};
  visit_dynamic_settings(results, visit);
  if (file.has("/dynamic/stations")) read_pipe_in_time(file, results);
  visit.group = "/dynamic/energy";
  visit_energy(results.energy, visit);
  visit.group = "/dynamic/run";
  visit_dynamic_run(results.run, visit);
  read_rows(file, "/dynamic/extremes", results.extremes, [](auto& row, auto& t) { visit_estimate(row, t); });
  results.checks = read_checks(file, "/dynamic/checks");
  read_moored_dynamics(file, results);
  results.lines = read_lines_in_time(file);
  results.bodies = read_bodies_in_time(file);
  read_summaries(file, results.histories);
  read_spectra(file, results.spectra);
  return results;
}

}  // namespace

bool has_dynamic(const std::filesystem::path& h5) {
  return Hdf5Reader(h5).has("/dynamic");
}

StoredDynamics read_dynamic_results(const std::filesystem::path& h5) {
  return {read_static_results(h5), read_dynamics(Hdf5Reader(h5))};
}

}  // namespace overbend
