#include "dynamics/setup/end_swing.h"

#include <cmath>
#include <numbers>

#include "mechanics/build_up.h"

namespace overbend {

std::vector<EndSwing> end_swings(const std::vector<FreeLineDescription>& lines, const std::vector<int>& of_system,
                                 std::size_t first) {
  std::vector<EndSwing> swings;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (of_system[i] < 0) continue;
    std::size_t attachment = first + 2 * static_cast<std::size_t>(of_system[i]);
    for (const LineEndDescription* end : {&lines[i].first, &lines[i].second}) {
      if (end->kind != LineEndKind::body && end->period > 0.0) {
        swings.push_back({attachment, end->amplitude, 2.0 * std::numbers::pi / end->period, end->phase});
      }
      ++attachment;
    }
  }
  return swings;
}

void swing_ends(const std::vector<EndSwing>& swings, double time, double build_up, std::vector<EndMotion>& ends) {
  if (swings.empty()) return;
  const BuildUp b = half_cosine(time, build_up);
  for (const EndSwing& swing : swings) {
    const double angle = swing.omega * time + swing.phase;
    const double s = std::sin(angle), rate = swing.omega * std::cos(angle), bend = -swing.omega * swing.omega * s;
    EndMotion& end = ends[swing.attachment];
    end.place += b.value * s * swing.amplitude;
    end.velocity += (b.rate * s + b.value * rate) * swing.amplitude;
    end.acceleration += (b.acceleration * s + 2.0 * b.rate * rate + b.value * bend) * swing.amplitude;
  }
}

}  // namespace overbend
