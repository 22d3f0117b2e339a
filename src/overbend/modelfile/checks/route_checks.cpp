#include <fmt/core.h>

#include <cmath>
#include <numbers>

#include "base/constants.h"
#include "modelfile/checks/model_checks.h"

namespace overbend {
namespace {

constexpr double kMaxTurn = 170.0 * kDegree;  ///< Max. turn at a corner for which its arc is meaningful.

struct Place {
  double x = 0.0, y = 0.0;
};

std::optional<Place> parse_place(const FieldValue& point) {
  const auto x = point.get_number("x"), y = point.get_number("y");
  return x && y ? std::optional(Place{*x, *y}) : std::nullopt;
}

/// Turn from one line to the next, and length of either line used by the arc.
double turn_between(const Place& a, const Place& b, const Place& c) {
  return std::remainder(std::atan2(c.y - b.y, c.x - b.x) - std::atan2(b.y - a.y, b.x - a.x), 2.0 * std::numbers::pi);
}

void check_corners(Checker& check, const std::vector<FieldValue>& points, const FieldValue* radius) {
  std::vector<Place> places{{}};
  for (const FieldValue& point : points) {
    const std::optional<Place> place = parse_place(point);
    if (!place) return;
    if (std::hypot(place->x - places.back().x, place->y - places.back().y) == 0.0) {
      check.error(point, "the previous point again", "distinct consecutive points");
      return;
    }
    places.push_back(*place);
  }
  double taken = 0.0;
  for (std::size_t i = 1; i + 1 < places.size(); ++i) {
    const double turn = std::abs(turn_between(places[i - 1], places[i], places[i + 1]));
    if (turn > kMaxTurn) {
      check.error(points[i - 1], fmt::format("a turn by {:.0f} degrees", turn * kToDegrees),
                  "at most 170 degrees at a point");
      return;
    }
    const double cut = radius != nullptr ? radius->number * std::tan(0.5 * turn) : 0.0;
    const double line = std::hypot(places[i].x - places[i - 1].x, places[i].y - places[i - 1].y);
    const bool last = i + 2 == places.size();
    const double next = std::hypot(places[i + 1].x - places[i].x, places[i + 1].y - places[i].y);
    if (radius != nullptr && (taken + cut > line || (last && cut > next))) {
      check.error(
          *radius, radius->shown,
          fmt::format("arcs that fit between the points: at point {} the arc takes {:.1f} m of each line", i, cut));
      return;
    }
    taken = cut;
  }
}

void check_points(Checker& check, const FieldValue& route) {
  const std::vector<FieldValue>& points = Checker::items(route, "points");
  if (points.empty()) return;
  const FieldValue *x = points.front().find("x"), *y = points.front().find("y");
  if (y != nullptr && y->number != 0.0) {
    check.error(*y, y->shown, "0 m",
                "the route leaves the barge straight astern: its first point is on the barge's axis");
    return;
  }
  if (x != nullptr && x->number <= 0.0) {
    check.error(*x, x->shown, "more than 0 m", "the route starts at the stern shoe and runs astern");
    return;
  }
  const FieldValue* radius = route.find("corner_radius");
  check_corners(check, points, radius != nullptr && radius->given ? radius : nullptr);
}

void check_leg(Checker& check, const FieldValue& leg) {
  const bool length = leg.mentions("length"), radius = leg.mentions("radius"), angle = leg.mentions("angle");
  if (length && (radius || angle)) {
    check.error(leg, "a length together with an arc", "a length, or a radius with an angle");
  } else if (!length && !(radius && angle)) {
    check.error(leg, radius || angle ? "only one of radius and angle" : "nothing",
                "a length, or a radius with an angle");
  } else if (const FieldValue* turn = leg.find("angle"); turn != nullptr && turn->number == 0.0) {
    check.error(*turn, turn->shown, "the angle by which the arc turns, positive to port");
  }
}

}  // namespace

void check_route(Checker& check) {
  const FieldValue* route = check.root().find("route");
  if (route == nullptr || !route->given) return;
  const FieldValue* legs = route->find("legs");
  const bool points = route->mentions("points");
  if (legs != nullptr && points) check.error(*legs, "both legs and points", "points or legs");
  if (legs == nullptr && !points) check.error(*route, "neither points nor legs", "points or legs");
  const FieldValue* radius = route->find("corner_radius");
  if (legs != nullptr && radius != nullptr && radius->given) {
    check.error(*radius, "a key of points", "none with legs, each of which has its own radius");
  }
  check_points(check, *route);
  for (const FieldValue& leg : Checker::items(*route, "legs")) check_leg(check, leg);
}

}  // namespace overbend
