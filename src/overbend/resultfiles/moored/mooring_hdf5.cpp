#include "resultfiles/moored/mooring_hdf5.h"

#include <algorithm>
#include <limits>

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_readers.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/moored/mooring_tables.h"
#include "results/fields/mooring_fields.h"
#include "results/fields/move_fields.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

template <class Row, class Visit>
void visit_operation(Row& r, Visit& visit) {
  visit(ResultField{"operation", "1", "Operation; empty without one"}, r.operation);
  visit(ResultField{"distance", "m", "Distance of a pull-ahead"}, r.distance);
}

template <class Row, class Visit>
void visit_state(Row& r, Visit& visit) {
  visit(ResultField{"state", "1", "Static or the stage of the operation"}, r.name);
  visit_vessel_offset(r.vessel, visit);
  visit(ResultField{"residual", "1", "Largest unbalanced force over the force scale"}, r.residual);
  visit(ResultField{"iterations", "1", "Iterations of Newton's method"}, r.iterations);
}

template <class Row, class Visit>
void visit_period(Row& r, Visit& visit) {
  visit(ResultField{"mode", "1", "Motion with most of the kinetic energy"}, r.mode);
  visit(ResultField{"period", "s", "Undamped natural period"}, r.period);
}

template <class Row, class Visit>
void visit_line_of_state(Row& r, Visit& visit) {
  visit_mooring_line(r, visit);
  visit_mooring_use(r, visit);
  visit(ResultField{"nearest_object", "1", "Object of the clearance"}, r.nearest_object);
}

/// Calls a function for the lists of a state, empty for a fixed hull: name, size, member.
template <class Function>
void visit_matrices(Function visit) {
  visit(
      "stiffness", "Stiffness of lines, thrusters and water about the shifted midship, nominal axes, SI",
      std::size_t{36}, [](auto& state) -> auto& { return state.vessel.stiffness; });
  visit(
      "mooring_stiffness", "The same for the lines alone", std::size_t{36},
      [](auto& state) -> auto& { return state.mooring_stiffness; });
  visit(
      "mooring_force", "Force and moment of the lines about the shifted midship, nominal axes, SI", std::size_t{6},
      [](auto& state) -> auto& { return state.mooring_force; });
  visit(
      "thrust", "Thrust of dynamic positioning: ahead and to port of the hull, bow to port, SI", std::size_t{3},
      [](auto& state) -> auto& { return state.thrust; });
}

void write_matrices(DatasetSink& file, const std::vector<const MooredState*>& states) {
  visit_matrices([&](const char* name, const char* what, std::size_t size, auto member) {
    std::vector<double> all;
    for (const MooredState* state : states) {
      const std::vector<double>& values = member(*state);
      for (std::size_t i = 0; i < size; ++i) all.push_back(values.empty() ? kNone : values[i]);
    }
    file.write(std::string("/moorings/") + name, ResultField{name, "1", what}, all, {states.size(), size});
  });
}

void write_lines(DatasetSink& file, const std::vector<const MooredState*>& states) {
  TableWriter vessels, periods, lines, shapes;
  for (const MooredState* state : states) {
    for (const PeriodResult& period : state->vessel.natural_periods) {
      periods(index_field("Number of the row, from 0"), periods.rows());
      periods(ResultField{"vessel", "1", "Index of the state in the table of the vessel"}, vessels.rows());
      visit_period(period, periods);
      periods.end_row();
    }
    for (const MooringLineResult& line : state->moorings) {
      for (const Vec3& point : line.shape_W) {
        shapes(index_field("Number of the point, from 0"), shapes.rows());
        shapes(ResultField{"line", "1", "Index of its line in the table of lines"}, lines.rows());
        shapes(ResultField{"", "m", "Point of the line, fairlead to anchor", kWorldFrame}, point);
        shapes.end_row();
      }
      lines(index_field("Number of state and line, from 0"), lines.rows());
      lines(ResultField{"vessel", "1", "Index of the state in the table of the vessel"}, vessels.rows());
      lines(ResultField{"state", "1", "Static or the stage of the operation"}, state->name);
      visit_line_of_state(line, lines);
      lines.end_row();
    }
    vessels(index_field("Number of the state, from 0"), vessels.rows());
    visit_state(*state, vessels);
    vessels.end_row();
  }
  vessels.write(file, "/moorings/vessel", "Pose of the hull");
  periods.write(file, "/moorings/periods", "Natural periods");
  lines.write(file, "/moorings/lines", "Mooring lines, state by state");
  shapes.write(file, "/moorings/shapes", "Shapes of the lines");
}

