#include "study/run/early_termination.h"

#include <algorithm>

#include "base/ranges.h"
#include "checks/run_checks.h"

namespace overbend {

bool is_irreversible(const CheckRow& row) {
  return row.id != "fatigue";
}

void keep_irreversible_checks(CheckTable& table) {
  std::erase_if(table.rows, [](const CheckRow& row) { return !is_irreversible(row); });
}

bool EarlyTermination::operator()(const DynamicProgress& progress) {
  if (progress.time <= 0.0 || progress.time < next_) return false;
  next_ = progress.time + every_;
  const CheckTable table = check_dynamics(*model_, *statics_, progress.so_far());
  return ranges::any_of(table.rows, [](const CheckRow& row) {
    return row.governing && row.status == CheckStatus::exceeded && is_irreversible(row);
  });
}

}  // namespace overbend
