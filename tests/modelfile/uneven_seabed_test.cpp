// Profile and bathymetry of the seabed in the model file.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "model/model.h"
#include "modelfile/binding/model_inputs.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

const std::string kStiffness = "    stiffness: 100 kN/m^2\n";

/// The good model with more keys of its seabed.
std::string with_bed(const std::string& keys) {
  std::string text = testing::kGoodModel;
  const std::size_t index = text.find(kStiffness);
  EXPECT_NE(index, std::string::npos);
  return text.insert(index + kStiffness.size(), keys);
}

std::string profile(const std::string& points) {
  return with_bed("    profile: [" + points + "]\n");
}

std::string first_error(const std::string& text, const std::filesystem::path& folder = "/nowhere") {
  const std::vector<std::string> lines =
      read_model_text(text, (folder / "model.yaml").string()).diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

class bathymetry_file : public ::testing::Test {
 protected:
  bathymetry_file() {
    folder_ = std::filesystem::temp_directory_path() /
              ("overbend_bathymetry_" + std::string(::testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::create_directories(folder_);
  }
  ~bathymetry_file() override { std::filesystem::remove_all(folder_); }
  void put(const std::string& name, const std::string& text) const { std::ofstream(folder_ / name) << text; }

  std::filesystem::path folder_;
};

TEST(uneven_seabed, profile_fills_the_model_along_its_axis_astern) {
  const ModelReading reading =
      read_model_text(profile("{x: 0 m, depth: 89 m}, {x: 100 m, depth: 91 m}, {x: 200 m, depth: 91 m}"), "model.yaml");
  ASSERT_TRUE(reading.description.has_value()) << reading.diagnostics.lines(Severity::error).front();
  const Model model = build_model(*reading.description);
  const Vec3 shoe = point_from_ramp(model, model.mean_pose, Vec3::Zero());
  const Vec3 vec3 = shoe + 150.0 * astern_direction(model.mean_pose);
  EXPECT_NEAR(model.seabed.surface.height(shoe.x(), shoe.y()), -89.0, 1e-12);
  EXPECT_NEAR(model.seabed.surface.height(vec3.x(), vec3.y()), -91.0, 1e-12);
}

TEST(uneven_seabed, profile_is_rejected_with_the_reason) {
  EXPECT_NE(first_error(profile("{x: 0 m, depth: 89 m}")).find("at least two points"), std::string::npos);
  EXPECT_NE(first_error(profile("{x: 5 m, depth: 89 m}, {x: 5 m, depth: 90 m}")).find("more than the x before it"),
            std::string::npos);
  const std::string deeper = first_error(profile("{x: 0 m, depth: 89.2 m}, {x: 90 m, depth: 90 m}"));
  EXPECT_NE(deeper.find("89.2 m"), std::string::npos) << deeper;
  EXPECT_NE(deeper.find("environment.water_depth, 89 m"), std::string::npos) << deeper;
  EXPECT_EQ(first_error(profile("{x: 0 m, depth: 89.09 m}, {x: 90 m, depth: 90 m}")), "");
}

TEST(uneven_seabed, is_prescribed_in_one_way_only) {
  const std::string both =
      first_error(with_bed("    slope: 1 deg\n    profile: [{x: 0 m, depth: 89 m}, {x: 9 m, depth: 89 m}]\n"));
  EXPECT_NE(both.find("profile and slope"), std::string::npos) << both;
}

TEST(uneven_seabed, soil_that_softens_says_at_which_force) {
  const ModelReading reading =
      read_model_text(with_bed("    soil: {model: hyperbolic, bearing_force: 4 kN/m}\n"), "model.yaml");
  ASSERT_TRUE(reading.description.has_value());
  EXPECT_EQ(reading.description->environment.seabed.soil, SoilModel::hyperbolic);
  EXPECT_EQ(reading.description->environment.seabed.bearing_force, 4e3);
  EXPECT_NE(first_error(with_bed("    soil: {model: bilinear}\n")).find("soil.bearing_force"), std::string::npos);
  EXPECT_NE(first_error(with_bed("    soil: {bearing_force: 4 kN/m}\n")).find("linear soil"), std::string::npos);
}

TEST_F(bathymetry_file, is_read_next_to_the_model_and_kept_for_other_values) {
  put("bed.csv", "east,north,depth\n-300,-300,89\n300,-300,89\n-300,300,89\n300,300,89\n");
  const ModelReading reading =
      read_model_text(with_bed("    bathymetry: bed.csv\n"), (folder_ / "model.yaml").string());
  ASSERT_TRUE(reading.description.has_value()) << reading.diagnostics.lines(Severity::error).front();
  const auto& depths = reading.description->environment.seabed.bathymetry;
  ASSERT_TRUE(depths.has_value());
  EXPECT_EQ(depths->columns, 2);
  ModelValues values(*reading.description);
  const auto input = values.find("tensioner.tension");
  ASSERT_TRUE(input.has_value());
  EXPECT_TRUE(values.with(values.inputs()[*input], 3e5).environment.seabed.bathymetry.has_value());
}

TEST_F(bathymetry_file, has_to_be_there_and_agree_with_the_water_depth) {
  const std::string text = with_bed("    bathymetry: bed.csv\n");
  EXPECT_NE(first_error(text, folder_).find("does not exist"), std::string::npos);
  put("bed.csv", "east,north,depth\n-300,-300,80\n300,-300,80\n-300,300,80\n300,300,80\n");
  const std::string shallow = first_error(text, folder_);
  EXPECT_NE(shallow.find("a depth of 80 m at the stern shoe"), std::string::npos) << shallow;
}

/// An ASCII grid of 40 by 40 cells of 50 m around a place, of one depth but for the westernmost column.
std::string grid_around(double east, double north, const std::string& depth, const std::string& west) {
  std::string text = "ncols 40\nnrows 40\nxllcorner " + std::to_string(east - 1000.0) + "\nyllcorner " +
                     std::to_string(north - 1000.0) + "\ncellsize 50\n";
  for (int row = 0; row < 40; ++row) {
    text += west;
    for (int column = 1; column < 40; ++column) text += " " + depth;
    text += "\n";
  }
  return text;
}

TEST_F(bathymetry_file, far_from_the_lay_is_rejected_with_the_distance) {
  put("grid.asc", grid_around(431250.0, 6182100.0, "89", "89"));
  const std::string error = first_error(with_bed("    bathymetry: grid.asc\n"), folder_);
  EXPECT_NE(error.find("an area 6196 km from the stern shoe"), std::string::npos) << error;
  EXPECT_NE(error.find("bathymetry_midship"), std::string::npos) << error;
}

TEST_F(bathymetry_file, in_map_coordinates_is_placed_by_those_of_midship) {
  put("grid.asc", grid_around(431250.0, 6182100.0, "89", "89"));
  const std::string keys = "    bathymetry: grid.asc\n    bathymetry_midship: {east: 431250 m, north: 6182100 m}\n";
  const ModelReading reading = read_model_text(with_bed(keys), (folder_ / "model.yaml").string());
  ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error)[0];
  const Bathymetry& depths = *reading.description->environment.seabed.bathymetry;
  EXPECT_NEAR(depths.east.front(), -975.0, 1e-6);
  EXPECT_NEAR(depths.north.back(), 975.0, 1e-6);
}

TEST_F(bathymetry_file, in_a_map_may_be_turned_and_hold_heights) {
  // the model's north points to the map's east: the rows of the grid, from west to east, are at increasing y
  put("grid.asc", grid_around(431250.0, 6182100.0, "-89", "-95"));
  const std::string keys =
      "    bathymetry: grid.asc\n    bathymetry_origin: {east: 431250 m, north: 6182100 m, azimuth: 90 deg}\n"
      "    bathymetry_values: elevation\n";
  const ModelReading reading = read_model_text(with_bed(keys), (folder_ / "model.yaml").string());
  ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error)[0];
  const Bathymetry& depths = *reading.description->environment.seabed.bathymetry;
  for (std::size_t i = 0; i < depths.depth.size(); ++i) {
    EXPECT_EQ(depths.depth[i], depths.north[i] < -950.0 ? 95.0 : 89.0) << depths.north[i];
  }
  EXPECT_TRUE(has_code(reading.description->findings, FindingCode::input_converted));
}

TEST_F(bathymetry_file, needs_a_complete_origin_in_one_kind_of_coordinates) {
  put("bed.csv", "east,north,depth\n-300,-300,89\n300,-300,89\n-300,300,89\n300,300,89\n");
  const auto error = [&](const std::string& keys) {
    return first_error(with_bed("    bathymetry: bed.csv\n" + keys), folder_);
  };
  EXPECT_EQ(error("    bathymetry_origin: {azimuth: 10 deg}\n"), "");
  EXPECT_NE(error("    bathymetry_origin: {east: 1 m}\n").find("east and north, or lat and lon"), std::string::npos);
  EXPECT_NE(
      error("    bathymetry_origin: {east: 1 m, north: 1 m, lat: 1 deg, lon: 1 deg}\n").find("east and north, or"),
      std::string::npos);
  EXPECT_NE(error("    bathymetry_origin: {east: 1 m, north: 1 m}\n    bathymetry_midship: {east: 1 m, north: 1 m}\n")
                .find("one of them"),
            std::string::npos);
}

TEST_F(bathymetry_file, of_a_coast_serves_where_the_lay_is_in_the_water) {
  put("grid.asc", grid_around(0.0, 0.0, "89", "0"));
  put("land.asc", grid_around(0.0, 0.0, "-89", "12"));
  for (const char* file : {"grid.asc", "land.asc"}) {
    const std::string keys = std::string("    bathymetry: ") + file + "\n";
    const ModelReading reading = read_model_text(with_bed(keys), (folder_ / "model.yaml").string());
    ASSERT_TRUE(reading.description) << reading.diagnostics.lines(Severity::error)[0];
    EXPECT_NEAR(reading.description->environment.seabed.bathymetry->depth.back(), 89.0, 1e-12) << file;
  }
}

TEST(uneven_seabed, a_slope_that_leaves_the_water_where_pipe_is_laid_is_warned_of) {
  const auto warned = [](const std::string& keys) {
    const std::vector<std::string> lines =
        read_model_text(with_bed(keys), "model.yaml").diagnostics.lines(Severity::warning);
    return std::any_of(lines.begin(), lines.end(), [](const std::string& line) {
      return line.find("the seabed emerges 332.2 m astern") != std::string::npos;
    });
  };
  // 89 m / tan 15 deg; the bow points to 90 deg, so that the pipe is laid towards 270 deg.
  EXPECT_TRUE(warned("    slope: 15 deg\n    slope_towards: 90 deg\n"));
  EXPECT_FALSE(warned("    slope: 15 deg\n    slope_towards: 270 deg\n"));
  EXPECT_FALSE(warned("    slope: 2 deg\n    slope_towards: 90 deg\n"));
}

}  // namespace
}  // namespace overbend
