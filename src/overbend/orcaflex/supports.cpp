// Supports of the vessel: path with arc lengths, or places one by one.
#include <cmath>

#include "base/constants.h"
#include "base/text.h"
#include "orcaflex/translation.h"

namespace overbend::orcaflex {
namespace {

constexpr double kDegree = kPi / 180.0;

/// A frame: its axes are the columns.
struct Frame {
  Vec3 origin = Vec3::Zero();
  Mat3 axes = Mat3::Identity();
};

/// A roller box: axis of its cylinder in the axes of the vessel, its own x along the pipe and z away from the cylinder.
struct Support {
  std::string name, type;
  Frame frame;
  int line = 0;
};

/// Azimuth about z, then declination about y, which dips x, then gamma about x [deg].
Mat3 rotation(const Vec3& angles) {
  const Vec3 a = angles * kDegree;
  return (Eigen::AngleAxisd(a.x(), Vec3::UnitZ()) * Eigen::AngleAxisd(a.y(), Vec3::UnitY()) *
          Eigen::AngleAxisd(a.z(), Vec3::UnitX()))
      .toRotationMatrix();
}

/// Point of a path of straight and bent sections at an arc length, with the dip of its tangent [rad].
struct PathPoint {
  double along = 0.0, up = 0.0, dip = 0.0;
};

PathPoint path_point(const Table& sections, double unit, double arc) {
  PathPoint point;
  double left = arc;
  for (std::size_t row = 0; row < sections.size() && left > 0.0; ++row) {
    const bool is_last = row + 1 == sections.size();
    const double length = sections.number(row, "SupportPathSectionLength").value_or(0.0) * unit;
    const double step = is_last ? left : std::min(left, length);
    const double radius = sections.number(row, "SupportPathSectionBendRadius").value_or(HUGE_VAL) * unit;
    const double turned = std::isinf(radius) ? 0.0 : step / radius;
    if (turned == 0.0) {
      point.along += step * std::cos(point.dip);
      point.up -= step * std::sin(point.dip);
    } else {
      point.along += radius * (std::sin(point.dip + turned) - std::sin(point.dip));
      point.up -= radius * (std::cos(point.dip) - std::cos(point.dip + turned));
    }
    point.dip += turned;
    left -= step;
  }
  return point;
}

std::vector<Support> supports_on_path(const Translation& translation, const Object& vessel) {
  const double unit = translation.units.length;
  const std::optional<Table> sections = vessel.table("SupportPathSectionLength");
  const std::optional<Table> places = vessel.table("SupportArclength");
  std::vector<Support> supports;
  if (!sections || !places) {
    vessel.reject("SupportGeometrySpecification", "Simple without its tables", "path sections and supports");
    return supports;
  }
  const Frame path{vessel.triple("SupportPathOriginPos") * unit,
                   rotation(vessel.triple("SupportPathOriginOrientation"))};
  for (std::size_t row = 0; row < places->size(); ++row) {
    const double arc = places->number(row, "SupportArclength").value_or(0.0);
    const PathPoint point = path_point(*sections, unit, arc * unit);
    const double offset = places->number(row, "SupportzOffset").value_or(0.0) * unit;
    const Mat3 dipped = path.axes * rotation({0.0, point.dip / kDegree, 0.0});
    const Vec3 axis = path.origin + path.axes * Vec3(point.along, 0.0, point.up) + offset * dipped.col(2);
    supports.push_back(
        {"arc " + number_text(arc), places->text(row, "SupportType"), {axis, dipped}, places->line(row)});
  }
  return supports;
}

std::vector<Support> supports_at_places(const Translation& translation, const Object& vessel) {
  const double unit = translation.units.length;
  std::map<std::string, Frame> systems;
  for (const Object& system : vessel.objects("SupportCoordinateSystems")) {
    systems[system.text("SupportCoordinateSystemName")] = {
        system.triple("SupportCoordinateSystemPos") * unit,
        rotation(system.triple("SupportCoordinateSystemOrientation"))};
  }
  std::vector<Support> supports;
  std::map<std::string, int> counts;
  for (const Object& support : vessel.objects("Supports")) {
    const std::string system = support.text("SupportCoordinateSystem");
    Frame frame;
    if (const auto found = systems.find(system); found != systems.end()) {
      frame = found->second;
    } else if (!system.empty()) {
      support.reject("SupportCoordinateSystem", "'" + for_display(system) + "'", "one of SupportCoordinateSystems");
    }
    const Vec3 position = frame.origin + frame.axes * support.triple("SupportPosition") * unit;
    const std::string name = (system.empty() ? "support" : system) + " " + std::to_string(++counts[system]);
    supports.push_back({name,
                        support.text("SupportType"),
                        {position, frame.axes * rotation(support.triple("SupportOrientation"))},
                        support.line()});
  }
  return supports;
}

std::optional<Object> support_type(const Translation& translation, const Object& vessel, const std::string& name) {
  for (const Object& type : translation.objects("SupportTypes")) {
    if (type.name() == name) return type;
  }
  vessel.reject("SupportType", "'" + for_display(name) + "'", "one of the SupportTypes");
  return std::nullopt;
}

/// Half angle of a V between its rollers and the vertical plane [rad], under any of its keys.
double read_v_angle(const Object& type) {
  for (const char* key : {"VSupportWallAngle", "VSupportAngle", "WallAngle"}) {
    if (const std::optional<double> angle = type.number(key)) return *angle * kDegree;
  }
  type.reject("VSupportWallAngle", "nothing", "the angle of the walls");
  return 0.0;
}

std::string roller_text(Translation& translation, const Object& type) {
  const double unit = translation.units.length;
  const auto length = [&](const char* key, double otherwise) {
    return type.number(key).value_or(otherwise / unit) * unit;
  };
  const double radius = 0.5 * length("Diameter", 0.0);
  double stiffness = type.number("NormalStiffness").value_or(0.0) * translation.units.stiffness();
  const std::string geometry = type.text("Geometry", "Flat");
  const double pipe = translation.laid_pipe()->pieces.front().type->diameter();
  double face = length("FlatSupportLength", 2.0);
  std::string sides;
  if (geometry == "U shaped") {
    face = length("USupportHorizontalLength", 2.0);
    sides =
        fmt::format("    sides: {{radius: {} m, face: {} m, angle: 90 deg, clearance: {} m}}\n", number_text(radius),
                    number_text(length("USupportVerticalLength", 1.0)), number_text(0.5 * face - radius - 0.5 * pipe));
    translation.approximated("support type " + for_display(type.name()) +
                             ": bottom roller and two upright side rollers of the same diameter");
  } else if (geometry == "V shaped") {
    const double angle = read_v_angle(type);
    stiffness *= 2.0 * std::pow(std::cos(angle), 2);
    translation.approximated(
        fmt::format("support type {}: V of {} deg as one bottom roller of stiffness {} kN/m (2 k cos^2 of the "
                    "angle); it does not hold the pipe sideways",
                    for_display(type.name()), number_text(angle / kDegree), number_text(stiffness / 1e3)));
  } else if (geometry != "Flat") {
    type.reject("Geometry", "'" + for_display(geometry) + "'", "Flat, U shaped or V shaped");
  }
  return fmt::format("    bottom: {{radius: {} m, face: {} m}}\n{}    stiffness: {} kN/m\n", number_text(radius),
                     number_text(face), sides, number_text(stiffness / 1e3));
}

std::string roller_key(const std::string& name) {
  std::string key = lower_case(name);
  for (char& c : key) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  }
  return key.empty() ? "roller" : key;
}

/// A box of a support: where the underside of the pipe rests, in the frame of ramp and stinger.
std::string box_text(const Translation& translation, const Object& vessel, const Support& support, double radius) {
  const Vec3 rest = support.frame.origin + radius * support.frame.axes.col(2);
  const Vec3 along = support.frame.axes.col(0);
  if (std::abs(along.y()) > 1e-6 || along.x() > 0.0 || std::abs(rest.y()) > 1e-3) {
    vessel.reject("Supports",
                  fmt::format("{} {} m to port, along ({}, {}, {})", for_display(support.name), number_text(rest.y()),
                              number_text(along.x()), number_text(along.y()), number_text(along.z())),
                  "supports along the axis of the vessel, astern");
  }
  return fmt::format("      - {{name: {}, x: {} m, z: {} m, incline: {} deg, roller: {}}}\n", name_text(support.name),
                     number_text(translation.vessel.stern_shoe - rest.x()),
                     number_text(rest.z() + translation.vessel.position.z()),
                     number_text(std::atan2(-along.z(), -along.x()) / kDegree), roller_key(support.type));
}

}  // namespace

