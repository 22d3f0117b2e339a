#include "base/constants.h"
#include "model/description/description_enum_names.h"
#include "modelfile/fields/field_rows.h"
#include "modelfile/fields/row_makers.h"

namespace overbend::field_rows {
namespace {

constexpr double kMinWavePeriod = 0.5;  ///< Waves of 0.4 m, shorter than a pipe diameter [s].

/// Keys of a group of waves at `p`.
std::vector<Field> wave_rows(const std::string& p) {
  using Waves = WavesDescription;
  const Shown height = kLength, period = kTime;
  const Range sea_height = {.low = 0.0, .high = 40.0, .low_open = true};
  const Range sea_period = {.low = kMinWavePeriod, .high = 100.0};
  std::vector<Field> rows = {
      required(row_of_kind(FieldKind::choice, p + ".type", fills(&Waves::type),
                           "Regular wave, spectrum or measured elevation.")),
      quantity_row(p + ".hs", fills(&Waves::hs), "Significant wave height of an irregular sea.", height, sea_height),
      quantity_row(p + ".tp", fills(&Waves::tp), "Peak period of an irregular sea.", period, sea_period),
      quantity_row(p + ".tz", fills(&Waves::tz),
                   "Zero up-crossing period of a JONSWAP or Pierson-Moskowitz spectrum, in place of tp, which follows "
                   "by integrals over all frequencies: 1.2863 tz for gamma 3.3, 1.4077 tz for gamma 1.",
                   period, sea_period),
      quantity_row(p + ".height", fills(&Waves::height), "Height of a regular wave, crest to trough.", height,
                   {.low = 0.0, .high = 60.0, .low_open = true}),
      quantity_row(p + ".period", fills(&Waves::period), "Period of a regular wave.", period,
                   {.low = kMinWavePeriod, .high = 1000.0}),
      quantity_row(p + ".phase", defaults(&Waves::phase),
                   "Phase of a regular wave: 0 has a crest at the origin at t = 0, 90 deg a quarter period later.",
                   kAngle, azimuth()),
      quantity_row(p + ".from", defaults(&Waves::from), "Azimuth the waves come from, clockwise from north.", kAngle,
                   azimuth()),
      otherwise(row_of_kind(FieldKind::number, p + ".gamma", fills(&Waves::gamma), "JONSWAP peak enhancement factor.",
                            {.low = 1.0, .high = 10.0}),
                "rule of DNV-RP-C205"),
      list_row(p + ".parts", enters(&Waves::parts), "Two parts of an Ochi-Hubble spectrum, of low and high frequency.",
               ""),
      group_row(p + ".parts[]", appends<SpectrumPart>(), "Part of an Ochi-Hubble spectrum."),
      required(quantity_row(p + ".parts[].hs", fills(&SpectrumPart::hs), "Significant wave height of the part.", height,
                            sea_height)),
      required(
          quantity_row(p + ".parts[].tp", fills(&SpectrumPart::tp), "Peak period of the part.", period, sea_period)),
      required(row_of_kind(FieldKind::number, p + ".parts[].lambda", fills(&SpectrumPart::lambda),
                           "Shape of the part: 1 is Pierson-Moskowitz, a larger one is more peaked.",
                           {.low = 0.75, .high = 50.0})),
      row_of_kind(FieldKind::choice, p + ".model", fills(&Waves::model),
                  "Torsethaugen spectrum: the simplified double peak model of 2004, or the full model of 1996."),
      otherwise(row_of_kind(FieldKind::number, p + ".spreading", fills(&Waves::spreading),
                            "Exponent s of the directional spreading cos^2s(angle/2).",
                            {.low = 0.0, .high = 1000.0, .low_open = true}),
                "long-crested"),
      row_of_kind(FieldKind::integer, p + ".components", defaults(&Waves::components),
                  "Number of wave components of an irregular sea.", {.low = 1.0, .high = 100000.0}),
      row_of_kind(FieldKind::integer, p + ".seed", defaults(&Waves::seed),
                  "Seed of the random phases. In a list of groups each has random numbers of its own, also with equal "
                  "seeds.",
                  {.low = 0.0, .high = double{kMaxSeed}}),
      row_of_kind(FieldKind::text, p + ".spectrum_file", fills(&Waves::spectrum_file),
                  "For type user, a spectrum: CSV with the columns omega_rad_s,density_m2s or "
                  "frequency_hz,density_m2_hz, NDBC spectral density or SWAN spectrum, with directions if the file has "
                  "them. For jonswap and pierson_moskowitz, NDBC text of wave heights and periods (WVHT, DPD, MWD)."),
      otherwise(row_of_kind(FieldKind::text, p + ".time", fills(&Waves::time),
                            "Time in a spectrum file of several, as in the file: 2026-06-01 09:40."),
                "the only time"),
      otherwise(row_of_kind(FieldKind::integer, p + ".location", fills(&Waves::location),
                            "Number of the location in a SWAN file of several.", {.low = 1.0, .high = 100000.0}),
                "the only location"),
      row_of_kind(FieldKind::text, p + ".elevation_file", fills(&Waves::elevation_file),
                  "For type elevation: table of times and elevations in even steps, such as time_s,elevation_m; t = 0 "
                  "is its first "
                  "row."),
  };
  for (Field& row : rows) row.file = row.path.ends_with("_file");
  for (Field& row : rows) {
    if (row.path.ends_with(".parts")) row.min_items = row.max_items = 2;
  }
  append(rows,
         vector_rows({.group = otherwise(
                          group_row(p + ".at", enters(&Waves::measured_at), "Place where the elevation was measured."),
                          "the origin"),
                      .shown = kLength,
                      .texts = {"To the east, from below midship of the vessel in its position.", "To the north."},
                      .all = false}));
  return rows;
}

}  // namespace

std::vector<Field> waves() {
  const std::string p = "environment.waves";
  const auto open_only = [](EnvironmentDescription& environment, const FieldValue& value) -> WavesDescription& {
    environment.waves.assign(1, {});
    environment.waves.front().key = value.path;
    return environment.waves.front();
  };
  const auto open_item = [](std::vector<WavesDescription>& groups, const FieldValue& value) -> WavesDescription& {
    groups.emplace_back().key = value.path;
    return groups.back();
  };
  constexpr int kMaxGroups = 20;
  std::vector<Field> rows = {
      group_row(p, opened_by<EnvironmentDescription>(open_only),
                "Waves; only dynamic analysis uses them. One group of keys, or a list of groups.")};
  append(rows, wave_rows(p));
  rows.push_back(at_least(
      1, list_row(p, enters(&EnvironmentDescription::waves),
                  "Groups of waves at once, such as wind sea and swell: their waves superpose.", "one group of keys")));
  rows.back().max_items = kMaxGroups;
  rows.push_back(group_row(p + "[]", opened_by<std::vector<WavesDescription>>(open_item),
                           "Group of waves with the keys of a single one."));
  append(rows, wave_rows(p + "[]"));
  return rows;
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
