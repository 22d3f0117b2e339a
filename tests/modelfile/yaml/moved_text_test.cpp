#include "modelfile/yaml/moved_text.h"

#include <gtest/gtest.h>

namespace overbend {
namespace {

const char* const kModel =
    "overbend: 1   # kept\n"
    "environment:\n"
    "  seabed: {bathymetry: data/bed.csv}\n"
    "  waves: {type: user, spectrum_file: /srv/sea/storm.csv}\n";

TEST(moved_text, files_next_to_the_model_are_named_from_the_other_folder) {
  const std::string text = moved_text(kModel, "/srv/lay/model.yaml", "/srv/results/one");
  EXPECT_NE(text.find("bathymetry: ../../lay/data/bed.csv"), std::string::npos) << text;
}

TEST(moved_text, a_whole_path_and_the_rest_of_the_text_stay) {
  const std::string text = moved_text(kModel, "/srv/lay/model.yaml", "/srv/results/one");
  EXPECT_NE(text.find("spectrum_file: /srv/sea/storm.csv"), std::string::npos) << text;
  EXPECT_NE(text.find("# kept"), std::string::npos) << text;
}

TEST(moved_text, relative_paths_of_which_nothing_is_there_are_named_all_the_same) {
  EXPECT_EQ(moved_text(kModel, "no-such-folder/model.yaml", "no-such-results"),
            moved_text(kModel, "/srv/no-such-folder/model.yaml", "/srv/no-such-results"));
}

TEST(moved_text, in_its_own_folder_it_is_the_text) {
  EXPECT_EQ(moved_text(kModel, "/srv/lay/model.yaml", "/srv/lay"), kModel);
}

}  // namespace
}  // namespace overbend
