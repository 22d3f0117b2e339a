#include "serve/runs/run_routes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <string_view>

#include "modelfile/study_file/study_reader.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "serve/answers/matrix_json.h"
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

constexpr double kMostPoints = 20000, kMostFrames = 200;
constexpr std::size_t kMostSeeds = 10000;
constexpr std::array<std::string_view, 5> kKinds = {"static", "dynamic", "seeds", "comparison", "study"};

double duration_of(const Json& body) {
  if (!body.contains("duration") || body["duration"].is_null()) return 0.0;
  const double duration = body["duration"].get<double>();
  if (!(duration >= kMinDuration && duration <= kMaxDuration)) {
    throw HttpFault(422, fmt::format("duration: expected a time from {} s to {:g} s", kMinDuration, kMaxDuration));
  }
  return duration;
}

/// The seeds asked for, else the model's.
std::vector<std::uint64_t> seeds_of(const Json& body, const Description& description) {
  std::vector<std::uint64_t> seeds;
  if (description.dynamics) seeds = description.dynamics->seeds;
  if (body.contains("seeds") && !body["seeds"].is_null()) {
    seeds.clear();
    for (const Json& seed : body["seeds"]) {
      if (!seed.is_number_unsigned()) throw HttpFault(422, "seeds: expected whole numbers from 0 on");
      seeds.push_back(seed.get<std::uint64_t>());
    }
  }
  if (seeds.size() < 2 || seeds.size() > kMostSeeds) {
    throw HttpFault(422, "seeds: expected 2 to 10000 seeds",
                    "in the request, or as analysis.dynamic.seeds of the model");
  }
  return seeds;
}

/// What a request wants to be run. HttpFault where it cannot be.
RunRecord order_of(const Json& body, const Description& description) {
  RunRecord order;
  order.kind = body.value("kind", "");
  order.title = description.title;
  order.duration = duration_of(body);
  order.stage = body.value("stage", "");
  if (!order.stage.empty()) {
    if (order.kind != "static" && order.kind != "dynamic") throw HttpFault(422, "stage: of a single run only");
    order.title += ", stage " + order.stage;
  }
  std::variant<StudyPlan, std::string> plan;
  if (order.kind == "seeds") {
    order.seeds = seeds_of(body, description);
    plan = plan_seeds(order.seeds, {});
  } else if (order.kind == "comparison") {
    order.of = body.value("of", "");
    const std::optional<ComparisonOf> of = from_word<ComparisonOf>(order.of);
    if (!of) throw HttpFault(400, "of: found '" + order.of + "', expected tensioner, contact or impacts");
    plan = plan_comparison(*of, description, {});
  }
  if (const auto* fault = std::get_if<std::string>(&plan)) throw HttpFault(422, *fault);
  return order;
}

/// The study of this model; HttpFault with the first complaint where the text is none.
StudyDescription checked_study(const std::string& study, const std::string& path, Description&& base) {
  StudyReading reading = read_study_of(study, path, std::move(base));
  if (reading.study) return std::move(*reading.study);
  const std::vector<Diagnostic> list = reading.diagnostics.sorted();
  HttpFault fault(422, list.front().key + ": found " + list.front().found + ", expected " + list.front().expected);
  fault.beside["diagnostics"] = diagnostics_json(reading.diagnostics, study);
  throw fault;
}

/// "tension x water depth": what changes, behind the model's title.
std::string title_of(const StudyDescription& study, const std::string& model) {
  if (!study.title.empty()) return study.title;
  std::string keys;
  for (const StudyAxis& axis : study.axes) {
    std::string last = axis.key.substr(axis.key.rfind('.') + 1);
    std::ranges::replace(last, '_', ' ');
    keys += (keys.empty() ? "" : axis.with.empty() ? " x " : " with ") + last;
  }
  return keys.empty() ? model : model + ": " + keys;
}

HttpAnswer start(const OpenModel& model, RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const std::string kind = body.value("kind", "");
  if (std::ranges::find(kKinds, kind) == kKinds.end()) {
    throw HttpFault(400, "kind: found '" + kind + "', expected static, dynamic, seeds, comparison or study");
  }
  const ModelText text = model.now();
  ModelReading reading = read_model_text(text.text, text.path);
  if (!reading.description) {
    HttpFault fault(422, "the model has errors; correct them first");
    fault.beside["diagnostics"] = diagnostics_json(reading, text.text);
    throw fault;
  }
  RunRecord order = order_of(body, *reading.description);
  const std::string study = kind == "study" ? body.value("study", "") : "";
  if (kind == "study") {
    order.title = title_of(checked_study(study, text.path, std::move(*reading.description)), order.title);
  }
  return json_answer({{"id", runs.add(text, order, study).id}});
}

/// The run, when it has results to be read; 404 before.
RunInfo done(const RunQueue& runs, const HttpRequest& request) {
  RunInfo run = runs.find(request.parts[0]);
  if (!run.has_results) throw HttpFault(404, "the run has no results", "they are available when it is finished");
  return run;
}

std::string file_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw HttpFault(404, "the run has no " + file.filename().string());
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::filesystem::path h5_of(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  if (run.is_study() || run.is_matrix()) throw HttpFault(404, "a study has no such results", "each of its cases has");
  return runs.folder(run) / "results.h5";
}

