/// Results of a dynamic analysis: plain data, SI units, world frame W unless a member says otherwise. Statistics count
/// from t = 0, the end of the build-up, to the end of the run, weighted by time.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/assumption.h"
#include "base/finding.h"
#include "base/vec.h"
#include "results/fatigue_results.h"
#include "results/moored_dynamics.h"
#include "results/spread.h"
#include "results/static_results.h"
#include "results/stinger_dynamics.h"

namespace overbend {

inline constexpr std::size_t kSafetyClasses = 3;  ///< Of DNV: low, medium, high, numbered as SafetyClass.

/// The same for every station of the line, arrays of one length.
struct Envelope {
  std::vector<double> min, max, mean, std;
};

/// Largest of a region over time, with where and when.
struct DynamicExtreme {
  Spread over_time;         ///< Of the region's largest value at each instant.
  double s = 0.0;           ///< Arc length from the anchor, of the largest of all [m].
  double time = 0.0;        ///< When it stood there [s].
  Vec3 p_W = Vec3::Zero();  ///< Place of that station in the static state [m].
};

struct DynamicRegion {
  DynamicExtreme bending_moment, bending_stress, von_mises, strain;
};

/// One impact of the pipe on a roller: from first touch until the pipe leaves it or rests on it.
struct Impact {
  int roller = 0;                  ///< Index in Supports::rollers.
  double time = 0.0;               ///< Of first touch [s].
  double approach_velocity = 0.0;  ///< Normal, at first touch [m/s].
  double peak_force = 0.0;         ///< [N]
  double duration = 0.0;           ///< To separation, or to where the force has passed its peak and the pipe stays [s].
  double impulse = 0.0;            ///< Integral of the normal force over the duration [N s].
  double dent_depth = 0.0;         ///< Of bare steel under the peak force, see contact_damage.h [m].
  double line_load = 0.0;          ///< Peak force over the length of the coating under the roller [N/m].
};

/// What one roller saw.
struct RollerDynamics {
  int roller = 0;        ///< Index in Supports::rollers.
  int box = 0, row = 0;  ///< Indices; `row` counts within the box.
  RollerPosition position = RollerPosition::bottom;
  Spread reaction;    ///< Normal force [N].
  Spread separation;  ///< Positive for daylight; of the times when the pipe passed it, not a number if never [m].
  double static_reaction = 0.0, static_separation = 0.0;
  double contact_share = 0.0;  ///< Share of time in contact [-].
  std::int64_t impact_count = 0;
  double largest_approach_velocity = 0.0, largest_impact_force = 0.0, largest_impulse = 0.0;
  double dent_depth = 0.0;  ///< Under the largest force [m].
  double line_load = 0.0;   ///< Under the largest force [N/m].
};

/// What a quantity stays at or below for 50, 90 and 99 % of the time.
struct Percentiles {
  double p50 = 0.0, p90 = 0.0, p99 = 0.0;
};

struct SupportDynamics {
  std::string name;
  bool stinger = false;
  double s = 0.0;                                    ///< Arc length of the pipe at mid-box in the static state [m].
  Spread reaction, vertical, longitudinal, lateral;  ///< As in SupportResult [N].
  Percentiles reaction_over_time;                    ///< Of `reaction`, to 0.2 % of its largest value [N].
  Spread separation;                                 ///< Smallest over its bottom rollers [m].
  double static_reaction = 0.0, static_separation = 0.0;
  double contact_share = 0.0;  ///< Share of time in which any of its rollers carries.
  std::int64_t impact_count = 0;
  /// When the pipe was first off the box over its end on that side [s]; none where it stayed on it.
  std::optional<double> left_to_port, left_to_starboard;
  std::vector<RollerDynamics> rollers;
};

/// A time history, thinned for plotting: minimum and maximum of each of at most 2,000 equal time intervals.
struct HistorySummary {
  std::string name;         ///< For scripts: "top_tension", "heave", "support/stinger 8/reaction".
  std::string units;        ///< SI.
  std::string description;  ///< One line.
  Spread over_time;
  std::vector<double> low, high;  ///< Of each stretch; from -build_up to the end.
};

/// Variance density of a history from t = 0 (Welch 1967).
struct Spectrum {
  std::string name, units;        ///< Of the history.
  std::vector<double> frequency;  ///< [Hz]
  std::vector<double> density;    ///< [units^2/Hz]
};

/// Most probable largest (or smallest) value in three hours, with its 95 % confidence interval, and what the fits say
/// that it is chosen from: those that are of use.
struct ExtremeEstimate {
  std::string name, units;
  bool smallest = false;                      ///< Of the smallest value.
  int peaks = 0;                              ///< Between mean up-crossings, from t = 0.
  double observed = 0.0;                      ///< Largest (smallest) of the run.
  std::optional<double> estimate, low, high;  ///< None where no estimate is of use.
  std::string method;                         ///< "Weibull", "generalised Pareto" ...; empty without one.
  std::string quality;                        ///< "good", "uncertain", "none".
  std::string remark;                         ///< Why it is not good.
  std::optional<double> weibull, weibull_low, weibull_high;  ///< Of the upper half of the peaks.
  std::optional<double> gumbel, gumbel_low, gumbel_high;     ///< Of the largest of blocks of peaks.
  std::optional<double> pareto, pareto_low, pareto_high;     ///< Generalised, of peaks over a threshold.
  bool enough = false;                                       ///< False: too few peaks to fit.
};

/// Energies [J]: what went in, where it is, what is lost; see docs/theory/dynamics.md.
struct EnergyBalance {
  double kinetic = 0.0, strain = 0.0, gravity = 0.0, contact = 0.0, seabed = 0.0;  ///< Stored, change since the start.
  double fluid = 0.0, rollers = 0.0, top = 0.0, anchor = 0.0;                      ///< Work done on the pipe.
  double contact_loss = 0.0, friction_loss = 0.0, seabed_loss = 0.0, yielding_loss = 0.0;  ///< Dissipated.
  double line_loss = 0.0;   ///< Dissipated by internal damping of lines that only pull.
  double error = 0.0;       ///< Stored + lost - work in.
  double throughput = 0.0;  ///< What has passed: sum of absolute work in and losses.
  /// Of hull and stinger where they are free: stored in them, change since the start; work on them of all but the lines
  /// and rollers.
  std::optional<double> bodies, on_bodies;
  double drift() const { return throughput > 0.0 ? error / throughput : 0.0; }
};

/// What the tensioner was set to and what it did. Travel counts what was paid out, hauled in negative.
struct TensionerDynamics {
  std::string mode;                               ///< "controlled", "locked" or "constant".
  double wanted = 0.0;                            ///< Tension [N].
  double range_low = 0.0, range_high = 0.0;       ///< Operational range; both 0 without one [N].
  double travel_limit = 0.0;                      ///< Either way; 0 without one [m].
  Spread tension, travel;                         ///< Along the guide [N], [m].
  double time_out_of_range = 0.0;                 ///< [s]
  double time_holding = 0.0, time_delayed = 0.0;  ///< In the range; out of it, waiting [s].
  double time_paying_out = 0.0, time_hauling_in = 0.0, time_at_limit = 0.0;  ///< [s]
  std::int64_t pay_out_count = 0, haul_in_count = 0, limit_count = 0;
};

struct DynamicRunReport {
  std::int64_t steps = 0, rejected_steps = 0, newton_iterations = 0, factorisations = 0;
  double smallest_step = 0.0, largest_step = 0.0;  ///< [s]
  double wall_time = 0.0;                          ///< Of the time loop, all sittings together [s].
  double real_time_ratio = 0.0;                    ///< Simulated over wall time.
  std::string integrator;                          ///< "generalized-alpha, spectral radius 0.8".
};

/// The largest utilisations of every station over time and what they are made of, by the design load effects of
/// docs/theory/checks.md: arrays of one length. Times are of the instant of the largest utilisation [s].
struct DesignPeaks {
  // Load controlled.
  std::vector<double> load;           ///< Utilisation [-].
  std::vector<double> load_time;      ///< [s]
  std::vector<double> moment;         ///< Design moment [N m].
  std::vector<double> force;          ///< Design effective force [N].
  std::vector<double> load_pressure;  ///< External over internal pressure [Pa].
  std::vector<double> share;          ///< Of the plastic moment, that a roller's force left [-].
  // Displacement controlled, over the supports; 0 elsewhere.
  std::vector<double> strain;           ///< Utilisation [-].
  std::vector<double> strain_time;      ///< [s]
  std::vector<double> design_strain;    ///< [-]
  std::vector<double> strain_pressure;  ///< External over internal pressure [Pa].
};

/// What the code checks need of every station over time; arrays are empty where nothing of it was made.
struct StationDesign : DesignPeaks {
  std::vector<double> largest_force;  ///< Largest magnitude of the design effective force of all times [N].
  // When the largest values of the envelopes stood [s].
  std::vector<double> von_mises_time, fibre_strain_time, tension_time;
  /// The peaks by safety class, the run's own among them, so that a class can be changed without a new run.
  std::array<DesignPeaks, kSafetyClasses> of_class;
};

/// Everything a dynamic run hands on, beside the static results it started from.
struct DynamicResults {
  DynamicResults();  // These six are compiled once: a copy of all members is long, and many sources make one.
  DynamicResults(const DynamicResults&);
  DynamicResults(DynamicResults&&) noexcept;
  DynamicResults& operator=(const DynamicResults&);
  DynamicResults& operator=(DynamicResults&&) noexcept;
  ~DynamicResults();

