#include "serve/model/data_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>

#include "base/ranges.h"
#include "base/text.h"
#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"
#include "seafiles/hull_file_kind.h"
#include "seafiles/motion_file_kind.h"
#include "serve/http/base64.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

/// Maximum depth of subfolders that are searched.
constexpr int kMaxFolderDepth = 3;

/// True for the usual names of the files that models mention: hulls, motions, seas, beds.
bool has_data_name(const std::string& name) {
  constexpr std::array kEndings = {".txt",  ".tsv",       ".xyz",   ".asc",    ".spc",  ".sp2",
                                   ".spec", ".data_spec", ".swdir", ".swdir2", ".swr1", ".swr2"};
  const std::string ending = lower_case(fs::path(name).extension().string());
  return has_hull_text_ending(name) || has_hull_binary_ending(name) || ranges::find(kEndings, ending) != kEndings.end();
}

/// True for hidden files and folders of run results, which are skipped.
bool passed_over(const fs::path& place) {
  const std::string name = place.filename().string();
  return name.starts_with('.') || name == "runs" || name == "node_modules";
}

/// A file that is a source of vessel motion, with the keys of `vessel.motion` that may name it.
Json data_file(const std::string& name, const fs::path& file) {
  Json kinds = Json::array();
  for (const MotionFileKind kind : find_motion_file_kinds(file.string())) kinds.push_back(enum_name(kind));
  return {{"name", name}, {"kinds", kinds}};
}

/// Sources of vessel motion in the folder, by their contents.
Json data_files(const fs::path& folder) {
  std::map<std::string, Json> found;
  std::error_code error;
  const auto quietly = fs::directory_options::skip_permission_denied;
  for (auto position = fs::recursive_directory_iterator(folder, quietly, error); !error && position != end(position);
       position.increment(error)) {
    std::error_code none;
    if (position->is_directory(none) && (passed_over(position->path()) || position.depth() >= kMaxFolderDepth)) {
      position.disable_recursion_pending();
    } else if (position->is_regular_file(none) && !passed_over(position->path())) {
      const std::string name = position->path().lexically_relative(folder).generic_string();
      Json file = data_file(name, position->path());
      if (!file.at("kinds").empty()) found.emplace(name, std::move(file));
    }
  }
  Json files = Json::array();
  for (auto& [name, file] : found) files.push_back(std::move(file));
  return {{"files", std::move(files)}};
}

std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// Returns the path of a data file. Only plain names are accepted, so that nothing outside the folder is written; other
/// endings than the usual ones only if the text shows which program wrote it.
fs::path place(const fs::path& folder, const std::string& name, const std::string& text) {
  const bool bare = !name.empty() && name[0] != '.' && name.find_first_of("/\\") == std::string::npos &&
                    ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (bare && (has_data_name(name) || find_text_kind(text))) return folder / name;
  throw HttpError(422, "'" + name + "' is not a valid name for a data file",
                  "a plain name that ends in " + join_items(hull_text_endings(), "or"));
}

/// Content of a file that the page sends: bytes as base64, or plain text.
std::string uploaded_content(const Json& body) {
  if (!body.contains("base64")) return body.value("text", "");
  const std::optional<std::string> bytes = bytes_from_base64(body.value("base64", ""));
  if (!bytes) throw HttpError(422, "the content is no base64", "the bytes of a file in base64");
  return *bytes;
}

HttpAnswer upload(const fs::path& folder, const HttpRequest& request) {
  const Json body = request.json();
  const std::string name = body.value("name", "");
  write_data_file(folder, name, uploaded_content(body));
  return json_answer(data_file(name, folder / name));
}

}  // namespace

void write_data_file(const fs::path& folder, const std::string& name, const std::string& text) {
  const fs::path file = place(folder, name, text);
  std::error_code error;
  if (fs::exists(fs::symlink_status(file, error)) && file_text(file) != text) {
    throw HttpError(409, "the folder already contains a different file " + name, "choose another name");
  }
  const fs::path part_file = file.string() + ".part";
  try {
    write_text(part_file, text);
    name_complete_file(part_file, file);
  } catch (const std::exception& why) {
    fs::remove(part_file, error);
    throw HttpError(422, why.what());
  }
}

void add_data_routes(std::vector<HttpRoute>& routes, const fs::path& folder) {
  routes.push_back({"GET", "/api/data", [folder](const HttpRequest&) { return json_answer(data_files(folder)); }});
  routes.push_back({"POST", "/api/data", [folder](const HttpRequest& r) { return upload(folder, r); }});
}

}  // namespace overbend
