// A hull of the library, scaled to a vessel.
#include "seafiles/rao_reader.h"
#include "serve/serving.h"

namespace overbend {
namespace {

using testing::kSmallLay;
using testing::Reply;
using testing::Serving;

TEST(serve_library_hull, a_scaled_hull_is_a_file_that_a_model_can_use_and_that_says_what_it_is) {
  const Serving serving(kSmallLay);
  const Reply reply = serving.post("/api/hull", {{"length", 100.0}, {"beam", 24.0}});
  ASSERT_EQ(reply.status, 200) << reply.body;
  EXPECT_EQ(reply.json["name"], "box-hull-100x24m.csv");
  Diagnostics errors;
  const auto raos = read_raos((serving.folder / "box-hull-100x24m.csv").string(), {}, 20.0, errors);
  ASSERT_TRUE(raos) << errors.lines(Severity::error).size();
  ASSERT_EQ(raos->assumptions.size(), 1U);
  EXPECT_EQ(raos->assumptions[0].text, reply.json["assumption"]);
  EXPECT_EQ(serving.post("/api/hull", {{"length", 100.0}, {"beam", 24.0}}).status, 200);  // the same file again

  const Json model = serving.get("/api/model").json;
  const Reply set = serving.post(
      "/api/model/set", {{"revision", model["revision"]},
                         {"changes", {{{"path", "vessel.motion"}, {"value", {{"raos", reply.json["name"]}}}}}}});
  ASSERT_EQ(set.status, 200) << set.body;
  for (const Json& diagnostic : set.json["diagnostics"]) EXPECT_NE(diagnostic["severity"], "error") << diagnostic;
}

TEST(serve_library_hull, dimensions_of_no_vessel_are_rejected) {
  const Serving serving;
  for (const Json& size : {Json{{"length", 100.0}}, Json{{"length", 5.0}, {"beam", 24.0}},
                           Json{{"length", "100 m"}, {"beam", 24.0}}, Json{{"length", 100.0}, {"beam", 900.0}}}) {
    EXPECT_EQ(serving.post("/api/hull", size).status, 422) << size;
  }
}

}  // namespace
}  // namespace overbend
