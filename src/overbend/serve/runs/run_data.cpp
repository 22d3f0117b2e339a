#include "serve/runs/run_data.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/ranges.h"
#include "modelfile/reading/yaml_reader.h"
#include "numerics/welch.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "results/tables/named_tables.h"
#include "serve/answers/page_fields.h"
#include "serve/answers/page_style.h"

namespace overbend {
namespace {

/// Returns the static state in the form of envelopes.
DynamicResults static_envelopes(const StaticResults& statics) {
  DynamicResults r;
  for (const Station& station : statics.stations) {
    r.station_s.push_back(station.s);
    r.static_place.push_back(station.p_W);
    r.static_tension.push_back(station.effective_tension);
    r.static_moment.push_back(station.bending_moment);
    r.static_bending_stress.push_back(station.bending_stress);
    r.static_von_mises.push_back(station.von_mises);
    r.static_strain.push_back(station.strain);
  }
  return r;
}

Json envelopes(const DynamicResults& r, bool over_time) {
  PageStyle style;
  if (!r.station_s.empty()) style.top = r.station_s.back();
  return page_envelopes(style, r, over_time);
}

}  // namespace

Json series_json(std::span<const double> time, std::span<const double> values, const SeriesWindow& window) {
  const std::size_t rows = std::min(time.size(), values.size());
  time = time.first(rows);
  const auto begin = static_cast<std::size_t>(ranges::lower_bound(time, window.from) - time.begin());
  const auto end = static_cast<std::size_t>(ranges::upper_bound(time, window.to) - time.begin());
  const std::size_t count = end > begin ? end - begin : 0;
  const std::size_t points = std::min(std::max<std::size_t>(window.points, 1), count);
  Json t = Json::array(), low = Json::array(), high = Json::array();
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t first = begin + i * count / points, last = begin + (i + 1) * count / points;
    const auto [min_value, max_value] = ranges::minmax(values.subspan(first, last - first));
    t.push_back(seven_digits(time[first]));
    low.push_back(seven_digits(min_value));
    high.push_back(seven_digits(max_value));
  }
  return {{"t", t}, {"min", low}, {"max", high}};
}

Json spectrum_json(std::span<const double> time, std::span<const double> values) {
  const std::size_t rows = std::min(time.size(), values.size());
  time = time.first(rows);
  const auto begin = static_cast<std::size_t>(ranges::lower_bound(time, 0.0) - time.begin());
  values = values.subspan(begin, rows - begin);
  const double count = static_cast<double>(values.size());
  const double step = count > 1.0 ? (time.back() - time[begin]) / (count - 1.0) : 1.0;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / std::max(count, 1.0);
  double squares = 0.0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  const PowerSpectrum spectrum = power_spectrum(values, step);
  Json frequency = Json::array(), density = Json::array();
  for (const double f : spectrum.frequency) frequency.push_back(seven_digits(f));
  for (const double d : spectrum.density) density.push_back(seven_digits(d));
  return {{"frequency", frequency},
          {"density", density},
          {"segments", spectrum.segments},
          {"std", seven_digits(std::sqrt(squares / std::max(count, 1.0)))}};
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
  if (!has_dynamic(h5)) return envelopes(static_envelopes(read_static_results(h5).results), false);
  const StoredDynamics stored = read_dynamic_results(h5);
  return envelopes(stored.results, stored.statics.results.has_pipe());
}

Json run_statics_json(const std::filesystem::path& h5) {
  Json answer = {{"status", "converged"}};
  if (!has_dynamic(h5)) {
    answer.update(static_json(read_static_results(h5).results));
    return answer;
  }
  const StoredDynamics stored = read_dynamic_results(h5);
  answer.update(static_json(stored.statics.results));
  answer["run_tables"] = tables_json(dynamic_tables(stored.statics.results, stored.results));
  return answer;
}

Json run_scene_json(const std::filesystem::path& h5, const std::string& file) {
  const std::string text = read_static_results(h5).model_text;
  std::optional<std::uint64_t> seed;
  if (has_dynamic(h5)) seed = read_dynamic_results(h5).results.seed;
  std::optional<Description> description = read_model_text(text, file).description;
  if (!description) {  // a file it refers to may no longer exist
    Diagnostics errors;
    const std::optional<YamlNode> root = parse_yaml(text, file, errors);
    if (root) description = read_statics_inputs(*root, file).description;
  }
  if (!description) throw HttpError(422, "the model of the run can no longer be read");
  return scene_json(build_model(*description), seed);
}

Json impacts_json(const std::filesystem::path& h5) {
  DynamicResults r;
  if (has_dynamic(h5)) r = read_dynamic_results(h5).results;
  const PageStyle style;
  return {{"total", r.impact_count},
          {"impacts", style.rows(r.hardest_impacts, [&](const Impact& hit) { return page_impact(style, r, hit); })}};
}

}  // namespace overbend
