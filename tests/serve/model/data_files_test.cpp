// Files that models mention: listed, and taken from the page.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::Serving;

TEST(serve_data_files, sources_of_motion_below_the_folder_are_listed_by_content) {
  const Serving serving;
  namespace fs = std::filesystem;
  for (const char* place : {"data/ship", "runs/1", ".hidden"}) fs::create_directories(serving.folder / place);
  for (const char* name : {"motion.txt", "runs/1/motion.csv", ".hidden/motion.csv"}) {
    testing::write_file(serving.folder / name, "Time (s);Heave (m)\n0,0;0,1\n0,5;0,2\n");
  }
  testing::write_file(serving.folder / "data/ship/rao.4", "8 0 1 1 0 1 0\n");
  for (const char* name : {"spectrum.csv", "model.yaml", "notes.txt"}) {
    testing::write_file(serving.folder / name, "omega_rad_s,density_m2s\n0.5,1\n");
  }
  EXPECT_EQ(serving.get("/api/data").json["files"], Json::parse(R"([
      {"name": "data/ship/rao.4", "kinds": ["raos"]}, {"name": "motion.txt", "kinds": ["history"]}])"));
}

TEST(serve_data_files, a_hull_is_listed_once_whatever_the_number_of_its_files) {
  const Serving serving;
  for (const char* name : {"ship.1", "ship.3", "ship.8", "ship.hst"}) {
    EXPECT_EQ(serving.post("/api/data", {{"name", name}, {"text", "1 2 3"}}).status, 200) << name;
  }
  EXPECT_EQ(serving.get("/api/data").json["files"], Json::parse(R"([{"name": "ship.hst", "kinds": ["coupled"]}])"));
}

TEST(serve_data_files, bytes_are_taken_as_they_are) {
  const Serving serving;
  EXPECT_EQ(serving.post("/api/data", {{"name", "ship.nc"}, {"base64", "Q0RGAQD/"}}).status, 200);
  EXPECT_EQ(testing::file_text((serving.folder / "ship.nc").string()), std::string("CDF\1\0\xff", 6));
  EXPECT_EQ(serving.post("/api/data", {{"name", "other.nc"}, {"base64", "Q0RGAQD"}}).status, 422);
  EXPECT_EQ(serving.post("/api/data", {{"name", "other.nc"}, {"base64", "Q0R!"}}).status, 422);
}

TEST(serve_data_files, a_file_is_taken_once_and_another_of_its_name_is_not) {
  const std::string kMotion = "time_s,heave_m\n0,1\n";
  const Serving serving;
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", kMotion}}).status, 200);
  EXPECT_EQ(serving.get("/api/data").json["files"], Json::parse(R"([{"name": "rao.csv", "kinds": ["history"]}])"));
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", kMotion}}).status, 200);
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", "other"}}).status, 409);
  for (const char* name : {"../rao.csv", "data/rao.csv", ".rao.csv", "rao.exe", ""}) {
    EXPECT_EQ(serving.post("/api/data", {{"name", name}, {"text", ""}}).status, 422) << name;
  }
}

}  // namespace
}  // namespace overbend
