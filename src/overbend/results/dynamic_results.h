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
#include "results/static_results.h"
#include "results/stinger_dynamics.h"
#include "results/summary_statistics.h"

namespace overbend {

inline constexpr std::size_t kSafetyClasses = 3;  ///< DNV safety classes low, medium, high, numbered as SafetyClass.

/// Statistics over time at every station of the line, arrays of one length.
struct Envelope {
  std::vector<double> min, max, mean, std;
};

/// Maximum in a region over time, with its position and time.
struct DynamicExtreme {
  SummaryStatistics over_time;  ///< Statistics of the maximum in the region at each instant.
  double s = 0.0;               ///< Arc length from the anchor of the overall maximum [m].
  double time = 0.0;            ///< Time of the overall maximum [s].
  Vec3 p_W = Vec3::Zero();      ///< Position of that station in the static state [m].
};

struct DynamicRegion {
  DynamicExtreme bending_moment, bending_stress, von_mises, strain;
};

/// One impact of the pipe on a roller: from first touch until the pipe separates or stays in contact.
struct Impact {
  int roller = 0;                  ///< Index in Supports::rollers.
  double time = 0.0;               ///< Time of first touch [s].
  double approach_velocity = 0.0;  ///< Normal, at first touch [m/s].
  double peak_force = 0.0;         ///< [N]
  double duration = 0.0;           ///< Duration until separation, or until the force has passed its peak with the pipe
                                   ///< in contact [s].
  double impulse = 0.0;            ///< Integral of the normal force over the duration [N s].
  double dent_depth = 0.0;         ///< Dent of bare steel under the peak force, see contact_damage.h [m].
  double line_load = 0.0;          ///< Peak force over the length of the coating under the roller [N/m].
};

/// Statistics of one roller.
struct RollerDynamics {
  int roller = 0;        ///< Index in Supports::rollers.
  int box = 0, row = 0;  ///< Indices; `row` counts within the box.
  RollerPosition position = RollerPosition::bottom;
  SummaryStatistics reaction;    ///< Normal force [N].
  SummaryStatistics separation;  ///< Clearance, negative for penetration, while the pipe crosses the roller's plane;
                                 ///< NaN if never [m].
  double static_reaction = 0.0, static_separation = 0.0;
  double contact_share = 0.0;  ///< Share of time in contact [-].
  std::int64_t impact_count = 0;
  double max_approach_velocity = 0.0, max_impact_force = 0.0, max_impulse = 0.0;
  double dent_depth = 0.0;  ///< Under the maximum force [m].
  double line_load = 0.0;   ///< Under the maximum force [N/m].
};

/// Percentiles of a quantity over time: values not exceeded for 50, 90 and 99 % of the time.
struct Percentiles {
  double p50 = 0.0, p90 = 0.0, p99 = 0.0;
};

struct SupportDynamics {
  std::string name;
  bool stinger = false;
  double s = 0.0;  ///< Arc length of the pipe at mid-box in the static state [m].
  SummaryStatistics reaction, vertical, longitudinal, lateral;  ///< As in SupportResult [N].
  Percentiles reaction_over_time;  ///< Percentiles of `reaction`, to 0.2 % of its maximum [N].
  SummaryStatistics separation;    ///< Minimum over the bottom rollers [m].
  double static_reaction = 0.0, static_separation = 0.0;
  double contact_share = 0.0;  ///< Share of time in which any roller of the box is in contact [-].
  std::int64_t impact_count = 0;
  /// Time at which the pipe first left the box over that side [s]; none if it stayed on the box.
  std::optional<double> left_to_port, left_to_starboard;
  std::vector<RollerDynamics> rollers;
};

/// A time history, thinned for plotting: minimum and maximum of each of at most 2,000 equal time intervals.
struct HistorySummary {
  std::string name;         ///< Identifier for scripts: "top_tension", "heave", "support/stinger 8/reaction".
  std::string units;        ///< SI.
  std::string description;  ///< One line.
  SummaryStatistics over_time;
  std::vector<double> low, high;  ///< Minimum and maximum of each interval, from -build_up to the end.
};

/// Variance density of a history from t = 0 (Welch 1967).
struct Spectrum {
  std::string name, units;        ///< Name and units of the history.
  std::vector<double> frequency;  ///< [Hz]
  std::vector<double> density;    ///< [units^2/Hz]
};

/// Most probable maximum (or minimum) in three hours, with its 95 % confidence interval, and the fits that it is
/// selected from: those of sufficient quality.
struct ExtremeEstimate {
  std::string name, units;
  bool is_minimum = false;                    ///< True for the extreme of the minimum.
  int peaks = 0;                              ///< Number of peaks between mean up-crossings, from t = 0.
  double observed = 0.0;                      ///< Maximum (minimum) of the run.
  std::optional<double> estimate, low, high;  ///< None if no fit is of sufficient quality.
  std::string method;                         ///< "Weibull", "generalised Pareto" ...; empty without an estimate.
  std::string quality;                        ///< "good", "uncertain", "none".
  std::string remark;                         ///< Reason if the quality is not good.
  std::optional<double> weibull, weibull_low, weibull_high;  ///< Weibull fit to the upper half of the peaks.
  std::optional<double> gumbel, gumbel_low, gumbel_high;     ///< Gumbel fit to the maxima of blocks of peaks.
  std::optional<double> pareto, pareto_low, pareto_high;     ///< Generalised Pareto fit to the peaks over a threshold.
  bool enough = false;                                       ///< False: too few peaks to fit.
};

/// Energies [J]: work done, stored and dissipated; see docs/theory/dynamics.md.
struct EnergyBalance {
  double kinetic = 0.0, strain = 0.0, gravity = 0.0, contact = 0.0, seabed = 0.0;  ///< Stored, change since the start.
  double fluid = 0.0, rollers = 0.0, top = 0.0, anchor = 0.0;                      ///< Work done on the pipe.
  double contact_loss = 0.0, friction_loss = 0.0, seabed_loss = 0.0, yielding_loss = 0.0;  ///< Dissipated.
  double line_loss = 0.0;   ///< Dissipated by internal damping of lines that only pull.
  double error = 0.0;       ///< Stored + dissipated - work done.
  double throughput = 0.0;  ///< Sum of absolute work and dissipation, the reference for the error.
  /// Freely moving hull and stinger: change of stored energy since the start; work on them other than by lines and
  /// rollers.
  std::optional<double> bodies, on_bodies;
  double drift() const { return throughput > 0.0 ? error / throughput : 0.0; }
};

/// Settings and motion of the tensioner. Travel is positive for pay-out, negative for haul-in.
struct TensionerDynamics {
  std::string mode;                               ///< "controlled", "locked" or "constant".
  double wanted = 0.0;                            ///< Target tension [N].
  double range_low = 0.0, range_high = 0.0;       ///< Operational range; both 0 without one [N].
  double travel_limit = 0.0;                      ///< In both directions; 0 without one [m].
  SummaryStatistics tension, travel;              ///< Along the guide [N], [m].
  double time_out_of_range = 0.0;                 ///< [s]
  double time_holding = 0.0, time_delayed = 0.0;  ///< Within the range; outside it during the delay [s].
  double time_paying_out = 0.0, time_hauling_in = 0.0, time_at_limit = 0.0;  ///< [s]
  std::int64_t pay_out_count = 0, haul_in_count = 0, limit_count = 0;
};

struct DynamicRunReport {
  std::int64_t steps = 0, rejected_steps = 0, newton_iterations = 0, factorisations = 0;
  double min_step_taken = 0.0, max_step_taken = 0.0;  ///< [s]
  double wall_time = 0.0;                             ///< Wall time of the time loop, summed over all restarts [s].
  double real_time_ratio = 0.0;                       ///< Simulated time over wall time.
  std::string integrator;                             ///< "generalized-alpha, spectral radius 0.8".
};

/// Maximum utilisations of every station over time with their load effects, see docs/theory/checks.md: arrays of one
/// length. Times are those of the maximum utilisation [s].
struct DesignPeaks {
  // Load controlled.
  std::vector<double> load;           ///< Utilisation [-].
  std::vector<double> load_time;      ///< [s]
  std::vector<double> moment;         ///< Design moment [N m].
  std::vector<double> force;          ///< Design effective force [N].
  std::vector<double> load_pressure;  ///< External over internal pressure [Pa].
  std::vector<double> share;          ///< Remaining share of the plastic moment under a roller force [-].
  // Displacement controlled, over the supports; 0 elsewhere.
  std::vector<double> strain;           ///< Utilisation [-].
  std::vector<double> strain_time;      ///< [s]
  std::vector<double> design_strain;    ///< [-]
  std::vector<double> strain_pressure;  ///< External over internal pressure [Pa].
};

/// Results over time at every station for the code checks; arrays are empty where not recorded.
struct StationDesign : DesignPeaks {
  std::vector<double> max_force;  ///< Maximum magnitude of the design effective force over time [N].
  // Times of the maxima of the envelopes [s].
  std::vector<double> von_mises_time, fibre_strain_time, tension_time;
  /// Peaks by safety class, including that of the run, so that the class can be changed without a new run.
  std::array<DesignPeaks, kSafetyClasses> of_class;
};

/// Results of a dynamic run, in addition to the static results that it started from.
struct DynamicResults {
  DynamicResults();  // These six are defined in the source file: the member-wise copy is long, and many sources would
                     // instantiate it.
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
  Envelope x, y, z;                                                               ///< Positions of the stations, frame
                                                                                  ///< W [m].
  /// Static state at the same stations, from the same recovery.
  std::vector<double> static_tension, static_moment, static_bending_stress, static_von_mises, static_strain;
  std::vector<Vec3> static_place;
  SummaryStatistics top_tension, bottom_tension, lay_back, departure_angle, stinger_tip_clearance;
  DynamicExtreme min_effective_tension;  ///< Minimum effective tension along the line; `over_time.min` is the overall
                                         ///< minimum.
  DynamicRegion overbend, sagbend;       ///< As in StaticResults, with the regions of each instant.
  DynamicRegion tower;                   ///< Zero if the static results have no tower.
  std::vector<SupportDynamics> supports;
  std::vector<Impact> hardest_impacts;  ///< The 200 impacts with the largest peak force, in descending order.
  std::int64_t impact_count = 0;
  TensionerDynamics tensioner;
  std::optional<VesselDynamics> vessel;         ///< For a freely floating hull.
  std::vector<ThrustDynamics> thrust;           ///< Surge, sway and yaw; empty without dynamic positioning.
  std::vector<MooringLineDynamics> moorings;    ///< In the order of the model; empty without mooring lines in the
                                                ///< dynamic model.
  std::vector<LineDynamics> lines;              ///< Stand-alone lines.
  std::vector<BodyDynamics> bodies;             ///< Bodies other than the vessel.
  std::vector<StingerSectionDynamics> stinger;  ///< Sections on hinges, from the vessel astern; empty for a fixed
                                                ///< stinger.
  EnergyBalance energy;
  DynamicRunReport run;
  // From the stored histories, computed at the end of the run.
  std::vector<HistorySummary> histories;
  std::vector<Spectrum> spectra;
  std::vector<ExtremeEstimate> extremes;
  /// Event that makes the records before and after it statistically different, so that most probable extremes do not
  /// apply. Empty if there was none.
  std::string non_stationary;

  StationDesign design;
  CheckTable checks;  ///< Checks of the whole run.
  std::optional<FatigueResults> fatigue;
};

}  // namespace overbend