  double duration = 0.0, build_up = 0.0, output_step = 0.0;  ///< [s]
  std::uint64_t seed = 0;
  Assumptions assumptions;
  Findings findings;
  std::vector<double> station_s;                                                  ///< Arc length from the anchor [m].
  Envelope effective_tension, bending_moment, bending_stress, von_mises, strain;  ///< Per station.
  Envelope x, y, z;                                                               ///< Places of the stations, W [m].
  /// The static state at the same stations, by the same recovery.
  std::vector<double> static_tension, static_moment, static_bending_stress, static_von_mises, static_strain;
  std::vector<Vec3> static_place;
  Spread top_tension, bottom_tension, lay_back, departure_angle, stinger_tip_clearance;
  DynamicExtreme smallest_tension;  ///< Least effective tension along the line; `over_time.min` is the least of all.
  DynamicRegion overbend, sagbend;  ///< As in StaticResults, by the regions of each instant.
  DynamicRegion tower;              ///< Where the static results have one, else of zeros.
  std::vector<SupportDynamics> supports;
  std::vector<Impact> hardest_impacts;  ///< The 200 with the largest peak force, hardest first.
  std::int64_t impact_count = 0;
  TensionerDynamics tensioner;
  std::optional<VesselDynamics> vessel;         ///< Of a hull that moves freely.
  std::vector<ThrustDynamics> thrust;           ///< Surge, sway and yaw; empty without dynamic positioning.
  std::vector<MooringLineDynamics> moorings;    ///< In the order of the model; empty without lines in time.
  std::vector<LineDynamics> lines;              ///< That stand by themselves.
  std::vector<BodyDynamics> bodies;             ///< Besides the vessel.
  std::vector<StingerSectionDynamics> stinger;  ///< Sections on hinges, from the barge astern; empty: it stands still.
  EnergyBalance energy;
  DynamicRunReport run;
  // From the stored histories, made when the run ends.
  std::vector<HistorySummary> histories;
  std::vector<Spectrum> spectra;
  std::vector<ExtremeEstimate> extremes;
  /// What happened in the run that a record of it before and after is not one of the same: there are no most probable
  /// extremes then. Empty where nothing did.
  std::string non_stationary;

  StationDesign design;
  CheckTable checks;  ///< Of the whole run.
  std::optional<FatigueResults> fatigue;
};

}  // namespace overbend
