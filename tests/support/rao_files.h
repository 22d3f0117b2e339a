/// RAO tables of the repository and files written for a test.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "seafiles/rao_reader.h"

namespace overbend::testing {

/// A file in a folder of the test's own, gone with it.
class WrittenFile {
 public:
  WrittenFile(const std::string& name, const std::string& text) {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("overbend_") + test->test_suite_name() + "_" + test->name());
    std::filesystem::create_directories(folder_);
    path_ = (folder_ / name).string();
    std::ofstream(path_, std::ios::binary) << text;
  }
  WrittenFile(const WrittenFile&) = delete;
  WrittenFile& operator=(const WrittenFile&) = delete;
  ~WrittenFile() {
    std::error_code error;
    std::filesystem::remove_all(folder_, error);
  }
  const std::string& path() const { return path_; }

 private:
  std::filesystem::path folder_;
  std::string path_;
};

/// Reads a table that must be good.
inline RaoTable good_raos(const std::string& file, const RaoSettings& given = {}, double depth = 89.0) {
  Diagnostics diagnostics;
  std::optional<RaoTable> table = read_raos(file, given, depth, diagnostics);
  for (const std::string& line : diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return table ? *table : RaoTable{};
}

inline std::string bgl1_file(const std::string& name) {
  return std::string(OVERBEND_SOURCE_DIR) + "/data/bgl1/" + name;
}

inline const RaoTable& bgl1_raos() {
  static const RaoTable kTable = good_raos(bgl1_file("rao.csv"));
  return kTable;
}

}  // namespace overbend::testing
