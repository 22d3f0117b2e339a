#include "resultfiles/dynamic/dynamic_blocks.h"
#include "resultfiles/dynamic/dynamic_writer.h"
#include "resultfiles/dynamic/fatigue_files.h"
#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/dataset_path.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/hdf5/object_links.h"
#include "resultfiles/lines/bodies_files.h"
#include "resultfiles/lines/lines_files.h"
#include "resultfiles/moored/moored_dynamics_hdf5.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/static_scalars.h"
#include "results/fields/stinger_dynamics_fields.h"

namespace overbend {
namespace {

void write_region(Hdf5Writer& file, const std::string& group, const std::string& description,
                  const DynamicRegion& region) {
  file.group(group, description);
  visit_dynamic_region(region, [&](const ResultField& field, const DynamicExtreme& extreme) {
    ValueWriter visit{file, group + "/" + field.name};
    file.group(visit.group, std::string(field.description));
    visit_dynamic_extreme(field, extreme, visit);
  });
}

template <class Function, class Part>
void write_part(Hdf5Writer& file, const std::string& group, const std::string& description, Function visit_part,
                const Part& part) {
  file.group(group, description);
  ValueWriter visit{file, group};
  visit_part(part, visit);
}

/// Writes whole columns of the table of stations.
struct ColumnWriter {
  Hdf5Writer& file;

  void operator()(const ResultField& field, const std::vector<double>& values) {
    const std::string path = "/dynamic/stations/" + field.name, scale = "/dynamic/stations/s";
    file.write(path, field, values, {values.size()});
    if (path == scale) {
      file.make_scale(path, field.name);
    } else {
      file.attach_scale(path, scale);
    }
  }
  void operator()(const ResultField& field, const std::vector<Vec3>& places) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<double> values;
      for (const Vec3& place : places) values.push_back(place(axis));
      (*this)(ResultField{component_name(field, axis), field.units, field.description, field.frame}, values);
    }
  }
};

void write_supports(Hdf5Writer& file, const std::vector<SupportDynamics>& supports) {
  TableWriter boxes, rollers;
  for (const SupportDynamics& support : supports) {
    for (const RollerDynamics& roller : support.rollers) {
      rollers(index_field("Number of the row of this table, from 0"), rollers.rows());
      rollers(ResultField{"support", "1", "Index of its box in the table of supports"}, boxes.rows());
      visit_dynamic_roller(roller, rollers);
      rollers.end_row();
    }
    boxes(index_field("Number of the box, from 0"), boxes.rows());
    visit_dynamic_support(support, boxes);
    boxes.end_row();
  }
  boxes.write(file, "/dynamic/supports", "Roller boxes over time");
  rollers.write(file, "/dynamic/rollers", "Rollers over time");
}

template <class Row, class Function>
void write_rows(Hdf5Writer& file, const std::string& group, const char* description, const std::vector<Row>& rows,
                Function visit_row) {
  TableWriter table;
  for (const Row& row : rows) {
    table(index_field("Number of the row of this table, from 0"), table.rows());
    visit_row(row, table);
    table.end_row();
  }
  table.write(file, group, description);
}

/// Writes a row for each history; the thinned values are concatenated in `low` and `high`.
void write_summaries(Hdf5Writer& file, const std::vector<HistorySummary>& histories) {
  const std::string group = "/dynamic/thinned";
  std::vector<double> low, high;
  write_rows(
      file, group, "Histories thinned for plotting, a row each", histories, [&](const HistorySummary& h, auto& t) {
        t(ResultField{"name", "1", "Name of the history; /dynamic/histories contains all its values"}, h.name);
        t(ResultField{"units", "1", "Units of its values"}, h.units);
        t(ResultField{"meaning", "1", "Meaning"}, h.description);
        t(ResultField{"first", "1", "Index in low and high of its first time interval"},
          static_cast<std::int64_t>(low.size()));
        t(ResultField{"count", "1",
                      "Number of its time intervals, of equal length, from the start of the build-up to the end"},
          static_cast<std::int64_t>(h.low.size()));
        visit_spread(ResultField{"", kVaries, "Statistics of the history from t = 0"}, h.over_time, t);
        low.insert(low.end(), h.low.begin(), h.low.end());
        high.insert(high.end(), h.high.begin(), h.high.end());
      });
  if (histories.empty()) return;
  file.write(group + "/low", ResultField{"", kVaries, "Minimum of each time interval"}, low, {low.size()});
  file.write(group + "/high", ResultField{"", kVaries, "Maximum of each time interval"}, high, {high.size()});
}

