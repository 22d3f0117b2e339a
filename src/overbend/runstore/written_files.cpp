#include "runstore/written_files.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "runstore/append_file.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

constexpr const char* kStaged = ".overbend-staged";
constexpr const char* kOld = ".overbend-old";

bool is_name(const std::string& text) {
  return !text.empty() && text != "." && text != ".." && fs::path(text).filename() == text;
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    names.push_back(entry->path().filename().string());
  }
  return names;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(path, error));
}

bool write_mark(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  return static_cast<bool>(stream);
}

/// Moves all files not written by the program to the folder that replaced this one; returns false if one remains.
bool move_user_files(const fs::path& old, const fs::path& place) {
  std::vector<std::string> written = read_written(old).files;
  const std::vector<std::string> listed = read_written(place).files;
  written.insert(written.end(), listed.begin(), listed.end());
  bool complete = true;
  for (const std::string& name : names_in(old)) {
    std::error_code error;
    if (is_mark(name) || name == kWrittenFiles || holds(written, name)) continue;
    if (!is_folder(old / name) && fs::equivalent(old / name, place / name, error)) continue;  // shared
    fs::rename(old / name, place / name, error);
    complete = complete && !error;
  }
  return complete;
}

}  // namespace

WrittenFiles read_written(const fs::path& folder) {
  WrittenFiles written;
  std::ifstream stream(folder / kWrittenFiles, std::ios::binary);
  for (std::string line; std::getline(stream, line);) {
    const bool is_folder_name = line.ends_with('/');
    if (is_folder_name) line.pop_back();
    if (is_name(line)) (is_folder_name ? written.folders : written.files).push_back(line);
  }
  return written;
}

std::optional<std::string> find_user_file_conflict(const fs::path& folder, const std::vector<std::string>& names) {
  const std::vector<std::string> written = read_written(folder).files;
  for (const std::string& name : names) {
    std::error_code error;
    if (holds(written, name) || !fs::exists(fs::symlink_status(folder / name, error))) continue;
    if (fs::exists(folder / "study.json", error)) return "it contains a study; give another folder";
    return "'" + name + "' in it was not written by the program (" + kWrittenFiles +
           " does not list it); move it, or give another folder";
  }
  return std::nullopt;
}

void write_written(const fs::path& folder, const WrittenFiles& written) {
  std::string text;
  for (const std::string& name : written.files) text += name + "\n";
  for (const std::string& name : written.folders) text += name + "/\n";
  write_text(folder / kWrittenFiles, text);
}

bool mark_staged(const fs::path& folder) {
  return write_mark(folder / kStaged, "");
}

bool unmark_staged(const fs::path& folder) {
  std::error_code ignored;
  return fs::remove(folder / kStaged, ignored);
}

bool is_marked_staged(const fs::path& folder) {
  std::error_code ignored;
  return fs::exists(folder / kStaged, ignored);
}

bool mark_old(const fs::path& folder, const fs::path& place) {
  return write_mark(folder / kOld, place.string());
}

void unmark_old(const fs::path& folder) {
  std::error_code ignored;
  fs::remove(folder / kOld, ignored);
}

bool is_mark(const std::string& name) {
  return name == kStaged || name == kOld;
}

bool link_user_files(const fs::path& from, const fs::path& to, const std::vector<std::string>& mine,
                     std::vector<std::string>& shared) {
  for (const std::string& name : names_in(from)) {
    if (is_mark(name) || holds(mine, name) || is_folder(from / name)) continue;
    std::error_code error;
    fs::create_hard_link(from / name, to / name, error);
    if (error) return false;
    shared.push_back(name);
  }
  return true;
}

void clear_marked(const fs::path& folder) {
  std::error_code ignored;
  if (is_marked_staged(folder)) {
    fs::remove_all(folder, ignored);
    return;
  }
  std::ifstream mark(folder / kOld, std::ios::binary);
  std::string place;
  if (!std::getline(mark, place) || !is_folder(place)) return;
  if (fs::equivalent(folder, place, ignored)) return;
  if (move_user_files(folder, place)) fs::remove_all(folder, ignored);
}

}  // namespace overbend
