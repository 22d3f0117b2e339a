#include "serve/model/model_folder.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include "base/file_time.h"
#include "runstore/replace_file.h"
#include "runstore/run_record.h"
#include "serve/http/embedded_files.h"
#include "serve/http/page_files.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

bool model_name(const std::string& name) {
  return name.ends_with(".yaml") || name.ends_with(".yml");
}

void put(const fs::path& file, std::string_view text, const std::function<void()>& last_look = nullptr) {
  try {
    replace_file(file, text, last_look);
  } catch (const HttpError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw HttpError(422, error.what(), "nothing was written; try another name or folder");
  }
}

HttpError changed_on_disk(const std::string& name, const std::string& text, const std::string& version) {
  HttpError error(409, "the file " + name + " has changed since the page read it",
                  "reload the file, replace it with your version, or save under another name");
  error.more["reason"] = "disk";
  error.top_level["disk"] = {{"name", name}, {"text", text}, {"version", version}};
  return error;
}

}  // namespace

fs::path ModelFolder::place(const std::string& name) const {
  const bool bare = !name.empty() && name[0] != '.' && name.find_first_of("/\\") == std::string::npos &&
                    std::none_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (!bare || !model_name(name)) {
    throw HttpError(422, "'" + name + "' is not a valid name for a model file",
                    "a plain name that ends in .yaml, without folders");
  }
  return folder_ / name;
}

Json ModelFolder::files() const {
  std::vector<std::pair<std::string, double>> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, error)) {
    const std::string name = entry.path().filename().string();
    if (!model_name(name) || name[0] == '.' || !entry.is_regular_file(error)) continue;
    found.emplace_back(name, seconds_since_1970(entry.last_write_time(error)));
  }
  std::sort(found.begin(), found.end());
  Json list = Json::array();
  for (const auto& [name, modified] : found) list.push_back({{"name", name}, {"modified", modified}});
  return list;
}

std::string ModelFolder::read(const std::string& name) const {
  const fs::path file = place(name);
  std::error_code error;
  std::ifstream stream;
  if (fs::is_regular_file(file, error)) stream.open(file, std::ios::binary);  // reading from a named pipe would block
  if (!stream.is_open()) throw HttpError(404, "there is no file " + name + " in the folder");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string ModelFolder::version(const std::string& text) {
  return text_hash(text);
}

void ModelFolder::write(const std::string& name, const std::string& text,
                        const std::optional<std::string>& expected) const {
  const fs::path file = place(name);
  put(file, text, [&] {
    std::error_code error;
    if (!fs::exists(file, error)) return;
    const std::string found = read(name);
    if (found != text && version(found) != expected) throw changed_on_disk(name, found, version(found));
  });
}

void ModelFolder::overwrite(const std::string& name, const std::string& text) const {
  put(place(name), text);
}

void ModelFolder::provide_data(const std::string& text) const {
  std::error_code error;
  for (const EmbeddedFile& data : embedded_files()) {
    // Compares the stem, by which a model refers to several files of a hull.
    const fs::path name(data.path);
    const fs::path file = folder_ / name;
    if (!data.path.starts_with("data/") || fs::exists(file, error)) continue;
    if (text.find(" " + (name.parent_path() / name.stem()).generic_string()) == std::string::npos) continue;
    fs::create_directories(file.parent_path(), error);
    put(file, data.bytes);
  }
}

}  // namespace overbend
