#include "checks/calculation_sheet.h"

#include <utility>

namespace overbend {

void CalculationSheet::given(const char* symbol, const char* meaning, double value, const char* units,
                             std::string origin) {
  lines.push_back({symbol, meaning, "", value, units, std::move(origin), Confirmation::not_needed, ""});
}

void CalculationSheet::computed(const CodeFormula& f, double value) {
  lines.push_back({f.symbol, f.meaning, f.formula, value, f.units, f.clause, f.confirmation, f.sources});
}

std::vector<SheetLine> ratio_sheet(const CheckRow& row) {
  if (row.capacity <= 0.0) return {};
  CalculationSheet sheet;
  sheet.given("demand", row.quantity.c_str(), row.demand, row.units.c_str(), "analysis");
  sheet.given("capacity", row.quantity.c_str(), row.capacity, row.units.c_str(), row.code);
  sheet.computed({"U", "utilisation", "demand/capacity", "1", row.code}, row.utilisation);
  return sheet.lines;
}

}  // namespace overbend
