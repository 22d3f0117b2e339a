#include "serve/run_routes.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "resultfiles/long_data_reader.h"
#include "serve/diagnose.h"
#include "serve/run_data.h"

namespace overbend {
namespace {

constexpr double kMostPoints = 20000, kMostFrames = 200;

HttpAnswer start(const OpenModel& model, RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const std::string kind = body.value("kind", "");
  if (kind != "static" && kind != "dynamic") {
    throw HttpFault(400, "kind: found '" + kind + "', expected static or dynamic");
  }
  double duration = 0.0;
  if (body.contains("duration") && !body["duration"].is_null()) {
    duration = body["duration"].get<double>();
    if (!(duration > 0.0 && duration <= 1e7)) throw HttpFault(422, "duration: expected a time above 0 s");
  }
  const ModelText text = model.now();
  const ModelReading reading = read_model_text(text.text, text.path);
  if (!reading.description) {
    HttpFault fault(422, "the model has errors; correct them first");
    fault.beside["diagnostics"] = diagnostics_json(reading.diagnostics, text.text);
    throw fault;
  }
  return json_answer({{"id", runs.add(text, reading.description->title, kind, duration).id}});
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
  return runs.folder(done(runs, request)) / "results.h5";
}

HttpAnswer columns(RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = runs.find(request.parts[0]);
  if (run.state == RunState::running) return json_answer(columns_json(runs.live().columns()));
  if (!run.has_results) return json_answer(Json::array());
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard<std::mutex> hold(runs.files());
  return json_answer(columns_json(read_history_columns(h5)));
}

/// A history, so far or as a whole. A run that waits, failed or was cancelled has an empty one and not a fault: a page
/// asks with its last known state, and the run may have ended since.
std::vector<double> history(RunQueue& runs, const RunInfo& run, const std::string& name) {
  if (run.state == RunState::running) return runs.live().values(name);
  if (!run.has_results) return {};
  const std::lock_guard<std::mutex> hold(runs.files());
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

HttpAnswer frames(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const auto first = static_cast<std::int64_t>(std::clamp(request.number("from", 0.0), 0.0, 1e12));
  const auto count = static_cast<std::int64_t>(std::clamp(request.number("count", kMostFrames), 0.0, kMostFrames));
  const std::lock_guard<std::mutex> hold(runs.files());
  return json_answer(frames_json(h5, first, count));
}

HttpAnswer from_file(RunQueue& runs, const HttpRequest& request, Json (*read)(const std::filesystem::path&)) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard<std::mutex> hold(runs.files());
  return json_answer(read(h5));
}

HttpAnswer summary(const RunQueue& runs, const HttpRequest& request) {
  return {200, "application/json; charset=utf-8", file_text(runs.folder(done(runs, request)) / "summary.json"), ""};
}

HttpAnswer report(const RunQueue& runs, const HttpRequest& request) {
  const RunInfo run = done(runs, request);
  return {200, "text/html; charset=utf-8", file_text(runs.folder(run) / "report.html"), run.id + ".html"};
}

HttpAnswer annotate(RunQueue& runs, const HttpRequest& request) {
  const Json body = request.json();
  const RunInfo before = runs.find(request.parts[0]);
  return json_answer(
      run_json(runs.annotate(before.id, body.value("name", before.name), body.value("note", before.note))));
}

HttpAnswer scene(RunQueue& runs, const HttpRequest& request) {
  const std::filesystem::path h5 = h5_of(runs, request);
  const std::lock_guard<std::mutex> hold(runs.files());
  return json_answer(run_scene_json(h5, runs.find(request.parts[0]).model_path));
}

HttpAnswer list(const RunQueue& runs) {
  Json all = Json::array();
  for (const RunInfo& run : runs.list()) all.push_back(run_json(run));
  return json_answer(all);
}

}  // namespace

void add_run_routes(std::vector<HttpRoute>& routes, OpenModel& model, RunQueue& runs) {
  using Request = const HttpRequest&;
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
  routes.push_back({"GET", "/api/runs/*/summary", [&](Request r) { return summary(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/columns", [&](Request r) { return columns(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/series", [&](Request r) { return series(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/envelopes", [&](Request r) { return from_file(runs, r, envelopes_json); }});
  routes.push_back({"GET", "/api/runs/*/impacts", [&](Request r) { return from_file(runs, r, impacts_json); }});
  routes.push_back({"GET", "/api/runs/*/frames", [&](Request r) { return frames(runs, r); }});
  routes.push_back({"GET", "/api/runs/*/report.html", [&](Request r) { return report(runs, r); }});
}

}  // namespace overbend
