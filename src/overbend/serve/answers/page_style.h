/// Format of values sent to the page: seven digits, positions as [x, y, z], arc lengths from the tensioner.
#pragma once

#include "report/page/json_number.h"
#include "resultfiles/summary/json_fields.h"
#include "serve/answers/static_json.h"

namespace overbend {

struct PageStyle : ValueStyle<Output::page> {
  double top = 0.0;  ///< Arc length of the tensioner [m].

  Json number(double value) const { return seven_digits(value); }
  double along(double s) const { return top - s; }
  Vec3 moved(const ResultField&, const Vec3& vector) const { return vector; }
  Json vector(const Vec3& v) const { return place_json(v); }
};

}  // namespace overbend
