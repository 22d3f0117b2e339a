/// Columns of the histories, each with name, unit, meaning and its value in one row.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dynamics/run/simulation_observer.h"
#include "model/vessel/supports.h"
#include "recording/thrust_recorder.h"
#include "recording/vessel_recorder.h"
#include "system/followed_line.h"

namespace overbend {

/// Data of one row of histories. Key figures are laid out as in pipe_recorder_layout.h.
struct RowSource {
  const Instant& instant;
  std::span<const double> key{};                 ///< Present values.
  std::span<const double> max_key{}, min_key{};  ///< Maxima and minima since the previous row.
  std::span<const double> max_reaction{};        ///< Maximum of every box since the previous row [N].
  std::span<const double> min_separation{};      ///< Minimum of every box since the previous row; infinite if the
                                                 ///< pipe passed no roller of it [m].
  const VesselRecorder* floating = nullptr;      ///< Set if there are columns of a floating vessel.
  const ThrustRecorder* thrust = nullptr;        ///< Set if there are columns of dynamic positioning.
};

struct RecordedColumn {
  HistoryColumn column;
  std::function<double(const RowSource&)> value;
};

/// Objects of a run that have columns.
struct RecordedObjects {
  const Supports* supports = nullptr;   ///< Supports of the laid pipe; null without one.
  bool vessel = true;                   ///< True if anything is attached to the vessel.
  bool floating = false;                ///< True if the vessel floats freely or lies on mooring lines.
  std::vector<std::string> moorings{};  ///< Names of the mooring lines.
  std::vector<std::string> sections{};  ///< Stinger sections that turn during the run.
  Vec3 astern_W = Vec3::UnitX();        ///< Horizontal unit vector of longitudinal hinge forces.
  std::vector<FollowedLine> lines{};    ///< Lines of the model itself, in models of lines only or attached to the pipe.
};

/// Returns the columns of a run; the first is time.
std::vector<RecordedColumn> recorded_columns(const RecordedObjects& objects);

/// Adds the columns of dynamic positioning.
void add_thrust_columns(std::vector<RecordedColumn>& columns);

}  // namespace overbend
