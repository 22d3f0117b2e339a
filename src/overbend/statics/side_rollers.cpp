#include "statics/side_rollers.h"

#include <fmt/format.h>

#include <cmath>

#include "model/station.h"

namespace overbend {
namespace {

constexpr double kBears = 100.0;  ///< Force across a box from which its side rollers count [N].

}  // namespace

std::optional<std::string> warn_of_side_rollers(const Description& description, const StaticResults& results) {
  const bool held = has_mooring_lines(description) && description.moorings->find == FindMooring::lengths;
  if (held || !has_station(description)) return std::nullopt;
  std::string boxes;
  for (const SupportResult& support : results.supports) {
    if (!support.has_sides || std::abs(support.lateral) <= kBears) continue;
    boxes +=
        fmt::format("{}'{}' ({:.1f} kN)", boxes.empty() ? "" : ", ", support.name, 1e-3 * std::abs(support.lateral));
  }
  if (boxes.empty()) return std::nullopt;
  return "the pipe bears on side rollers of " + boxes +
         " while the vessel gives way to it: there may be more than one equilibrium, and which of them holds hangs on "
         "how the vessel came there; this one was found from the vessel as drawn";
}

}  // namespace overbend
