#include "resultfiles/hdf5/check_hdf5.h"

#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "results/fields/check_fields.h"

namespace overbend {
namespace {

/// Writes whole columns of one length; the first is the scale of the others unless `scale` is empty.
struct ColumnsWriter {
  DatasetSink& file;
  std::string group;
  std::string scale;

  void operator()(const ResultField& field, const std::vector<double>& values) const {
    const std::string path = group + "/" + field.name;
    file.write(path, field, values, {values.size()});
    if (field.name == "s") {
      file.make_scale(path, field.name);
    } else {
      file.attach_scale(path, scale);
    }
  }
};

struct ColumnsReader {
  const Hdf5Reader& file;
  std::string group;

  void operator()(const ResultField& field, std::vector<double>& values) const {
    values = file.doubles(group + "/" + field.name);
  }
};

void write_inputs(DatasetSink& file, const std::string& group, const std::vector<CheckRow>& rows) {
  TableWriter inputs;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const CheckInput& input : rows[i].inputs) {
      inputs(index_field("Number of the row of this table, from 0"), inputs.rows());
      inputs(ResultField{"check", "1", "Index of its check in the table of checks"}, static_cast<int>(i));
      visit_check_input(input, inputs);
      inputs.end_row();
    }
  }
  inputs.write(file, group, "Input values of the checks");
}

void write_sheets(DatasetSink& file, const std::string& group, const std::vector<CheckRow>& rows) {
  TableWriter lines;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (const SheetLine& line : rows[i].sheet) {
      lines(index_field("Number of the row of this table, from 0"), lines.rows());
      lines(ResultField{"check", "1", "Index of its check in the table of checks"}, static_cast<int>(i));
      visit_sheet_line(line, lines);
      lines.end_row();
    }
  }
  lines.write(file, group, "Calculation sheets of the checks: inputs and formulas in order, the utilisation last");
}

void read_sheets(const Hdf5Reader& file, const std::string& group, const std::vector<CheckRow*>& rows) {
  TableReader lines(file, group);
  for (std::size_t i = 0, count = lines.rows("index"); i < count; ++i) {
    lines.start_row(i);
    int check = -1;
    lines(ResultField{"check"}, check);
    visit_sheet_line(owner(rows, check, "line of a calculation sheet").sheet.emplace_back(), lines);
  }
}

}  // namespace

void write_checks(DatasetSink& file, const std::string& group, const CheckTable& table) {
  if (table.rows.empty()) return;
  file.group(group, "Code checks");
  ValueWriter values{file, group};
  values(ResultField{"assumptions", "1", "Assumptions of the checks"}, table.assumptions);
  TableWriter rows;
  for (const CheckRow& row : table.rows) {
    rows(index_field("Number of the check, from 0"), rows.rows());
    visit_check(row, rows);
    rows.end_row();
  }
  rows.write(file, group + "/list", "Each check at the station and time of its maximum utilisation");
  write_inputs(file, group + "/inputs", table.rows);
  write_sheets(file, group + "/sheet", table.rows);
  file.group(group + "/along", "Utilisations along the pipe");
  const ColumnsWriter columns{file, group + "/along", group + "/along/s"};
  visit_check_along(table.along, columns);
}

CheckTable read_checks(const Hdf5Reader& file, const std::string& group) {
  CheckTable table;
  if (!file.has(group)) return table;
  const ValueReader values{file, group};
  values(ResultField{"assumptions"}, table.assumptions);
  TableReader rows(file, group + "/list"), inputs(file, group + "/inputs");
  table.rows.resize(rows.rows("index"));
  std::vector<CheckRow*> owners;
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    rows.start_row(i);
    visit_check(table.rows[i], rows);
    owners.push_back(&table.rows[i]);
  }
  for (std::size_t i = 0, count = inputs.rows("index"); i < count; ++i) {
    inputs.start_row(i);
    int check = -1;
    inputs(ResultField{"check"}, check);
    visit_check_input(owner(owners, check, "check's input").inputs.emplace_back(), inputs);
  }
  read_sheets(file, group + "/sheet", owners);
  const ColumnsReader columns{file, group + "/along"};
  visit_check_along(table.along, columns);
  return table;
}

void write_design(DatasetSink& file, const StationDesign& design) {
  file.group("/dynamic/design", "Design values of the code checks at the stations of /dynamic/stations");
  const ColumnsWriter columns{file, "/dynamic/design", "/dynamic/stations/s"};
  visit_station_design(design, columns);
}

StationDesign read_design(const Hdf5Reader& file) {
  StationDesign design;
  if (!file.has("/dynamic/design")) return design;
  const ColumnsReader columns{file, "/dynamic/design"};
  visit_station_design(design, columns);
  return design;
}

}  // namespace overbend
