#include "serve/model/live_operation.h"

#include <charconv>

#include "base/interruption.h"
#include "model/lay_stage.h"
#include "modelfile/reading/yaml_reader.h"
#include "report/stages/operation_report.h"
#include "serve/answers/page_operation.h"
#include "serve/answers/page_style.h"
#include "serve/answers/static_json.h"
#include "serve/model/diagnose.h"
#include "study/stages/lay_operation.h"

namespace overbend {
namespace {

Json progress_json(const StageResult& stage, std::size_t done, std::size_t total) {
  return {{"done", done}, {"of", total}, {"name", stage.stage.name}, {"stands", stage.lay.has_value()}};
}

std::size_t parse_stage_number(const std::string& text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) {
    throw HttpError(404, "found stage '" + text + "', expected its number, starting from 0");
  }
  return number;
}

}  // namespace

Json LiveOperation::solve(const ModelText& model) {
  const std::uint64_t mine = ++asked_;
  const ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) {
    return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, model.text)}};
  }
  const Description& description = *reading.description;
  if (lay_stages(description).empty()) {
    throw HttpError(422, "the model has no operation on the line", "set operation.type and operation.stages");
  }
  const std::lock_guard<std::mutex> hold(solving_);
  const InterruptionScope scope([&] { return asked_ != mine; });
  std::size_t done = 0;
  OperationResults results;
  try {
    results = solve_operation(description, [&](const StageResult& stage, std::size_t total) {
      events_.send("stage", progress_json(stage, ++done, total), "stage");
      return asked_ == mine;
    });
  } catch (const Interrupted&) {
    if (asked_ == mine) throw;
  }
  if (asked_ != mine) return {{"status", "overtaken"}};
  Json answer = {{"status", "solved"}, {"revision", model.revision}};
  answer.update(page_operation(PageStyle{}, results, find_head_length(description.operation.lay)));
  const std::lock_guard<std::mutex> keep(mutex_);
  solved_ = std::move(results);
  solved_text_ = model.text;
  return answer;
}

Json LiveOperation::stage(std::size_t number) const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (!solved_ || number >= solved_->stages.size()) {
    throw HttpError(404, "there is no such stage", "solve the operation first");
  }
  const std::optional<StaticResults>& lay = solved_->stages[number].lay;
  if (!lay) throw HttpError(404, "the stage has no equilibrium");
  Json answer = {{"status", "converged"}};
  answer.update(static_json(*lay));
  return answer;
}

std::string LiveOperation::report() const {
  const std::lock_guard<std::mutex> hold(mutex_);
  if (!solved_) throw HttpError(404, "the operation has not been solved");
  return page_text(operation_report_document(*solved_, solved_text_));
}

void add_operation_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveOperation& operation) {
  routes.push_back({"POST", "/api/operation",
                    [&](const HttpRequest&) { return json_answer(operation.solve(model.snapshot())); }, kLongLimit});
  routes.push_back({"GET", "/api/operation/stages/*", [&](const HttpRequest& request) {
                      return json_answer(operation.stage(parse_stage_number(request.parts[0])));
                    }});
  routes.push_back({"GET", "/api/operation/report.html", [&](const HttpRequest& request) {
                      const char* name = request.parameter("show").empty() ? "operation.html" : "";
                      return HttpAnswer{200, "text/html; charset=utf-8", operation.report(), name};
                    }});
}

}  // namespace overbend
