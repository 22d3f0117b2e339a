// Profile and bathymetry of the seabed in the model file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "model/model.h"
#include "modelfile/model_inputs.h"
#include "modelfile/model_texts.h"
#include "modelfile/yaml_reader.h"

namespace overbend {
namespace {

const std::string kStiffness = "    stiffness: 100 kN/m^2\n";

/// The good model with more keys of its seabed.
std::string with_bed(const std::string& keys) {
  std::string text = testing::kGoodModel;
  const std::size_t at = text.find(kStiffness);
  EXPECT_NE(at, std::string::npos);
  return text.insert(at + kStiffness.size(), keys);
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
  const Vec3 there = shoe + 150.0 * astern_direction(model.mean_pose);
  EXPECT_NEAR(model.seabed.surface.height(shoe.x(), shoe.y()), -89.0, 1e-12);
  EXPECT_NEAR(model.seabed.surface.height(there.x(), there.y()), -91.0, 1e-12);
}

TEST(uneven_seabed, profile_is_refused_with_the_reason) {
  EXPECT_NE(first_error(profile("{x: 0 m, depth: 89 m}")).find("at least two points"), std::string::npos);
  EXPECT_NE(first_error(profile("{x: 5 m, depth: 89 m}, {x: 5 m, depth: 90 m}")).find("more than the x before it"),
            std::string::npos);
  const std::string deeper = first_error(profile("{x: 0 m, depth: 89.2 m}, {x: 90 m, depth: 90 m}"));
  EXPECT_NE(deeper.find("89.2 m"), std::string::npos) << deeper;
  EXPECT_NE(deeper.find("environment.water_depth, 89 m"), std::string::npos) << deeper;
  EXPECT_EQ(first_error(profile("{x: 0 m, depth: 89.09 m}, {x: 90 m, depth: 90 m}")), "");
}

TEST(uneven_seabed, is_told_in_one_way_only) {
  const std::string both =
      first_error(with_bed("    slope: 1 deg\n    profile: [{x: 0 m, depth: 89 m}, {x: 9 m, depth: 89 m}]\n"));
  EXPECT_NE(both.find("profile beside slope"), std::string::npos) << both;
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

TEST_F(bathymetry_file, is_read_beside_the_model_and_kept_for_other_values) {
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

}  // namespace
}  // namespace overbend