void read_lines(const Hdf5Reader& file, const std::vector<MooredState*>& states) {
  TableReader lines(file, "/moorings/lines"), shapes(file, "/moorings/shapes");
  std::vector<std::pair<MooredState*, std::size_t>> places;  // a pointer to a line would be invalidated by the next
                                                             // line
  for (std::size_t i = 0, count = lines.rows("index"); i < count; ++i) {
    lines.start_row(i);
    int state = -1;
    lines(ResultField{"vessel"}, state);
    MooredState& of = owner(states, state, "mooring line");
    visit_line_of_state(of.moorings.emplace_back(), lines);
    places.emplace_back(&of, of.moorings.size() - 1);
  }
  std::vector<MooringLineResult*> all;
  for (const auto& [state, index] : places) all.push_back(&state->moorings[index]);
  for (std::size_t i = 0, count = shapes.rows("index"); i < count; ++i) {
    shapes.start_row(i);
    int line = -1;
    Vec3 point;
    shapes(ResultField{"line"}, line);
    shapes(ResultField{""}, point);
    owner(all, line, "shape").shape_W.push_back(point);
  }
}

void read_matrices(const Hdf5Reader& file, const std::vector<MooredState*>& states) {
  visit_matrices([&](const char* name, const char*, std::size_t size, auto member) {
    const std::string path = std::string("/moorings/") + name;
    if (!file.has(path)) return;  // written by an older version
    const std::vector<double> all = file.doubles(path);
    for (std::size_t s = 0; s < states.size(); ++s) {
      if (std::isnan(element(all, s * size, path))) continue;
      element(all, (s + 1) * size - 1, path);
      const auto first = all.begin() + static_cast<std::ptrdiff_t>(s * size);
      member(*states[s]).assign(first, first + static_cast<std::ptrdiff_t>(size));
    }
  });
}

void read_states(const Hdf5Reader& file, MooringResults& results) {
  TableReader vessels(file, "/moorings/vessel"), periods(file, "/moorings/periods");
  const std::size_t count = vessels.rows("index");
  results.stages.resize(count > 0 ? count - 1 : 0);
  std::vector<MooredState*> states = {&results.rest};
  for (MooredState& stage : results.stages) states.push_back(&stage);
  for (std::size_t i = 0; i < count; ++i) {
    vessels.start_row(i);
    visit_state(*states[i], vessels);
  }
  for (std::size_t i = 0, rows = periods.rows("index"); i < rows; ++i) {
    periods.start_row(i);
    int state = -1;
    periods(ResultField{"vessel"}, state);
    visit_period(owner(states, state, "period").vessel.natural_periods.emplace_back(), periods);
  }
  read_lines(file, states);
  read_matrices(file, states);
}

/// Visits a position of a pull-ahead; `pipe` is that of the step, or an empty one.
template <class Step, class Pipe, class Visit>
void visit_step(Step& step, Pipe& pipe, bool& has_pipe, Visit& visit) {
  visit_move_step(step, visit);
  visit_vessel_offset(step.vessel, visit);
  visit(ResultField{"residual", "1", "Largest unbalanced force over the force scale"}, step.residual);
  visit(ResultField{"has_pipe", "1", "1 with a pipe; otherwise the columns of the pipe have no meaning"}, has_pipe);
  visit_pipe_at_step(pipe, visit);
  visit(ResultField{"tip_clearance", "m", "Separation at the last row of the stinger"}, pipe.stinger_tip_clearance);
}

