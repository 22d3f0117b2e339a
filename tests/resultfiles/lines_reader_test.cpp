#include "resultfiles/lines_reader.h"

#include <gtest/gtest.h>

#include "modelfile/moored_texts.h"
#include "modelfile/yaml_reader.h"
#include "study/lines_run.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

TEST(lines_reader, lines_at_rest_are_read_as_they_were_written) {
  const Description description = read_model_text(testing::kLines, "lines.yaml").description.value();
  const LinesResults solved = solve_lines(build_model(description)).results.value();
  const testing::TemporaryFolder folder;
  write_lines_run(solved, description, folder / "run");
  const StoredLines stored = read_lines_results(folder / "run" / "results.h5");
  EXPECT_EQ(stored.model_text, testing::kLines);
  ASSERT_EQ(stored.results.lines.size(), solved.lines.size());
  for (std::size_t i = 0; i < solved.lines.size(); ++i) {
    const LineResult &read = stored.results.lines[i], &written = solved.lines[i];
    EXPECT_EQ(read.name, written.name);
    EXPECT_EQ(read.utilisation, written.utilisation);
    EXPECT_EQ(read.largest_tension, written.largest_tension);
    EXPECT_EQ(read.first.force, written.first.force);
    EXPECT_EQ(read.second.declination, written.second.declination);
    ASSERT_EQ(read.nodes.size(), written.nodes.size());
    EXPECT_EQ(read.nodes.back().place, written.nodes.back().place);
    EXPECT_EQ(read.nodes[1].tension, written.nodes[1].tension);
  }
}

TEST(lines_reader, a_file_of_something_else_is_refused) {
  const testing::TemporaryFolder folder;
  testing::write_file(folder / "results.h5", "no HDF5");
  EXPECT_THROW(read_lines_results(folder / "results.h5"), std::runtime_error);
}

}  // namespace
}  // namespace overbend
