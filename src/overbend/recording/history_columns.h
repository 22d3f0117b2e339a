/// The table of histories: each column with its name, unit, meaning and value in one row.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dynamics/run/simulation_observer.h"
#include "model/vessel/supports.h"
#include "recording/thrust_watch.h"
#include "recording/vessel_watch.h"

namespace overbend {

/// What a row of histories is made of. Key figures are laid out as in dynamic_recorder_layout.h.
struct RowSource {
  const Instant& now;
  std::span<const double> key;                     ///< Now.
  std::span<const double> largest_key, least_key;  ///< Since the row before.
  std::span<const double> largest_reaction;        ///< Of every box since the previous row [N].
  std::span<const double> least_separation;        ///< Likewise; infinite where the pipe passed none of it [m].
  const VesselWatch* floating = nullptr;           ///< Where there are columns of a vessel that floats.
  const ThrustWatch* thrust = nullptr;             ///< Where there are columns of dynamic positioning.
};

struct RecordedColumn {
  HistoryColumn column;
  std::function<double(const RowSource&)> value;
};

/// The columns of a run over these supports; the first is time.
/// `moorings`: names of the mooring lines of the run; `floating`: whether the vessel floats free or lies on lines.
/// `sections`: names of those of the stinger that turn in time, told along the horizontal unit vector `astern_W`.
std::vector<RecordedColumn> recorded_columns(const Supports& supports, const std::vector<std::string>& moorings = {},
                                             bool floating = false, const std::vector<std::string>& sections = {},
                                             const Vec3& astern_W = Vec3::UnitX());

/// What dynamic positioning gives.
void add_thrust_columns(std::vector<RecordedColumn>& columns);

/// The columns of a run of a vessel on these mooring lines, without a pipe.
std::vector<RecordedColumn> moored_columns(const std::vector<std::string>& moorings);

}  // namespace overbend