void write_steps(DatasetSink& file, const MooringResults& results) {
  TableWriter steps, lines, anchors;
  for (const MoveStep& step : results.steps) {
    for (std::size_t i = 0; i < step.lengths.size(); ++i) {
      lines(index_field("Number of the row, from 0"), lines.rows());
      lines(ResultField{"step", "1", "Index of the position in the table of steps"}, steps.rows());
      lines(ResultField{"length", "m", "Unstressed length of the first segment"}, step.lengths[i]);
      lines(ResultField{"tension", "N", "Tension at the fairlead"}, step.tensions[i]);
      lines.end_row();
    }
    bool has_pipe = step.pipe.has_value();
    const PipeAtStep pipe = step.pipe.value_or(PipeAtStep{});
    steps(index_field("Number of the position, from 0"), steps.rows());
    visit_step(step, pipe, has_pipe, steps);
    steps.end_row();
  }
  for (const AnchorDue& due : results.anchors) {
    anchors(index_field("Number of the move, from 0"), anchors.rows());
    visit_anchor_due(due, anchors);
    anchors.end_row();
  }
  steps.write(file, "/moorings/steps", "Positions of a pull-ahead");
  lines.write(file, "/moorings/step_lines", "Lines at those positions, in the order of the model");
  anchors.write(file, "/moorings/anchors", "Anchor moves due on a route");
}

void read_steps(const Hdf5Reader& file, MooringResults& results) {
  TableReader steps(file, "/moorings/steps"), lines(file, "/moorings/step_lines"), anchors(file, "/moorings/anchors");
  results.steps.resize(steps.rows("index"));
  std::vector<MoveStep*> all;
  for (std::size_t i = 0; i < results.steps.size(); ++i) {
    steps.start_row(i);
    MoveStep& step = results.steps[i];
    bool has_pipe = false;
    PipeAtStep pipe;
    visit_step(step, pipe, has_pipe, steps);
    if (has_pipe) step.pipe = pipe;
    all.push_back(&step);
  }
  for (std::size_t i = 0, count = lines.rows("index"); i < count; ++i) {
    lines.start_row(i);
    int step = -1;
    lines(ResultField{"step"}, step);
    MoveStep& of = owner(all, step, "line");
    lines(ResultField{"length"}, of.lengths.emplace_back());
    lines(ResultField{"tension"}, of.tensions.emplace_back());
  }
  results.anchors.resize(anchors.rows("index"));
  for (std::size_t i = 0; i < results.anchors.size(); ++i) {
    anchors.start_row(i);
    visit_anchor_due(results.anchors[i], anchors);
  }
}

}  // namespace

void write_moorings(DatasetSink& file, const MooringResults& results) {
  file.group("/moorings", "Static results of hull and mooring lines");
  ValueWriter values{file, "/moorings"};
  visit_operation(results, values);
  const std::vector<const MooredState*> states = moored_states(results);
  write_lines(file, states);
  write_matrices(file, states);
  TableWriter winches;
  for (const WinchMove& move : results.winches) {
    winches(index_field("Number of the line, from 0"), winches.rows());
    visit_winch_move(move, winches);
    winches.end_row();
  }
  write_steps(file, results);
  winches.write(file, "/moorings/winches", "Winch operations of a pull-ahead");
}

std::optional<MooringResults> read_moorings(const Hdf5Reader& file) {
  if (!file.has("/moorings")) return std::nullopt;
  MooringResults results;
  ValueReader values{file, "/moorings"};
  visit_operation(results, values);
  read_states(file, results);
  read_steps(file, results);
  TableReader winches(file, "/moorings/winches");
  results.winches.resize(winches.rows("index"));
  for (std::size_t i = 0; i < results.winches.size(); ++i) {
    winches.start_row(i);
    visit_winch_move(results.winches[i], winches);
  }
  return results;
}

}  // namespace overbend
