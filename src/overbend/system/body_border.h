/// Coupling of lines and rollers with the unknowns of free bodies: residual, columns, rows and corner of the border.
///
/// A node held by a body moves with it: of its unknowns only those along the guide remain. A roller force on the pipe
/// depends on their relative position only, so that its derivative by the body follows from that by the pipe
/// (objectivity). See docs/theory/coupling.md.
#pragma once

#include <array>
#include <vector>

#include "numerics/bordered_system.h"
#include "system/free_body.h"
#include "system/hinged_sections.h"
#include "system/line_assembly.h"
#include "system/system.h"
#include "system/wire.h"

namespace overbend {

/// Returns the indices of the free bodies of a system: the order of SystemState::bodies.
std::vector<int> free_bodies(const System& system);

/// Border of the free bodies of a system.
class BodyBorder {
 public:
  explicit BodyBorder(const System& system);

  bool empty() const { return bodies_.empty(); }
  /// True if there are neither free bodies nor wires.
  bool idle() const { return bodies_.empty() && wires_.empty(); }
  std::size_t count() const { return bodies_.size(); }
  int unknowns() const { return 6 * static_cast<int>(bodies_.size()); }
  /// Returns the shared unknowns that each line touches.
  std::vector<BorderedLine> lines() const;
  /// Returns the number of shared unknowns that a line touches.
  int unknowns_of_line(int index) const { return lines_[static_cast<std::size_t>(index)].unknowns(); }
  /// Returns the number of a body among the free ones, -1 for other bodies.
  int free_body_number(int body) const { return body < 0 ? -1 : number_[static_cast<std::size_t>(body)]; }
  const FreeBody& body(std::size_t number) const { return *bodies_[number].body; }
  const HullBalance& balance(std::size_t number) const { return bodies_[number].own_balance; }
  /// Bodies that are sections of a hinged stinger.
  const HingedSections& hinged() const { return hinged_; }
  /// Pulls of the wires of the system at the last evaluated state.
  const std::vector<WirePull>& wires() const { return wires_; }

  /// Moves the free bodies and the ends they hold to a state.
  void lead(const std::vector<HullState>& states, Surroundings& surroundings);
  /// Evaluates the water at hinged bodies at a time, at their present positions.
  void evaluate_water(double time) { hinged_.evaluate_water(time); }
  /// Starts a new step or repeats one.
  void begin_step();

  /// Sums the loads on the bodies after the evaluation of the lines; quasi-static lines store theirs in `state`.
  void evaluate(SystemState& state, const SystemState& before, const Weights& weights,
                const std::vector<LineAssembly>& lines, bool with_tangent);
  /// Adds one line's border to the solver, from blocks before hold_node().
  void put_line(int index, const LineAssembly& line, const SystemState& state, const Weights& weights,
                const std::vector<HeldDirections>& held, BorderedSystem& solver);
  /// Adds the corner to the solver: the bodies themselves and the parts found by put_line().
  void put_corner(BorderedSystem& solver) const;
  /// True if a body holds the first end of a line or an inner node, near which contacts cannot be renewed separately.
  bool holds_before_last(int line) const;

  /// Holds a freedom constant; it is left out of the residual.
  void hold(int body, int freedom, bool held);
  bool held(int body, int freedom) const;

  /// Returns the power of an end on the body that holds it, as if it moved with the body [W].
  double end_power(const Attachment& held, const LineAssembly& line, const SystemState& state) const;

  /// Residual forces of the free bodies, six each.
  const std::vector<double>& residual() const { return residual_; }
  /// Returns the maximum residual of a body over its force scale, moments over the body's arm.
  double relative_residual(std::size_t number) const;

 private:
  struct Member {
    const FreeBody* body = nullptr;
    int index = 0;  ///< In System::bodies.
    BodyPose pose;
    HullBalance own_balance;
    std::array<bool, 6> held{};
  };
  struct LinePart {
    std::vector<int> bodies;     ///< Free bodies that the line touches, ascending.
    std::vector<double> corner;  ///< Row-major, square.
    int unknowns() const { return 6 * static_cast<int>(bodies.size()); }
  };
  /// Position of a body in the border of a line: its first column there.
  struct Place {
    int line = 0, first = 0;
    const BodyPose* pose = nullptr;
  };

  /// An end of a wire: number of its free body and point on it, or its fixed or prescribed position [m].
  struct WireEnd {
    int number = -1;
    Vec3 place = Vec3::Zero();
  };

  void set_wire_ends(const Surroundings& surroundings);
  void add_wire_forces();
  void put_wires(BorderedSystem& solver) const;
  Place border_place(int line, int number) const;
  void add_contact_forces(const LineAssembly& line);
  void add_end_force(const Attachment& held, const LineAssembly& line, const LineState& state);
  void put_contacts(int index, const LineAssembly& line, const LineState& state, const Weights& weights,
                    BorderedSystem& solver);
  void put_end(const Attachment& held, const LineAssembly& line, const LineState& state, BorderedSystem& solver);
  void add_corner(const Place& place, const Mat6& part);
  void put_hinged_contact(int index, int number, int roller, const LineAssembly& line, const LineState& state,
                          const Weights& weights, BorderedSystem& solver);

  const System* system_;
  std::vector<int> number_;  ///< Per body.
  std::vector<Member> bodies_;
  std::vector<LinePart> lines_;
  std::vector<double> residual_;
  HingedSections hinged_;
  std::vector<std::array<WireEnd, 2>> wire_ends_;
  std::vector<WirePull> wires_;
};

}  // namespace overbend
