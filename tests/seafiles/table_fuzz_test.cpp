// Damaged tables: each is read or rejected with a message, and what is read is finite.
#include <gtest/gtest.h>

#include <cmath>

#include "base/constants.h"
#include "seafiles/bathymetry_reader.h"
#include "seafiles/motion_history_reader.h"
#include "seafiles/route_depths_reader.h"
#include "seafiles/scatter_reader.h"
#include "support/rao_files.h"
#include "support/table_cases.h"

namespace overbend {
namespace {

void expect_answer(bool read, const Diagnostics& diagnostics, const std::string& text) {
  EXPECT_NE(read, diagnostics.has_errors()) << text << testing::all_messages(diagnostics);
}

void expect_finite(const std::vector<double>& values, const std::string& text) {
  for (const double value : values) ASSERT_TRUE(std::isfinite(value)) << text;
}

TEST(table_fuzz, soundings_and_grids) {
  for (const char* name : {"lattice-blank.xyz", "map-comma.csv", "soundings-tab.txt", "esri-dx-dy-nan.asc"}) {
    testing::with_damage(
        testing::case_text(std::string("beds/") + name), testing::damage_trials(), [](const std::string& text) {
          for (const bool grid : {true, false}) {
            Diagnostics diagnostics;
            const auto bed =
                grid ? read_ascii_grid(text, "bed", diagnostics) : read_depth_table(text, "bed", diagnostics);
            expect_answer(bed.has_value(), diagnostics, text);
            if (!bed) continue;
            EXPECT_EQ(bed->east.size(), bed->depth.size());
            expect_finite(bed->depth, text);
            expect_finite(bed->east, text);
          }
        });
  }
}

TEST(table_fuzz, netcdf_grids) {
  MapOrigin origin;
  origin.lat = 58.25 * kDegree;
  origin.lon = 3.125 * kDegree;
  testing::with_damage(testing::case_text("beds/gebco-like.nc"), testing::damage_trials(),
                       [&](const std::string& text) {
                         const testing::WrittenFile file("bed.nc", text.starts_with("CDF") ? text : "CDF" + text);
                         Diagnostics diagnostics;
                         const auto bed = read_bathymetry(file.path(), diagnostics, {.origin = origin});
                         expect_answer(bed.has_value(), diagnostics, "netCDF");
                         if (bed) expect_finite(bed->depth, "netCDF");
                       });
}

TEST(table_fuzz, records) {
  const MotionColumns columns = {{"Zeit", "time"}, {"Tauchen", "heave"}, {"Rollen", "roll"}, {"Stampfen", "pitch"}};
  for (const char* name :
       {"clock-midnight.csv", "iso-times.csv", "milliseconds.tsv", "quoted.csv", "semicolon-decimal-comma.csv"}) {
    testing::with_damage(
        testing::case_text(std::string("records/") + name), testing::damage_trials(), [&](const std::string& text) {
          const testing::WrittenFile file("motion.csv", text);
          Diagnostics diagnostics;
          const bool keyed = std::string_view(name).starts_with("semicolon");
          const auto history = read_motion_history(file.path(), 0.0, diagnostics, keyed ? columns : MotionColumns{});
          expect_answer(history.has_value(), diagnostics, text);
          if (!history) return;
          EXPECT_GE(history->time.size(), 2U);
          expect_finite(history->time, text);
          for (std::size_t i = 1; i < history->time.size(); ++i)
            ASSERT_GT(history->time[i], history->time[i - 1]) << text;
          for (const auto& row : history->freedoms) expect_finite({row.begin(), row.end()}, text);
        });
  }
}

TEST(table_fuzz, scatter_diagrams) {
  WavesDescription waves;
  waves.type = WaveType::jonswap;
  for (const char* name : {"scatter-tz-counts.csv", "scatter-tp-percent.csv", "scatter-tz-share.tsv"}) {
    testing::with_damage(testing::case_text(std::string("scatter/") + name), testing::damage_trials(),
                         [&](const std::string& text) {
                           Diagnostics diagnostics;
                           const auto diagram = read_scatter_text(text, "seas", diagnostics, {{}, &waves});
                           expect_answer(diagram.has_value(), diagnostics, text);
                           if (!diagram) return;
                           for (const ScatterDiagram::Sea& sea : diagram->seas) {
                             expect_finite({sea.hs, sea.tp, sea.hs_width, sea.fraction[0]}, text);
                             ASSERT_GT(sea.hs_width, 0.0) << text;
                           }
                         });
  }
}

TEST(table_fuzz, route_depths) {
  const std::string good = "KP (km);Depth (m);Note\n0,0;60,5;a\n1,0;61,5;b\n2,0;62,0;\n3,5;70,0;c\n";
  testing::with_damage(good, testing::damage_trials(), [](const std::string& text) {
    Diagnostics diagnostics;
    const auto points = read_route_depths_text(text, "route", diagnostics);
    expect_answer(!points.empty(), diagnostics, text);
    for (const RouteDepth& point : points) expect_finite({point.distance, point.depth}, text);
  });
}

}  // namespace
}  // namespace overbend
