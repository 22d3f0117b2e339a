/// The model files of the folder that the program was started in.
#pragma once

#include <filesystem>
#include <string>

#include "serve/http.h"

namespace overbend {

/// Files by their bare names: nothing outside the folder is reached. Faults are HttpFault.
class ModelFolder {
 public:
  explicit ModelFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }
  /// `[{name, modified}]` of the *.yaml and *.yml, by name; `modified` in seconds since 1970.
  Json files() const;
  std::string read(const std::string& name) const;
  /// Written beside and renamed.
  void write(const std::string& name, const std::string& text) const;
  /// Puts the data that an example names into the folder, where the text names it and it is not there.
  void provide_data(const std::string& text) const;

 private:
  std::filesystem::path place(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace overbend
