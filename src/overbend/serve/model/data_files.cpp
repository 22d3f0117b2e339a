#include "serve/model/data_files.h"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "base/ranges.h"
#include "base/text.h"
#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"
#include "seafiles/hull_file_kind.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

/// Maximum depth of subfolders that are searched.
constexpr int kMaxFolderDepth = 3;

/// True for text files that the page may upload: tables, RAOs, hydrodynamics of a hull.
bool text_data(const fs::path& file) {
  return has_hull_text_ending(file.string());
}

bool data_name(const fs::path& file) {
  return text_data(file) || has_hull_binary_ending(file.string());
}

/// True for hidden files and folders of run results, which are skipped.
bool passed_over(const fs::path& place) {
  const std::string name = place.filename().string();
  return name.starts_with('.') || name == "runs" || name == "node_modules";
}

Json data_files(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code error;
  const auto quietly = fs::directory_options::skip_permission_denied;
  for (auto position = fs::recursive_directory_iterator(folder, quietly, error); !error && position != end(position);
       position.increment(error)) {
    std::error_code none;
    if (position->is_directory(none) && (passed_over(position->path()) || position.depth() >= kMaxFolderDepth)) {
      position.disable_recursion_pending();
    } else if (position->is_regular_file(none) && !passed_over(position->path()) && data_name(position->path())) {
      names.push_back(position->path().lexically_relative(folder).generic_string());
    }
  }
  ranges::sort(names);
  return {{"files", names}};
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
  if (bare && (text_data(name) || find_text_kind(text))) return folder / name;
  throw HttpError(422, "'" + name + "' is not a valid name for a data file",
                  "a plain name that ends in " + join_items(hull_text_endings(), "or"));
}

HttpAnswer upload(const fs::path& folder, const HttpRequest& request) {
  const Json body = request.json();
  const std::string name = body.value("name", "");
  write_data_file(folder, name, body.value("text", ""));
  return json_answer({{"name", name}});
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
