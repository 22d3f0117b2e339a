#include <optional>

#include "io/hdf5_file.h"
#include "io/results_writer.h"
#include "io/run_record.h"
#include "io/static_columns.h"
#include "io/static_scalars.h"

namespace overbend {
namespace {

/// Writes single values into a group as they are visited.
struct ValueWriter {
  Hdf5Writer& file;
  std::string group;

  std::string path(const Field& field) const { return group + "/" + field.name; }
  void operator()(const Field& field, double value) { file.write(path(field), field, std::vector{value}, {}); }
  void operator()(const Field& field, int value) { file.write(path(field), field, std::vector{value}, {}); }
  void operator()(const Field& field, const std::string& value) {
    file.write(path(field), field, std::vector{value}, {});
  }
  void operator()(const Field& field, const std::vector<std::string>& values) {
    file.write(path(field), field, values, {values.size()});
  }
  void operator()(const Field& field, const std::optional<double>& value) {
    if (value) (*this)(field, *value);  // absent where the question has no sense: no stinger, no clearance
  }
  void operator()(const Field& field, const Vec3& value) {
    file.write(path(field), field, std::vector<double>{value.x(), value.y(), value.z()}, {3});
  }
  void operator()(const Field& field, const Mat3& value) {
    std::vector<double> rows;
    for (int i = 0; i < 9; ++i) rows.push_back(value(i / 3, i % 3));
    file.write(path(field), field, rows, {3, 3});
  }
};

/// Gathers the columns of a table row by row, then writes them with the first one as the dimension scale.
class TableWriter {
 public:
  void operator()(const Field& field, double value) { column(field).numbers.push_back(value); }
  void operator()(const Field& field, int value) { column(field).integers.push_back(value); }
  void operator()(const Field& field, bool value) { column(field).integers.push_back(value ? 1 : 0); }
  void operator()(const Field& field, const std::string& value) { column(field).texts.push_back(value); }
  void operator()(const Field& field, Region value) { column(field).texts.emplace_back(word(value)); }
  void operator()(const Field& field, RollerPosition value) { column(field).texts.emplace_back(word(value)); }
  void operator()(const Field& field, const Vec3& value) {
    for (int i = 0; i < 3; ++i) {
      (*this)(Field{component_name(field, i), field.units, field.description, field.frame}, value(i));
    }
  }
  void end_row() {
    next_ = 0;
    ++rows_;
  }
  int rows() const { return static_cast<int>(rows_); }

  /// Writes nothing for a table without rows.
  void write(Hdf5Writer& file, const std::string& group, const std::string& description) const {
    if (rows_ == 0) return;
    file.group(group, description);
    const std::string scale = group + "/" + columns_.front().field.name;
    for (const Column& c : columns_) {
      const std::string path = group + "/" + c.field.name;
      if (!c.numbers.empty()) {
        file.write(path, c.field, c.numbers, {rows_});
      } else if (!c.integers.empty()) {
        file.write(path, c.field, c.integers, {rows_});
      } else {
        file.write(path, c.field, c.texts, {rows_});
      }
      if (path == scale) {
        file.make_scale(path, c.field.name);
      } else {
        file.attach_scale(path, scale);
      }
    }
  }

