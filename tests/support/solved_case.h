/// Reference cases solved once per test program, and folders that clean up after themselves.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string>

#include "model/model.h"
#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/static_analysis.h"

namespace overbend::testing {

struct SolvedCase {
  Description description;
  StaticResults results;
};

inline std::string case_file(const std::string& name) {
  return OVERBEND_SOURCE_DIR "/validation/static_cases/" + name + ".yaml";
}

/// The statics of validation/static_cases/<name>.yaml.
inline const SolvedCase& solved_case(const std::string& name) {
  static std::map<std::string, SolvedCase> cases;
  const auto [found, fresh] = cases.try_emplace(name);
  if (fresh) {
    const ModelReading reading = read_model(case_file(name));
    const Model model = build_model(reading.description.value());
    const StaticOutcome outcome = solve_statics(model);
    found->second = {*reading.description, checked_statics(model, {outcome.solution, {}, {}})};
  }
  return found->second;
}

/// A new empty folder, removed with all it holds at the end.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "overbend-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void write_file(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary) << text;
}

}  // namespace overbend::testing
