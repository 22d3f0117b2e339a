#include "serve/model/model_routes.h"

#include "base/shown_unit.h"
#include "base/version.h"
#include "modelfile/reading/json_schema.h"
#include "serve/http/page_files.h"
#include "serve/model/new_dialogue.h"

namespace overbend {
namespace {

std::string read_text_member(const Json& request, const char* key) {
  const auto found = request.find(key);
  if (found == request.end() || !found->is_string()) {
    throw HttpError(400, std::string("the request has no '") + key + "'", "see docs/api.md");
  }
  return found->get<std::string>();
}

std::int64_t read_revision(const Json& request) {
  const auto found = request.find("revision");
  if (found == request.end() || !found->is_number_integer()) throw HttpError(400, "the request has no 'revision'");
  return found->get<std::int64_t>();
}

HttpAnswer info(const OpenModel& model) {
  Json list = Json::array();
  for (const Example& example : examples()) list.push_back({{"name", example.name}, {"title", example.title}});
  return json_answer({{"version", kVersion},
                      {"folder", model.folder().path().string()},
                      {"examples", list},
                      {"has_model", !model.snapshot().text.empty()}});
}

HttpAnswer put_model(OpenModel& model, const HttpRequest& request) {
  const Json body = request.json();
  const bool named = body.contains("name");
  const std::string name = named ? read_text_member(body, "name") : "";
  Json answer = model_json(model.put(read_text_member(body, "text"), read_revision(body), named ? &name : nullptr));
  answer.erase("text");
  return json_answer(answer);
}

HttpAnswer set_keys(OpenModel& model, const HttpRequest& request) {
  const Json body = request.json();
  return json_answer(model_json(model.set(read_changes(body.at("changes")), read_revision(body))));
}

SaveRequest save_request(const Json& body) {
  SaveRequest request{read_text_member(body, "name")};
  request.force = body.value("force", false);
  request.knows = body.contains("disk");
  if (request.knows && !body["disk"].is_null()) request.disk = read_text_member(body, "disk");
  return request;
}

HttpAnswer save(OpenModel& model, const HttpRequest& request) {
  const Json body = request.json();
  const SaveRequest wanted = save_request(body);
  if (!body.contains("text")) return json_answer(model_json(model.save(wanted)));
  const ModelText kept = model.put(read_text_member(body, "text"), read_revision(body), nullptr);
  try {
    return json_answer(model_json(model.save(wanted)));
  } catch (HttpError& error) {
    error.top_level["revision"] = kept.revision;  // the text is now the open model even if saving failed
    throw;
  }
}

/// Returns the current version of the model file, which another program may have changed.
HttpAnswer file_on_disk(const OpenModel& model) {
  const std::string name = model.snapshot().name;
  Json version;
  try {
    if (!name.empty()) version = ModelFolder::version(model.folder().read(name));
  } catch (const HttpError&) {
    // the file was deleted
  }
  return json_answer({{"name", name}, {"version", version}});
}

HttpAnswer example(const HttpRequest& request) {
  for (const Example& found : examples()) {
    if (found.name != request.parts[0]) continue;
    std::string text(found.text);
    // Examples refer to ../data/; here data/ is a subfolder.
    const std::size_t position = text.find(" ../data/");
    if (position != std::string::npos) text.erase(position + 1, 3);
    return json_answer({{"text", text}, {"name", found.name}});
  }
  throw HttpError(404, "there is no example " + request.parts[0]);
}

/// Sets the system of units of the program; the page reloads to show it.
HttpAnswer choose_units(const HttpRequest& request) {
  const std::string units = read_text_member(request.json(), "units");
  if (units != "metric" && units != "us") throw HttpError(400, "'units' must be metric or us");
  use_units(units == "us" ? UnitSystem::us : UnitSystem::metric);
  return json_answer({{"units", units}});
}

}  // namespace

void add_model_routes(std::vector<HttpRoute>& routes, OpenModel& model) {
  routes.push_back({"GET", "/api/info", [&](const HttpRequest&) { return info(model); }});
  routes.push_back({"GET", "/api/schema", [](const HttpRequest&) {
                      return HttpAnswer{200, "application/json; charset=utf-8", json_schema(), ""};
                    }});
  routes.push_back({"GET", "/api/licences", [](const HttpRequest&) {
                      return HttpAnswer{200, "text/plain; charset=utf-8", licence_texts(), ""};
                    }});
  routes.push_back({"POST", "/api/units", choose_units});
  routes.push_back(
      {"GET", "/api/model", [&](const HttpRequest&) { return json_answer(model_json(model.snapshot())); }});
  routes.push_back({"GET", "/api/model/disk", [&](const HttpRequest&) { return file_on_disk(model); }});
  routes.push_back({"PUT", "/api/model", [&](const HttpRequest& r) { return put_model(model, r); }});
  routes.push_back({"POST", "/api/model/set", [&](const HttpRequest& r) { return set_keys(model, r); }});
  routes.push_back({"POST", "/api/model/open", [&](const HttpRequest& r) {
                      return json_answer(model_json(model.open(read_text_member(r.json(), "name"))));
                    }});
  routes.push_back({"POST", "/api/model/save", [&](const HttpRequest& r) { return save(model, r); }});
  routes.push_back({"GET", "/api/examples/*", example});
  routes.push_back(
      {"GET", "/api/files", [&](const HttpRequest&) {
         return json_answer({{"folder", model.folder().path().string()}, {"files", model.folder().files()}});
       }});
  routes.push_back({"GET", "/api/new", [](const HttpRequest&) { return json_answer(new_dialogue()); }});
  routes.push_back({"POST", "/api/new", [](const HttpRequest& r) {
                      return json_answer({{"text", new_text(r.json())}});
                    }});
}

}  // namespace overbend
