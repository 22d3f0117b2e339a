// Bathymetry as surveys and grids keep it: depths of known surfaces.
#include <gtest/gtest.h>

#include "base/constants.h"
#include "model/site/seabed_shape.h"
#include "seafiles/bathymetry_reader.h"
#include "support/rao_files.h"
#include "support/table_cases.h"

namespace overbend {
namespace {

struct Depth {
  double x, y, depth;
};

/// The surface of all files in metres but the soundings by tabs.
const std::vector<Depth> kSurface = {
    {0.0, 0.0, 60.0}, {-125.0, 60.0, 57.95}, {210.5, -77.25, 63.1123}, {-333.0, 140.0, 53.8076}};

std::string expect_depths(const std::string& name, const BathymetrySettings& settings, const std::vector<Depth>& depths,
                          double tolerance) {
  Diagnostics diagnostics;
  const auto bed = read_bathymetry(testing::table_case("beds/" + name), diagnostics, settings);
  const std::string messages = testing::all_messages(diagnostics);
  EXPECT_TRUE(bed) << messages;
  if (!bed) return messages;
  const auto shape = grid_shape(*bed);
  for (const Depth& point : depths) {
    EXPECT_NEAR(-bed_point(*shape, point.x, point.y).z, point.depth, tolerance) << name << " " << point.x;
  }
  return messages;
}

std::string reading_error(const std::string& name, const BathymetrySettings& settings = {}) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_bathymetry(testing::table_case(name), diagnostics, settings));
  const std::vector<std::string> errors = diagnostics.lines(Severity::error);
  return errors.empty() ? "" : errors.front();
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << text;
}

std::optional<Bathymetry> read_table(const std::string& text, Diagnostics& diagnostics,
                                     const BathymetrySettings& settings = {}) {
  return read_depth_table(text, "bed.xyz", diagnostics, settings);
}

MapOrigin in_map(double east, double north, double azimuth = 0.0) {
  MapOrigin origin;
  origin.east = east;
  origin.north = north;
  origin.azimuth = azimuth;
  return origin;
}

MapOrigin geographic(double lat, double lon) {
  MapOrigin origin;
  origin.lat = lat * kDegree;
  origin.lon = lon * kDegree;
  return origin;
}

TEST(bathymetry_cases, a_lattice_by_blanks_in_any_order) {
  EXPECT_EQ(expect_depths("lattice-blank.xyz", {}, kSurface, 0.002), "");
}

TEST(bathymetry_cases, heights_in_the_coordinates_of_a_map) {
  const std::string messages = expect_depths("map-comma.csv", {.origin = in_map(512340.0, 5934120.0)}, kSurface, 0.002);
  expect_part(messages, "its values are heights");
}

TEST(bathymetry_cases, soundings_by_tabs) {
  const std::string messages = expect_depths(
      "soundings-tab.txt", {},
      {{0.0, 0.0, 75.0}, {-125.0, 60.0, 77.355}, {210.5, -77.25, 71.2245}, {-333.0, 140.0, 81.115}}, 0.01);
  EXPECT_EQ(messages, "");
}

TEST(bathymetry_cases, an_esri_grid_with_oblong_cells_and_nan) {
  const std::string messages = expect_depths("esri-dx-dy-nan.asc", {}, kSurface, 0.002);
  expect_part(messages, "left out: 8 cells without data");
}

TEST(bathymetry_cases, a_grid_of_gebco_in_degrees) {
  const std::string messages =
      expect_depths("gebco-like.nc", {.origin = geographic(58.25, 3.125)},
                    {{0.0, 0.0, 118.0}, {1500.0, -900.0, 140.8}, {-2600.0, 2200.0, 74.0}}, 0.6);
  expect_part(messages, "cells of land; the seabed there continues");
  expect_part(messages, "the plane that touches the ellipsoid of WGS 84 at latitude 58.25, longitude 3.125");
  expect_part(reading_error("beds/gebco-like.nc"),
              "coordinates in degrees, expected environment.seabed.bathymetry_origin");
}

TEST(bathymetry_cases, damaged_files_are_rejected_with_their_line) {
  const std::string mixed = reading_error("bad/xyz-mixed-signs.xyz");
  expect_part(mixed, "xyz-mixed-signs.xyz:41: depth: found -56.3 among positive depths");
  expect_part(mixed, "environment.seabed.bathymetry_values");
  const std::string row = reading_error("bad/esri-short-row.asc");
  expect_part(row, "esri-short-row.asc:15: found 24 values, expected 26, as ncols states");
}

