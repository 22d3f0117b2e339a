#include "study/exceeded_early.h"

#include "checks/run_checks.h"

namespace overbend {

bool ExceededEarly::operator()(const DynamicProgress& at) {
  if (at.time <= 0.0 || at.time < next_) return false;
  next_ = at.time + every_;
  const CheckTable table = check_dynamics(*model_, *statics_, at.so_far());
  const CheckRow* worst = worst_check(table);
  return worst != nullptr && worst->status == CheckStatus::exceeded;
}

}  // namespace overbend