HttpAnswer columns(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  if (run.state == RunState::running) return json_answer(columns_json(runs.live().columns()));
  if (!run.has_results || run.is_study() || run.is_matrix()) return json_answer(Json::array());
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(columns_json(read_history_columns(h5)));
}

/// A history, so far or as a whole. A run that waits, failed or was cancelled has an empty one and not a fault: a page
/// asks with its last known state, and the run may have ended since.
std::vector<double> history(RunQueue& runs, const RunInfo& run, const std::string& name) {
  if (run.state == RunState::running) return runs.live().values(name);
  if (!run.has_results || run.is_study() || run.is_matrix()) return {};
  const std::lock_guard hold(runs.files());
  try {
    return read_history(runs.folder(run) / "results.h5", name);
  } catch (const std::runtime_error&) {
    throw HttpFault(404, "the run has no history '" + name + "'");
  }
}

HttpAnswer series(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  const double infinity = std::numeric_limits<double>::infinity();
  const SeriesWindow window{request.number("t0", -infinity), request.number("t1", infinity),
                            static_cast<std::size_t>(std::clamp(request.number("px", 1000.0), 1.0, kMostPoints))};
  const std::vector<double> time = history(runs, run, "time");
  Json all = Json::object();
  const auto [first, last] = request.query.equal_range("name");
  for (auto name = first; name != last; ++name) {
    all[name->second] = series_json(time, history(runs, run, name->second), window);
  }
  if (all.empty()) throw HttpFault(400, "the request lacks a 'name'");
  return json_answer(all.size() == 1 ? *all.begin() : Json{{"series", all}});
}

HttpAnswer spectrum(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  const std::string name = request.parameter("name");
  if (name.empty()) throw HttpFault(400, "the request lacks a 'name'");
  return json_answer(spectrum_json(history(runs, run, "time"), history(runs, run, name)));
}

/// In which keys the open model differs from that of the run.
HttpAnswer changes(const OpenModel& model, const RunQueue& runs, const HttpRequest& request) {
  return json_answer({{"changed", runs.changes_since(request.parts[0], model.now().text)}});
}

HttpAnswer frames(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const auto first = static_cast<std::int64_t>(std::clamp(request.number("from", 0.0), 0.0, 1e12));
  const auto count = static_cast<std::int64_t>(std::clamp(request.number("count", kMostFrames), 0.0, kMostFrames));
  const std::lock_guard hold(runs.files());
  return json_answer(frames_json(h5, first, count));
}

HttpAnswer from_file(RunQueue& runs, const HttpRequest& request, Json (*read)(const std::filesystem::path&)) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(read(h5));
}

HttpAnswer summary(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const char* file = run.is_matrix()  ? "study/summary.json"
                     : run.is_study() ? study_files(run).summary
                                      : "summary.json";
  return {200, "application/json; charset=utf-8", file_text(runs.folder(run) / file), ""};
}

/// Of a study, beside its table.
HttpAnswer study(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  return json_answer(study_json(run, runs.folder(run)));
}

/// Of a run by itself: that of its pipe, or of what it has in its place.
const char* main_table(const std::filesystem::path& folder) {
  for (const char* file : {"pipe.csv", "moorings.csv", "lines.csv"}) {
    if (std::filesystem::exists(folder / file)) return file;
  }
  return "pipe.csv";
}

/// Of a study file's, with the cases computed so far while it runs; null before its folder is made.
HttpAnswer matrix(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  if (!run.is_matrix()) throw HttpFault(404, "the run is none of a study file");
  const std::filesystem::path folder = runs.folder(run) / kStudyFolder;
  std::error_code none;
  if (!std::filesystem::exists(folder / "study.json", none)) return json_answer(nullptr);
  return json_answer(matrix_json(study_so_far(folder)));
}

HttpAnswer table(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const std::filesystem::path folder = runs.folder(run) / (run.is_matrix() ? kStudyFolder : "");
  const char* file = run.is_matrix() ? "study.csv" : run.is_study() ? study_files(run).table : main_table(folder);
  return {200, "text/csv; charset=utf-8", file_text(folder / file), run.id + ".csv"};
}

HttpAnswer report(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  const std::string name = request.parameter("show").empty() ? run.id + ".html" : "";
  const std::string file = run.is_study() ? study_files(run).page : "report.html";
  if (run.is_matrix()) {
    return {200, "text/html; charset=utf-8", file_text(runs.folder(run) / kStudyFolder / file), name};
  }
  if (file.empty()) throw HttpFault(404, "several seeds have no report of their own", "each of the cases has one");
  return {200, "text/html; charset=utf-8", file_text(runs.folder(run) / file), name};
}

HttpAnswer annotate(RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const RunInfo before = runs.find(request.parts[0]);
  return json_answer(
      run_json(runs.annotate(before.id, body.value("name", before.name), body.value("note", before.note))));
}

HttpAnswer scene(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard hold(runs.files());
  return json_answer(run_scene_json(h5, runs.find(request.parts[0]).model_path));
}

/// With which the run was started; of a case that of its study.
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
    if (routes[i].method == "GET") routes[i].limit = kLongLimit;  // results may be of gigabytes
  }
}

}  // namespace overbend
