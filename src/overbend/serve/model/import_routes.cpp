#include "serve/model/import_routes.h"

#include <map>

#include "orcaflex/import_orcaflex.h"
#include "serve/model/data_files.h"

namespace overbend {
namespace fs = std::filesystem;
namespace {

using Texts = std::map<std::string, std::string>;

/// Names and texts of the request; `first` is the name of the file to translate.
Texts read_files(const Json& request, std::string& first) {
  Texts texts;
  const auto files = request.find("files");
  if (files == request.end() || !files->is_array() || files->empty()) {
    throw HttpError(400, "the request has no 'files'", "see docs/api.md");
  }
  for (const Json& file : *files) {
    const std::string name = file.value("name", "");
    if (texts.empty()) first = name;
    texts[name] = file.value("text", "");
  }
  return texts;
}

Json account_json(const orcaflex::Account& account) {
  Json left_out = Json::array();
  for (const orcaflex::Account::Omission& omission : account.left_out) {
    left_out.push_back({{"text", omission.text}, {"matters", omission.matters}});
  }
  return {{"translated", account.translated}, {"approximated", account.approximated}, {"left_out", left_out}};
}

HttpAnswer import_files(const fs::path& folder, const HttpRequest& request) {
  std::string first;
  const Texts texts = read_files(request.json(), first);
  orcaflex::ImportOptions options;
  options.is_one_folder = true;
  options.title = fs::path(first).stem().string();
  Diagnostics diagnostics;
  const auto file_text = [&](const fs::path& file) -> std::optional<std::string> {
    const auto found = texts.find(file.filename().string());  // browsers give no folders
    return found == texts.end() ? std::nullopt : std::optional(found->second);
  };
  const std::optional<orcaflex::ImportedModel> model =
      orcaflex::import_orcaflex(first, options, diagnostics, file_text);
  if (!model) {
    const std::vector<std::string> lines = diagnostics.lines(Severity::error);
    throw HttpError(422, lines.empty() ? "the file cannot be translated" : lines.front(),
                    lines.size() > 1 ? std::to_string(lines.size() - 1) + " more errors" : "");
  }
  for (const auto& [name, text] : texts) write_data_file(folder, name, text);
  return json_answer({{"text", model->text}, {"account", account_json(model->account)}});
}

}  // namespace

void add_import_routes(std::vector<HttpRoute>& routes, const fs::path& folder) {
  routes.push_back({"POST", "/api/import", [folder](const HttpRequest& r) { return import_files(folder, r); }});
}

}  // namespace overbend
