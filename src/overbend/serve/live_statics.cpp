#include "serve/live_statics.h"

#include <algorithm>
#include <chrono>
#include <filesystem>

#include "modelfile/yaml_edit.h"
#include "modelfile/yaml_reader.h"
#include "report/json_number.h"
#include "seafiles/hydrodynamics_reader.h"
#include "serve/diagnose.h"
#include "serve/static_json.h"
#include "study/lay_beside.h"
#include "study/model_statics.h"

namespace overbend {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kFromTheLast =
    "the equilibrium was found from the last one; something pushes the pipe sideways, so that there may be several, "
    "and a run, which finds its own from nothing, may have another";

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
bool LiveStatics::close_to_last(const Model& model) const {
  return last_.has_value() && model.description.source_file == last_file_ &&
         model.supports.rollers.size() == last_rollers_;
}

Json LiveStatics::solve(Model model, const StaticWish& wish) {
  // While a value is dragged the stages of an operation can wait.
  if (wish.lists) model.description.operation = {};
  const bool near = !wish.full && close_to_last(model);
  bool warm = near && !(model.description.has_pipe && pushed_sideways(model) && !wish.lists);
  const auto start = Clock::now();
  ModelStatics found = solve_model(model, warm ? &*last_ : nullptr);
  if (found.failure && near && !warm) {
    warm = true;
    model = build_model(model.description);  // as it was before the attempt
    found = solve_model(model, &*last_);
  }
  // Found only from the last one, a lay that is pushed sideways is not the one that a run would find.
  if (warm && found.lay && pushed_sideways(model)) found.lay->warnings.emplace_back(kFromTheLast);
  const double solve_ms = milliseconds_since(start);
  if (found.failure) {
    const StaticFailure& f = *found.failure;
    return {{"status", "failed"}, {"what", f.what}, {"where", f.where}, {"why", f.why}};
  }
  last_ = std::move(found.solution);
  last_file_ = model.description.source_file;
  last_rollers_ = model.supports.rollers.size();
  Json answer = {{"status", "converged"}, {"elapsed_ms", 0.0}, {"solve_ms", solve_ms}, {"warm", warm}};
  answer.update(found.lines      ? static_json(*found.lines)
                : found.moorings ? static_json(*found.moorings)
                                 : static_json(*found.lay, wish.lists ? &*wish.lists : nullptr));
  return answer;
}

void LiveStatics::parse(const ModelText& model) {
  if (parsed_ && parsed_text_ == model.text && (!hull_ || stamps_of(*hull_) == hull_stamps_)) return;
  Diagnostics faults;
  parsed_ = parse_yaml(model.text, model.path, faults);
  parsed_text_ = model.text;
  hull_.reset();
  if (faults.has_errors()) parsed_.reset();
  if (!parsed_ || parsed_->kind != YamlNode::Kind::map) return;
  const ModelReading still = read_still_model(*parsed_, model.path);
  if (!still.description || !still.description->vessel.coupled) return;
  const ModelReading whole = read_model_text(model.text, model.path);
  if (whole.description) hull_ = whole.description->vessel.coupled;
  if (hull_) hull_stamps_ = stamps_of(*hull_);
}

/// The short way, without writing and reading the text; nothing where the change is not a simple one or at fault. A
/// hull that floats free needs its files in statics: they are kept from the first reading of the text, as long as
/// nothing of the vessel changes, which they might not fit any more.
std::optional<Description> LiveStatics::read_changed(const ModelText& model, const std::vector<YamlChange>& changes) {
  parse(model);
  if (!parsed_ || parsed_->kind != YamlNode::Kind::map) return std::nullopt;
  YamlNode root = *parsed_;
  if (!edit_tree(root, changes)) return std::nullopt;
  std::optional<Description> description = read_still_model(root, model.path).description;
  if (!description || !description->vessel.coupled) return description;
  const bool of_vessel = std::ranges::any_of(changes, [](const YamlChange& c) { return c.path.starts_with("vessel"); });
  if (of_vessel || !hull_) return std::nullopt;
  description->vessel.coupled = hull_;
  return description;
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
