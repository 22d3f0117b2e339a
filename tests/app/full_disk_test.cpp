// A disk that takes no more ends a run with a reason and leaves nothing half-written. A limit on the size of files is
// what a full disk looks like to who writes.
#include <gtest/gtest.h>

#include "app/program.h"
#include "app/small_lay.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "runstore/append_file.h"
#include "support/size_limit.h"
#include "support/solved_case.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::ProgramRun;
using testing::Scratch;

/// The program where no file may grow beyond that many blocks of 512 bytes.
ProgramRun run_with_blocks(int blocks, const std::string& arguments) {
  return testing::run_program(arguments, "ulimit -f " + std::to_string(blocks) + " && ");
}

TEST(full_disk, ends_static_with_1_and_the_reason_and_leaves_nothing) {
  const Scratch folder;
  const std::string model = folder.write("model.yaml", testing::kSmallLay);
  for (const int blocks : {1, 128, 512}) {  // in tables, at the end of results.h5, or in the report
    const ProgramRun run = run_with_blocks(blocks, "static " + model + " -o " + folder.file("out"));
    EXPECT_EQ(run.code, 1) << blocks;
    EXPECT_NE(run.err.find("cannot be written: File too large"), std::string::npos) << run.err;
    EXPECT_EQ(run.err.find("internal"), std::string::npos) << run.err;
    EXPECT_FALSE(fs::exists(folder.file("out"))) << blocks;
  }
}

TEST(full_disk, ends_dynamic_with_1_and_leaves_no_results) {
  const Scratch folder;
  const std::string model = folder.write("model.yaml", testing::kSmallLay);
  for (const int blocks : {4, 512}) {  // while it runs, and at its end
    const ProgramRun run = run_with_blocks(blocks, "dynamic " + model + " -o " + folder.file("out"));
    EXPECT_EQ(run.code, 1) << blocks << run.err;
    EXPECT_NE(run.err.find("cannot be written: File too large"), std::string::npos) << run.err;
    if (!fs::exists(folder.file("out"))) continue;
    for (const fs::directory_entry& left : fs::directory_iterator(folder.file("out"))) {
      EXPECT_EQ(left.path().filename(), ".run");  // a checkpoint may stand
    }
  }
}

TEST(full_disk, is_reported_at_every_size_of_a_results_file) {
  const testing::TemporaryFolder folder;
  const std::vector<double> numbers(20000, 1.0);
  const ResultField field{"numbers", "1", "Some"};
  const auto write = [&] {
    Hdf5Writer file(folder / "results.h5");
    for (int i = 0; i < 10; ++i) {
      file.group("/group" + std::to_string(i), "A group");
      file.write("/group" + std::to_string(i) + "/numbers", field, numbers, {numbers.size()});
    }
    file.close();
  };
  for (const rlim_t size : {0U, 100U, 2048U, 5000U, 200000U, 1000000U, 1600000U}) {
    const testing::SizeLimit limit(size);
    EXPECT_THROW(write(), FileError) << size;
  }
  write();
  EXPECT_EQ(Hdf5Reader(folder / "results.h5").doubles("/group9/numbers"), numbers);
}

}  // namespace
}  // namespace overbend
