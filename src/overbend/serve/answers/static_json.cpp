#include "serve/answers/static_json.h"

#include <cmath>

#include "results/tables/named_tables.h"
#include "serve/answers/page_fields.h"
#include "serve/answers/page_style.h"

namespace overbend {
namespace {

/// Rounds a coordinate to seven digits and removes round-off near zero.
double visible(double value) {
  return std::abs(value) < 1e-9 ? 0.0 : seven_digits(value);
}

}  // namespace

Json place_json(const Vec3& p_W) {
  return {visible(p_W.x()), visible(p_W.y()), visible(p_W.z())};
}

Json pose_json(const Vec3& p_WV, const Mat3& R_WV) {
  Json pose = place_json(p_WV);
  for (int i = 0; i < 9; ++i) pose.push_back(visible(R_WV(i / 3, i % 3)));
  return pose;
}

Json static_json(const StaticResults& results, const std::vector<std::string>* lists) {
  PageStyle style;
  if (!results.stations.empty()) style.top = results.stations.back().s;
  Json answer = page_statics(style, results, lists);
  if (lists == nullptr) {
    answer["tables"] = tables_json(static_tables(results));
  }  // tables are omitted while a value is dragged
  return answer;
}

}  // namespace overbend
