/// A table of inputs: name, value, unit.
#pragma once

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>

#include "base/shown_unit.h"
#include "results/tables/table.h"

namespace overbend {

/// Formats with six digits, as inputs are given.
inline std::string general(double value) {
  return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value);
}

/// Formats a value [SI] in the unit shown.
inline std::string general(double value, const ShownUnit& unit) {
  return general(value * unit.factor);
}
inline std::string general(double value, std::string_view si) {
  return general(value, shown_unit(si));
}

/// Rows of a quantity, its value and its unit.
inline Table listing_table(const std::string& title) {
  return {title, {TableColumn("Quantity"), TableColumn::texts("Value"), TableColumn("Unit")}};
}

class Listing {
 public:
  explicit Listing(const std::string& title) : table_(listing_table(title)) {}
  Listing& add(const std::string& name, double value, const ShownUnit& unit) {
    return add(name, general(value, unit), std::string(unit.name));
  }
  Listing& add(const std::string& name, double value, std::string_view si) {  // value [SI]
    return add(name, value, shown_unit(si));
  }
  Listing& add(const std::string& name, std::initializer_list<double> values, std::string_view si) {
    std::string all;
    for (const double value : values) all += (all.empty() ? "" : ", ") + general(value, si);
    return add(name, all, shown_name(si));
  }
  Listing& add(const std::string& name, const std::string& value, const std::string& unit = "") {
    table_.row({name, value, unit});
    return *this;
  }
  const Table& table() const { return table_; }

 private:
  Table table_;
};

}  // namespace overbend
