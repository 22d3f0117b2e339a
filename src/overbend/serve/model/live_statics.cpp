#include "serve/model/live_statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/interruption.h"
#include "base/ranges.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"
#include "report/page/json_number.h"
#include "seafiles/hydrodynamics_reader.h"
#include "serve/answers/static_json.h"
#include "serve/model/diagnose.h"
#include "study/run/static_analysis.h"
#include "study/run/warm_start.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kWarmStartMessage =
    "the equilibrium was found from the previous solution; because the pipe is loaded sideways there may be several, "
    "and a run, which starts without a previous solution, may find another";

double milliseconds_since(Clock::time_point start) {
  return seven_digits(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

Json invalid(const ModelReading& reading, const std::string& text) {
  return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, text)}};
}

std::string with_changes(const ModelText& model, const std::vector<YamlChange>& changes) {
  try {
    return edit_yaml(model.text, changes);
  } catch (const YamlEditError& error) {
    throw HttpError(422, error.what());
  }
}

/// Returns modification time and size of the files of a coupled hull.
std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> read_hull_stamps(
    const CoupledHullDescription& hull) {
  std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> stamps;
  const auto add = [&](const std::string& file) {
    std::error_code absent;
    const auto written = std::filesystem::last_write_time(file, absent);
    const auto size = absent ? 0 : std::filesystem::file_size(file, absent);
    stamps.emplace_back(absent ? std::filesystem::file_time_type() : written, absent ? 0 : size);
  };
  for (const std::string& file : hydrodynamic_files(hull.hydrodynamics)) add(file);
  add(hull.current.table_file);
  add(hull.wind.table_file);
  return stamps;
}

}  // namespace

/// True if the last solution is a suitable warm start: same model file and same number of rollers.
bool LiveStatics::is_suitable_warm_start(const LastSolution& last, const Model& model) {
  return model.description.source_file == last.file && model.supports.rollers.size() == last.rollers;
}

Json LiveStatics::solve(Model model, const StaticRequest& request) {
  // The stages of an operation are skipped while a value is dragged.
  if (request.lists) model.description.operation = {};
  std::unique_lock<std::mutex> hold(mutex_);
  std::shared_ptr<const LastSolution>& kept = request.probe ? last_probe_ : last_;
  const std::shared_ptr<const LastSolution> last = request.probe && !last_probe_ ? last_ : kept;
  hold.unlock();
  const bool near = !request.full && last && is_suitable_warm_start(*last, model);
  bool warm = near && !(model.description.has_pipe && has_lateral_load(model) && !request.lists);
  const auto start = Clock::now();
  StaticRun found = run_statics(model, warm ? &last->solution : nullptr);
  if (found.failure && near && !warm) {
    warm = true;
    model = build_model(model.description);  // restores the model after the failed attempt
    found = run_statics(model, &last->solution);
  }
  // With lateral load, an equilibrium found from a warm start may differ from that of a run.
  if (warm && model.description.has_pipe && found.results && has_lateral_load(model)) {
    found.results->findings.push_back({FindingCode::other_equilibrium_possible, kWarmStartMessage});
  }
  const double solve_ms = milliseconds_since(start);
  if (found.failure) {
    const StaticFailure& f = *found.failure;
    return {{"status", "failed"}, {"what", f.what}, {"where", f.where}, {"why", f.why}};
  }
  if (!request.lists) add_hull_results(model, *found.results);  // skipped while a value is dragged
  if (found.solution) {
    hold.lock();
    kept = std::make_shared<const LastSolution>(
        LastSolution{std::move(*found.solution), model.description.source_file, model.supports.rollers.size()});
    hold.unlock();
  }
  Json answer = {{"status", "converged"}, {"elapsed_ms", 0.0}, {"solve_ms", solve_ms}, {"warm", warm}};
  answer.update(static_json(*found.results, request.lists ? &*request.lists : nullptr));
  return answer;
}

bool LiveStatics::is_valid_tree(const Parsed& text) {
  return text.tree && text.tree->kind == YamlNode::Kind::map && !text.errors.has_errors();
}

