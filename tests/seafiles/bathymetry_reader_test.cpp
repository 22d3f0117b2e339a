#include "seafiles/bathymetry_reader.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

std::string fault_of_table(const std::string& text) {
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

TEST(bathymetry_reader, says_line_and_reason_of_a_fault) {
  EXPECT_NE(fault_of_table("x,y,z\n0,0,5\n").find("'east,north,depth'"), std::string::npos);
  EXPECT_NE(fault_of_table("east,north,depth\n0,0,5\n0,1,deep\n").find("bed.csv:3"), std::string::npos);
  EXPECT_NE(fault_of_table("east,north,depth\n0,0,5\n0,1,-5\n").find("more than 0"), std::string::npos);
  EXPECT_NE(fault_of_table("east,north,depth\n0,0,5\n0,1,5\n").find("at least three"), std::string::npos);
  EXPECT_NE(fault_of_table("east,north,depth\n0,0,5\n0,1,5\n0,2,5\n").find("points on one line"), std::string::npos);
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

TEST(bathymetry_reader, refuses_depths_that_no_sea_has) {
  EXPECT_NE(fault_of_table("east,north,depth\n0,0,50\n0,1,99999\n1,0,50\n").find("at most 12000"), std::string::npos);
  Diagnostics diagnostics;
  EXPECT_FALSE(read_ascii_grid(kHead + "1 2 3\n4 5 99999\n", "bed.asc", diagnostics).has_value());
  EXPECT_TRUE(diagnostics.has_errors());
}

TEST(bathymetry_reader, refuses_grids_that_are_not_whole_or_of_both_signs) {
  const auto refused = [](const std::string& text) {
    Diagnostics diagnostics;
    EXPECT_FALSE(read_ascii_grid(text, "bed.asc", diagnostics).has_value()) << text;
    return diagnostics.has_errors();
  };
  EXPECT_TRUE(refused(kHead + "1 2 3\n4 5\n"));
  EXPECT_TRUE(refused(kHead + "1 2 3\n4 5 -6\n"));
  EXPECT_TRUE(refused("ncols 3\n1 2 3\n"));
  EXPECT_TRUE(refused(""));
}

TEST(bathymetry_reader, says_how_to_convert_a_geotiff) {
  Diagnostics diagnostics;
  EXPECT_FALSE(read_bathymetry("survey.TIF", diagnostics).has_value());
  EXPECT_NE(diagnostics.lines(Severity::error).front().find("gdal_translate"), std::string::npos);
}

}  // namespace
}  // namespace overbend