TEST(bathymetry_cases, a_key_states_what_values_of_both_signs_are) {
  const std::string text = "0 0 -50\n100 0 -60\n0 100 -50\n100 100 12\n";
  Diagnostics diagnostics;
  const auto heights = read_table(text, diagnostics, {.values = BathymetryValues::elevation});
  ASSERT_TRUE(heights) << testing::all_messages(diagnostics);
  EXPECT_EQ(heights->depth, (std::vector<double>{50, 60, 50}));
  expect_part(testing::all_messages(diagnostics), "left out: 1 point of land");
  Diagnostics none;
  const auto depths =
      read_table(testing::case_text("bad/xyz-mixed-signs.xyz"), none, {.values = BathymetryValues::depth});
  ASSERT_TRUE(depths);
  EXPECT_EQ(testing::all_messages(none), "");
}

TEST(bathymetry_cases, a_depth_column_of_heights_needs_the_key) {
  const std::string text = "east,north,depth\n0,0,-5\n20,0,-6\n0,20,-5\n20,20,-6\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_table(text, diagnostics));
  expect_part(testing::all_messages(diagnostics), "bathymetry_values: elevation");
  Diagnostics positive;
  EXPECT_FALSE(read_table("east,north,elevation\n0,0,5\n20,0,6\n0,20,5\n", positive));
  expect_part(testing::all_messages(positive), "no height below 0");
  Diagnostics with_key;
  const auto depths = read_table(text, with_key, {.values = BathymetryValues::elevation});
  ASSERT_TRUE(depths);
  EXPECT_EQ(depths->depth, (std::vector<double>{5, 6, 5, 6}));
}

TEST(bathymetry_cases, titles_name_columns_and_units) {
  Diagnostics diagnostics;
  const auto bed = read_table(
      "Survey;Water depth [ft];Northing (m);Easting (m)\nA;100,0;0;0\nA;110,0;0;20\nB;100,0;30;0\n", diagnostics);
  ASSERT_TRUE(bed) << testing::all_messages(diagnostics);
  EXPECT_NEAR(bed->depth[1], 110.0 * 0.3048, 1e-9);
  EXPECT_EQ(bed->east[1], 20.0);
  const std::string messages = testing::all_messages(diagnostics);
  expect_part(messages, "depth is converted from ft");
  expect_part(messages, "columns that are not used: Survey");
}

TEST(bathymetry_cases, longitude_and_latitude_need_an_origin_in_degrees) {
  const std::string text = "lat,lon,depth\n58.25,3.125,60\n58.26,3.125,61\n58.25,3.135,62\n40,3,4000\n";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_table(text, diagnostics));
  expect_part(testing::all_messages(diagnostics), "{lat, lon}");
  Diagnostics placed;
  const auto bed = read_table(text, placed, {.origin = geographic(58.25, 3.125)});
  ASSERT_TRUE(bed) << testing::all_messages(placed);
  EXPECT_EQ(bed->depth.size(), 3U);
  EXPECT_NEAR(bed->north[1], 1114.1, 0.5);
  expect_part(testing::all_messages(placed), "left out: 1 point more than 50 km away");
  Diagnostics metres;
  EXPECT_FALSE(read_table("x,y,z\n512340,5934120,60\n512360,5934120,61\n512340,5934140,62\n", metres,
                          {.origin = geographic(58.25, 3.125)}));
  expect_part(testing::all_messages(metres), "bathymetry_origin: {east, north}");
}

TEST(bathymetry_cases, the_north_of_the_model_may_have_an_azimuth_in_the_map) {
  // depth grows towards the east of the map, which is the north of the model
  Diagnostics diagnostics;
  const auto bed =
      read_table("0 0 50\n100 0 60\n0 100 50\n100 100 60\n", diagnostics, {.origin = in_map(0.0, 0.0, 90.0 * kDegree)});
  ASSERT_TRUE(bed) << testing::all_messages(diagnostics);
  const auto shape = grid_shape(*bed);
  EXPECT_NEAR(-bed_point(*shape, -50.0, 25.0).z, 52.5, 1e-6);
}

TEST(bathymetry_cases, a_geotiff_is_recognised_by_its_content) {
  Diagnostics diagnostics;
  const testing::WrittenFile file("bed.dat", std::string("II*\0\x08\0\0\0", 8));
  EXPECT_FALSE(read_bathymetry(file.path(), diagnostics));
  expect_part(testing::all_messages(diagnostics), "gdal_translate");
}

TEST(bathymetry_cases, an_esri_grid_is_recognised_by_its_content) {
  Diagnostics diagnostics;
  const testing::WrittenFile file("bed.txt", testing::case_text("beds/esri-dx-dy-nan.asc"));
  EXPECT_TRUE(read_bathymetry(file.path(), diagnostics)) << testing::all_messages(diagnostics);
}

}  // namespace
}  // namespace overbend
