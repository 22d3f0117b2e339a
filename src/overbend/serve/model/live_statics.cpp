#include "serve/model/live_statics.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "base/interruption.h"
#include "modelfile/reading/yaml_reader.h"
#include "modelfile/yaml/yaml_edit.h"
#include "report/page/json_number.h"
#include "seafiles/hydrodynamics_reader.h"
#include "serve/answers/static_json.h"
#include "serve/model/diagnose.h"
#include "study/run/lay_beside.h"
#include "study/run/static_run.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kFromTheLast =
    "the equilibrium was found from the last one; something pushes the pipe sideways, so that there may be several, "
    "and a run, which finds its own from nothing, may have another";

double milliseconds_since(Clock::time_point start) {
  return seven_digits(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
}

Json invalid(const ModelReading& reading, const std::string& text) {
  return {{"status", "invalid"}, {"diagnostics", diagnostics_json(reading, text)}};
}

std::string with_changes(const ModelText& model, const std::vector<YamlChange>& changes) {
  try {
    return edit_yaml(model.text, changes);
  } catch (const YamlEditFault& fault) {
    throw HttpFault(422, fault.what());
  }
}

/// Of the files that a hull is made from: when they were last written, and how long they are.
std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> stamps_of(const CoupledHullDescription& hull) {
  std::vector<std::pair<std::filesystem::file_time_type, std::uintmax_t>> stamps;
  const auto add = [&](const std::string& file) {
    std::error_code absent;
    const auto written = std::filesystem::last_write_time(file, absent);
    const auto size = absent ? 0 : std::filesystem::file_size(file, absent);
    stamps.emplace_back(absent ? std::filesystem::file_time_type() : written, absent ? 0 : size);
  };
  for (const char* ending : {"", ".1", ".2", ".3", ".7", ".8", ".9", ".hst"}) {
    add(hydrodynamics_stem(hull.hydrodynamics) + ending);
  }
  add(hull.current.table_file);
  add(hull.wind.table_file);
  return stamps;
}

}  // namespace

/// Another file or another set of rollers is another lay: nothing to start from.
bool LiveStatics::close_by(const Last& last, const Model& model) {
  return model.description.source_file == last.file && model.supports.rollers.size() == last.rollers;
}

Json LiveStatics::solve(Model model, const StaticWish& wish) {
  // While a value is dragged the stages of an operation can wait.
  if (wish.lists) model.description.operation = {};
  std::unique_lock<std::mutex> hold(mutex_);
  std::shared_ptr<const Last>& kept = wish.probe ? last_probe_ : last_;
  const std::shared_ptr<const Last> last = wish.probe && !last_probe_ ? last_ : kept;
  hold.unlock();
  const bool near = !wish.full && last && close_by(*last, model);
  bool warm = near && !(model.description.has_pipe && pushed_sideways(model) && !wish.lists);
  const auto start = Clock::now();
  StaticRun found = run_statics(model, warm ? &last->solution : nullptr);
  if (found.failure && near && !warm) {
    warm = true;
    model = build_model(model.description);  // as it was before the attempt
    found = run_statics(model, &last->solution);
  }
  // Found only from the last one, a lay that is pushed sideways is not the one that a run would find.
  if (warm && model.description.has_pipe && found.results && pushed_sideways(model)) {
    found.results->findings.push_back({FindingCode::other_equilibrium_possible, kFromTheLast});
  }
  const double solve_ms = milliseconds_since(start);
  if (found.failure) {
    const StaticFailure& f = *found.failure;
    return {{"status", "failed"}, {"what", f.what}, {"where", f.where}, {"why", f.why}};
  }
  if (!wish.lists) tell_hull(model, *found.results);  // while a value is dragged it can wait
  if (found.solution) {
    hold.lock();
    kept = std::make_shared<const Last>(
        Last{std::move(*found.solution), model.description.source_file, model.supports.rollers.size()});
    hold.unlock();
  }
  Json answer = {{"status", "converged"}, {"elapsed_ms", 0.0}, {"solve_ms", solve_ms}, {"warm", warm}};
  answer.update(static_json(*found.results, wish.lists ? &*wish.lists : nullptr));
  return answer;
}

bool LiveStatics::is_sound(const Parsed& text) {
  return text.tree && text.tree->kind == YamlNode::Kind::map && !text.faults.has_errors();
}

