#include "serve/http/page_files.h"

#include <filesystem>

#include "base/shown_unit.h"
#include "base/yaml_document.h"
#include "serve/http/embedded_files.h"

namespace overbend {
namespace {

/// Returns the media type by extension. The charset also keeps the library from compressing.
std::string media_type(const std::string& path) {
  static const std::vector<std::pair<std::string, std::string>> kTypes = {
      {".html", "text/html; charset=utf-8"},
      {".js", "text/javascript; charset=utf-8"},
      {".mjs", "text/javascript; charset=utf-8"},
      {".css", "text/css; charset=utf-8"},
      {".json", "application/json; charset=utf-8"},
      {".svg", "image/svg+xml; charset=utf-8"},
      {".png", "image/png"},
      {".ico", "image/x-icon"},
      {".woff2", "font/woff2"},
      {".wasm", "application/wasm"},
      {".txt", "text/plain; charset=utf-8"},
  };
  for (const auto& [extension, type] : kTypes) {
    if (path.ends_with(extension)) return type;
  }
  return "application/octet-stream";
}

std::string find_title(std::string_view text) {
  Diagnostics ignored;
  const std::optional<YamlNode> root = parse_yaml(std::string(text), "", ignored);
  if (root) {
    for (const YamlEntry& entry : root->entries) {
      if (entry.key == "title") return entry.value.text;
    }
  }
  return {};
}

std::vector<Example> find_examples() {
  std::vector<Example> found;
  for (const EmbeddedFile& file : embedded_files()) {
    if (!file.path.starts_with("examples/")) continue;
    found.push_back({std::filesystem::path(file.path).stem().string(), find_title(file.bytes), file.bytes});
  }
  return found;
}

/// Sets the system of units in the root element of the page.
std::string in_units_in_use(std::string page) {
  constexpr std::string_view kElement = "<html ";
  const std::size_t element = page.find(kElement);
  if (units_in_use() == UnitSystem::us && element != std::string::npos) {
    page.insert(element + kElement.size(), "data-units=\"us\" ");
  }
  return page;
}

}  // namespace

std::string_view embedded_text(const std::string& path) {
  for (const EmbeddedFile& file : embedded_files()) {
    if (file.path == path) return file.bytes;
  }
  return {};
}

std::string licence_texts() {
  const std::string line = "\n" + std::string(78, '-') + "\n\n";
  return "Overbend\n\n" + std::string(embedded_text("LICENSE")) + line +
         "The page of overbend serve and the HTML report contain these packages, in whole or in part.\n" + line +
         std::string(embedded_text("licences.txt"));
}

HttpAnswer page_file(const std::string& path) {
  const std::string name = path == "/" ? "/index.html" : path;
  std::string bytes(embedded_text("page" + name));
  if (bytes.empty()) return error_answer(404, "there is nothing at " + path);
  if (name == "/index.html") bytes = in_units_in_use(std::move(bytes));
  return {200, media_type(name), std::move(bytes), ""};
}

const std::vector<Example>& examples() {
  static const std::vector<Example> kExamples = find_examples();
  return kExamples;
}

}  // namespace overbend
