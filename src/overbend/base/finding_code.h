/// The kinds of findings that analyses report: name, severity, meaning and remedy of each.
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace overbend {

enum class FindingSeverity {
  serious,  ///< The lay is not feasible as given, or the results are not valid: never a pass.
  caution,  ///< To be reviewed before the pipe is laid.
  note,     ///< For information.
};

/// "serious", "caution", "note".
const char* name(FindingSeverity severity);

/// In the order of the user guide.
enum class FindingCode {
  // Pipe and supports
  pipe_off_rollers,
  compression,
  yield_with_linear_steel,
  strain_next_to_stiff_section,
  pipe_at_roller_end,
  rollers_below_seabed,
  support_out_of_line,
  stern_shoe_below_water,
  tensioner_incline,
  field_joint_strain_missing,
  moment_curvature_fit,
  structure_beyond_end,
  tension_target_missed,
  anchor_target_missed,
  history_dependent_strain,
  residual_curvature,
  other_equilibrium_possible,
  friction_limit_not_found,
  sensitivities_missing,
  current_effect_unknown,
  check_not_judged,
  // Seabed and route
  seabed_above_water,
  laid_pipe_slides,
  free_spans,
  moment_over_crest,
  outside_bathymetry,
  steady_laying_not_found,
  route_not_held,
  // Stinger
  stinger_unstable,
  stinger_at_stop,
  stinger_clear_of_pipe,
  stinger_friction_range,
  stinger_stop_impacts,
  // Cables, moorings and lines
  breaking_load_exceeded,
  working_load_exceeded,
  line_slack,
  line_snaps,
  line_compressed,
  line_in_bow,
  element_folded,
  lifted_end_drawn_back,
  davit_wire_leans,
  davit_slack,
  yield_at_davit,
  welded_line_pushed,
  anchor_lifted,
  anchor_holding_exceeded,
  anchor_dragged,
  line_parted,
  no_length_on_seabed,
  seabed_end_lifted,
  line_off_seabed,
  winch_limit_exceeded,
  winch_rendered,
  winch_stalled,
  drum_length_exceeded,
  winch_element_stretched,
  // Vessel
  vessel_not_held,
  thrust_at_limit,
  positioning_unstable,
  slow_motion_undamped,
  vessel_angle_nonlinear,
  vessel_heave_nonlinear,
  rao_conventions,
  radiation_misfit,
  radiation_by_convolution,
  negative_radiation_damping,
  added_mass_mismatch,
  hull_not_evaluated,
  force_table_sign,
  sea_outside_wave_forces,
  sea_above_drift,
  no_drift_coefficients,
  newman_in_shallow_water,
  vessel_moves_as_prescribed,
  // Time-domain analysis
  run_not_at_rest,
  tensioner_at_travel_limit,
  pipe_end_past_first_box,
  nothing_moves,
  tensioner_never_moves,
  yield_assumed,
  tensioner_mode_assumed,
  tensioner_locked_in_move,
  tensioner_slower_than_vessel,
  tensioner_travel_not_applied,
  mean_tension_off_target,
  tension_drifts,
  tensioner_statistics_uncertain,
  start_without_build_up,
  build_up_too_short,
  controller_limited,
  vessel_fixed_in_sea,
  energy_imbalance,
  record_not_stationary,
  short_record,
  few_slow_cycles,
  few_wave_components,
  sea_outside_raos,
  sea_not_random,
  fatigue_budget,
  fatigue_few_cycles,
  fatigue_with_yield,
  // Operations, studies, lay tables, seeks
  stage_without_equilibrium,
  run_shorter_than_operation,
  no_stage_chosen,
  stage_without_history,
  stages_at_rest,
  case_without_solution,
  no_passing_value,
  limit_not_found,
  gap_between_passing_values,
  table_range_unknown,
  study_inputs,
  dragged_head_lifted,
  dragged_cable_on_bed,
  dragged_line_clear_of_bed,
  // Input files
  unusual_input,
  unused_input,
  input_converted,
  recorded_motion_leaps,
  recorded_yaw_is_heading,
  unknown,  ///< Code of results written by another version of the program.
};

/// Description of a code. Texts are literals.
struct FindingKind {
  FindingCode code;
  std::string_view name;  ///< Name in files: "pipe-off-rollers".
  FindingSeverity severity;
  std::string_view meaning;  ///< One or two sentences.
  std::string_view remedy;   ///< Recommended action.
};

/// Returns all codes, in the order of FindingCode.
std::span<const FindingKind> finding_kinds();

const FindingKind& kind(FindingCode code);

/// Returns nothing if no code has that name.
std::optional<FindingCode> find_finding_code(std::string_view name);

}  // namespace overbend
