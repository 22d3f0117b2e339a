#include "checks/current_part.h"

#include <algorithm>

namespace overbend {

Vec3 CurrentPart::moment(const Vec3& t) const {
  const Vec3 horizontal(t.x(), t.y(), 0.0);
  if (horizontal.norm() < 1e-9) return Vec3::Zero();  // vertical pipe: the vertical plane is undefined
  const Vec3 port = Vec3::UnitZ().cross(horizontal.normalized());
  return vertical * t.cross(port) + lateral * port;
}

CurrentPart current_part(const StaticResults& statics, double s) {
  const std::vector<Station>& all = statics.stations;
  const auto above =
      std::lower_bound(all.begin(), all.end(), s, [](const Station& station, double v) { return station.s < v; });
  const Station& b = above == all.end() ? all.back() : *above;
  const Station& a = above == all.begin() || above == all.end() ? b : *(above - 1);
  const double share = b.s > a.s ? std::clamp((s - a.s) / (b.s - a.s), 0.0, 1.0) : 1.0;
  const auto mix = [&](double Station::*member) { return a.*member + share * (b.*member - a.*member); };
  return {mix(&Station::current_vertical_moment), mix(&Station::current_lateral_moment),
          mix(&Station::current_tension)};
}

bool has_current_part(const StaticResults& statics) {
  return std::any_of(statics.stations.begin(), statics.stations.end(), [](const Station& station) {
    return station.current_vertical_moment != 0.0 || station.current_lateral_moment != 0.0 ||
           station.current_tension != 0.0;
  });
}

}  // namespace overbend
