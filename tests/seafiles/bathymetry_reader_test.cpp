#include "seafiles/bathymetry_reader.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

std::string table_error(const std::string& text) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_depth_table(text, "bed.csv", diagnostics).has_value());
  const std::vector<std::string> lines = diagnostics.lines(Severity::error);
  return lines.empty() ? "" : lines.front();
}

const std::string kHead = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner -50\ncellsize 10\nNODATA_value -9999\n";

TEST(bathymetry_reader, orders_a_regular_grid_however_its_rows_stand) {
  Diagnostics diagnostics;
  const auto depths = read_depth_table("East,North_m,depth\n10,0,51\n0,5,52\n0,0,50\n10,5,53\n20,5,55\n20,0,54\n",
                                       "bed.csv", diagnostics);
  ASSERT_TRUE(depths.has_value());
  EXPECT_EQ(depths->columns, 3);
  EXPECT_EQ(depths->rows, 2);
  EXPECT_EQ(depths->depth, (std::vector<double>{50, 51, 54, 52, 53, 55}));
  EXPECT_EQ(depths->east, (std::vector<double>{0, 10, 20, 0, 10, 20}));
}

TEST(bathymetry_reader, takes_points_with_a_gap_for_scattered) {
  Diagnostics diagnostics;
  const auto depths =
      read_depth_table("east,north,depth\n0,0,50\n10,0,51\n0,5,52\n10,5,53\n20,0,54\n", "bed.csv", diagnostics);
  ASSERT_TRUE(depths.has_value());
  EXPECT_EQ(depths->columns, 0);
  EXPECT_EQ(depths->depth.size(), 5U);
}

TEST(bathymetry_reader, says_line_and_reason_of_an_error) {
  EXPECT_NE(table_error("a,b,c\n0,0,5\n").find("'east,north,depth'"), std::string::npos);
  EXPECT_NE(table_error("east,north,depth\n0,0,5\n0,1,deep\n").find("bed.csv:3"), std::string::npos);
  EXPECT_NE(table_error("east,north,depth\n0,0,-5\n0,9,-5\n30,0,-4\n").find("no depth above 0"), std::string::npos);
  EXPECT_NE(table_error("east,north,depth\n0,0,5\n0,1,5\n").find("at least three"), std::string::npos);
  EXPECT_NE(table_error("east,north,depth\n0,0,5\n0,1,5\n0,2,5\n").find("points on one line"), std::string::npos);
}

TEST(bathymetry_reader, takes_an_ascii_grid_from_its_north_west_corner) {
  Diagnostics diagnostics;
  const auto depths = read_ascii_grid(kHead + "1 2 3\n4 5 6\n", "bed.asc", diagnostics);
  ASSERT_TRUE(depths.has_value());
  EXPECT_EQ(depths->columns, 3);
  EXPECT_EQ(depths->depth, (std::vector<double>{4, 5, 6, 1, 2, 3}));
  EXPECT_EQ(depths->east.front(), 105.0);  // cells' middles
  EXPECT_EQ(depths->north.front(), -45.0);
}

TEST(bathymetry_reader, turns_heights_into_depths_and_leaves_out_cells_without_data) {
  Diagnostics diagnostics;
  const auto depths = read_ascii_grid(kHead + "-1 -2 -9999\n-4 -5 -6\n", "bed.asc", diagnostics);
  ASSERT_TRUE(depths.has_value());
  EXPECT_EQ(depths->columns, 0);
  EXPECT_EQ(depths->depth, (std::vector<double>{4, 5, 6, 1, 2}));
}

