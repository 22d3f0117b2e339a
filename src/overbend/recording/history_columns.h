/// The table of histories: each column with its name, unit, meaning and value in one row.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dynamics/run/simulation_observer.h"
#include "model/vessel/supports.h"
#include "recording/thrust_watch.h"
#include "recording/vessel_watch.h"
#include "system/followed_line.h"

namespace overbend {

/// What a row of histories is made of. Key figures are laid out as in pipe_recorder_layout.h.
struct RowSource {
  const Instant& now;
  std::span<const double> key{};                       ///< Now.
  std::span<const double> largest_key{}, least_key{};  ///< Since the row before.
  std::span<const double> largest_reaction{};          ///< Of every box since the previous row [N].
  std::span<const double> least_separation{};          ///< Likewise; infinite where the pipe passed none of it [m].
  const VesselWatch* floating = nullptr;               ///< Where there are columns of a vessel that floats.
  const ThrustWatch* thrust = nullptr;                 ///< Where there are columns of dynamic positioning.
};

struct RecordedColumn {
  HistoryColumn column;
  std::function<double(const RowSource&)> value;
};

/// The objects of a run that have columns.
struct RecordedObjects {
  const Supports* supports = nullptr;   ///< Of the pipe that is laid; null without one.
  bool vessel = true;                   ///< Whether anything is held by the vessel.
  bool floating = false;                ///< Whether it floats free or lies on lines.
  std::vector<std::string> moorings{};  ///< Names of the mooring lines.
  std::vector<std::string> sections{};  ///< Of the stinger, that turn in time.
  Vec3 astern_W = Vec3::UnitX();        ///< Horizontal unit vector along which forces of their hinges are given.
  std::vector<FollowedLine> lines{};    ///< That stand by themselves, or on the pipe.
};

/// The columns of a run; the first is time.
std::vector<RecordedColumn> recorded_columns(const RecordedObjects& objects);

/// What dynamic positioning gives.
void add_thrust_columns(std::vector<RecordedColumn>& columns);

}  // namespace overbend
