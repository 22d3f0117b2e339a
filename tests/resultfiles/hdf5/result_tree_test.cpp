#include "resultfiles/hdf5/result_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

using testing::solved_case;
using testing::TemporaryFolder;

/// Paths of all datasets of the file below a group.
void list_datasets(const Hdf5Reader& file, const std::string& group, std::vector<std::string>& paths) {
  for (const std::string& name : file.names(group)) {
    if (name.ends_with('/')) {
      list_datasets(file, group + name, paths);
    } else {
      paths.push_back(group + name);
    }
  }
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

void expect_same_values(const Dataset& a, const Dataset& b, const std::string& path) {
  ASSERT_EQ(a.values.index(), b.values.index()) << path;
  if (const auto* numbers = std::get_if<std::vector<double>>(&a.values)) {
    EXPECT_TRUE(std::ranges::equal(*numbers, std::get<std::vector<double>>(b.values), same_bits)) << path;
  } else {
    EXPECT_EQ(a.values, b.values) << path;
  }
}

TEST(result_tree, holds_what_the_file_of_the_same_results_holds) {
  const TemporaryFolder folder;
  const auto& lay = solved_case("J12-D400-T560");
  Hdf5Writer writer(folder.path() / "results.h5");
  ResultTree tree;
  for (DatasetSink* sink : {static_cast<DatasetSink*>(&writer), static_cast<DatasetSink*>(&tree)}) {
    write_static_groups(*sink, lay.results, lay.description);
  }
  writer.close();

  const Hdf5Reader file(folder.path() / "results.h5");
  std::vector<std::string> paths;
  list_datasets(file, "/", paths);
  ASSERT_GT(paths.size(), 100U);
  EXPECT_EQ(paths.size(), tree.datasets.size());
  for (const std::string& path : paths) {
    ASSERT_TRUE(tree.datasets.contains(path)) << path;
    const Dataset stored = file.whole(path);
    const Dataset& held = tree.datasets.at(path);
    expect_same_values(held, stored, path);
    EXPECT_EQ(held.shape, stored.shape) << path;
    EXPECT_EQ(held.units, stored.units) << path;
    EXPECT_EQ(held.description, stored.description) << path;
    EXPECT_EQ(held.frame, stored.frame) << path;
    EXPECT_EQ(held.scales, stored.scales) << path;
  }
}

TEST(result_tree, columns_come_as_they_were_written_in_memory_and_from_the_file) {
  const TemporaryFolder folder;
  const auto& lay = solved_case("J12-D400-T560");
  Hdf5Writer writer(folder.path() / "results.h5");
  ResultTree tree;
  write_lay_group(writer, "/static", lay.results);
  write_lay_group(tree, "/static", lay.results);
  writer.close();
  std::vector<std::string> held;
  const std::string group = "/static/stations/";
  for (const std::string& path : tree.order) {
    if (path.starts_with(group)) held.push_back(path.substr(group.size()));
  }
  ASSERT_GT(held.size(), 10U);
  EXPECT_FALSE(std::ranges::is_sorted(held));
  EXPECT_EQ(Hdf5Reader(folder.path() / "results.h5").names(group), held);
}

TEST(result_tree, columns_know_what_they_stand_over) {
  ResultTree tree;
  const auto& lay = solved_case("J12-D400-T560");
  write_lay_group(tree, "/static", lay.results);
  EXPECT_EQ(tree.datasets.at("/static/stations/effective_tension").scales,
            std::vector<std::string>{"/static/stations/s"});
  EXPECT_EQ(tree.datasets.at("/static/stations/effective_tension").units, "N");
}

}  // namespace
}  // namespace overbend
