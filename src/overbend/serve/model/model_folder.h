/// Model files of the folder that the program was started in.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "serve/http/http.h"

namespace overbend {

/// Accesses files by plain names, so that nothing outside the folder is reached. Errors are HttpError.
class ModelFolder {
 public:
  explicit ModelFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  const std::filesystem::path& path() const { return folder_; }
  /// Returns `[{name, modified}]` of the *.yaml and *.yml files, sorted by name; `modified` in seconds since 1970.
  Json files() const;
  /// Returns the text of a file; HttpError 404 if it does not exist.
  std::string read(const std::string& name) const;
  /// Returns a hash of a text that identifies the contents of a file.
  static std::string version(const std::string& text);
  /// Writes the text to a file (replace_file). If the file differs from the `expected` version (nothing: no file
  /// expected), nothing is written: HttpError 409 with the text of the file. A file that was deleted or already has
  /// this text is not a conflict.
  void write(const std::string& name, const std::string& text, const std::optional<std::string>& expected) const;
  /// The same regardless of the contents of the file.
  void overwrite(const std::string& name, const std::string& text) const;
  /// Copies data of the examples into the folder if the text refers to them and they do not exist.
  void provide_data(const std::string& text) const;

 private:
  std::filesystem::path place(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace overbend
