#include "serve/live_statics.h"

#include <chrono>

#include "modelfile/yaml_edit.h"
#include "modelfile/yaml_reader.h"
#include "report/json_number.h"
#include "serve/diagnose.h"
#include "serve/static_json.h"
#include "study/static_run.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
  return seven_digits(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

Json invalid(const Diagnostics& diagnostics, const std::string& text) {
  return {{"status", "invalid"}, {"diagnostics", diagnostics_json(diagnostics, text)}};
}

std::string with_changes(const ModelText& model, const std::vector<YamlChange>& changes) {
  try {
    return edit_yaml(model.text, changes);
  } catch (const YamlEditFault& fault) {
    throw HttpFault(422, fault.what());
  }
}

}  // namespace

/// Another file or another set of rollers is another lay: nothing to start from.
bool LiveStatics::close_to_last(const Model& model) const {
  return last_.has_value() && model.description.source_file == last_file_ &&
         model.supports.rollers.size() == last_rollers_;
}

Json LiveStatics::solve(Model model, const StaticWish& wish) {
  const bool warm = !wish.full && close_to_last(model);
  const auto start = Clock::now();
  LayOutcome outcome = solve_lay(model, warm ? &*last_ : nullptr);
  const double solve_ms = milliseconds_since(start);
  if (outcome.failure) {
    const StaticFailure& f = *outcome.failure;
    return {{"status", "failed"}, {"what", f.what}, {"where", f.where}, {"why", f.why}};
  }
  const StaticResults results = checked_statics(model, outcome);
  last_ = std::move(outcome.solution);
  last_file_ = model.description.source_file;
  last_rollers_ = model.supports.rollers.size();
  Json answer = {{"status", "converged"}, {"elapsed_ms", 0.0}, {"solve_ms", solve_ms}, {"warm", warm}};
  answer.update(static_json(results, wish.lists ? &*wish.lists : nullptr));
  return answer;
}

/// The short way, without writing and reading the text; nothing where the change is not a simple one or at fault.
std::optional<Description> LiveStatics::read_changed(const ModelText& model, const std::vector<YamlChange>& changes) {
  if (!parsed_ || parsed_text_ != model.text) {
    Diagnostics faults;
    parsed_ = parse_yaml(model.text, model.path, faults);
    parsed_text_ = model.text;
    if (faults.has_errors()) parsed_.reset();
  }
  if (!parsed_ || parsed_->kind != YamlNode::Kind::map) return std::nullopt;
  YamlNode root = *parsed_;
  if (!edit_tree(root, changes)) return std::nullopt;
  return read_still_model(root, model.path).description;
}

Json LiveStatics::solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish) {
  const std::lock_guard<std::mutex> hold(mutex_);
  const auto start = Clock::now();
  std::optional<Description> description = read_changed(model, changes);
  if (!description) {
    const std::string text = with_changes(model, changes);
    ModelReading reading = read_model_text(text, model.path);
    if (!reading.description) return invalid(reading.diagnostics, text);
    description = std::move(reading.description);
  }
  Json answer = solve(build_model(*description), wish);
  answer["elapsed_ms"] = milliseconds_since(start);
  answer["revision"] = model.revision;
  return answer;
}

Json scene_of(const ModelText& model) {
  const ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) return invalid(reading.diagnostics, model.text);
  return scene_json(build_model(*reading.description));
}

void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics) {
  routes.push_back({"POST", "/api/static", [&](const HttpRequest& request) {
                      const Json body = request.json();
                      const std::vector<YamlChange> changes = changes_of(body.value("changes", Json::array()));
                      StaticWish wish = {body.value("full", false), {}};
                      if (body.contains("lists")) wish.lists = body["lists"].get<std::vector<std::string>>();
                      return json_answer(statics.solve(model.now(), changes, wish));
                    }});
  routes.push_back({"GET", "/api/scene", [&](const HttpRequest&) { return json_answer(scene_of(model.now())); }});
}

}  // namespace overbend
