#include "serve/runs/run_routes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include "base/ranges.h"
#include "modelfile/study_file/study_reader.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "serve/answers/campaign_json.h"
#include "serve/model/diagnose.h"
#include "serve/model/model_fields.h"
#include "serve/runs/run_data.h"
#include "serve/runs/study_json.h"
#include "study/campaign/study_folder.h"
#include "study/campaign/study_runner.h"
#include "study/seeds/compare_variants.h"
#include "study/seeds/study.h"

namespace overbend {
namespace {

constexpr double kMaxPoints = 20000, kMaxFrames = 200;
constexpr std::size_t kMaxSeeds = 10000;
constexpr std::array<std::string_view, 5> kKinds = {"static", "dynamic", "seeds", "comparison", "study"};

double read_duration(const Json& body) {
  if (!body.contains("duration") || body["duration"].is_null()) return 0.0;
  const double duration = body["duration"].get<double>();
  if (!(duration >= kMinDuration && duration <= kMaxDuration)) {
    throw HttpError(422, fmt::format("duration: expected a time from {} s to {:g} s", kMinDuration, kMaxDuration));
  }
  return duration;
}

/// Returns the requested seeds, or those of the model.
std::vector<std::uint64_t> read_seeds(const Json& body, const Description& description) {
  std::vector<std::uint64_t> seeds;
  if (description.dynamics) seeds = description.dynamics->seeds;
  if (body.contains("seeds") && !body["seeds"].is_null()) {
    seeds.clear();
    for (const Json& seed : body["seeds"]) {
      if (!seed.is_number_unsigned()) throw HttpError(422, "seeds: expected whole numbers of at least 0");
      seeds.push_back(seed.get<std::uint64_t>());
    }
  }
  if (seeds.size() < 2 || seeds.size() > kMaxSeeds) {
    throw HttpError(422, "seeds: expected 2 to 10000 seeds",
                    "set them in the request or as analysis.dynamic.seeds of the model");
  }
  return seeds;
}

/// Returns the record of the requested run. HttpError if the request is invalid.
RunRecord read_order(const Json& body, const Description& description) {
  RunRecord order;
  order.kind = body.value("kind", "");
  order.title = description.title;
  order.duration = read_duration(body);
  order.stage = body.value("stage", "");
  if (!order.stage.empty()) {
    if (order.kind != "static" && order.kind != "dynamic") throw HttpError(422, "stage: allowed only for a single run");
    order.title += ", stage " + order.stage;
  }
  std::variant<StudyPlan, std::string> plan;
  if (order.kind == "seeds") {
    order.seeds = read_seeds(body, description);
    plan = plan_seeds(order.seeds, {});
  } else if (order.kind == "comparison") {
    order.of = body.value("of", "");
    const std::optional<ComparisonType> comparison = from_enum_name<ComparisonType>(order.of);
    if (!comparison) throw HttpError(400, "of: found '" + order.of + "', expected tensioner, contact or impacts");
    plan = plan_comparison(*comparison, description, {});
  }
  if (const auto* error = std::get_if<std::string>(&plan)) throw HttpError(422, *error);
  return order;
}

/// Returns the study of this model; HttpError with the first error if the text is invalid.
StudyDescription checked_study(const std::string& study, const std::string& path, Description&& base) {
  StudyReading reading = read_study_with_base(study, path, std::move(base));
  if (reading.study) return std::move(*reading.study);
  const std::vector<Diagnostic> list = reading.diagnostics.sorted();
  HttpError error(422, list.front().key + ": found " + list.front().found + ", expected " + list.front().expected);
  error.top_level["diagnostics"] = diagnostics_json(reading.diagnostics, study);
  throw error;
}

/// Returns the title of the study, or the model's title with the keys that vary: "tension x water depth".
std::string make_study_title(const StudyDescription& study, const std::string& model) {
  if (!study.title.empty()) return study.title;
  std::string keys;
  for (const StudyAxis& axis : study.axes) {
    std::string last = axis.key.substr(axis.key.rfind('.') + 1);
    ranges::replace(last, '_', ' ');
    keys += (keys.empty() ? "" : axis.with.empty() ? " x " : " with ") + last;
  }
  return keys.empty() ? model : model + ": " + keys;
}

HttpAnswer start(const OpenModel& model, RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const std::string kind = body.value("kind", "");
  if (ranges::find(kKinds, kind) == kKinds.end()) {
    throw HttpError(400, "kind: found '" + kind + "', expected static, dynamic, seeds, comparison or study");
  }
  const ModelText text = model.snapshot();
  ModelReading reading = read_model_text(text.text, text.path);
  if (!reading.description) {
    HttpError error(422, "the model has errors; correct them first");
    error.top_level["diagnostics"] = diagnostics_json(reading, text.text);
    throw error;
  }
  RunRecord order = read_order(body, *reading.description);
  const std::string study = kind == "study" ? body.value("study", "") : "";
  if (kind == "study") {
    order.title = make_study_title(checked_study(study, text.path, std::move(*reading.description)), order.title);
  }
  return json_answer({{"id", runs.add(text, order, study).id}});
}

/// Returns the run if it has results; HttpError 404 otherwise.
RunInfo done(const RunQueue& runs, const HttpRequest& request) {
  RunInfo run = runs.find(request.parts[0]);
  if (!run.has_results) throw HttpError(404, "the run has no results", "they are available when it is finished");
  return run;
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw HttpError(404, "the run has no " + file.filename().string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::filesystem::path find_h5(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  if (run.is_study() || run.is_campaign()) {
    throw HttpError(404, "a study has no such results", "request those of one of its cases");
  }
  return runs.folder(run) / "results.h5";
}

HttpAnswer columns(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  if (run.state == RunState::running) return json_answer(columns_json(runs.live().columns()));
  if (!run.has_results || run.is_study() || run.is_campaign()) return json_answer(Json::array());
  const std::filesystem::path h5 = find_h5(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(columns_json(read_history_columns(h5)));
}

/// Returns a history, so far or complete. For a run that waits, failed or was cancelled, returns an empty history
/// instead of an error, because the page may request it with an outdated state.
std::vector<double> history(RunQueue& runs, const RunInfo& run, const std::string& name) {
  if (run.state == RunState::running) return runs.live().values(name);
  if (!run.has_results || run.is_study() || run.is_campaign()) return {};
  const std::lock_guard hold(runs.files());
  try {
    return read_history(runs.folder(run) / "results.h5", name);
  } catch (const std::runtime_error&) {
    throw HttpError(404, "the run has no history '" + name + "'");
  }
}

HttpAnswer series(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  const double infinity = std::numeric_limits<double>::infinity();
  const SeriesWindow window{request.number("t0", -infinity), request.number("t1", infinity),
                            static_cast<std::size_t>(std::clamp(request.number("px", 1000.0), 1.0, kMaxPoints))};
  const std::vector<double> time = history(runs, run, "time");
  Json all = Json::object();
  const auto [first, last] = request.query.equal_range("name");
  for (auto name = first; name != last; ++name) {
    all[name->second] = series_json(time, history(runs, run, name->second), window);
  }
  if (all.empty()) throw HttpError(400, "the request has no 'name'");
  return json_answer(all.size() == 1 ? *all.begin() : Json{{"series", all}});
}

HttpAnswer spectrum(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  const std::string name = request.parameter("name");
  if (name.empty()) throw HttpError(400, "the request has no 'name'");
  return json_answer(spectrum_json(history(runs, run, "time"), history(runs, run, name)));
}

/// Returns the keys in which the open model differs from that of the run.
HttpAnswer changes(const OpenModel& model, const RunQueue& runs, const HttpRequest& request) {
  return json_answer({{"changed", runs.changes_since(request.parts[0], model.snapshot().text)}});
}

HttpAnswer frames(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = find_h5(runs, request);
  const auto first = static_cast<std::int64_t>(std::clamp(request.number("from", 0.0), 0.0, 1e12));
  const auto count = static_cast<std::int64_t>(std::clamp(request.number("count", kMaxFrames), 0.0, kMaxFrames));
  const std::lock_guard hold(runs.files());
  return json_answer(frames_json(h5, first, count));
}

HttpAnswer from_file(RunQueue& runs, const HttpRequest& request, Json (*read)(const std::filesystem::path&)) {
  const std::filesystem::path h5 = find_h5(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(read(h5));
}

HttpAnswer summary(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const char* file = run.is_campaign() ? "study/summary.json"
                     : run.is_study()  ? study_files(run).summary
                                       : "summary.json";
  return {200, "application/json; charset=utf-8", file_text(runs.folder(run) / file), ""};
}

/// Returns the results of a study for the page.
HttpAnswer study(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  return json_answer(study_json(run, runs.folder(run)));
}

/// Returns the file of the main table of a single run: pipe, moorings or lines.
const char* main_table(const std::filesystem::path& folder) {
  for (const char* file : {"pipe.csv", "moorings.csv", "lines.csv"}) {
    if (std::filesystem::exists(folder / file)) return file;
  }
  return "pipe.csv";
}

/// Returns the results of a study file, while it runs with the cases so far; null before its folder exists.
HttpAnswer matrix(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  if (!run.is_campaign()) throw HttpError(404, "the run is not a study of cases");
  const std::filesystem::path folder = runs.folder(run) / kStudyFolder;
  std::error_code none;
  if (!std::filesystem::exists(folder / "study.json", none)) return json_answer(nullptr);
  return json_answer(campaign_json(study_so_far(folder)));
}

HttpAnswer table(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const std::filesystem::path folder = runs.folder(run) / (run.is_campaign() ? kStudyFolder : "");
  const char* file = run.is_campaign() ? "study.csv" : run.is_study() ? study_files(run).table : main_table(folder);
  return {200, "text/csv; charset=utf-8", file_text(folder / file), run.id + ".csv"};
}

HttpAnswer report(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const std::string name = request.parameter("show").empty() ? run.id + ".html" : "";
  const std::string file = run.is_study() ? study_files(run).page : "report.html";
  if (run.is_campaign()) {
    return {200, "text/html; charset=utf-8", file_text(runs.folder(run) / kStudyFolder / file), name};
  }
  if (file.empty()) {
    throw HttpError(404, "a study of several seeds has no report", "request the report of one of its cases");
  }
  return {200, "text/html; charset=utf-8", file_text(runs.folder(run) / file), name};
}

HttpAnswer annotate(RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const RunInfo before = runs.find(request.parts[0]);
  return json_answer(
      run_json(runs.annotate(before.id, body.value("name", before.name), body.value("note", before.note))));
}

HttpAnswer scene(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = find_h5(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(run_scene_json(h5, runs.find(request.parts[0]).model_path));
}

/// Returns the model of the run; for a case that of its study.
HttpAnswer run_model(const RunQueue& runs, const HttpRequest& request) {
  RunInfo run = runs.find(request.parts[0]);
  if (!run.parent.empty()) run = runs.find(run.parent);
  const std::string text = file_text(runs.folder(run) / kModelCopy);
  const ModelReading reading = read_model_text(text, run.model_path);
  const std::string name = std::filesystem::path(run.model_path).filename().string();
  return json_answer({{"text", text}, {"name", name}, {"fields", model_fields(reading.tree.get())}});
}

HttpAnswer list(const RunQueue& runs) {
  Json all = Json::array();
  for (const RunInfo& run : runs.list()) all.push_back(run_json(run));
  return json_answer(all);
}

}  // namespace

void add_run_routes(std::vector<HttpRoute>& routes, OpenModel& model, RunQueue& runs) {
  using Request = const HttpRequest&;
  const std::size_t first = routes.size();
  routes.push_back({"POST", "/api/runs", [&](Request r) { return start(model, runs, r); }});
  routes.push_back({"GET", "/api/runs", [&](Request) { return list(runs); }});
  routes.push_back(
      {"POST", "/api/runs/*/cancel", [&](Request r) { return json_answer(run_json(runs.cancel(r.parts[0]))); }});
  routes.push_back({"POST", "/api/runs/*/annotate", [&](Request r) { return annotate(runs, r); }});
  routes.push_back({"POST", "/api/runs/*/delete", [&](Request r) {
                      runs.remove(r.parts[0]);
                      return json_answer(Json::object());
                    }});
  routes.push_back({"GET", "/api/runs/*/statics", [&](Request r) { return from_file(runs, r, run_statics_json); }});
  routes.push_back({"GET", "/api/runs/*/scene", [&](Request r) { return scene(runs, r); }});
  routes.push_back(
      {"POST", "/api/runs/*/resume", [&](Request r) { return json_answer(run_json(runs.resume(r.parts[0]))); }});
  routes.push_back({"GET", "/api/runs/*/model", [&](Request r) { return run_model(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/summary", [&](Request r) { return summary(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/matrix", [&](Request r) { return matrix(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/study", [&](Request r) { return study(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/table.csv", [&](Request r) { return table(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/columns", [&](Request r) { return columns(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/series", [&](Request r) { return series(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/spectrum", [&](Request r) { return spectrum(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/changes", [&](Request r) { return changes(model, runs, r); }});
  routes.push_back({"GET", "/api/runs/*/envelopes", [&](Request r) { return from_file(runs, r, envelopes_json); }});
  routes.push_back({"GET", "/api/runs/*/impacts", [&](Request r) { return from_file(runs, r, impacts_json); }});
  routes.push_back({"GET", "/api/runs/*/frames", [&](Request r) { return frames(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/report.html", [&](Request r) { return report(runs, r); }});
  for (std::size_t i = first; i < routes.size(); ++i) {
    if (routes[i].method == "GET") routes[i].limit = kLongLimit;  // results may take gigabytes
  }
}

}  // namespace overbend
