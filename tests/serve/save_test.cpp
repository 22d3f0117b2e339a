// Saving never overwrites changes by another program.
#include <sys/stat.h>

#include "serve/serving.h"

namespace overbend {
namespace {

using testing::file_text;
using testing::kSmallLay;
using testing::Reply;
using testing::Serving;
using testing::write_file;

const std::string kMine = kSmallLay + "# mine\n", kTheirs = kSmallLay + "# an editor's\n";

Json saving(const std::string& text, int revision = 1) {
  return {{"name", "model.yaml"}, {"text", text}, {"revision", revision}};
}

TEST(serve_save, an_editors_change_is_409_with_its_text) {
  const Serving serving(kSmallLay);
  write_file(serving.folder / "model.yaml", kTheirs);
  const Reply reply = serving.post("/api/model/save", saving(kMine));
  EXPECT_EQ(reply.status, 409);
  EXPECT_EQ(reply.json["error"]["reason"], "disk");
  EXPECT_EQ(reply.json["disk"]["text"], kTheirs);
  EXPECT_EQ(file_text(serving.folder / "model.yaml"), kTheirs);
  // Nothing is lost on the other side either: the page's text is the open model.
  const Json model = serving.get("/api/model").json;
  EXPECT_EQ(model["text"], kMine);
  EXPECT_EQ(model["saved"], false);
  EXPECT_EQ(model["revision"], reply.json["revision"]);
}

TEST(serve_save, the_version_of_the_answer_or_force_overwrite) {
  const Serving serving(kSmallLay);
  write_file(serving.folder / "model.yaml", kTheirs);
  const Json found = serving.post("/api/model/save", saving(kMine)).json["disk"];
  Json again = {{"name", "model.yaml"}, {"disk", found["version"]}};
  write_file(serving.folder / "model.yaml", kTheirs + "# and once more\n");
  EXPECT_EQ(serving.post("/api/model/save", again).status, 409);
  write_file(serving.folder / "model.yaml", kTheirs);
  const Reply saved = serving.post("/api/model/save", again);
  EXPECT_EQ(saved.status, 200) << saved.body;
  EXPECT_EQ(saved.json["saved"], true);
  EXPECT_EQ(file_text(serving.folder / "model.yaml"), kMine);

  write_file(serving.folder / "model.yaml", kTheirs);
  EXPECT_EQ(serving.post("/api/model/save", {{"name", "model.yaml"}, {"force", true}}).status, 200);
  EXPECT_EQ(file_text(serving.folder / "model.yaml"), kMine);
}

TEST(serve_save, the_file_is_seen_to_change) {
  const Serving serving(kSmallLay);
  const Json known = serving.get("/api/model").json["disk"];
  EXPECT_EQ(serving.get("/api/model/disk").json["version"], known);
  write_file(serving.folder / "model.yaml", kTheirs);
  const Json changed = serving.get("/api/model/disk").json["version"];
  EXPECT_TRUE(changed.is_string());
  EXPECT_NE(changed, known);
  EXPECT_EQ(serving.get("/api/model").json["disk"], known);
  std::filesystem::remove(serving.folder / "model.yaml");
  EXPECT_EQ(serving.get("/api/model/disk").json["version"], nullptr);
}

TEST(serve_save, the_version_goes_with_the_model) {
  const Serving serving(kSmallLay);
  const Json first = serving.get("/api/model").json["disk"];
  EXPECT_TRUE(first.is_string());
  EXPECT_EQ(serving.put("/api/model", {{"text", kMine}, {"revision", 1}}).json["disk"], first);
  const Json saved = serving.post("/api/model/save", {{"name", "model.yaml"}, {"disk", first}}).json["disk"];
  EXPECT_TRUE(saved.is_string());
  EXPECT_NE(saved, first);
  EXPECT_EQ(serving.put("/api/model", {{"text", kMine}, {"revision", 3}, {"name", ""}}).json["disk"], nullptr);
}

TEST(serve_save, a_file_that_appeared_under_the_name_is_409) {
  const Serving serving(kSmallLay);
  write_file(serving.folder / "other.yaml", kTheirs);
  EXPECT_EQ(serving.post("/api/model/save", {{"name", "other.yaml"}}).status, 409);
  EXPECT_EQ(serving.post("/api/model/save", {{"name", "other.yaml"}, {"disk", nullptr}}).status, 409);
  EXPECT_EQ(file_text(serving.folder / "other.yaml"), kTheirs);
}

TEST(serve_save, a_file_that_has_gone_or_holds_the_same_contradicts_nothing) {
  const Serving serving(kSmallLay);
  std::filesystem::remove(serving.folder / "model.yaml");
  EXPECT_EQ(serving.post("/api/model/save", saving(kMine)).status, 200);
  EXPECT_EQ(file_text(serving.folder / "model.yaml"), kMine);
  write_file(serving.folder / "model.yaml", kTheirs);
  EXPECT_EQ(serving.post("/api/model/save", saving(kTheirs, 3)).status, 200);
}

TEST(serve_save, mode_and_link_stay) {
  const Serving serving(kSmallLay);
  std::filesystem::rename(serving.folder / "model.yaml", serving.folder / "kept.txt");
  std::filesystem::create_symlink("kept.txt", serving.folder / "model.yaml");
  ASSERT_EQ(::chmod((serving.folder / "kept.txt").c_str(), 0600), 0);
  EXPECT_EQ(serving.post("/api/model/save", saving(kMine)).status, 200);
  EXPECT_TRUE(std::filesystem::is_symlink(serving.folder / "model.yaml"));
  EXPECT_EQ(file_text(serving.folder / "kept.txt"), kMine);
  struct stat stat {};
  ASSERT_EQ(::stat((serving.folder / "kept.txt").c_str(), &stat), 0);
  EXPECT_EQ(stat.st_mode & 0777, 0600U);
}

TEST(serve_save, a_link_laid_next_to_the_file_is_not_followed) {
  const Serving serving(kSmallLay);
  write_file(serving.folder / "victim", "untouched");
  std::filesystem::create_symlink("victim", serving.folder / "model.yaml.part");
  EXPECT_EQ(serving.post("/api/model/save", saving(kMine)).status, 200);
  EXPECT_EQ(file_text(serving.folder / "victim"), "untouched");
}

TEST(serve_save, a_name_that_is_no_plain_file_is_422_with_the_reason) {
  const Serving serving(kSmallLay);
  std::filesystem::create_directory(serving.folder / "folder.yaml");
  ASSERT_EQ(::mkfifo((serving.folder / "pipe.yaml").c_str(), 0600), 0);
  std::filesystem::create_symlink("nowhere", serving.folder / "dangling.yaml");
  for (const char* name : {"folder.yaml", "pipe.yaml", "dangling.yaml"}) {
    const Reply reply = serving.post("/api/model/save", {{"name", name}, {"force", true}});
    EXPECT_EQ(reply.status, 422) << name << reply.body;
    EXPECT_NE(reply.json["error"]["message"].get<std::string>().find(name), std::string::npos) << reply.body;
    EXPECT_EQ(serving.post("/api/model/open", {{"name", name}}).status, 404) << name;
  }
}

}  // namespace
}  // namespace overbend
