#include "serve/model/data_files.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "resultfiles/static/results_writer.h"
#include "runstore/append_file.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

/// Folders below the program's that are looked into.
constexpr int kDeepest = 3;

/// Files of text, which the page may send: tables, RAOs, hydrodynamics of a hull in WAMIT's layout.
bool text_data(const fs::path& file) {
  constexpr std::array kEndings = {".csv", ".4", ".yml", ".1", ".3", ".8", ".hst"};
  return std::ranges::find(kEndings, file.extension().string()) != kEndings.end();
}

bool data_name(const fs::path& file) {
  return text_data(file) || file.extension() == ".nc";
}

/// Neither what is hidden nor the results of runs.
bool passed_over(const fs::path& place) {
  const std::string name = place.filename().string();
  return name.starts_with('.') || name == "runs" || name == "node_modules";
}

Json data_files(const fs::path& folder) {
  std::vector<std::string> names;
  std::error_code fault;
  const auto quietly = fs::directory_options::skip_permission_denied;
  for (auto at = fs::recursive_directory_iterator(folder, quietly, fault); !fault && at != end(at);
       at.increment(fault)) {
    std::error_code none;
    if (at->is_directory(none) && (passed_over(at->path()) || at.depth() >= kDeepest)) {
      at.disable_recursion_pending();
    } else if (at->is_regular_file(none) && !passed_over(at->path()) && data_name(at->path())) {
      names.push_back(at->path().lexically_relative(folder).generic_string());
    }
  }
  std::ranges::sort(names);
  return {{"files", names}};
}

std::string file_text(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

/// A bare name, so that nothing outside the folder is written.
fs::path place(const fs::path& folder, const std::string& name) {
  const bool bare = !name.empty() && name[0] != '.' && name.find_first_of("/\\") == std::string::npos &&
                    std::ranges::none_of(name, [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (bare && text_data(name)) return folder / name;
  throw HttpFault(422, "'" + name + "' is not a valid name for a data file",
                  "a plain name that ends in .csv, .4, .yml, .1, .3, .8 or .hst");
}

HttpAnswer upload(const fs::path& folder, const HttpRequest& request) {
  const Json body = request.json();
  const std::string name = body.value("name", "");
  write_data_file(folder, name, body.value("text", ""));
  return json_answer({{"name", name}});
}

}  // namespace

void write_data_file(const fs::path& folder, const std::string& name, const std::string& text) {
  const fs::path file = place(folder, name);
  std::error_code fault;
  if (fs::exists(fs::symlink_status(file, fault)) && file_text(file) != text) {
    throw HttpFault(409, "the folder has another file " + name + " already", "give this one another name");
  }
  const fs::path beside = file.string() + ".part";
  try {
    write_text(beside, text);
    fs::rename(beside, file);
  } catch (const std::exception& why) {
    fs::remove(beside, fault);
    throw HttpFault(422, why.what());
  }
}

void add_data_routes(std::vector<HttpRoute>& routes, const fs::path& folder) {
  routes.push_back({"GET", "/api/data", [folder](const HttpRequest&) { return json_answer(data_files(folder)); }});
  routes.push_back({"POST", "/api/data", [folder](const HttpRequest& r) { return upload(folder, r); }});
}

}  // namespace overbend
