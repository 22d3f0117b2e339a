/// Writes results as datasets while their fields are visited; see results/fields/result_field.h.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "base/assumption.h"
#include "base/finding.h"
#include "model/description/description.h"
#include "resultfiles/hdf5/dataset_sink.h"

namespace overbend {

/// Writes single values into a group as they are visited.
struct ValueWriter {
  DatasetSink& file;
  std::string group;

  std::string path(const ResultField& field) const { return group + "/" + field.name; }
  void operator()(const ResultField& field, double value) { file.write(path(field), field, std::vector{value}, {}); }
  void operator()(const ResultField& field, int value) { file.write(path(field), field, std::vector{value}, {}); }
  void operator()(const ResultField& field, std::int64_t value) {
    file.write(path(field), field, std::vector{value}, {});
  }
  void operator()(const ResultField& field, std::uint64_t value) {
    file.write(path(field), field, std::vector{value}, {});
  }
  void operator()(const ResultField& field, const std::string& value) {
    file.write(path(field), field, std::vector{value}, {});
  }
  void operator()(const ResultField& field, const std::vector<std::string>& values) {
    file.write(path(field), field, values, {values.size()});
  }
  /// Writes the texts, and the names of their ranks as "assumption_ranks".
  void operator()(const ResultField& field, const Assumptions& values) {
    (*this)(field, texts(values));
    (*this)(ResultField{kAssumptionRanks, "1", "Ranks of the assumptions"}, rank_names(values));
  }
  /// Writes each finding as a JSON text; the messages also as "warnings".
  void operator()(const ResultField& field, const Findings& values) {
    std::vector<std::string> texts;
    for (const Finding& finding : values) texts.push_back(json_text(finding_json(finding)));
    (*this)(field, texts);
    (*this)(ResultField{"warnings", "1", "Messages of the findings"}, messages(values));
  }
  void operator()(const ResultField& field, const std::optional<double>& value) {
    if (value) (*this)(field, *value);  // omitted if not applicable: no stinger, no clearance
  }
  void operator()(const ResultField& field, const Vec3& value) {
    file.write(path(field), field, std::vector<double>{value.x(), value.y(), value.z()}, {3});
  }
  void operator()(const ResultField& field, const Mat3& value) {
    std::vector<double> rows;
    for (int i = 0; i < 9; ++i) rows.push_back(value(i / 3, i % 3));
    file.write(path(field), field, rows, {3, 3});
  }
};

/// Collects the columns of a table row by row, then writes them with the first one as the dimension scale.
class TableWriter {
 public:
  void operator()(const ResultField& field, double value) { column(field).numbers.push_back(value); }
  void operator()(const ResultField& field, const std::optional<double>& value) {
    (*this)(field, value.value_or(std::numeric_limits<double>::quiet_NaN()));
  }
  void operator()(const ResultField& field, int value) { column(field).integers.push_back(value); }
  void operator()(const ResultField& field, std::int64_t value) { column(field).counts.push_back(value); }
  void operator()(const ResultField& field, bool value) { column(field).integers.push_back(value ? 1 : 0); }
  void operator()(const ResultField& field, const std::string& value) { column(field).texts.push_back(value); }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField& field, Enum value) {
    column(field).texts.emplace_back(word(value));
  }
  void operator()(const ResultField& field, const Vec3& value) {
    for (int i = 0; i < 3; ++i) {
      (*this)(ResultField{component_name(field, i), field.units, field.description, field.frame}, value(i));
    }
  }
  void end_row() {
    next_ = 0;
    ++rows_;
  }
  int rows() const { return static_cast<int>(rows_); }

  /// Writes the table; nothing if it has no rows.
  void write(DatasetSink& file, const std::string& group, const std::string& description) const {
    if (rows_ == 0) return;
    file.group(group, description);
    const std::string scale = group + "/" + columns_.front().field.name;
    for (const Column& c : columns_) {
      const std::string path = group + "/" + c.field.name;
      ResultField field = c.field;
      field.description = c.description;
      if (!c.numbers.empty()) {
        file.write(path, field, c.numbers, {rows_});
      } else if (!c.counts.empty()) {
        file.write(path, field, c.counts, {rows_});
      } else if (!c.integers.empty()) {
        file.write(path, field, c.integers, {rows_});
      } else {
        file.write(path, field, c.texts, {rows_});
      }
      if (path == scale) {
        file.make_scale(path, field.name);
      } else {
        file.attach_scale(path, scale);
      }
    }
  }

 private:
  struct Column {
    ResultField field;
    std::string description;  ///< Copy of the field's description, which may no longer exist when the table is written.
    std::vector<double> numbers;
    std::vector<int> integers;
    std::vector<std::int64_t> counts;
    std::vector<std::string> texts;
  };
  Column& column(const ResultField& field) {
    if (rows_ == 0) columns_.push_back({field, std::string(field.description), {}, {}, {}, {}});
    return columns_.at(next_++);
  }
  std::vector<Column> columns_;
  std::size_t next_ = 0;
  Extent rows_ = 0;
};

/// Returns the field of a row number, without unit.
inline ResultField index_field(const char* description) {
  return {"index", "1", description, kNoFrame};
}

/// Writes the group model: text, file, version, machine.
void write_model_group(DatasetSink& file, const Description& description);

/// Writes the model's text and its hash into the group model.
void write_model_text(DatasetSink& file, const std::string& text);

/// Writes the attributes of the file of results, and the group model.
void write_results_heading(DatasetSink& file, const std::string& title, const Description& description);

/// Writes a lay under `group`: key results, regions, tables and checks.
void write_lay_group(DatasetSink& file, const std::string& group, const StaticResults& results);

/// Writes the groups model and static, and the attributes of the file.
void write_static_groups(DatasetSink& file, const StaticResults& results, const Description& description);
/// Writes the results alone: the group static, and moorings, hull and lines if present.
void write_static_parts(DatasetSink& file, const StaticResults& results);

}  // namespace overbend
