// Files that models mention: listed, and taken from the page.
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::Serving;

TEST(serve_data_files, data_below_the_folder_are_listed_without_results_and_hidden_files) {
  const Serving serving;
  namespace fs = std::filesystem;
  for (const char* place : {"data/ship", "runs/1", ".hidden"}) fs::create_directories(serving.folder / place);
  for (const char* name : {"b.csv", "data/ship/rao.4", "runs/1/pipe.csv", ".hidden/x.csv", "model.yaml", "notes.txt"}) {
    testing::write_file(serving.folder / name, "1");
  }
  EXPECT_EQ(serving.get("/api/data").json["files"], Json({"b.csv", "data/ship/rao.4"}));
}

TEST(serve_data_files, hydrodynamics_of_a_hull_are_listed_and_taken_as_far_as_they_are_text) {
  const Serving serving;
  testing::write_file(serving.folder / "ship.nc", "1");
  for (const char* name : {"ship.1", "ship.3", "ship.8", "ship.hst"}) {
    EXPECT_EQ(serving.post("/api/data", {{"name", name}, {"text", "1 2 3"}}).status, 200) << name;
  }
  EXPECT_EQ(serving.get("/api/data").json["files"], Json({"ship.1", "ship.3", "ship.8", "ship.hst", "ship.nc"}));
  EXPECT_EQ(serving.post("/api/data", {{"name", "other.nc"}, {"text", ""}}).status, 422);  // no text
}

TEST(serve_data_files, a_file_is_taken_once_and_another_of_its_name_is_not) {
  const Serving serving;
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", "a,b\n1,2\n"}}).status, 200);
  EXPECT_EQ(serving.get("/api/data").json["files"], Json({"rao.csv"}));
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", "a,b\n1,2\n"}}).status, 200);
  EXPECT_EQ(serving.post("/api/data", {{"name", "rao.csv"}, {"text", "other"}}).status, 409);
  for (const char* name : {"../rao.csv", "data/rao.csv", ".rao.csv", "rao.exe", ""}) {
    EXPECT_EQ(serving.post("/api/data", {{"name", name}, {"text", ""}}).status, 422) << name;
  }
}

}  // namespace
}  // namespace overbend
