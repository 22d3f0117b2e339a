#include "modelfile/checks/seabed_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/constants.h"
#include "base/ranges.h"
#include "base/shown_unit.h"
#include "base/units.h"
#include "model/model.h"
#include "model/site/seabed_shape.h"
#include "seafiles/bathymetry_reader.h"
#include "seafiles/table_layout.h"

namespace overbend {
namespace {

Vec3 stern_shoe(const VesselDescription& vessel) {
  return vessel_axes(vessel.heading, vessel.trim, vessel.heel) * Vec3(vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z);
}

/// Returns the horizontal unit vector of an azimuth.
Vec3 towards(double azimuth) {
  return vessel_axes(azimuth, 0.0, 0.0).col(0);
}

double depth_under(const Bathymetry& depths, const Vec3& place) {
  return -bed_point(*grid_shape(depths), place.x(), place.y()).z;
}

/// A rectangle of the map [m].
struct Area {
  double west, east, south, north;
};

Area extent(const Bathymetry& depths) {
  const auto [west, east] = ranges::minmax(depths.east);
  const auto [south, north] = ranges::minmax(depths.north);
  return {west, east, south, north};
}

std::string area_label(const Area& a) {
  return fmt::format("{:.8g} to {:.8g} m east, {:.8g} to {:.8g} m north of midship", a.west, a.east, a.south, a.north);
}

double distance(const Area& a, const Vec3& p) {
  return std::hypot(std::max({a.west - p.x(), p.x() - a.east, 0.0}), std::max({a.south - p.y(), p.y() - a.north, 0.0}));
}

/// Returns true if the line from the stern shoe astern, along which the pipe is laid, enters the area within 3 km.
bool reaches(const Area& area, const Vec3& shoe, const Vec3& astern) {
  constexpr double kStep = 10.0;  // [m]
  constexpr int kSoon = 300;      // steps
  for (int i = 0; i <= kSoon; ++i) {
    if (distance(area, shoe + i * kStep * astern) == 0.0) return true;
  }
  return false;
}

/// Returns the distance astern of the stern shoe at which the seabed emerges [m]; empty beyond the reach of a laid
/// pipe.
std::optional<double> shore_astern(const Description& description) {
  const EnvironmentDescription& environment = description.environment;
  const SeabedDescription& bed = environment.seabed;
  const double reach = 8.0 * environment.water_depth + 300.0;
  const Vec3 shoe = stern_shoe(description.vessel), astern = -towards(description.vessel.heading);
  if (!bed.bathymetry) {
    const double rise = -std::tan(bed.slope) * towards(bed.slope_towards).dot(astern);
    const double shore = rise > 0.0 ? environment.water_depth / rise : kInfinity;
    return shore < reach ? std::optional(shore) : std::nullopt;
  }
  const auto shape = grid_shape(*bed.bathymetry);
  constexpr double kStep = 5.0;  // [m]
  for (int i = 0; i * kStep < reach; ++i) {
    const double x = i * kStep;
    const Vec3 place = shoe + x * astern;
    if (bed_point(*shape, place.x(), place.y()).z > 0.0) return x;
  }
  return std::nullopt;
}

}  // namespace

void check_shore(const FieldValue& root, const Description& description, Diagnostics& diagnostics) {
  if (!description.has_pipe || diagnostics.has_errors()) return;
  const std::string key =
      "environment.seabed." + std::string(description.environment.seabed.bathymetry ? "bathymetry" : "slope");
  const FieldValue* value = root.find(key);
  const std::optional<double> shore = value != nullptr ? shore_astern(description) : std::nullopt;
  if (!shore) return;
  diagnostics.add(
      {Severity::warning, description.source_file, value->line, 0, key,
       fmt::format(
           "the seabed emerges {} astern of the stern shoe: it rises in the direction in which the pipe is laid",
           shown(*shore, "m", 1)),
       "", ""});
}

void read_bathymetry_file(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  SeabedDescription& bed = description.environment.seabed;
  const FieldValue* key = root.find("environment.seabed.bathymetry");
  if (bed.bathymetry_file.empty() || key == nullptr) return;
  const auto add_error = [&](std::string found, std::string expected, std::string hint) {
    diagnostics.add({Severity::error, description.source_file, key->line, 0, key->path, std::move(found),
                     std::move(expected), std::move(hint)});
  };
  std::error_code code;
  if (!std::filesystem::exists(bed.bathymetry_file, code)) {
    return add_error("the file " + key->shown + ", which does not exist", "a file with depths", "");
  }
  bed.bathymetry = read_bathymetry(bed.bathymetry_file, diagnostics, {bed.bathymetry_origin, bed.bathymetry_values});
  if (!bed.bathymetry) return;
  const Vec3 shoe = stern_shoe(description.vessel);
  const Area area = extent(*bed.bathymetry);
  if (!reaches(area, shoe, -towards(description.vessel.heading))) {
    const double away = distance(area, shoe);
    return add_error(
        "an area " + format_number(away > 1e4 ? std::round(1e-3 * away) : away, 6) + (away > 1e4 ? " km" : " m") +
            " from the stern shoe: " + area_label(area),
        "an area in which the pipe is laid, with east and north measured from midship",
        "environment.seabed.bathymetry_origin (formerly bathymetry_midship) gives the position of midship in the "
        "coordinates of the file");
  }
  const double wanted = description.environment.water_depth;
  double depth = depth_under(*bed.bathymetry, shoe);
  // heights instead of depths; near a coast most of a grid may be land
  if (!bed.bathymetry_values && depth_disagrees(depth, wanted) && !depth_disagrees(-depth, wanted)) {
    for (double& value : bed.bathymetry->depth) value = -value;
    depth = -depth;
    add_notice(diagnostics, bed.bathymetry_file, 0,
               "its values have the opposite sign: with it the depth at the stern shoe is environment.water_depth");
  }
  if (const auto found = depth_disagrees(depth, wanted)) {
    add_error(*found, "environment.water_depth, " + format_quantity(wanted, "m", "m") + ", within 0.1 m",
              "east and north are measured from midship, or from environment.seabed.bathymetry_origin");
  }
}

}  // namespace overbend
