#include "io/results_reader.h"

#include <map>
#include <stdexcept>

#include "io/hdf5_file.h"
#include "io/static_columns.h"
#include "io/static_scalars.h"

namespace overbend {
namespace {

template <class Value>
const Value& at(const std::vector<Value>& values, std::size_t index, const std::string& path) {
  if (index >= values.size()) throw std::runtime_error("dataset " + path + " is too short");
  return values[index];
}

/// Reads single values of a group as they are visited.
struct ValueReader {
  const Hdf5Reader& file;
  std::string group;

  std::string path(const Field& field) const { return group + "/" + field.name; }
  void operator()(const Field& f, double& value) const { value = at(file.doubles(path(f)), 0, path(f)); }
  void operator()(const Field& f, int& value) const { value = at(file.ints(path(f)), 0, path(f)); }
  void operator()(const Field& f, std::string& value) const { value = at(file.texts(path(f)), 0, path(f)); }
  void operator()(const Field& f, std::vector<std::string>& values) const { values = file.texts(path(f)); }
  void operator()(const Field& f, std::optional<double>& value) const {
    if (file.has(path(f))) value = at(file.doubles(path(f)), 0, path(f));
  }
  void operator()(const Field& f, Vec3& value) const {
    const std::vector<double> numbers = file.doubles(path(f));
    for (std::size_t i = 0; i < 3; ++i) value(static_cast<int>(i)) = at(numbers, i, path(f));
  }
  void operator()(const Field& f, Mat3& value) const {
    const std::vector<double> numbers = file.doubles(path(f));
    for (int i = 0; i < 9; ++i) value(i / 3, i % 3) = at(numbers, i, path(f));
  }
};

/// Reads the columns of a table when first asked for them, and gives them out row by row.
class TableReader {
 public:
  TableReader(const Hdf5Reader& file, std::string group) : file_(file), group_(std::move(group)) {}

  /// Number of rows; a table without rows is not in the file.
  std::size_t rows(const std::string& first) { return file_.has(group_) ? file_.doubles(path(first)).size() : 0; }
  void start_row(std::size_t row) { row_ = row; }

  void operator()(const Field& f, double& value) { value = number(f.name); }
  void operator()(const Field& f, bool& value) { value = integer(f.name) != 0; }
  void operator()(const Field& f, int& value) { value = integer(f.name); }
  void operator()(const Field& f, std::string& value) { value = text(f.name); }
  void operator()(const Field& f, Vec3& value) {
    for (int i = 0; i < 3; ++i) value(i) = number(component_name(f, i));
  }
  template <class Word>
  void operator()(const Field& f, Word& value) {
    const std::string& found = text(f.name);
    if (!from_word(found, value)) throw std::runtime_error("dataset " + path(f.name) + ": unknown word " + found);
  }

 private:
  std::string path(const std::string& name) const { return group_ + "/" + name; }
  double number(const std::string& name) {
    const auto [found, fresh] = numbers_.try_emplace(name);
    if (fresh) found->second = file_.doubles(path(name));
    return at(found->second, row_, path(name));
  }
  int integer(const std::string& name) {
    const auto [found, fresh] = integers_.try_emplace(name);
    if (fresh) found->second = file_.ints(path(name));
    return at(found->second, row_, path(name));
  }
  const std::string& text(const std::string& name) {
    const auto [found, fresh] = texts_.try_emplace(name);
    if (fresh) found->second = file_.texts(path(name));
    return at(found->second, row_, path(name));
  }

  const Hdf5Reader& file_;
  std::string group_;
  std::size_t row_ = 0;
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, std::vector<int>> integers_;
  std::map<std::string, std::vector<std::string>> texts_;
};

void read_region(const Hdf5Reader& file, const std::string& group, RegionResult& region) {
  visit_region(region, [&](const std::string& name, const char* units, const char* text, Extreme& extreme) {
    ValueReader visit{file, group + "/" + name};
    visit_extreme_fields(units, text, extreme, visit);
  });
}

/// The element of `owners` that a child names.
template <class Owner>
Owner& owner(const std::vector<Owner*>& owners, int index, const char* what) {
  if (index < 0 || index >= static_cast<int>(owners.size())) {
    throw std::runtime_error(std::string("a ") + what + " belongs to nothing");
  }
  return *owners[static_cast<std::size_t>(index)];
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
    rows(Field{"support"}, box);
    visit_row(owner(all_boxes, box, "row").rows.emplace_back(), rows);
  }
  std::vector<RowResult*> all_rows;  // rows are numbered through all boxes
  for (SupportResult& support : results.supports) {
    for (RowResult& row : support.rows) all_rows.push_back(&row);
  }
  for (std::size_t i = 0, count = rollers.rows("index"); i < count; ++i) {
    rollers.start_row(i);
    int row = -1;
    rollers(Field{"row"}, row);
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
  visit(Field{"text"}, stored.model_text);
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
  read_region(file, "/static/sagbend", results.sagbend);
  read_tables(file, results);
  read_supports(file, results);
  return stored;
}

}  // namespace overbend
