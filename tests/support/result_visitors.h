/// Visitors of result fields that tests share.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "results/fields/check_fields.h"
#include "results/fields/result_field.h"

namespace overbend::testing {

inline constexpr std::size_t kListBytes = sizeof(std::vector<double>);  // the same for any vector

/// The bytes that the visited members take in their struct, flags and words with the padding that follows them.
struct SizeVisitor {
  std::size_t bytes = 0;
  template <class Value>
  void operator()(const ResultField&, const Value&) {
    const bool padded = std::is_enum_v<Value> || std::is_same_v<Value, bool>;
    bytes += padded ? sizeof(double) : sizeof(Value);
  }
};

/// Everything as one text, numbers by their bits.
struct BitsVisitor {
  std::string text;
  void operator()(const ResultField& field, double value) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    text += field.name + "=" + std::to_string(bits) + "\n";
  }
  void operator()(const ResultField& field, int value) { text += field.name + "=" + std::to_string(value) + "\n"; }
  void operator()(const ResultField& field, std::int64_t value) {
    text += field.name + "=" + std::to_string(value) + "\n";
  }
  void operator()(const ResultField& field, std::uint64_t value) {
    text += field.name + "=" + std::to_string(value) + "\n";
  }
  void operator()(const ResultField& field, bool value) { (*this)(field, value ? 1 : 0); }
  void operator()(const ResultField& field, const std::string& value) { text += field.name + "=" + value + "\n"; }
  void operator()(const ResultField& field, const Assumption& value) {
    text += field.name + "=" + std::string(rank_name(value.rank)) + " " + value.text + "\n";
  }
  void operator()(const ResultField& field, const Finding& value) {
    text += field.name + "=" + json_text(finding_json(value)) + "\n";
  }
  template <HasResultEnumNames Enum>
  void operator()(const ResultField& field, Enum value) {
    (*this)(field, std::string(word(value)));
  }
  void operator()(const ResultField& field, const std::optional<double>& value) {
    if (value) (*this)(field, *value);
  }
  template <class Value>
  void operator()(const ResultField& field, const std::vector<Value>& values) {
    for (const Value& value : values) (*this)(field, value);
  }
  template <int Rows, int Columns>
  void operator()(const ResultField& field, const Eigen::Matrix<double, Rows, Columns>& value) {
    for (double number : value.reshaped()) (*this)(field, number);
  }
};

/// A table of checks by its bits.
inline void visit_checks(const CheckTable& table, BitsVisitor& bits) {
  for (const CheckRow& row : table.rows) {
    visit_check(row, bits);
    for (const CheckInput& input : row.inputs) visit_check_input(input, bits);
    for (const SheetLine& line : row.sheet) visit_sheet_line(line, bits);
  }
  visit_check_along(table.along, bits);
  bits(ResultField{"assumptions"}, table.assumptions);
}

}  // namespace overbend::testing
