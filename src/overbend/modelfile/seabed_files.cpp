#include "modelfile/seabed_files.h"

#include <filesystem>

#include "base/units.h"
#include "model/bed_shape.h"
#include "model/model.h"
#include "seafiles/bathymetry_reader.h"

namespace overbend {
namespace {

Vec3 stern_shoe(const VesselDescription& vessel) {
  return vessel_axes(vessel.heading, vessel.trim, vessel.heel) * Vec3(vessel.stern_shoe_x, 0.0, vessel.stern_shoe_z);
}

}  // namespace

void read_bathymetry_file(const FieldValue& root, Description& description, Diagnostics& diagnostics) {
  SeabedDescription& bed = description.environment.seabed;
  const FieldValue* key = root.find("environment.seabed.bathymetry");
  if (bed.bathymetry_file.empty() || key == nullptr) return;
  const auto refuse = [&](std::string found, std::string expected, std::string hint) {
    diagnostics.add({Severity::error, description.source_file, key->line, 0, key->path, std::move(found),
                     std::move(expected), std::move(hint)});
  };
  std::error_code fault;
  if (!std::filesystem::exists(bed.bathymetry_file, fault)) {
    return refuse("the file " + key->shown + ", which does not exist", "a file with depths", "");
  }
  bed.bathymetry = read_bathymetry(bed.bathymetry_file, diagnostics);
  if (!bed.bathymetry) return;
  const Vec3 shoe = stern_shoe(description.vessel);
  const double depth = -bed_point(*grid_shape(*bed.bathymetry), shoe.x(), shoe.y()).z;
  if (const auto found = depth_disagrees(depth, description.environment.water_depth)) {
    refuse(
        *found,
        "environment.water_depth, " + format_quantity(description.environment.water_depth, "m", "m") + ", within 0.1 m",
        "east and north count from midship");
  }
}

}  // namespace overbend
