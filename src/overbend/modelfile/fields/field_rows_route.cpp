#include <numbers>

#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

std::vector<Field> route() {
  constexpr double kHalfTurn = std::numbers::pi;
  return {
      otherwise(group_row("route", enters(&Description::route),
                          "Lay route in plan, from the stern shoe astern along the barge as drawn, which is aligned "
                          "with its beginning: points or legs."),
                "straight astern"),
      list_row(
          "route.points", enters(&RouteDescription::points),
          "Points joined by straight lines from the stern shoe, the first straight astern; the last line continues.",
          "legs, or straight astern"),
      group_row("route.points[]", appends<RoutePoint>(), "One point."),
      required(quantity_row("route.points[].x", fills(&RoutePoint::x),
                            "Distance astern of the stern shoe, along the barge as drawn.", kLength)),
      required(quantity_row("route.points[].y", fills(&RoutePoint::y), "To port.", kLength)),
      otherwise(
          quantity_row("route.corner_radius", fills(&RouteDescription::corner_radius),
                       "Radius of the arc at each point between the first line and the last.", kLength, kPositive),
          "1.5 times the minimum radius that friction holds under the bottom tension of a cable"),
      list_row("route.legs", enters(&RouteDescription::legs),
               "Alternative to points: successive straight lines and arcs from the stern shoe; the last direction "
               "continues.",
               "points, or straight astern"),
      group_row("route.legs[]", appends<RouteLeg>(), "One leg: a length, or a radius with an angle."),
      otherwise(quantity_row("route.legs[].length", fills(&RouteLeg::length), "Length of a straight leg.", kLength,
                             kPositive),
                "an arc"),
      otherwise(quantity_row("route.legs[].radius", fills(&RouteLeg::radius), "Radius of an arc.", kLength, kPositive),
                "a straight leg"),
      otherwise(quantity_row("route.legs[].angle", fills(&RouteLeg::angle),
                             "Change of direction along the arc, positive to port going astern.", kAngle,
                             {.low = -kHalfTurn, .high = kHalfTurn, .low_open = true, .high_open = true}),
                "a straight leg"),
  };
}

}  // namespace overbend::field_rows
