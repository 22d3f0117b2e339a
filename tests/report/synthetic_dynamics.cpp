#include "report/synthetic_dynamics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/constants.h"

namespace overbend::testing {
namespace {

constexpr double kDuration = 3600.0, kBuildUp = 60.0;
constexpr std::size_t kStretches = 2000;
constexpr int kComponents = 40;

double frequency(int component) {
  return 0.045 + 0.004 * component;  // [Hz]
}

/// Variance density over frequency, peaked at 1 / 12.9 s.
double density(double f) {
  const double ratio = f * 12.9;
  return f > 0.0 ? std::pow(ratio, -5.0) * std::exp(-1.25 * std::pow(ratio, -4.0)) : 0.0;
}

/// Irregular waves of unit standard deviation, with a phase shift of its own for each quantity.
double waves(double time, double shift) {
  double sum = 0.0, variance = 0.0;
  for (int i = 0; i < kComponents; ++i) {
    const double a = std::sqrt(density(frequency(i)));
    variance += 0.5 * a * a;
    sum += a * std::cos(2.0 * std::numbers::pi * frequency(i) * time + 2.4 * i * i + shift * (1.0 + 0.05 * i));
  }
  const double ramp = time >= 0.0 ? 1.0 : 0.5 * (1.0 + std::cos(std::numbers::pi * time / kBuildUp));
  return ramp * sum / std::sqrt(variance);
}

SummaryStatistics around(double mean, double std) {
  return {mean - 3.1 * std, mean + 3.4 * std, mean, std};
}

/// Greatest of the region at each instant lies above the static value.
SummaryStatistics above(double value, double share) {
  return {value * (1.0 - 0.2 * share), value * (1.0 + share), value * (1.0 + 0.2 * share), 0.25 * share * value};
}

Envelope envelope(const std::vector<double>& values, double share, double more) {
  Envelope out;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double width = share * std::abs(values[i]) * (1.0 + 0.4 * std::sin(0.11 * static_cast<double>(i))) + more;
    out.min.push_back(values[i] - width < 0.0 ? 0.0 : values[i] - width);
    out.max.push_back(values[i] + 1.2 * width);
    out.mean.push_back(values[i] + 0.05 * width);
    out.std.push_back(0.3 * width);
  }
  return out;
}

void add_history(DynamicResults& r, const std::string& name, const std::string& units, const std::string& description,
                 double mean, double std, double floor = -1e300) {
  HistorySummary out{name, units, description, around(mean, std), {}, {}};
  out.over_time.min = std::max(out.over_time.min, floor);
  const double shift = static_cast<double>(r.histories.size());
  const double stretch = (kDuration + kBuildUp) / static_cast<double>(kStretches);
  for (std::size_t k = 0; k < kStretches; ++k) {
    double low = 1e300, high = -1e300;
    for (int part = 0; part <= 4; ++part) {
      const double time = -kBuildUp + stretch * (static_cast<double>(k) + 0.25 * part);
      const double value = std::max(mean + std * waves(time, shift), floor);
      low = std::min(low, value);
      high = std::max(high, value);
    }
    out.low.push_back(low);
    out.high.push_back(high);
  }
  r.histories.push_back(std::move(out));
}

void add_spectrum(DynamicResults& r, const std::string& name, const std::string& units, double std) {
  Spectrum out{name, units, {}, {}};
  for (int i = 0; i < 513; ++i) {
    const double f = i / 512.0;  // to the Nyquist frequency of two rows per second
    out.frequency.push_back(f);
    out.density.push_back(std * std * 12.9 * density(f) * (1.0 + 0.3 * std::sin(1.7 * i)));
  }
  r.spectra.push_back(std::move(out));
}

void fill_stations(DynamicResults& r, const StaticResults& statics) {
  for (const Station& station : statics.stations) {
    r.station_s.push_back(station.s);
    r.static_tension.push_back(station.effective_tension);
    r.static_moment.push_back(station.bending_moment);
    r.static_bending_stress.push_back(station.bending_stress);
    r.static_von_mises.push_back(station.von_mises);
    r.static_strain.push_back(station.strain);
    r.static_place.push_back(station.p_W);
  }
  r.effective_tension = envelope(r.static_tension, 0.12, 3e3);
  r.bending_moment = envelope(r.static_moment, 0.09, 4e3);
  r.bending_stress = envelope(r.static_bending_stress, 0.09, 4e6);
  r.von_mises = envelope(r.static_von_mises, 0.1, 4e6);
  r.strain = envelope(r.static_strain, 0.09, 2e-5);
  const auto places = [&](int axis) {
    std::vector<double> values;
    for (const Station& station : statics.stations) values.push_back(station.p_W(axis));
    return envelope(values, 0.0, 0.4);
  };
  r.x = places(0);
  r.y = places(1);
  r.z = places(2);
}

/// The largest of the envelope between two stations.
DynamicExtreme extreme(const DynamicResults& r, const Envelope& envelope, double before, double from, double to,
                       double time) {
  DynamicExtreme out;
  for (std::size_t i = 0; i < r.station_s.size(); ++i) {
    if (r.station_s[i] >= from && r.station_s[i] <= to && envelope.max[i] > out.over_time.max) {
      out = {above(before, envelope.max[i] / before - 1.0), r.station_s[i], time, r.static_place[i]};
    }
  }
  return out;
}

DynamicRegion region(const DynamicResults& r, const RegionResult& before, double from, double to) {
  return {extreme(r, r.bending_moment, before.bending_moment.value, from, to, 1204.5),
          extreme(r, r.bending_stress, before.bending_stress.value, from, to, 1204.5),
          extreme(r, r.von_mises, before.von_mises.value, from, to, 1204.6),
          extreme(r, r.strain, before.strain.value, from, to, 2822.1)};
}

RollerDynamics roller_dynamics(const RollerResult& before, int index, int box, int row, bool calm) {
  RollerDynamics r;
  r.roller = index;
  r.box = box;
  r.row = row;
  r.position = before.position;
  r.static_reaction = before.reaction;
  r.static_separation = before.separation;
  const bool loses = !calm && (index % 3 == 0 || before.reaction < 8e3);
  if (before.reaction > 0.0) {
    r.reaction = around(before.reaction, 0.2 * before.reaction);
    r.contact_share = loses ? 0.62 + 0.3 * std::sin(index) : 1.0;
  } else if (!calm && index % 4 != 0) {
    r.contact_share = 0.12 + 0.1 * std::sin(index);
    r.reaction = {0.0, 14e3, 500.0, 1500.0};
  }
  if (loses) r.reaction.min = 0.0;
  r.separation = {std::min(before.separation, 0.0) - 1e-4, before.separation + (loses ? 0.03 : 0.0005),
                  before.separation + 0.002, 0.004};
  if (r.contact_share > 0.0 && r.contact_share < 1.0) {
    r.impact_count = 20 + index;
    r.max_approach_velocity = 0.1 + 0.002 * index;
    r.max_impact_force = 0.9 * r.reaction.max;
    r.max_impulse = 0.08 * r.max_impact_force;
  }
  r.dent_depth = 1e-4 * std::pow(r.reaction.max / 50e3, 2.0);
  r.line_load = r.reaction.max / 0.35;
  return r;
}

void fill_supports(DynamicResults& r, const StaticResults& statics, bool calm) {
  int index = 0;
  for (std::size_t b = 0; b < statics.supports.size(); ++b) {
    const SupportResult& before = statics.supports[b];
    SupportDynamics box;
    box.name = before.name;
    box.stinger = before.stinger;
    box.s = before.s;
    box.static_reaction = before.reaction;
    box.static_separation = before.separation;
    box.reaction = around(before.reaction, 0.15 * before.reaction);
    box.reaction_over_time = {box.reaction.mean, box.reaction.mean + box.reaction.std,
                              box.reaction.mean + 2.3 * box.reaction.std};
    box.vertical = around(before.vertical, 0.15 * before.vertical);
    box.longitudinal = around(before.longitudinal, 500.0);
    box.lateral = around(before.lateral, 2e3);
    box.separation = {before.separation - 0.001, before.separation + 0.02, before.separation + 0.001, 0.003};
    for (std::size_t row = 0; row < before.rows.size(); ++row) {
      for (const RollerResult& roller : before.rows[row].rollers) {
        box.rollers.push_back(roller_dynamics(roller, index++, static_cast<int>(b), static_cast<int>(row), calm));
        box.contact_share = std::max(box.contact_share, box.rollers.back().contact_share);
        box.impact_count += box.rollers.back().impact_count;
      }
    }
    r.impact_count += box.impact_count;
    r.supports.push_back(std::move(box));
  }
}

void fill_impacts(DynamicResults& r) {
  std::vector<const RollerDynamics*> hit;
  for (const SupportDynamics& box : r.supports) {
    for (const RollerDynamics& roller : box.rollers) {
      if (roller.impact_count > 0) hit.push_back(&roller);
    }
  }
  for (std::size_t i = 0; i < 200 && !hit.empty(); ++i) {
    const RollerDynamics& roller = *hit[(7 * i) % hit.size()];
    const double velocity = 0.02 + 0.2 * std::pow(std::fmod(0.618034 * static_cast<double>(i), 1.0), 2.0);
    Impact impact{roller.roller, std::fmod(271.3 * static_cast<double>(i), kDuration), velocity, 3e5 * velocity, 0.18};
    impact.impulse = 0.5 * impact.peak_force * impact.duration;
    impact.dent_depth = 1e-4 * std::pow(impact.peak_force / 50e3, 2.0);
    impact.line_load = impact.peak_force / 0.35;
    r.hardest_impacts.push_back(impact);
  }
  std::sort(r.hardest_impacts.begin(), r.hardest_impacts.end(),
            [](const Impact& a, const Impact& b) { return a.peak_force > b.peak_force; });
}

void fill_histories(DynamicResults& r, const StaticResults& statics) {
  add_history(r, "elevation", "m", "Water surface above the mean position of the stern shoe", 0.0, 1.0);
  const std::array<std::pair<const char*, double>, 3> moves = {{{"surge", 0.5}, {"sway", 0.02}, {"heave", 0.4}}};
  const std::array<std::pair<const char*, double>, 3> turns = {{{"roll", 0.1}, {"pitch", 1.1}, {"yaw", 0.05}}};
  for (const auto& [name, std] : moves) add_history(r, name, "m", std::string("Vessel, ") + name, 0.0, std);
  for (const auto& [name, std] : turns) add_history(r, name, "rad", std::string("Vessel, ") + name, 0.0, std * kDegree);
  for (const char* name : {"top_tension", "top_tension_peak"}) {
    add_history(r, name, "N", "Tension at the tensioner", statics.top_tension, 9e3);
  }
  add_history(r, "bottom_tension", "N", "Horizontal tension at touchdown", statics.bottom_tension, 8e3);
  if (statics.overbend) {
    add_history(r, "overbend_von_mises_peak", "Pa", "Largest", statics.overbend->von_mises.value, 8e6);
  }
  add_history(r, "sagbend_von_mises_peak", "Pa", "Largest", statics.sagbend.von_mises.value, 6e6);
  if (statics.stinger_tip_clearance) {
    add_history(r, "stinger_tip_clearance", "m", "Separation", *statics.stinger_tip_clearance + 0.004, 0.006, -0.0003);
  }
  for (const SupportResult& box : statics.supports) {
    add_history(r, "support/" + box.name + "/reaction", "N", "Resultant", box.reaction, 0.2 * box.reaction, 0.0);
    add_history(r, "support/" + box.name + "/separation", "m", "Least", box.separation, 0.001);
  }
  for (const HistorySummary& history : r.histories) {
    if (history.name.find('/') == std::string::npos && history.name.find("_peak") == std::string::npos) {
      add_spectrum(r, history.name, history.units, history.over_time.std);
    }
    if (r.spectra.size() == 8) break;
  }
}

void fill_extremes(DynamicResults& r, bool calm) {
  for (const HistorySummary& history : r.histories) {
    if (history.name.find("_peak") == std::string::npos && history.name.find("/reaction") == std::string::npos) {
      continue;
    }
    const double max_value = history.over_time.max;
    ExtremeEstimate e;
    e.name = history.name;
    e.units = history.units;
    e.peaks = 281;
    e.observed = max_value;
    e.enough = !calm && history.over_time.std > 0.0;
    if (e.enough) {
      const double std = history.over_time.std;
      e.method = "Weibull";
      e.quality = "good";
      e.estimate = e.weibull = max_value + 0.4 * std;
      e.low = e.weibull_low = max_value + 0.1 * std;
      e.high = e.weibull_high = max_value + 0.9 * std;
      e.gumbel = max_value + 0.6 * std;
      e.gumbel_low = max_value + 0.2 * std;
      e.gumbel_high = max_value + 1.1 * std;
    } else {
      e.peaks = 7;
      e.quality = "none";
      e.remark = "fewer than 30 peaks";
    }
    r.extremes.push_back(e);
  }
}

}  // namespace

