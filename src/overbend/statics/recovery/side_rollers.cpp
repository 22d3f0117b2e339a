#include "statics/recovery/side_rollers.h"

#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"
#include "model/vessel/station.h"

namespace overbend {
namespace {

constexpr double kBears = 100.0;  ///< Force across a box from which its side rollers count [N].

}  // namespace

std::optional<Finding> find_side_roller_contact(const Description& description, const StaticResults& results) {
  const bool held = has_mooring_lines(description) && description.moorings->find == FindMooring::lengths;
  if (held || !has_station(description)) return std::nullopt;
  std::string boxes;
  for (const SupportResult& support : results.supports) {
    if (!support.has_sides || std::abs(support.lateral) <= kBears) continue;
    boxes +=
        fmt::format("{}'{}' ({})", boxes.empty() ? "" : ", ", support.name, shown(std::abs(support.lateral), "N", 1));
  }
  if (boxes.empty()) return std::nullopt;
  return Finding{FindingCode::other_equilibrium_possible,
                 "the pipe bears on side rollers of " + boxes +
                     " while the vessel gives way to it: more than one equilibrium is possible, and which one holds "
                     "depends on how the vessel came there; this one was found from the nominal pose"}
      .on("vessel");
}

}  // namespace overbend
