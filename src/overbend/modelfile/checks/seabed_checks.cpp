#include <array>
#include <cmath>

#include "base/text.h"
#include "base/units.h"
#include "model/site/seabed_shape.h"
#include "modelfile/checks/line_checks.h"
#include "modelfile/checks/model_checks.h"
#include "modelfile/checks/seabed_files.h"

namespace overbend {
namespace {

constexpr const char* kBed = "environment.seabed";

/// Checks that only one of plane, profile and grid is given.
void check_one_shape(Checker& check) {
  constexpr std::array kShapes = {"slope", "profile", "bathymetry"};
  const FieldValue* first = nullptr;
  for (const char* key : kShapes) {
    const FieldValue* shape = check.root().find(std::string(kBed) + "." + key);
    if (shape == nullptr || !shape->given) continue;
    if (first != nullptr) {
      check.error(*shape, shape->key + " and " + first->key, "one of slope, profile and bathymetry",
                  "each of them is the whole seabed");
    }
    first = first != nullptr ? first : shape;
  }
}

std::vector<std::string> origin_keys(const FieldValue& origin) {
  std::vector<std::string> keys;
  for (const FieldValue& key : origin.children) {
    if (key.given) keys.push_back(key.key);
  }
  return keys;
}

/// Checks that the position in the map is complete, in one kind of coordinates and of a bathymetry.
void check_origin(Checker& check) {
  const FieldValue* origin = check.root().find(std::string(kBed) + ".bathymetry_origin");
  if (origin == nullptr || !origin->given) return;
  const auto has = [&](const char* key) { return origin->mentions(key); };
  const FieldValue* former = check.root().find(std::string(kBed) + ".bathymetry_midship");
  if (former != nullptr && former->given) {
    check.error(*origin, "bathymetry_origin and bathymetry_midship", "one of them");
  } else if (has("east") != has("north") || has("lat") != has("lon") || (has("east") && has("lat"))) {
    check.error(*origin, "keys " + join_items(origin_keys(*origin), "and"), "east and north, or lat and lon",
                "lat and lon are for files in degrees");
  }
}

/// Returns the complete points of the profile as long as x increases.
std::vector<ProfilePoint> check_profile(Checker& check, const FieldValue& list) {
  std::vector<ProfilePoint> points;
  bool good = true;
  const FieldValue* before = nullptr;
  for (const FieldValue& point : list.children) {
    const FieldValue *x = point.find("x"), *depth = point.find("depth");
    good = good && x != nullptr && depth != nullptr;
    if (x != nullptr && before != nullptr && x->number <= before->number) {
      check.error(*x, x->shown, "more than the x before it, " + before->shown, "the profile is listed by increasing x");
      good = false;
    }
    if (good) points.push_back({x->number, depth->number});
    before = x != nullptr ? x : before;
  }
  if (list.children.size() < 2) {
    check.error(list, list.children.empty() ? "no point" : "one point", "at least two points");
    good = false;
  }
  return good ? points : std::vector<ProfilePoint>{};
}

/// Checks that a bearing force is given for nonlinear soil only.
void check_soil(Checker& check) {
  const FieldValue* soil = check.root().find(std::string(kBed) + ".soil");
  if (soil == nullptr || !soil->given) return;
  const bool softens = soil->get_text("model").value_or("linear") != "linear";
  const FieldValue* bearing = soil->find("bearing_force");
  if (softens && bearing == nullptr && !soil->mentions("bearing_force")) {
    check.missing(*soil, "bearing_force", "a force per length with its unit", "the soil softens towards it");
  }
  if (!softens && bearing != nullptr) {
    check.error(*bearing, "a bearing force of linear soil", "model: hyperbolic or bilinear");
  }
}

}  // namespace

std::optional<std::string> depth_disagrees(double bed_depth, double water_depth) {
  if (std::abs(bed_depth - water_depth) <= kDepthTolerance) return std::nullopt;
  return "a depth of " + format_quantity(bed_depth, "m", "m") + " at the stern shoe";
}

void check_seabed(Checker& check) {
  check_one_shape(check);
  check_soil(check);
  check_origin(check);
  const FieldValue* list = check.root().find(std::string(kBed) + ".profile");
  const FieldValue* depth = check.root().find("environment.water_depth");
  if (list == nullptr || list->kind != FieldValue::Kind::list || !list->given) return;
  const std::vector<ProfilePoint> points = check_profile(check, *list);
  if (points.empty() || depth == nullptr) return;
  const double origin[2] = {0.0, 0.0}, along[2] = {1.0, 0.0};
  const double at_shoe = -bed_point(*profile_shape(points, origin, along), 0.0, 0.0).z;
  if (const auto found = depth_disagrees(at_shoe, depth->number)) {
    check.error(*list, *found,
                "environment.water_depth, " + format_quantity(depth->number, "m", "m") + ", within 0.1 m",
                "x is measured from there");
  }
}

}  // namespace overbend
