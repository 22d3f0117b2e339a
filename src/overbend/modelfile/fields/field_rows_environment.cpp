#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"

namespace overbend::field_rows {
namespace {

constexpr double kMinWavePeriod = 0.5;  ///< Waves of 0.4 m, shorter than a pipe diameter [s].

}  // namespace

std::vector<Field> waves() {
  const std::string p = "environment.waves";
  return {
      {.path = p, .member = enters(&EnvironmentDescription::waves), .text = "Waves; only dynamic analysis uses them."},
      {.path = p + ".type",
       .member = fills(&WavesDescription::type),
       .kind = FieldKind::choice,
       .text = "Sea state or regular wave.",
       .required = true},
      {.path = p + ".hs",
       .member = fills(&WavesDescription::hs),
       .kind = FieldKind::quantity,
       .text = "Significant wave height of an irregular sea.",
       .unit = "m",
       .show = "m",
       .range = {.low = 0.0, .high = 40.0, .low_open = true}},
      {.path = p + ".tp",
       .member = fills(&WavesDescription::tp),
       .kind = FieldKind::quantity,
       .text = "Peak period of an irregular sea.",
       .unit = "s",
       .show = "s",
       .range = {.low = kMinWavePeriod, .high = 100.0}},
      {.path = p + ".height",
       .member = fills(&WavesDescription::height),
       .kind = FieldKind::quantity,
       .text = "Height of a regular wave, crest to trough.",
       .unit = "m",
       .show = "m",
       .range = {.low = 0.0, .high = 60.0, .low_open = true}},
      {.path = p + ".period",
       .member = fills(&WavesDescription::period),
       .kind = FieldKind::quantity,
       .text = "Period of a regular wave.",
       .unit = "s",
       .show = "s",
       .range = {.low = kMinWavePeriod, .high = 1000.0}},
      {.path = p + ".phase",
       .member = defaults(&WavesDescription::phase),
       .kind = FieldKind::quantity,
       .text = "Phase of a regular wave: 0 has a crest at the origin at t = 0, 90 deg a quarter period later.",
       .unit = "rad",
       .show = "deg",
       .range = azimuth()},
      {.path = p + ".from",
       .member = defaults(&WavesDescription::from),
       .kind = FieldKind::quantity,
       .text = "Azimuth the waves come from, clockwise from north.",
       .unit = "rad",
       .show = "deg",
       .range = azimuth()},
      {.path = p + ".gamma",
       .member = fills(&WavesDescription::gamma),
       .kind = FieldKind::number,
       .text = "JONSWAP peak enhancement factor.",
       .fallback_text = "rule of DNV-RP-C205",
       .range = {.low = 1.0, .high = 10.0}},
      {.path = p + ".spreading",
       .member = fills(&WavesDescription::spreading),
       .kind = FieldKind::number,
       .text = "Exponent s of the directional spreading cos^2s(angle/2).",
       .fallback_text = "long-crested",
       .range = {.low = 0.0, .high = 1000.0, .low_open = true}},
      {.path = p + ".components",
       .member = defaults(&WavesDescription::components),
       .kind = FieldKind::integer,
       .text = "Number of wave components of an irregular sea.",
       .range = {.low = 1.0, .high = 100000.0}},
      {.path = p + ".seed",
       .member = defaults(&WavesDescription::seed),
       .kind = FieldKind::integer,
       .text = "Seed of the random phases.",
       .range = {.low = 0.0, .high = double{kMaxSeed}}},
      {.path = p + ".spectrum_file",
       .member = fills(&WavesDescription::spectrum_file),
       .kind = FieldKind::text,
       .file = true,
       .text = "For type user: CSV file with the columns omega_rad_s,density_m2s or frequency_hz,density_m2_hz."},
  };
}

namespace {

Field map_coordinate(const std::string& path, double MapOrigin::*member, const char* text) {
  return {.path = path,
          .member = fills(member),
          .kind = FieldKind::quantity,
          .text = text,
          .unit = "m",
          .show = "m",
          .range = {.low = -1e8, .high = 1e8}};
}

Field map_angle(const std::string& path, const Member& member, const char* text, double low, double high) {
  return {.path = path,
          .member = member,
          .kind = FieldKind::quantity,
          .text = text,
          .unit = "rad",
          .show = "deg",
          .range = {.low = low * kDegree, .high = high * kDegree}};
}

/// Position of the model in the bathymetry, and meaning of its values. `bathymetry_midship` is the former form.
std::vector<Field> bathymetry_position() {
  const std::string origin = "environment.seabed.bathymetry_origin", midship = "environment.seabed.bathymetry_midship";
  std::vector<Field> rows = {
      {.path = origin,
       .member = enters(&SeabedDescription::bathymetry_origin),
       .text =
           "Position of midship in the coordinates of the bathymetry: east and north of a map, or lat and lon for a "
           "file in degrees, which are converted to metres in the plane that touches the ellipsoid of WGS 84 there.",
       .fallback_text = "at their origin"},
      map_coordinate(origin + ".east", &MapOrigin::east, "Easting."),
      map_coordinate(origin + ".north", &MapOrigin::north, "Northing."),
      map_angle(origin + ".lat", fills(&MapOrigin::lat), "Latitude, north positive.", -89.0, 89.0),
      map_angle(origin + ".lon", fills(&MapOrigin::lon), "Longitude, east positive.", -180.0, 360.0),
      map_angle(origin + ".azimuth", defaults(&MapOrigin::azimuth),
                "Azimuth, in the map, of the model's north, clockwise from the map's north.", -360.0, 360.0),
      {.path = midship,
       .member = enters(&SeabedDescription::bathymetry_origin),
       .text = "Position of midship in the coordinates of the bathymetry: the former form of bathymetry_origin.",
       .fallback_text = "at their origin"},
      map_coordinate(midship + ".east", &MapOrigin::east, "Easting."),
      map_coordinate(midship + ".north", &MapOrigin::north, "Northing."),
      {.path = "environment.seabed.bathymetry_values",
       .member = fills(&SeabedDescription::bathymetry_values),
       .kind = FieldKind::choice,
       .text =
           "Meaning of the values of the bathymetry. depth: positive below the water; elevation: negative below the "
           "water, and land is left out of tables and netCDF grids.",
       .fallback_text = "as the file states, or by the sign that all its values have"},
  };
  for (Field& row : rows) row.required = row.path == midship + ".east" || row.path == midship + ".north";
  return rows;
}

}  // namespace

std::vector<Field> environment() {
  std::vector<Field> rows = {
      {.path = "environment",
       .member = enters(&Description::environment),
       .text = "Water, seabed, current and waves.",
       .required = true},
      {.path = "environment.water_depth",
       .member = fills(&EnvironmentDescription::water_depth),
       .kind = FieldKind::quantity,
       .text = "Water depth at the stern shoe.",
       .unit = "m",
       .show = "m",
       .required = true,
       .range = {.low = 0.0, .high = 12e3, .low_open = true}},
      {.path = "environment.water_weight_density",
       .member = defaults(&EnvironmentDescription::water_weight_density),
       .kind = FieldKind::quantity,
       .text = "Weight density of the sea water.",
       .unit = "N/m^3",
       .show = "kN/m^3",
       .range = {.low = 0.0, .high = 20e3, .low_open = true},
       .usual = {.low = 9.7e3, .high = 10.4e3}},
      {.path = "environment.seabed",
       .member = enters(&EnvironmentDescription::seabed),
       .text = "Seabed under the line.",
       .required = true},
      {.path = "environment.seabed.stiffness",
       .member = fills(&SeabedDescription::stiffness),
       .kind = FieldKind::quantity,
       .text = "Normal force per length of pipe and penetration.",
       .unit = "N/m^2",
       .show = "kN/m^2",
       .required = true,
       .range = {.low = 100.0},
       .usual = {.low = 1e3, .high = 1e8}},
  };
  append(rows, friction<SeabedDescription>("environment.seabed.friction", "Coulomb friction of the pipe on the seabed",
                                           &SeabedDescription::friction_axial, &SeabedDescription::friction_lateral));
  append(
      rows,
      {
          {.path = "environment.seabed.damping",
           .member = defaults(&SeabedDescription::damping),
           .kind = FieldKind::quantity,
           .text = "Normal damping per length of pipe while the penetration increases.",
           .unit = "N*s/m^2",
           .show = "kN*s/m^2",
           .range = {.low = 0.0}},
          {.path = "environment.seabed.soil", .text = "How the normal force grows with penetration."},
          {.path = "environment.seabed.soil.model",
           .member = defaults(&SeabedDescription::soil),
           .kind = FieldKind::choice,
           .text = "linear: by the stiffness; hyperbolic: softens towards bearing_force; bilinear: a tenth of the "
                   "stiffness beyond bearing_force."},
          {.path = "environment.seabed.soil.bearing_force",
           .member = fills(&SeabedDescription::bearing_force),
           .kind = FieldKind::quantity,
           .text = "Force per length of pipe at which soil that is not linear softens.",
           .unit = "N/m",
           .show = "kN/m",
           .fallback_text = "linear soil",
           .range = {.low = 0.0, .low_open = true}},
          {.path = "environment.seabed.slope",
           .member = defaults(&SeabedDescription::slope),
           .kind = FieldKind::quantity,
           .text = "Slope of the seabed, which falls towards slope_towards.",
           .unit = "rad",
           .show = "deg",
           .range = {.low = 0.0, .high = 45.0 * kDegree, .high_open = true}},
          {.path = "environment.seabed.slope_towards",
           .member = defaults(&SeabedDescription::slope_towards),
           .kind = FieldKind::quantity,
           .text = "Azimuth towards which the seabed falls, clockwise from north.",
           .unit = "rad",
           .show = "deg",
           .range = azimuth()},
          {.path = "environment.seabed.profile",
           .member = enters(&SeabedDescription::profile),
           .kind = FieldKind::list,
           .text = "Depths of an uneven seabed along the vessel's axis as drawn, by increasing x, at least two: the "
                   "monotone piecewise cubic through them, level beyond the ends and across.",
           .fallback_text = "a plane"},
          {.path = "environment.seabed.profile[]", .member = appends<ProfilePoint>(), .text = "Depth at one point."},
          {.path = "environment.seabed.profile[].x",
           .member = fills(&ProfilePoint::x),
           .kind = FieldKind::quantity,
           .text = "Astern of the stern shoe.",
           .unit = "m",
           .show = "m",
           .required = true},
          {.path = "environment.seabed.profile[].depth",
           .member = fills(&ProfilePoint::depth),
           .kind = FieldKind::quantity,
           .text = "Water depth there, negative on land.",
           .unit = "m",
           .show = "m",
           .required = true,
           .range = {.low = -200.0, .high = 12e3}},
          {.path = "environment.seabed.bathymetry",
           .member = fills(&SeabedDescription::bathymetry_file),
           .kind = FieldKind::text,
           .file = true,
           .text = "File of depths over an area, recognised by its content: a table of soundings (east, north, depth "
                   "in m, by commas, semicolons, tabs or blanks), an ESRI ASCII grid or a netCDF grid; positions from "
                   "midship, or from the origin of bathymetry_origin."},
      });
  append(rows, bathymetry_position());
  append(rows,
         {
             {.path = "environment.current",
              .member = enters(&EnvironmentDescription::current),
              .kind = FieldKind::list,
              .text = "Current by increasing depth, linear in between.",
              .fallback_text = "no current"},
             {.path = "environment.current[]", .member = appends<CurrentPoint>(), .text = "Current at one depth."},
             {.path = "environment.current[].depth",
              .member = fills(&CurrentPoint::depth),
              .kind = FieldKind::quantity,
              .text = "Below the mean water level.",
              .unit = "m",
              .show = "m",
              .required = true,
              .range = {.low = 0.0, .high = 12e3}},
             {.path = "environment.current[].speed",
              .member = fills(&CurrentPoint::speed),
              .kind = FieldKind::quantity,
              .text = "Speed of the current.",
              .unit = "m/s",
              .show = "m/s",
              .required = true,
              .range = {.low = 0.0, .high = 20.0},
              .usual = {.low = 0.0, .high = 5.0}},
             {.path = "environment.current[].towards",
              .member = fills(&CurrentPoint::towards),
              .kind = FieldKind::quantity,
              .text = "Azimuth towards which the current flows, clockwise from north.",
              .unit = "rad",
              .show = "deg",
              .required = true,
              .range = azimuth()},
         });
  return rows;
}

}  // namespace overbend::field_rows
