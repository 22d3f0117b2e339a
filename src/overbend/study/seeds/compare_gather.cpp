#include "study/seeds/compare_gather.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "model/site/wave_groups.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "resultfiles/dynamic/long_data_reader.h"
#include "study/run/seeds_gather.h"

namespace overbend {
namespace {

/// A compared quantity and the function that evaluates it.
struct Rule {
  SeedQuantity quantity;
  double (*value)(const DynamicResults&);
};

using Results = DynamicResults;

std::vector<Rule> tensioner_rules() {
  return {
      {{"tension_mean", "N", "Mean tension at the tensioner"},
       [](const Results& r) { return r.tensioner.tension.mean; }},
      {{"tension_std", "N", "Standard deviation of the tension"},
       [](const Results& r) { return r.tensioner.tension.std; }},
      {{"tension_min", "N", "Minimum tension"}, [](const Results& r) { return r.tensioner.tension.min; }},
      {{"tension_max", "N", "Maximum tension"}, [](const Results& r) { return r.tensioner.tension.max; }},
      {{"time_out_of_range", "s", "Time out of the operational range"},
       [](const Results& r) { return r.tensioner.time_out_of_range; }},
      {{"time_at_limit", "s", "Time at its travel limit"}, [](const Results& r) { return r.tensioner.time_at_limit; }},
      {{"largest_travel", "m", "Largest travel in either direction"},
       [](const Results& r) { return std::max(std::abs(r.tensioner.travel.min), std::abs(r.tensioner.travel.max)); }},
      {{"pay_out_count", "1", "Number of pay-outs"},
       [](const Results& r) { return static_cast<double>(r.tensioner.pay_out_count); }},
      {{"haul_in_count", "1", "Number of haul-ins"},
       [](const Results& r) { return static_cast<double>(r.tensioner.haul_in_count); }},
      {{"limit_count", "1", "Number of times at its travel limit"},
       [](const Results& r) { return static_cast<double>(r.tensioner.limit_count); }},
  };
}

/// Maximum of a member over all rollers.
double max_over_rollers(const Results& results, double RollerDynamics::*member) {
  double max = 0.0;
  for (const SupportDynamics& box : results.supports) {
    for (const RollerDynamics& roller : box.rollers) max = std::max(max, roller.*member);
  }
  return max;
}

double boxes_carrying(const Results& results) {
  double sum = 0.0;
  for (const SupportDynamics& box : results.supports) sum += box.contact_share;
  return sum;
}

std::vector<Rule> contact_rules() {
  return {
      {{"boxes_carrying", "1", "Boxes that carry, on average"}, boxes_carrying},
      {{"boxes_always_carrying", "1", "Boxes that always carry"},
       [](const Results& r) {
         return static_cast<double>(std::count_if(r.supports.begin(), r.supports.end(),
                                                  [](const SupportDynamics& box) { return box.contact_share >= 1.0; }));
       }},
      {{"boxes_never_carrying", "1", "Boxes that never carry"},
       [](const Results& r) {
         return static_cast<double>(std::count_if(r.supports.begin(), r.supports.end(),
                                                  [](const SupportDynamics& box) { return box.contact_share <= 0.0; }));
       }},
      {{"largest_dent_depth", "m", "Deepest dent of bare steel"},
       [](const Results& r) { return max_over_rollers(r, &RollerDynamics::dent_depth); }},
      {{"largest_line_load", "N/m", "Largest line load on the coating"},
       [](const Results& r) { return max_over_rollers(r, &RollerDynamics::line_load); }},
  };
}

std::vector<Rule> make_rules(ComparisonType of) {
  return of == ComparisonType::tensioner ? tensioner_rules() : contact_rules();
}

/// Start of the detailed view: five wave periods before the end, in whole seconds; one minute in calm water.
double find_detail_start(const WaveGroups& waves, double duration) {
  constexpr double kPeriods = 5.0;
  const double period = max_period(waves);
  return std::max(0.0, duration - (period > 0.0 ? std::ceil(kPeriods * period) : 60.0));
}

void read_tensioner(ComparedRun& run, const std::filesystem::path& h5, double from) {
  const std::vector<double> time = read_history(h5, "time");
  const std::vector<double> tension = read_history(h5, "tensioner/tension");
  const std::vector<double> travel = read_history(h5, "tensioner/travel");
  run.states = tensioner_spans(time, read_history(h5, "tensioner/state"));
  const auto first = std::lower_bound(time.begin(), time.end(), from) - time.begin();
  run.close = {{time.begin() + first, time.end()},
               {tension.begin() + first, tension.end()},
               {travel.begin() + first, travel.end()}};
}

ComparedBox compared_box(const SupportDynamics& box) {
  ComparedBox out{box.contact_share, box.static_reaction, box.reaction.mean, box.reaction.max};
  for (const RollerDynamics& roller : box.rollers) {
    out.peak_force = std::max(out.peak_force, roller.reaction.max);
    out.dent_depth = std::max(out.dent_depth, roller.dent_depth);
    out.line_load = std::max(out.line_load, roller.line_load);
    if (roller.position != RollerPosition::bottom) continue;
    out.row_share.push_back(roller.contact_share);
    out.row_peak.push_back(roller.reaction.max);
  }
  return out;
}

std::vector<ComparedBoxes> compared_boxes(const std::vector<ComparedRun>& runs) {
  std::vector<ComparedBoxes> boxes;
  const std::vector<SupportDynamics>& first = runs.front().results.supports;
  for (std::size_t i = 0; i < first.size(); ++i) {
    ComparedBoxes box{first[i].name, first[i].stinger, {}};
    for (const ComparedRun& run : runs) box.runs.push_back(compared_box(run.results.supports.at(i)));
    boxes.push_back(std::move(box));
  }
  return boxes;
}

std::vector<double> compute_values(const std::vector<Rule>& rules, const StaticResults& statics,
                                   const Results& results) {
  std::vector<double> values;
  for (const Rule& rule : rules) values.push_back(rule.value(results));
  const std::vector<double> key = seed_values(statics, results);
  values.insert(values.end(), key.begin(), key.end());
  return values;
}

}  // namespace

std::vector<TensionerSpan> tensioner_spans(const std::vector<double>& time, const std::vector<double>& state) {
  if (time.size() != state.size()) throw std::invalid_argument("tensioner_spans: time and state differ in length");
  std::vector<TensionerSpan> spans;
  for (std::size_t i = 0; i < time.size(); ++i) {
    const int value = static_cast<int>(std::lround(state[i]));
    if (!spans.empty()) spans.back().to = time[i];
    if (spans.empty() || spans.back().state != value) spans.push_back({time[i], time[i], value});
  }
  return spans;
}

Comparison gather_comparison(ComparisonType of, const Description& description, const StaticResults& statics,
                             const std::vector<FinishedVariant>& variants) {
  const DynamicSettings& settings = *description.dynamics;
  Comparison all;
  all.of = of;
  all.duration = settings.duration;
  all.build_up = settings.build_up;
  all.detail_start = find_detail_start(description.environment.waves, settings.duration);
  const std::vector<Rule> rules = make_rules(of);
  for (const Rule& rule : rules) all.quantities.push_back(rule.quantity);
  const std::vector<SeedQuantity> key = seed_quantities(statics);
  all.quantities.insert(all.quantities.end(), key.begin(), key.end());
  for (const FinishedVariant& variant : variants) {
    const std::filesystem::path h5 = variant.folder / "results.h5";
    ComparedRun run{variant.name, variant.label, read_dynamic_results(h5).results};
    run.values = compute_values(rules, statics, run.results);
    if (of == ComparisonType::tensioner) read_tensioner(run, h5, all.detail_start);
    all.runs.push_back(std::move(run));
  }
  if (of != ComparisonType::tensioner) all.boxes = compared_boxes(all.runs);
  return all;
}

}  // namespace overbend
