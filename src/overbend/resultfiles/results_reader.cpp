#include "resultfiles/results_reader.h"

#include "resultfiles/check_hdf5.h"
#include "resultfiles/hdf5_readers.h"
#include "resultfiles/mooring_hdf5.h"
#include "results/fields/static_tables.h"
#include "results/fields/static_values.h"

namespace overbend {
namespace {

void read_region(const Hdf5Reader& file, const std::string& group, RegionResult& region) {
  visit_region(region, [&](const ResultField& field, Extreme& extreme) {
    ValueReader visit{file, group + "/" + field.name};
    visit_extreme_fields(field, extreme, visit);
  });
}

void read_supports(const Hdf5Reader& file, StaticResults& results) {
  TableReader boxes(file, "/static/supports"), rows(file, "/static/rows"), rollers(file, "/static/rollers");
  results.supports.resize(boxes.rows("index"));
  std::vector<SupportResult*> all_boxes;
  for (std::size_t i = 0; i < results.supports.size(); ++i) {
    boxes.start_row(i);
    visit_support(results.supports[i], boxes);
    all_boxes.push_back(&results.supports[i]);
  }
  for (std::size_t i = 0, count = rows.rows("index"); i < count; ++i) {
    rows.start_row(i);
    int box = -1;
    rows(ResultField{"support"}, box);
    visit_row(owner(all_boxes, box, "row").rows.emplace_back(), rows);
  }
  std::vector<RowResult*> all_rows;  // rows are numbered through all boxes
  for (SupportResult& support : results.supports) {
    for (RowResult& row : support.rows) all_rows.push_back(&row);
  }
  for (std::size_t i = 0, count = rollers.rows("index"); i < count; ++i) {
    rollers.start_row(i);
    int row = -1;
    rollers(ResultField{"row"}, row);
    visit_roller(owner(all_rows, row, "roller").rollers.emplace_back(), rollers);
  }
}

void read_tables(const Hdf5Reader& file, StaticResults& results) {
  TableReader stations(file, "/static/stations"), sections(file, "/static/sections");
  results.stations.resize(stations.rows("s"));
  for (std::size_t i = 0; i < results.stations.size(); ++i) {
    stations.start_row(i);
    visit_station(results.stations[i], stations);
  }
  results.sections.resize(sections.rows("index"));
  for (std::size_t i = 0; i < results.sections.size(); ++i) {
    sections.start_row(i);
    visit_section(results.sections[i], sections);
  }
}

}  // namespace

StoredStatics read_static_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  StoredStatics stored;
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  visit(ResultField{"file"}, stored.model_file);
  StaticResults& results = stored.results;
  visit.group = "/static";
  visit_key_results(results, visit);
  visit.group = "/static/touchdown";
  visit_touchdown(results.touchdown, visit);
  visit.group = "/static/sums";
  visit_sums(results, visit);
  visit.group = "/static/solve";
  visit_solve(results.solve, visit);
  visit.group = "/static/scene";
  visit_scene(results, visit);
  if (file.has("/static/overbend")) read_region(file, "/static/overbend", results.overbend.emplace());
  visit.group = "/static/smallest_tension";
  visit_extreme_fields(smallest_tension_field(), results.smallest_tension, visit);
  if (file.has("/static/tower")) read_region(file, "/static/tower", results.tower.emplace());
  read_region(file, "/static/sagbend", results.sagbend);
  read_tables(file, results);
  read_supports(file, results);
  results.checks = read_checks(file, "/static/checks");
  results.moorings = read_moorings(file);
  results.hull = read_hull(file);
  return stored;
}

bool has_moorings_alone(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  return file.has("/moorings") && !file.has("/static");
}

StoredMoorings read_mooring_results(const std::filesystem::path& h5) {
  const Hdf5Reader file(h5);
  StoredMoorings stored;
  std::optional<MooringResults> found = read_moorings(file);
  if (!found) throw std::runtime_error("the file '" + h5.string() + "' holds no moorings");
  stored.results = std::move(*found);
  stored.results.hull = read_hull(file);
  ValueReader visit{file, "/model"};
  visit(ResultField{"text"}, stored.model_text);
  visit(ResultField{"file"}, stored.model_file);
  return stored;
}

}  // namespace overbend
