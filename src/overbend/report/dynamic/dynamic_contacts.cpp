#include "report/dynamic/dynamic_contacts.h"

#include <fmt/format.h>

namespace overbend {

std::string RollerPlace::name() const {
  return box == nullptr ? "" : fmt::format("{}, row {}, {}", box->name, roller->row + 1, word(roller->position));
}

ContactCount count_contacts(const DynamicResults& results) {
  ContactCount count;
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      const bool bottom = r.position == RollerPosition::bottom;
      count.bottom += bottom ? 1 : 0;
      count.never += bottom && r.contact_share == 0.0 ? 1 : 0;
      count.carrying += r.static_reaction > 0.0 ? 1 : 0;
      count.losing += r.static_reaction > 0.0 && r.contact_share < 1.0 ? 1 : 0;
      if (count.hardest.roller == nullptr || r.reaction.max > count.hardest.roller->reaction.max) {
        count.hardest = {&box, &r};
      }
    }
  }
  return count;
}

RollerPlace find_roller(const DynamicResults& results, int roller) {
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& r : box.rollers) {
      if (r.roller == roller) {
        return {&box, &r};
      }
    }
  }
  return {};
}

}  // namespace overbend
