#include "serve/model_folder.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>

#include "serve/page_files.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

bool model_name(const std::string& name) {
  return name.ends_with(".yaml") || name.ends_with(".yml");
}

double seconds_since_1970(fs::file_time_type time) {
  const auto system = std::chrono::file_clock::to_sys(time);
  return static_cast<double>(std::chrono::duration_cast<std::chrono::seconds>(system.time_since_epoch()).count());
}

void write_beside(const fs::path& file, std::string_view text) {
  const fs::path beside = file.string() + ".part";
  std::ofstream stream(beside, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  std::error_code fault;
  if (stream) fs::rename(beside, file, fault);
  if (!stream || fault) {
    fs::remove(beside, fault);
    throw HttpFault(422, "the file " + file.filename().string() + " can not be written", "is the folder writable?");
  }
}

}  // namespace

fs::path ModelFolder::place(const std::string& name) const {
  const bool bare = !name.empty() && name[0] != '.' && name.find_first_of("/\\") == std::string::npos &&
                    std::none_of(name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) < 32; });
  if (!bare || !model_name(name)) {
    throw HttpFault(422, "'" + name + "' is no name for a model file",
                    "a plain name that ends in .yaml, without folders");
  }
  return folder_ / name;
}

Json ModelFolder::files() const {
  std::vector<std::pair<std::string, double>> found;
  std::error_code fault;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, fault)) {
    const std::string name = entry.path().filename().string();
    if (!model_name(name) || name[0] == '.' || !entry.is_regular_file(fault)) continue;
    found.emplace_back(name, seconds_since_1970(entry.last_write_time(fault)));
  }
  std::sort(found.begin(), found.end());
  Json list = Json::array();
  for (const auto& [name, modified] : found) list.push_back({{"name", name}, {"modified", modified}});
  return list;
}

std::string ModelFolder::read(const std::string& name) const {
  std::ifstream stream(place(name), std::ios::binary);
  if (!stream) throw HttpFault(404, "there is no file " + name + " in the folder");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void ModelFolder::write(const std::string& name, const std::string& text) const {
  write_beside(place(name), text);
}

void ModelFolder::provide_data(const std::string& text) const {
  const std::string name = "data/bgl1/rao.csv";
  std::error_code fault;
  const fs::path file = folder_ / name;
  if (text.find(" " + name) == std::string::npos || fs::exists(file, fault)) return;
  fs::create_directories(file.parent_path(), fault);
  write_beside(file, embedded_text(name));
}

}  // namespace overbend