std::shared_ptr<const LiveStatics::Parsed> LiveStatics::parsed(const ModelText& model) {
  std::unique_lock<std::mutex> hold(mutex_);
  std::shared_ptr<const Parsed> before = parsed_;
  hold.unlock();
  const auto unchanged = [&] { return !before->hull || read_hull_stamps(*before->hull) == before->hull_stamps; };
  if (before && before->text == model.text && unchanged()) return before;
  auto fresh = std::make_shared<Parsed>();
  if (std::optional<YamlNode> root = parse_yaml(model.text, model.path, fresh->errors)) {
    fresh->tree = std::make_shared<const YamlNode>(std::move(*root));
  }
  fresh->text = model.text;
  if (is_valid_tree(*fresh)) {
    const ModelReading statics_reading = read_statics_inputs(*fresh->tree, model.path);
    if (statics_reading.description && statics_reading.description->vessel.coupled) {
      const ModelReading full_reading = read_model_tree(fresh->tree, fresh->errors, model.text, model.path);
      if (full_reading.description) fresh->hull = full_reading.description->vessel.coupled;
    }
    if (fresh->hull) fresh->hull_stamps = read_hull_stamps(*fresh->hull);
  }
  hold.lock();
  parsed_ = fresh;
  return fresh;
}

/// Applies changes to the parsed tree, without writing and reading the text. Returns nothing if a change is not simple
/// or is invalid. A floating hull needs the contents of its files in statics: they are reused from the first reading of
/// the text unless a key of the vessel changes.
std::optional<Description> LiveStatics::read_changed(const Parsed& text, const ModelText& model,
                                                     const std::vector<YamlChange>& changes) {
  if (!is_valid_tree(text)) return std::nullopt;
  YamlNode root = *text.tree;
  if (!edit_tree(root, changes)) return std::nullopt;
  std::optional<Description> description = read_statics_inputs(root, model.path).description;
  if (!description || !description->vessel.coupled) return description;
  const bool of_vessel = ranges::any_of(changes, [](const YamlChange& c) { return c.path.starts_with("vessel"); });
  if (of_vessel || !text.hull) return std::nullopt;
  description->vessel.coupled = text.hull;
  return description;
}

Json LiveStatics::answer(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request) {
  const auto start = Clock::now();
  const std::shared_ptr<const Parsed> open = parsed(model);
  std::optional<Description> description = read_changed(*open, model, changes);
  if (!description) {
    const std::string text = with_changes(model, changes);
    ModelReading reading = changes.empty() && is_valid_tree(*open)
                               ? read_model_tree(open->tree, open->errors, text, model.path)
                               : read_model_text(text, model.path);
    if (!reading.description) return invalid(reading, text);
    description = std::move(reading.description);
  }
  Json answer = solve(build_model(*description), request);
  answer["elapsed_ms"] = milliseconds_since(start);
  answer["revision"] = model.revision;
  return answer;
}

Json LiveStatics::probe(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request,
                        std::uint64_t number) {
  const InterruptionScope scope([&] { return newest_ != number; });
  try {
    return answer(model, changes, request);
  } catch (const Interrupted&) {
    if (newest_ == number) throw;
    return {{"status", "overtaken"}};
  }
}

Json LiveStatics::solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticRequest& request) {
  const std::uint64_t number = ++newest_;
  try {
    return request.probe ? probe(model, changes, request, number) : answer(model, changes, request);
  } catch (const Interrupted&) {
    return {{"status", "failed"},
            {"what", fmt::format("the static analysis takes more than {} s", kShortLimit.count())},
            {"where", ""},
            {"why", "this is the time limit of the page; a static run has no limit"}};
  }
}

Json make_scene_answer(const ModelText& model) {
  const ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) return invalid(reading, model.text);
  return scene_json(build_model(*reading.description));
}

void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics) {
  routes.push_back({"POST", "/api/static", [&](const HttpRequest& request) {
                      const Json body = request.json();
                      const std::vector<YamlChange> changes = read_changes(body.value("changes", Json::array()));
                      StaticRequest wanted = {body.value("full", false), {}, body.value("probe", false)};
                      if (body.contains("lists")) wanted.lists = body["lists"].get<std::vector<std::string>>();
                      return json_answer(statics.solve(model.snapshot(), changes, wanted));
                    }});
  routes.push_back(
      {"GET", "/api/scene", [&](const HttpRequest&) { return json_answer(make_scene_answer(model.snapshot())); }});
}

}  // namespace overbend