void write_spectra(Hdf5Writer& file, const std::vector<Spectrum>& spectra) {
  write_rows(file, "/dynamic/spectrum_list", "The spectra in /dynamic/spectra", spectra,
             [](const Spectrum& s, auto& t) {
               t(ResultField{"name", "1", "Name of the history"}, s.name);
               t(ResultField{"units", "1", "Units of the history"}, s.units);
             });
  for (const Spectrum& spectrum : spectra) {
    const std::string group = "/dynamic/spectra/" + dataset_path(spectrum.name);
    make_groups_above(file, group + "/", "Variance densities of histories");
    file.write(group + "/frequency", ResultField{"", "Hz", "Frequency"}, spectrum.frequency,
               {spectrum.frequency.size()});
    file.write(group + "/density", ResultField{"", "(" + spectrum.units + ")^2/Hz", "Variance density from t = 0 on"},
               spectrum.density, {spectrum.density.size()});
    file.make_scale(group + "/frequency", "frequency");
    file.attach_scale(group + "/density", group + "/frequency");
  }
}

/// Parts that exist only with a laid pipe.
void write_pipe_in_time(Hdf5Writer& file, const StaticResults& statics, const DynamicResults& dynamics) {
  const auto tensioner = [](const auto& part, auto& visit) { visit_tensioner(part, visit); };
  const auto impacts = [](const auto& part, auto& visit) { visit_impact(part, visit); };
  write_part(file, "/dynamic/tensioner", "Tensioner behaviour", tensioner, dynamics.tensioner);
  if (statics.overbend) {
    write_region(file, "/dynamic/overbend", "Extremes from the tensioner to the inflection below the last support",
                 dynamics.overbend);
  }
  const ResultField min_tension = min_effective_tension_field();
  const auto visit_min_tension = [&](const auto& part, auto& visit) {
    visit_dynamic_extreme(min_tension, part, visit);
  };
  write_part(file, "/dynamic/" + min_tension.name, std::string(min_tension.description), visit_min_tension,
             dynamics.min_effective_tension);
  if (statics.tower) {
    write_region(file, "/dynamic/tower", "Extremes where the clamped guide bends the pipe", dynamics.tower);
  }
  write_region(file, "/dynamic/sagbend", "Extremes from the inflection to touchdown", dynamics.sagbend);
  file.group("/dynamic/stations", "Stations of the line: static state and envelopes over time");
  ColumnWriter stations{file};
  visit_dynamic_stations(dynamics, stations);
  write_supports(file, dynamics.supports);
  write_rows(file, "/dynamic/hardest_impacts", "Impacts with the largest peak forces, in descending order",
             dynamics.hardest_impacts, impacts);
  if (!dynamics.stinger.empty()) {
    write_rows(file, "/dynamic/stinger", "Sections of the stinger on their hinges over time", dynamics.stinger,
               [](const auto& part, auto& visit) { visit_stinger_dynamics(part, visit); });
  }
  write_fatigue(file, dynamics);
  if (!dynamics.design.load.empty()) write_design(file, dynamics.design);
}

}  // namespace

void write_dynamic_hdf5(const StaticResults& statics, const DynamicResults& dynamics, const RunStore& store,
                        const Description& description, const std::filesystem::path& path) {
  Hdf5Writer file(path);
  write_static_groups(file, statics, description);
  const bool tip = statics.stinger_tip_clearance.has_value();
  const auto keys = [&](const auto& part, auto& visit) {
    visit_dynamic_settings(part, visit);
    if (statics.has_pipe()) visit_pipe_over_time(part, visit, tip);
  };
  const auto energy = [](const auto& part, auto& visit) { visit_energy(part, visit); };
  const auto run = [](const auto& part, auto& visit) { visit_dynamic_run(part, visit); };
  const auto extremes = [](const auto& part, auto& visit) { visit_estimate(part, visit); };
  write_part(file, "/dynamic", "Time domain: settings and key results", keys, dynamics);
  write_part(file, "/dynamic/energy", "Energy balance of the run", energy, dynamics.energy);
  write_part(file, "/dynamic/run", "Solver statistics", run, dynamics.run);
  if (statics.has_pipe()) write_pipe_in_time(file, statics, dynamics);
  write_rows(file, "/dynamic/extremes", "Most probable maxima or minima in three hours", dynamics.extremes, extremes);
  write_checks(file, "/dynamic/checks", dynamics.checks);
  write_moored_dynamics(file, dynamics);
  write_lines_in_time(file, dynamics.lines);
  write_bodies_in_time(file, dynamics.bodies);
  write_summaries(file, dynamics.histories);
  write_spectra(file, dynamics.spectra);
  write_long_data(file, store);
  link_line_histories(file, dynamics.lines);
  link_objects(file, statics);
  file.close();
}

}  // namespace overbend