TEST(bathymetry_reader, knows_cells_without_data_however_the_head_spells_them) {
  const std::string head = "ncols 3\nnrows 2\nxllcorner 100\nyllcorner -50\ncellsize 10\n";
  Diagnostics diagnostics;
  const auto of_gdal = read_ascii_grid(head + "NODATA_value -3.4028234663852886e+38\n-1 -2 -3.4028235e+38\n-4 -5 -6\n",
                                       "bed.asc", diagnostics);
  const auto of_none = read_ascii_grid(head + "-1 -2 -9999\n-4 -5 -6\n", "bed.asc", diagnostics);
  ASSERT_TRUE(of_gdal && of_none);
  EXPECT_EQ(of_gdal->depth, (std::vector<double>{4, 5, 6, 1, 2}));
  EXPECT_EQ(of_none->depth, of_gdal->depth);
}

TEST(bathymetry_reader, rejects_depths_that_no_sea_has) {
  EXPECT_NE(table_error("east,north,depth\n0,0,50\n0,1,99999\n1,0,50\n").find("at most 12000"), std::string::npos);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_ascii_grid(kHead + "1 2 3\n4 5 99999\n", "bed.asc", diagnostics).has_value());
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(bathymetry_reader, a_grid_may_reach_the_shore_and_the_land_behind_it) {
  Diagnostics diagnostics;
  const auto shore = read_ascii_grid(kHead + "0 2 3\n0 5 6\n", "bed.asc", diagnostics);
  const auto land = read_ascii_grid(kHead + "8 -2 -3\n0 -5 -6\n", "bed.asc", diagnostics);
  const auto table =
      read_depth_table("east,north,depth\n0,0,-3\n20,0,0\n40,0,5\n0,9,-2\n20,9,1\n40,9,6\n", "bed.csv", diagnostics);
  ASSERT_TRUE(shore && land && table) << diagnostics.lines(Severity::error)[0];
  EXPECT_EQ(shore->depth, (std::vector<double>{0, 5, 6, 0, 2, 3}));
  EXPECT_EQ(shore->columns, 3);
  EXPECT_EQ(land->depth, (std::vector<double>{0, 5, 6, -8, 2, 3}));
  EXPECT_EQ(table->depth, (std::vector<double>{-3, 0, 5, -2, 1, 6}));
  EXPECT_EQ(table->columns, 3);
}

TEST(bathymetry_reader, values_that_stand_for_none_are_no_land) {
  for (const char* value : {"-999", "-9999", "-32768", "9999"}) {
    const std::string table = std::string("east,north,depth\n0,0,50\n0,20,") + value + "\n20,0,50\n";
    EXPECT_NE(table_error(table).find("places without data"), std::string::npos) << value;
  }
}

TEST(bathymetry_reader, an_area_of_millimetres_is_rejected) {
  const std::string degrees = table_error("east,north,depth\n5.001,60.002,50\n5.005,60.002,51\n5.001,60.006,52\n");
  EXPECT_NE(degrees.find("an area of 0.004 m by 0.004 m"), std::string::npos) << degrees;
  EXPECT_NE(degrees.find("longitude and latitude in degrees?"), std::string::npos) << degrees;
  std::string wide = "ncols 4000\nnrows 2\nxllcorner 5\nyllcorner 60\ncellsize 0.00417\n";
  for (int i = 0; i < 8000; ++i) wide += "-80 ";
  Diagnostics diagnostics;
  EXPECT_FALSE(read_ascii_grid(wide, "bed.asc", diagnostics));
  EXPECT_NE(diagnostics.lines(Severity::error)[0].find("in cells of 4.17 mm"), std::string::npos);
}

TEST(bathymetry_reader, rejects_grids_that_are_not_whole) {
  const auto rejected = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_ascii_grid(text, "bed.asc", diagnostics).has_value()) << text;
    return diagnostics.has_errors();
  };
  EXPECT_TRUE(rejected(kHead + "1 2 3\n4 5\n"));
  EXPECT_TRUE(rejected("ncols 3\n1 2 3\n"));
  EXPECT_TRUE(rejected(""));
}

TEST(bathymetry_reader, says_how_to_convert_a_geotiff) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_bathymetry("survey.TIF", diagnostics).has_value());
  EXPECT_NE(diagnostics.lines(Severity::error).front().find("gdal_translate"), std::string::npos);
}

}  // namespace
}  // namespace overbend
