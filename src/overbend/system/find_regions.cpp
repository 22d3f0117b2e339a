#include "system/find_regions.h"

#include <algorithm>

namespace overbend {
namespace {

double first_sagging(const BendingProfile& line, double touchdown, double departure) {
  for (std::size_t i = line.s.size(); i-- > 0;) {
    if (line.s[i] < departure && line.vertical[i] > 0.0) return std::max(line.s[i], touchdown);
  }
  return touchdown;
}

double first_min_moment(const BendingProfile& line, double touchdown) {
  std::size_t i = line.s.size() - 1;
  while (i > 0 && line.s[i] > touchdown && line.moment[i - 1] < line.moment[i]) --i;
  return std::max(line.s[i], touchdown);
}

}  // namespace

Regions find_regions(const BendingProfile& line, double touchdown, std::optional<double> departure, bool clamped) {
  const double top = line.s.back();
  if (departure) return {touchdown, first_sagging(line, touchdown, *departure), *departure, true};
  return {touchdown, clamped ? first_min_moment(line, touchdown) : top, top, false};
}

}  // namespace overbend