 private:
  struct Column {
    Field field;
    std::vector<double> numbers;
    std::vector<int> integers;
    std::vector<std::string> texts;
  };
  Column& column(const Field& field) {
    if (rows_ == 0) columns_.push_back({field, {}, {}, {}});
    return columns_.at(next_++);
  }
  std::vector<Column> columns_;
  std::size_t next_ = 0;
  hsize_t rows_ = 0;
};

Field index_field(const char* description) {
  return {"index", "1", description};
}

void write_region(Hdf5Writer& file, const std::string& group, const std::string& description,
                  const RegionResult& region) {
  file.group(group, description);
  visit_region(region, [&](const std::string& name, const char* units, const char* text, const Extreme& extreme) {
    file.group(group + "/" + name, text);
    ValueWriter visit{file, group + "/" + name};
    visit_extreme_fields(units, text, extreme, visit);
  });
}

void write_supports(Hdf5Writer& file, const std::string& group, const StaticResults& results) {
  TableWriter boxes, rows, rollers;
  for (const SupportResult& support : results.supports) {
    for (const RowResult& row : support.rows) {
      for (const RollerResult& roller : row.rollers) {
        rollers(index_field("Number of the roller, from 0"), rollers.rows());
        rollers(Field{"row", "1", "Index of its row in the table of rows"}, rows.rows());
        visit_roller(roller, rollers);
        rollers.end_row();
      }
      rows(index_field("Number of the row, from 0"), rows.rows());
      rows(Field{"support", "1", "Index of its box in the table of supports"}, boxes.rows());
      visit_row(row, rows);
      rows.end_row();
    }
    boxes(index_field("Number of the box, from 0"), boxes.rows());
    visit_support(support, boxes);
    boxes.end_row();
  }
  boxes.write(file, group + "/supports", "Roller boxes");
  rows.write(file, group + "/rows", "Rows of rollers");
  rollers.write(file, group + "/rollers", "Rollers: bottom first, then port and starboard");
}

void write_tables(Hdf5Writer& file, const std::string& group, const StaticResults& results) {
  TableWriter stations, sections;
  for (const Station& station : results.stations) {
    visit_station(station, stations);
    stations.end_row();
  }
  for (const DerivedSection& section : results.sections) {
    sections(index_field("Number of the section, from 0: first the line's own"), sections.rows());
    visit_section(section, sections);
    sections.end_row();
  }
  stations.write(file, group + "/stations", "Stations of the pipe from the anchor to the tensioner");
  sections.write(file, group + "/sections", "Properties of the sections");
}

void write_model(Hdf5Writer& file, const Description& description) {
  file.group("/model", "What was analysed, and with what");
  ValueWriter visit{file, "/model"};
  visit(Field{"text", "1", "Text of the model file"}, description.source_text);
  visit(Field{"file", "1", "Path of the model file as given"}, description.source_file);
  visit(Field{"hash", "1", "FNV-1a (64 bit) of the text"}, text_hash(description.source_text));
  visit(Field{"version", "1", "Version of the program"}, std::string(OVERBEND_VERSION));
  visit(Field{"machine", "1", "Operating system, its release and the architecture"}, machine_name());
  visit(Field{"compiler", "1", "Compiler of the program"}, compiler_name());
}

template <class Function, class Part>
void write_part(Hdf5Writer& file, const std::string& group, const char* description, Function visit_part,
                const Part& part) {
  file.group(group, description);
  ValueWriter visit{file, group};
  visit_part(part, visit);
}

}  // namespace

void write_static_hdf5(const StaticResults& results, const Description& description,
                       const std::filesystem::path& path) {
  Hdf5Writer file(path);
  file.attribute("/", "Conventions", "overbend-results-1; SI units; attributes units, frame, description");
  file.attribute("/", "title", results.title);
  file.attribute("/", "source", "overbend " OVERBEND_VERSION);
  write_model(file, description);
  const auto keys = [](const auto& part, auto& visit) { visit_key_results(part, visit); };
  const auto touchdown = [](const auto& part, auto& visit) { visit_touchdown(part, visit); };
  const auto sums = [](const auto& part, auto& visit) { visit_sums(part, visit); };
  const auto solve = [](const auto& part, auto& visit) { visit_solve(part, visit); };
  const auto scene = [](const auto& part, auto& visit) { visit_scene(part, visit); };
  write_part(file, "/static", "Static equilibrium: key results", keys, results);
  write_part(file, "/static/touchdown", "Touchdown", touchdown, results.touchdown);
  write_part(file, "/static/sums", "Sums of forces on the line", sums, results);
  write_part(file, "/static/solve", "How the solver got there", solve, results.solve);
  write_part(file, "/static/scene", "What pictures need", scene, results);
  if (results.overbend) {
    write_region(file, "/static/overbend", "Extremes from the tensioner to the inflection below the last support",
                 *results.overbend);
  }
  write_region(file, "/static/sagbend", "Extremes from there to touchdown", results.sagbend);
  write_tables(file, "/static", results);
  write_supports(file, "/static", results);
  file.close();
}

}  // namespace overbend
