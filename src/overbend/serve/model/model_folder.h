/// The model files of the folder that the program was started in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "serve/http/http.h"

namespace overbend {

/// Files by their bare names: nothing outside the folder is reached. Faults are HttpFault.
class ModelFolder {
 public:
  explicit ModelFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }
  /// `[{name, modified}]` of the *.yaml and *.yml, by name; `modified` in seconds since 1970.
  Json files() const;
  std::string read(const std::string& name) const;
  /// Which content a file has: equal for equal texts, and in practice for no others.
  static std::string version(const std::string& text);
  /// The file of that name gets the text (replace_file). Where it has meanwhile another content than the `expected`
  /// version (nothing: it is not there yet) nothing is written: 409 with the file's own text. A file that has gone, or
  /// has this very text already, contradicts nobody.
  void write(const std::string& name, const std::string& text, const std::optional<std::string>& expected) const;
  /// The same whatever the file holds.
  void overwrite(const std::string& name, const std::string& text) const;
  /// Puts the data that an example names into the folder, where the text names it and it is not there.
  void provide_data(const std::string& text) const;

 private:
  std::filesystem::path place(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace overbend