std::shared_ptr<const LiveStatics::Parsed> LiveStatics::parsed(const ModelText& model) {
  std::unique_lock<std::mutex> hold(mutex_);
  std::shared_ptr<const Parsed> before = parsed_;
  hold.unlock();
  const auto unchanged = [&] { return !before->hull || stamps_of(*before->hull) == before->hull_stamps; };
  if (before && before->text == model.text && unchanged()) return before;
  auto fresh = std::make_shared<Parsed>();
  if (std::optional<YamlNode> root = parse_yaml(model.text, model.path, fresh->faults)) {
    fresh->tree = std::make_shared<const YamlNode>(std::move(*root));
  }
  fresh->text = model.text;
  if (is_sound(*fresh)) {
    const ModelReading still = read_still_model(*fresh->tree, model.path);
    if (still.description && still.description->vessel.coupled) {
      const ModelReading whole = read_model_tree(fresh->tree, fresh->faults, model.text, model.path);
      if (whole.description) fresh->hull = whole.description->vessel.coupled;
    }
    if (fresh->hull) fresh->hull_stamps = stamps_of(*fresh->hull);
  }
  hold.lock();
  parsed_ = fresh;
  return fresh;
}

/// The short way, without writing and reading the text; nothing where the change is not a simple one or at fault. A
/// hull that floats free needs its files in statics: they are kept from the first reading of the text, as long as
/// nothing of the vessel changes, which they might not fit any more.
std::optional<Description> LiveStatics::read_changed(const Parsed& text, const ModelText& model,
                                                     const std::vector<YamlChange>& changes) {
  if (!is_sound(text)) return std::nullopt;
  YamlNode root = *text.tree;
  if (!edit_tree(root, changes)) return std::nullopt;
  std::optional<Description> description = read_still_model(root, model.path).description;
  if (!description || !description->vessel.coupled) return description;
  const bool of_vessel = std::ranges::any_of(changes, [](const YamlChange& c) { return c.path.starts_with("vessel"); });
  if (of_vessel || !text.hull) return std::nullopt;
  description->vessel.coupled = text.hull;
  return description;
}

Json LiveStatics::answer(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish) {
  const auto start = Clock::now();
  const std::shared_ptr<const Parsed> open = parsed(model);
  std::optional<Description> description = read_changed(*open, model, changes);
  if (!description) {
    const std::string text = with_changes(model, changes);
    ModelReading reading = changes.empty() && is_sound(*open)
                               ? read_model_tree(open->tree, open->faults, text, model.path)
                               : read_model_text(text, model.path);
    if (!reading.description) return invalid(reading, text);
    description = std::move(reading.description);
  }
  Json answer = solve(build_model(*description), wish);
  answer["elapsed_ms"] = milliseconds_since(start);
  answer["revision"] = model.revision;
  return answer;
}

Json LiveStatics::probe(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish,
                        std::uint64_t number) {
  const InterruptionScope scope([&] { return newest_ != number; });
  try {
    return answer(model, changes, wish);
  } catch (const Interrupted&) {
    if (newest_ == number) throw;
    return {{"status", "overtaken"}};
  }
}

Json LiveStatics::solve(const ModelText& model, const std::vector<YamlChange>& changes, const StaticWish& wish) {
  const std::uint64_t number = ++newest_;
  try {
    return wish.probe ? probe(model, changes, wish, number) : answer(model, changes, wish);
  } catch (const Interrupted&) {
    return {{"status", "failed"},
            {"what", fmt::format("the statics take more than {} s", kShortLimit.count())},
            {"where", ""},
            {"why", "the page waits no longer; a run of statics takes as long as it needs"}};
  }
}

Json scene_of(const ModelText& model) {
  const ModelReading reading = read_model_text(model.text, model.path);
  if (!reading.description) return invalid(reading, model.text);
  return scene_json(build_model(*reading.description));
}

void add_static_routes(std::vector<HttpRoute>& routes, OpenModel& model, LiveStatics& statics) {
  routes.push_back({"POST", "/api/static", [&](const HttpRequest& request) {
                      const Json body = request.json();
                      const std::vector<YamlChange> changes = changes_of(body.value("changes", Json::array()));
                      StaticWish wish = {body.value("full", false), {}, body.value("probe", false)};
                      if (body.contains("lists")) wish.lists = body["lists"].get<std::vector<std::string>>();
                      return json_answer(statics.solve(model.now(), changes, wish));
                    }});
  routes.push_back({"GET", "/api/scene", [&](const HttpRequest&) { return json_answer(scene_of(model.now())); }});
}

}  // namespace overbend
