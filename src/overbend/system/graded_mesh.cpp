#include "system/graded_mesh.h"

namespace overbend {
namespace {

void fill(std::vector<double>& u, const MeshPlan& plan, double to) {
  const double from = u.back();
  double position = from;
  std::vector<double> steps;
  walk(plan, from, to, [&](double step) {
    steps.push_back(step);
    position += step;
    return true;
  });
  const double scale = (to - from) / (position - from);
  for (const double step : steps) {
    u.push_back(u.back() + scale * step);
  }
  u.back() = to;
}

}  // namespace

double element_size_at(const MeshPlan& plan, double u) {
  double size = plan.max_length;
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
