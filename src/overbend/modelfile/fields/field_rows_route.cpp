#include <numbers>

#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {

std::vector<Field> route() {
  constexpr double kHalfTurn = std::numbers::pi;
  return {
      otherwise(group_row("route", enters(&Description::route),
                          "The line on which the pipe is laid, in plan, from the stern shoe astern along the barge as "
                          "drawn, which heads along its beginning: points or legs."),
                "straight astern"),
      list_row("route.points", enters(&RouteDescription::points),
               "Joined by straight lines from the stern shoe on, the first straight astern; the last line goes on.",
               "legs, or straight astern"),
      group_row("route.points[]", appends<RoutePoint>(), "One point."),
      required(quantity_row("route.points[].x", fills(&RoutePoint::x),
                            "Astern of the stern shoe, along the barge as drawn.", kLength)),
      required(quantity_row("route.points[].y", fills(&RoutePoint::y), "To port.", kLength)),
      otherwise(quantity_row("route.corner_radius", fills(&RouteDescription::corner_radius),
                             "Of the arc at each point between the first line and the last.", kLength, kPositive),
                "1.5 times the least radius that friction holds under the bottom tension of a cable"),
      list_row("route.legs", enters(&RouteDescription::legs),
               "Instead of points: straight lines and arcs one after the other from the stern shoe on; the last "
               "direction goes on.",
               "points, or straight astern"),
      group_row("route.legs[]", appends<RouteLeg>(), "One leg: a length, or a radius with an angle."),
      otherwise(quantity_row("route.legs[].length", fills(&RouteLeg::length), "Of a straight leg.", kLength, kPositive),
                "an arc"),
      otherwise(quantity_row("route.legs[].radius", fills(&RouteLeg::radius), "Of an arc.", kLength, kPositive),
                "a straight leg"),
      otherwise(quantity_row("route.legs[].angle", fills(&RouteLeg::angle),
                             "By which the arc turns, positive to port going astern.", kAngle,
                             {.low = -kHalfTurn, .high = kHalfTurn, .low_open = true, .high_open = true}),
                "a straight leg"),
  };
}

}  // namespace overbend::field_rows
