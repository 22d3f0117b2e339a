/// Reads results from HDF5 as their fields are visited; see results/fields/result_field.h. A missing value throws
/// std::runtime_error with its path.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>

#include "base/assumption.h"
#include "base/finding.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "results/static_results.h"

namespace overbend {

template <class Value>
const Value& element(const std::vector<Value>& values, std::size_t index, const std::string& path) {
  if (index >= values.size()) throw std::runtime_error("dataset " + path + " is too short");
  return values[index];
}

/// Reads single values of a group as they are visited.
struct ValueReader {
  const Hdf5Reader& file;
  std::string group;

  std::string path(const ResultField& field) const { return group + "/" + field.name; }
  void operator()(const ResultField& f, double& value) const { value = element(file.doubles(path(f)), 0, path(f)); }
  void operator()(const ResultField& f, int& value) const { value = element(file.ints(path(f)), 0, path(f)); }
  void operator()(const ResultField& f, bool& value) const { value = element(file.ints(path(f)), 0, path(f)) != 0; }
  void operator()(const ResultField& f, std::int64_t& value) const {
    value = element(file.counts(path(f)), 0, path(f));
  }
  void operator()(const ResultField& f, std::uint64_t& value) const { value = file.seed(path(f)); }
  void operator()(const ResultField& f, std::string& value) const { value = element(file.texts(path(f)), 0, path(f)); }
  void operator()(const ResultField& f, std::vector<std::string>& values) const { values = file.texts(path(f)); }
  void operator()(const ResultField& f, Assumptions& values) const {
    const std::string ranks = group + "/" + kAssumptionRanks;
    values = read_assumptions(file.texts(path(f)), file.has(ranks) ? file.texts(ranks) : std::vector<std::string>{});
  }
  void operator()(const ResultField& f, Findings& values) const {
    values.clear();
    if (file.has(path(f))) {
      for (const std::string& text : file.texts(path(f))) values.push_back(read_finding(read_json(text)));
    } else if (file.has(group + "/warnings")) {  // files of an older version, with messages only
      for (std::string& text : file.texts(group + "/warnings")) {
        values.push_back({FindingCode::unknown, std::move(text)});
      }
    }
  }
  void operator()(const ResultField& f, std::optional<double>& value) const {
    if (file.has(path(f))) value = element(file.doubles(path(f)), 0, path(f));
  }
  void operator()(const ResultField& f, Vec3& value) const {
    const std::vector<double> numbers = file.doubles(path(f));
    for (std::size_t i = 0; i < 3; ++i) value(static_cast<int>(i)) = element(numbers, i, path(f));
  }
  void operator()(const ResultField& f, Mat3& value) const {
    const std::vector<double> numbers = file.doubles(path(f));
    for (int i = 0; i < 9; ++i) value(i / 3, i % 3) = element(numbers, i, path(f));
  }
};

/// Reads the columns of a table at their first use, and returns them row by row.
class TableReader {
 public:
  TableReader(const Hdf5Reader& file, std::string group) : file_(file), group_(std::move(group)) {}

  /// Number of rows; a table without rows is not stored.
  std::size_t rows(const std::string& first) { return file_.has(group_) ? file_.doubles(path(first)).size() : 0; }
  void start_row(std::size_t row) { row_ = row; }

  void operator()(const ResultField& f, double& value) { value = number(f.name); }
  void operator()(const ResultField& f, std::optional<double>& value) {
    if (!file_.has(path(f.name))) return;
    const double found = number(f.name);
    value = std::isnan(found) ? std::nullopt : std::optional(found);
  }
  void operator()(const ResultField& f, bool& value) { value = integer(f.name) != 0; }
  void operator()(const ResultField& f, int& value) { value = integer(f.name); }
  void operator()(const ResultField& f, std::int64_t& value) {
    const auto [found, fresh] = counts_.try_emplace(f.name);
    if (fresh) found->second = file_.counts(path(f.name));
    value = element(found->second, row_, path(f.name));
  }
  void operator()(const ResultField& f, std::string& value) { value = text(f.name); }
  void operator()(const ResultField& f, Vec3& value) {
    for (int i = 0; i < 3; ++i) value(i) = number(component_name(f, i));
  }
  template <class Word>
  void operator()(const ResultField& f, Word& value) {
    const std::string& found = text(f.name);
    if (!from_enum_name(found, value)) throw std::runtime_error("dataset " + path(f.name) + ": unknown value " + found);
  }

 private:
  std::string path(const std::string& name) const { return group_ + "/" + name; }
  double number(const std::string& name) {
    const auto [found, fresh] = numbers_.try_emplace(name);
    if (fresh) found->second = file_.doubles(path(name));
    return element(found->second, row_, path(name));
  }
  int integer(const std::string& name) {
    const auto [found, fresh] = integers_.try_emplace(name);
    if (fresh) found->second = file_.ints(path(name));
    return element(found->second, row_, path(name));
  }
  const std::string& text(const std::string& name) {
    const auto [found, fresh] = texts_.try_emplace(name);
    if (fresh) found->second = file_.texts(path(name));
    return element(found->second, row_, path(name));
  }

  const Hdf5Reader& file_;
  std::string group_;
  std::size_t row_ = 0;
  std::map<std::string, std::vector<double>> numbers_;
  std::map<std::string, std::vector<int>> integers_;
  std::map<std::string, std::vector<std::int64_t>> counts_;
  std::map<std::string, std::vector<std::string>> texts_;
};

/// Returns the element of `owners` that a child refers to.
template <class Owner>
Owner& owner(const std::vector<Owner*>& owners, int index, const char* what) {
  if (index < 0 || index >= static_cast<int>(owners.size())) {
    throw std::runtime_error(std::string("a ") + what + " has no parent row");
  }
  return *owners[static_cast<std::size_t>(index)];
}

/// Reads the lay that write_lay_group wrote under `group`, without moorings and hull.
StaticResults read_lay_group(const Hdf5Reader& file, const std::string& group);

}  // namespace overbend
