#include "results/check_results.h"

namespace overbend {

CheckRow::CheckRow() = default;
CheckRow::CheckRow(const CheckRow&) = default;
CheckRow::CheckRow(CheckRow&&) noexcept = default;
CheckRow& CheckRow::operator=(const CheckRow&) = default;
CheckRow& CheckRow::operator=(CheckRow&&) noexcept = default;
CheckRow::~CheckRow() = default;

}  // namespace overbend