DynamicResults synthetic_dynamics(const StaticResults& statics, bool calm) {
  DynamicResults r;
  r.duration = kDuration;
  r.build_up = kBuildUp;
  r.output_step = 0.5;
  r.seed = 7;
  r.assumptions = {{AssumptionRank::other, "The sea is long-crested."},
                   {AssumptionRank::other, "Water moves as linear waves with Wheeler stretching."}};
  r.findings = {{FindingCode::tension_drifts, "the tension left the operational range"}};
  fill_stations(r, statics);
  r.top_tension = around(statics.top_tension, 9e3);
  r.bottom_tension = around(statics.bottom_tension, 8e3);
  r.lay_back = around(statics.lay_back, 0.8);
  r.departure_angle = around(statics.departure_angle, 0.004);
  r.stinger_tip_clearance = {-0.0003, 0.024, statics.stinger_tip_clearance.value_or(0.0) + 0.004, 0.006};
  const double top = r.station_s.back();
  const double between = statics.supports.empty() ? top : statics.supports.back().s - 15.0;
  if (statics.overbend) r.overbend = region(r, *statics.overbend, between, top);
  r.sagbend = region(r, statics.sagbend, statics.touchdown.s, between);
  fill_supports(r, statics, calm);
  if (!calm) fill_impacts(r);
  r.tensioner = {"controlled", 250e3,  240e3, 260e3, 2.5,   r.top_tension, {-0.4, 0.6, 0.05, 0.2},
                 312.5,        9800.0, 160.5, 420.0, 406.0, 13.5,          41,
                 39,           1};
  r.energy = {2.1e3, 3.4e3, -1.2e3, 40.0, 5.0, 8.4e4, 6.1e4, -3.2e4, 0.0,
              1.9e4, 6.0e4, 2.96e4, 0.0,  0.0, 345.0, 9.1e6, {},     {}};
  r.run = {72'000, 31, 190'000, 41'000, 0.00039, 0.1, 84.2, kDuration / 84.2, "generalized-alpha, spectral radius 0.8"};
  fill_histories(r, statics);
  fill_extremes(r, calm);
  return r;
}

}  // namespace overbend::testing
