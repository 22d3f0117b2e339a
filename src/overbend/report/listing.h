/// A table of inputs: name, value, unit.
#pragma once

#include <fmt/format.h>

#include <string>

#include "report/html.h"

namespace overbend {

/// Six digits, as inputs are given.
inline std::string general(double value) {
  return fmt::format("{:.6g}", value == 0.0 ? 0.0 : value);
}

class Listing {
 public:
  explicit Listing(const std::string& caption)
      : table_(caption, {{"Quantity", "", true}, {"Value", ""}, {"Unit", "", true}}, "plain") {}
  Listing& add(const std::string& name, double value, const std::string& unit) {
    return add(name, general(value), unit);
  }
  Listing& add(const std::string& name, const std::string& value, const std::string& unit = "") {
    table_.row({name, value, unit});
    return *this;
  }
  std::string str() const { return table_.str(); }

 private:
  html::Table table_;
};

}  // namespace overbend
