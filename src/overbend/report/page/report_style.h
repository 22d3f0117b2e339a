/// Style of the data of the report's diagrams: seven digits, positions and directions in the vessel's axes
/// (results/fields/location_names.h), arc lengths from the tensioner.
#pragma once

#include "report/page/json_number.h"
#include "resultfiles/summary/json_fields.h"
#include "results/fields/location_names.h"

namespace overbend {

struct ReportStyle : ValueStyle<Output::report> {
  const StaticResults* statics = nullptr;

  explicit ReportStyle(const StaticResults& results) : statics(&results) {}

  Json number(double value) const { return json_number(value); }
  double along(double s) const { return from_tensioner(*statics, s); }
  /// Directions have no unit.
  Vec3 moved(const ResultField& field, const Vec3& v_W) const {
    return field.units == "1" ? ship_direction(*statics, v_W) : ship_point(*statics, v_W);
  }
  Json vector(const Vec3& v) const { return Json::array({json_number(v.x()), json_number(v.y()), json_number(v.z())}); }
};

}  // namespace overbend
