#include "serve/run_data.h"

#include <algorithm>
#include <cmath>

#include "modelfile/yaml_reader.h"
#include "report/json_number.h"
#include "resultfiles/dynamic_reader.h"
#include "serve/static_json.h"

namespace overbend {
namespace {

/// Values per station in the page's order, from the tensioner on.
Json reversed(const std::vector<double>& values) {
  Json list = Json::array();
  for (auto value = values.rbegin(); value != values.rend(); ++value) list.push_back(seven_digits(*value));
  return list;
}

Json envelope(const Envelope& over_time, const std::vector<double>& before) {
  return {{"static", reversed(before)},
          {"min", reversed(over_time.min)},
          {"max", reversed(over_time.max)},
          {"mean", reversed(over_time.mean)}};
}

Json dynamic_envelopes(const DynamicResults& r) {
  std::vector<double> s, x, z;
  for (const double at : r.station_s) s.push_back(r.station_s.back() - at);
  for (const Vec3& place : r.static_place) {
    x.push_back(place.x());
    z.push_back(place.z());
  }
  return {{"s", reversed(s)},
          {"x", reversed(x)},
          {"z", reversed(z)},
          {"tension", envelope(r.effective_tension, r.static_tension)},
          {"moment", envelope(r.bending_moment, r.static_moment)},
          {"bending_stress", envelope(r.bending_stress, r.static_bending_stress)},
          {"von_mises", envelope(r.von_mises, r.static_von_mises)},
          {"strain", envelope(r.strain, r.static_strain)}};
}

template <class Value>
Json static_list(const StaticResults& r, Value value) {
  std::vector<double> values;
  for (const Station& at : r.stations) values.push_back(value(at));
  return reversed(values);
}

template <class Value>
Json static_values(const StaticResults& r, Value value) {
  return {{"static", static_list(r, value)}};
}

Json static_envelopes(const StaticResults& r) {
  std::vector<double> s;
  for (const Station& at : r.stations) s.push_back(r.stations.back().s - at.s);
  return {{"s", reversed(s)},
          {"x", static_list(r, [](const Station& at) { return at.p_W.x(); })},
          {"z", static_list(r, [](const Station& at) { return at.p_W.z(); })},
          {"tension", static_values(r, [](const Station& at) { return at.effective_tension; })},
          {"moment", static_values(r, [](const Station& at) { return at.bending_moment; })},
          {"bending_stress", static_values(r, [](const Station& at) { return at.bending_stress; })},
          {"von_mises", static_values(r, [](const Station& at) { return at.von_mises; })},
          {"strain", static_values(r, [](const Station& at) { return at.strain; })}};
}

/// Position of a roller, in words.
Json roller_place(const DynamicResults& r, int roller) {
  for (const SupportDynamics& box : r.supports) {
    for (const RollerDynamics& one : box.rollers) {
      if (one.roller == roller) {
        return {{"support", box.name}, {"row", one.row}, {"position", word(one.position)}};
      }
    }
  }
  return {{"support", ""}, {"row", 0}, {"position", ""}};
}

}  // namespace

Json series_json(std::span<const double> time, std::span<const double> values, const SeriesWindow& window) {
  const std::size_t rows = std::min(time.size(), values.size());
  time = time.first(rows);
  const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(time, window.from) - time.begin());
  const auto end = static_cast<std::size_t>(std::ranges::upper_bound(time, window.to) - time.begin());
  const std::size_t count = end > begin ? end - begin : 0;
  const std::size_t points = std::min(std::max<std::size_t>(window.points, 1), count);
  Json t = Json::array(), low = Json::array(), high = Json::array();
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t first = begin + i * count / points, last = begin + (i + 1) * count / points;
    const auto [least, greatest] = std::ranges::minmax(values.subspan(first, last - first));
    t.push_back(seven_digits(time[first]));
    low.push_back(seven_digits(least));
    high.push_back(seven_digits(greatest));
  }
  return {{"t", t}, {"min", low}, {"max", high}};
}

Json columns_json(const std::vector<HistoryColumn>& columns) {
  Json list = Json::array();
  for (const HistoryColumn& column : columns) {
    if (column.name == "time") continue;
    list.push_back({{"name", column.name}, {"unit", column.units}, {"text", column.description}});
  }
  return list;
}

Json envelopes_json(const std::filesystem::path& h5) {
  return has_dynamic(h5) ? dynamic_envelopes(read_dynamic_results(h5).results)
                         : static_envelopes(read_static_results(h5).results);
}

Json run_statics_json(const std::filesystem::path& h5) {
  Json answer = {{"status", "converged"}};
  answer.update(
      static_json(has_dynamic(h5) ? read_dynamic_results(h5).statics.results : read_static_results(h5).results));
  return answer;
}

Json run_scene_json(const std::filesystem::path& h5, const std::string& file) {
  std::string text;
  std::optional<std::uint64_t> seed;
  if (has_dynamic(h5)) {
    StoredDynamics stored = read_dynamic_results(h5);
    text = std::move(stored.statics.model_text);
    seed = stored.results.seed;
  } else {
    text = read_static_results(h5).model_text;
  }
  std::optional<Description> description = read_model_text(text, file).description;
  if (!description) {  // a file that it mentions may have gone
    Diagnostics faults;
    const std::optional<YamlNode> root = parse_yaml(text, file, faults);
    if (root) description = read_still_model(*root, file).description;
  }
  if (!description) throw HttpFault(422, "the model of the run can no longer be read");
  return scene_json(build_model(*description), seed);
}

Json impacts_json(const std::filesystem::path& h5) {
  Json list = Json::array();
  if (!has_dynamic(h5)) return {{"total", 0}, {"impacts", list}};
  const DynamicResults r = read_dynamic_results(h5).results;
  for (const Impact& impact : r.hardest_impacts) {
    Json item = {{"time", seven_digits(impact.time)}};
    item.update(roller_place(r, impact.roller));
    item["peak_force"] = seven_digits(impact.peak_force);
    item["approach_velocity"] = seven_digits(impact.approach_velocity);
    item["duration"] = seven_digits(impact.duration);
    item["impulse"] = seven_digits(impact.impulse);
    item["dent_depth"] = seven_digits(impact.dent_depth);
    item["line_load"] = seven_digits(impact.line_load);
    list.push_back(std::move(item));
  }
  return {{"total", r.impact_count}, {"impacts", list}};
}

}  // namespace overbend
