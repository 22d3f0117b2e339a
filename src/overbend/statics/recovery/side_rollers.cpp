#include "statics/recovery/side_rollers.h"

#include <fmt/format.h>

#include <cmath>

#include "base/shown_unit.h"
#include "model/vessel/mooring_queries.h"

namespace overbend {
namespace {

constexpr double kBears = 100.0;  ///< Minimum lateral force on a box for its side rollers to count as loaded [N].

}  // namespace

std::optional<Finding> warn_of_side_roller_contact(const Description& description, const StaticResults& results) {
  const bool held = has_mooring_lines(description) && description.moorings->find == FindMooring::lengths;
  if (held || !finds_vessel_position(description)) return std::nullopt;
  std::string boxes;
  for (const SupportResult& support : results.supports) {
    if (!support.has_sides || std::abs(support.lateral) <= kBears) continue;
    boxes +=
        fmt::format("{}'{}' ({})", boxes.empty() ? "" : ", ", support.name, shown(std::abs(support.lateral), "N", 1));
  }
  if (boxes.empty()) return std::nullopt;
  return Finding{FindingCode::other_equilibrium_possible,
                 "the pipe loads the side rollers of " + boxes +
                     " while the vessel is free to move: more than one equilibrium is possible, depending on the path "
                     "of the vessel; this one was found from the nominal pose"}
      .on("vessel");
}

}  // namespace overbend
