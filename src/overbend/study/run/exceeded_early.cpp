#include "study/run/exceeded_early.h"

#include <algorithm>

#include "checks/run_checks.h"

namespace overbend {

bool stays_exceeded(const CheckRow& row) {
  return row.id != "fatigue";
}

void keep_lasting_checks(CheckTable& table) {
  std::erase_if(table.rows, [](const CheckRow& row) { return !stays_exceeded(row); });
}

bool ExceededEarly::operator()(const DynamicProgress& at) {
  if (at.time <= 0.0 || at.time < next_) return false;
  next_ = at.time + every_;
  const CheckTable table = check_dynamics(*model_, *statics_, at.so_far());
  return std::ranges::any_of(table.rows, [](const CheckRow& row) {
    return row.governing && row.status == CheckStatus::exceeded && stays_exceeded(row);
  });
}

}  // namespace overbend
