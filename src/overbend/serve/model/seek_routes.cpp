#include "serve/model/seek_routes.h"

#include "modelfile/reading/seek_reader.h"
#include "modelfile/reading/yaml_reader.h"
#include "resultfiles/studies/seek_writer.h"
#include "serve/model/diagnose.h"
#include "study/goal_seek/seek.h"

namespace overbend {
namespace {

std::string with_seek(const ModelText& model, const Json& wanted) {
  try {
    return edit_yaml(model.text, {{"seek", YamlChange::Kind::flow, json_text(wanted)}});
  } catch (const YamlEditError& error) {
    throw HttpError(422, error.what());
  }
}

Json changes_json(const std::vector<YamlChange>& changes) {
  Json list = Json::array();
  for (const YamlChange& change : changes) list.push_back({{"path", change.path}, {"value", change.value}});
  return list;
}

}  // namespace

Json seek_answer(const ModelText& model, const Json& wanted) {
  const std::string text = with_seek(model, wanted);
  const ModelReading reading = read_model_text(text, model.path);
  if (!reading.description) {
    return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, text)}};
  }
  const SeekDescription asked = read_seek(*reading.description).value_or(SeekDescription{});
  try {
    const SeekResults results = seek(*reading.description, asked).results;
    Json answer = {{"status", results.found ? "found" : "none"}, {"revision", model.revision}};
    answer["seek"] = seek_json(results);
    answer["changes"] =
        changes_json(results.found ? answer_changes(*reading.description, asked, results) : std::vector<YamlChange>{});
    return answer;
  } catch (const SeekError& error) {
    throw HttpError(422, error.what());
  }
}

void add_seek_routes(std::vector<HttpRoute>& routes, OpenModel& model) {
  routes.push_back({"POST", "/api/seek",
                    [&](const HttpRequest& request) {
                      const Json body = request.json();
                      return json_answer(seek_answer(model.snapshot(), body.at("seek")));
                    },
                    kLongLimit});
}

}  // namespace overbend
