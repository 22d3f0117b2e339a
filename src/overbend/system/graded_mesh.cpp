#include "system/graded_mesh.h"

#include <cstddef>
#include <numeric>

namespace overbend {
namespace {

/// Steps that end on `to`: all of them stretched, or where nodes are to keep their places only the last few.
void fill(std::vector<double>& u, const MeshPlan& plan, double to) {
  constexpr std::size_t kStretched = 6;
  const double from = u.back();
  std::vector<double> steps;
  walk(plan, from, to, [&](double step) {
    steps.push_back(step);
    return true;
  });
  const std::size_t first = plan.keeps_places && steps.size() > kStretched ? steps.size() - kStretched : 0;
  const double kept = std::accumulate(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(first), 0.0);
  const double stretched = std::accumulate(steps.begin() + static_cast<std::ptrdiff_t>(first), steps.end(), 0.0);
  const double scale = (to - from - kept) / stretched;
  for (std::size_t i = 0; i < steps.size(); ++i) u.push_back(u.back() + (i < first ? 1.0 : scale) * steps[i]);
  u.back() = to;
}

}  // namespace

double wanted_size(const MeshPlan& plan, double u) {
  double size = plan.longest;
  for (const FineStretch& stretch : plan.fine) {
    const double away = std::max({stretch.from - u, u - stretch.to, 0.0});
    size = std::min(size, stretch.size + kMeshGrowth * away);
  }
  return size;
}

std::vector<double> graded_nodes(const MeshPlan& plan) {
  std::vector<double> u{0.0};
  for (const double to : plan.fixed) {
    fill(u, plan, to);
  }
  return u;
}

}  // namespace overbend
