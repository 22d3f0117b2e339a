#include "recording/history_columns.h"

#include "dynamics/machines/mooring_tension.h"
#include "recording/line_recorder.h"
#include "recording/pipe_recorder_layout.h"
#include "recording/stinger_recorder.h"

namespace overbend {
namespace {

using Value = std::function<double(const RowSource&)>;

Value key(std::size_t i) {
  return [i](const RowSource& row) { return row.key[i]; };
}
Value max_value(std::size_t i) {
  return [i](const RowSource& row) { return row.max_key[i]; };
}
Value min_value(std::size_t i) {
  return [i](const RowSource& row) { return row.min_key[i]; };
}
Value freedom(std::size_t i) {
  return [i](const RowSource& row) { return row.instant.vessel().freedoms[i]; };
}

using Columns = std::vector<RecordedColumn>;

// Flags of a column: in the extremes, in the spectra, in the minima.

void add_time(Columns& columns, const std::string& over) {
  columns.push_back({{"time", "s", "Time from the end of the build-up", false, false},
                     [](const RowSource& row) { return row.instant.state->time; }});
  columns.push_back({{"elevation", "m", "Water surface above the mean position of " + over, false, true},
                     [](const RowSource& row) { return row.instant.elevation; }});
}

void add_vessel(Columns& columns) {
  columns.push_back({{"surge", "m", "Vessel, forward", false, true}, freedom(0)});
  columns.push_back({{"sway", "m", "Vessel, to port", false, true}, freedom(1)});
  columns.push_back({{"heave", "m", "Vessel, up", false, true}, freedom(2)});
  columns.push_back({{"roll", "rad", "Vessel, starboard down", false, true}, freedom(3)});
  columns.push_back({{"pitch", "rad", "Vessel, bow down", false, true}, freedom(4)});
  columns.push_back({{"yaw", "rad", "Vessel, bow to port", false, true}, freedom(5)});
}

void add_lay(Columns& columns) {
  columns.push_back({{"top_tension", "N", "Effective tension at the tensioner", false, true}, key(kTopTension)});
  columns.push_back({{"bottom_tension", "N", "Horizontal tension at touchdown", false, false}, key(kBottomTension)});
  columns.push_back(
      {{"lay_back", "m", "Horizontal distance from the mean position of the stern shoe to touchdown", false, false},
       key(kLayBack)});
  columns.push_back(
      {{"departure_angle", "rad", "Angle of the pipe at the last support in contact, from horizontal", false, false},
       key(kDepartureAngle)});
  columns.push_back(
      {{"stinger_tip_clearance", "m", "Separation at the last row of the stinger", false, false}, key(kTipClearance)});
}

void add_region(Columns& columns, const std::string& name, std::size_t first) {
  columns.push_back(
      {{name + "_bending_stress", "Pa", "Largest bending stress of the " + name + " at the instant", false, false},
       key(first + kBendingStress)});
  columns.push_back(
      {{name + "_von_mises", "Pa", "Largest von Mises stress of the " + name + " at the instant", false, false},
       key(first + kVonMises)});
  columns.push_back(
      {{name + "_strain_peak", "1", "Largest strain of the " + name + " since the previous row", true, false},
       max_value(first + kStrain)});
  columns.push_back({{name + "_von_mises_peak", "Pa",
                      "Largest von Mises stress of the " + name + " since the previous row", true, false},
                     max_value(first + kVonMises)});
}

void add_tension(Columns& columns) {
  columns.push_back({{"top_tension_peak", "N", "Largest tension at the tensioner since the previous row", true, false},
                     max_value(kTopTension)});
  columns.push_back(
      {{"top_tension_low", "N", "Smallest tension at the tensioner since the previous row", false, false, true},
       min_value(kTopTension)});
  columns.push_back({{"smallest_tension", "N",
                      "Smallest effective tension anywhere along the line since the previous row", false, false, true},
                     min_value(kMinLineTension)});
  columns.push_back({{"tensioner/tension", "N", "Force of the tensioner on the pipe along its guide", false, false},
                     [](const RowSource& row) { return row.instant.tensioner->machine.tension; }});
  columns.push_back(
      {{"tensioner/travel", "m", "Length paid out by the tensioner, negative when hauled in", false, false},
       [](const RowSource& row) {
         return row.instant.move.moves ? row.instant.move.paid_out : row.instant.tensioner->travel.q;
       }});
  columns.push_back({{"tensioner/state", "1", "0 holds, 1 delay, 2 pays out, 3 hauls in, 4 at its limit", false, false},
                     [](const RowSource& row) { return static_cast<double>(row.instant.tensioner->machine.state); }});
}

void add_solver(Columns& columns) {
  columns.push_back(
      {{"step", "s", "Preceding time step", false, false}, [](const RowSource& row) { return row.instant.step; }});
  columns.push_back(
      {{"energy_drift", "1", "Error of the energy balance relative to the energy exchanged", false, false},
       [](const RowSource& row) { return row.instant.drift; }});
}

void add_box(Columns& columns, const std::string& name, std::size_t box) {
  columns.push_back({{"support/" + name + "/reaction", "N", "Largest resultant since the previous row", true, false},
                     [box](const RowSource& row) { return row.max_reaction[box]; }});
  columns.push_back(
      {{"support/" + name + "/separation", "m", "Minimum separation since the previous row", false, false},
       [box](const RowSource& row) { return or_missing(row.min_separation[box]); }});
}

void add_floating(Columns& columns) {
  const auto shift = [&](const char* name, const char* units, const char* description, std::size_t freedom) {
    columns.push_back({{std::string("vessel/") + name, units, description, false, false},
                       [freedom](const RowSource& row) { return row.floating->shift(freedom); }});
  };
  shift("surge", "m", "Shift of midship forward from the nominal position", 0);
  shift("sway", "m", "Shift of midship to port from the nominal position", 1);
  shift("heave", "m", "Shift of midship upwards from the nominal position", 2);
  shift("roll", "rad", "Starboard down, from the nominal pose", 3);
  shift("pitch", "rad", "Bow down, from the nominal pose", 4);
  shift("yaw", "rad", "Bow to port, from the nominal pose", 5);
  columns.push_back({{"vessel/offset", "m", "Horizontal distance of midship from its initial position", true, false},
                     [](const RowSource& row) { return row.floating->offset(); }});
}

void add_mooring(Columns& columns, const std::string& name, std::size_t line) {
  const auto tension = [line](LineEnd end) {
    return [line, end](const RowSource& row) {
      return mooring_tension(*row.instant.assembly, *row.instant.state, line, end);
    };
  };
  columns.push_back(
      {{"mooring/" + name + "/fairlead_tension", "N", "Tension at the fairlead", true, true}, tension(LineEnd::last)});
  columns.push_back(
      {{"mooring/" + name + "/anchor_tension", "N", "Tension at the anchor", true, false}, tension(LineEnd::first)});
}

void add_line(Columns& columns, const FollowedLine& line) {
  const auto tension = [line](LineEnd end) {
    return
        [line, end](const RowSource& row) { return end_tension(*row.instant.assembly, *row.instant.state, line, end); };
  };
  const std::string& name = line.name;
  columns.push_back(
      {{"line/" + name + "/first_tension", "N", "Tension at the first end, negative in compression", true, true},
       tension(LineEnd::first)});
  columns.push_back(
      {{"line/" + name + "/second_tension", "N", "Tension at the second end, negative in compression", true, true},
       tension(LineEnd::last)});
}

void add_section(Columns& columns, const std::string& name, std::size_t section, const Vec3& astern_W) {
  const auto reading = [section](const RowSource& row) { return row.instant.assembly->hinged().reading(section); };
  const std::string prefix = "stinger/" + name + "/";
  columns.push_back({{prefix + "angle", "rad", "Angle from the nominal position, tip down", true, true},
                     [=](const RowSource& row) { return reading(row).angle; }});
  columns.push_back(
      {{prefix + "hinge_longitudinal", "N", "Force of the hinge on the section, level astern", true, false},
       [=](const RowSource& row) { return hinge_force(reading(row), astern_W).longitudinal; }});
  columns.push_back({{prefix + "hinge_vertical", "N", "Force of the hinge on the section, upwards", true, false},
                     [=](const RowSource& row) { return hinge_force(reading(row), astern_W).vertical; }});
  columns.push_back({{prefix + "stop_moment", "N m", "Moment of the stops on the section, tip down", false, false},
                     [=](const RowSource& row) { return reading(row).stop_moment; }});
  columns.push_back({{prefix + "draught", "m", "Deepest end of its tanks below the local surface", false, false},
                     [=](const RowSource& row) { return reading(row).draught; }});
}

}  // namespace

std::vector<RecordedColumn> recorded_columns(const RecordedObjects& objects) {
  Columns columns;
  const Supports* const supports = objects.supports;
  add_time(columns, supports != nullptr ? "the stern shoe" : "midship");
  if (objects.vessel) add_vessel(columns);
  if (supports != nullptr) {
    add_lay(columns);
    add_region(columns, supports->boxes.empty() ? "tower" : "overbend", kUpper);
    add_region(columns, "sagbend", kSagbend);
    add_tension(columns);
  }
  add_solver(columns);
  for (std::size_t box = 0; supports != nullptr && box < supports->boxes.size(); ++box) {
    add_box(columns, supports->boxes[box].name, box);
  }
  if (objects.floating) add_floating(columns);
  for (std::size_t i = 0; i < objects.moorings.size(); ++i) add_mooring(columns, objects.moorings[i], i);
  for (std::size_t i = 0; i < objects.sections.size(); ++i) {
    add_section(columns, objects.sections[i], i, objects.astern_W);
  }
  for (const FollowedLine& line : objects.lines) add_line(columns, line);
  return columns;
}

void add_thrust_columns(std::vector<RecordedColumn>& columns) {
  const auto thrust = [&](const char* name, const char* units, const char* description, std::size_t direction) {
    columns.push_back({{std::string("thrust/") + name, units, description, false, false},
                       [direction](const RowSource& row) { return row.thrust->given(direction); }});
  };
  thrust("surge", "N", "Thrust of dynamic positioning ahead", 0);
  thrust("sway", "N", "Thrust of dynamic positioning to port", 1);
  thrust("yaw", "N m", "Moment of dynamic positioning, bow to port", 2);
}

}  // namespace overbend