std::string supports_text(Translation& translation) {
  if (!translation.vessel_object || translation.laid_pipe() == nullptr) return "";
  const Object& vessel = *translation.vessel_object;
  const std::string specification = vessel.text("SupportGeometrySpecification", "None");
  const bool is_simple = specification == "Simple";
  if (!is_simple && specification != "Explicit") return "";
  const std::vector<Support> supports =
      is_simple ? supports_on_path(translation, vessel) : supports_at_places(translation, vessel);
  std::map<std::string, double> radii;
  std::string rollers, ramp, stinger;
  for (const Support& support : supports) {
    if (!radii.contains(support.type)) {
      const std::optional<Object> type = support_type(translation, vessel, support.type);
      if (!type) return "";
      radii[support.type] = 0.5 * type->number("Diameter").value_or(0.0) * translation.units.length;
      rollers += "  " + roller_key(support.type) + ":\n" + roller_text(translation, *type);
    }
    const double radius = radii[support.type];
    const Vec3 rest = support.frame.origin + radius * support.frame.axes.col(2);
    const bool is_on_ramp = translation.vessel.stern_shoe - rest.x() < 0.0;
    (is_on_ramp ? ramp : stinger) += box_text(translation, vessel, support, radius);
  }
  std::string text = "rollers:\n" + rollers + "\nsupports:\n";
  const std::string first = supports.empty() ? "roller" : roller_key(supports.front().type);
  if (!ramp.empty()) text += "  ramp:\n    roller: " + first + "\n    boxes:\n" + ramp;
  if (!stinger.empty()) text += "  stinger:\n    roller: " + first + "\n    boxes:\n" + stinger;
  translation.translated(fmt::format("{} supports ({}) as boxes with inclines", supports.size(),
                                     is_simple ? "along a path" : "at places"));
  translation.left_out("shear stiffness of supports and seabed");
  return text + "\n";
}

}  // namespace overbend::orcaflex
