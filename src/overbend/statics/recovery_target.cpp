#include "statics/recovery_target.h"

#include <fmt/format.h>

#include <cmath>

namespace overbend {
namespace {

constexpr double kWorthSaying = 1e-3;  ///< Of what is wanted: where meshes serve, results miss it by 1e-6.

}  // namespace

void warn_of_missed_target(StaticResults& results, const Model& model) {
  const Description& d = model.description;
  if (d.tensioner.tension) {
    const double wanted = *d.tensioner.tension;
    if (std::abs(results.top_tension - wanted) > kWorthSaying * wanted) {
      results.warnings.push_back(fmt::format(
          "the tension at the tensioner is {:.2f} kN, {:.2f} kN was specified: the elements are too long for such a "
          "sharp bend; look for a box off the line of the pipe, or reduce analysis.mesh.overbend_element",
          1e-3 * results.top_tension, 1e-3 * wanted));
    }
  } else if (d.pipe.anchor) {
    const double wanted = *d.pipe.anchor, reached = results.stations.front().astern;
    if (std::abs(reached - wanted) > kWorthSaying * std::abs(wanted)) {
      results.warnings.push_back(
          fmt::format("the anchor is {:.2f} m astern of the stern shoe, {:.2f} m was specified", reached, wanted));
    }
  }
}

}  // namespace overbend
