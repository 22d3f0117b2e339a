#include "study/goal_seek/seek_start_points.h"

#include <algorithm>

#include "study/sampling/latin_hypercube.h"

namespace overbend {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index kMaxWithCorners = 4;             // unknowns: 16 corners
constexpr int kPerUnknown = 10, kMaxDraws = 60;  // draws
constexpr std::uint64_t kSeed = 1;

void add_corners(Index n, std::vector<VectorXd>& places) {
  for (Index corner = 0; corner < (Index{1} << n); ++corner) {
    VectorXd x(n);
    for (Index i = 0; i < n; ++i) x(i) = (corner >> i) & 1 ? 1.0 : 0.0;
    places.push_back(std::move(x));
  }
}

void add_draws(Index n, std::vector<VectorXd>& places) {
  const SampledKey uniform{.key = {}, .unit = "1", .show = {}, .from = 0.0, .to = 1.0};
  const StudySample sample{.count = std::min(kPerUnknown * static_cast<int>(n), kMaxDraws),
                           .seed = kSeed,
                           .keys = std::vector<SampledKey>(static_cast<std::size_t>(n), uniform)};
  for (const std::vector<double>& draw : latin_hypercube(sample)) {
    places.push_back(Eigen::Map<const VectorXd>(draw.data(), n));
  }
}

}  // namespace

std::vector<VectorXd> start_points_within_bounds(const VectorXd& start) {
  std::vector<VectorXd> places;
  if (start.size() <= kMaxWithCorners) add_corners(start.size(), places);
  places.push_back(VectorXd::Constant(start.size(), 0.5));
  add_draws(start.size(), places);
  std::stable_sort(places.begin(), places.end(), [&](const VectorXd& a, const VectorXd& b) {
    return (a - start).squaredNorm() < (b - start).squaredNorm();
  });
  return places;
}

}  // namespace overbend
