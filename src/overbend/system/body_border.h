/// What lines and rollers have to do with the unknowns of free bodies: residual, columns, rows and corner of the
/// border.
///
/// A node held by a body goes with it: of its unknowns those along the guide remain, the others are the body's. A
/// roller acts on the pipe by their relative place alone, so that how its force changes with the body follows from how
/// it changes with the pipe (objectivity). See docs/theory/coupling.md.
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

/// The free bodies among those of a system, by index: the order of SystemState::bodies.
std::vector<int> free_bodies(const System& system);

class BodyBorder {
 public:
  explicit BodyBorder(const System& system);

  bool empty() const { return bodies_.empty(); }
  /// Whether there is nothing that it has to look at: neither free bodies nor wires.
  bool idle() const { return bodies_.empty() && wires_.empty(); }
  std::size_t count() const { return bodies_.size(); }
  int unknowns() const { return 6 * static_cast<int>(bodies_.size()); }
  /// Which shared unknowns each line touches.
  std::vector<BorderedLine> lines() const;
  /// How many of them a line touches.
  int unknowns_of_line(int index) const { return lines_[static_cast<std::size_t>(index)].unknowns(); }
  /// Which of the free bodies, -1 where a body is none of them.
  int number_of(int body) const { return body < 0 ? -1 : number_[static_cast<std::size_t>(body)]; }
  const FreeBody& body(std::size_t number) const { return *bodies_[number].body; }
  const HullBalance& balance(std::size_t number) const { return bodies_[number].own; }
  /// Those of the bodies that are sections of a stinger on hinges.
  const HingedSections& hinged() const { return hinged_; }
  /// Of the wires of the system, at the state evaluated last.
  const std::vector<WirePull>& wires() const { return wires_; }

  /// Brings free bodies and the ends they hold to a state.
  void lead(const std::vector<HullState>& at, Surroundings& now);
  /// Takes the water around bodies on hinges at a time, where they are now.
  void meet_water(double time) { hinged_.meet_water(time); }
  /// Another step begins, or the same one again.
  void begin_step();

  /// Sums the forces on the bodies, after the lines have been evaluated; quasi-static lines leave theirs in `state`.
  void evaluate(SystemState& state, const SystemState& before, const Weights& weights,
                const std::vector<LineAssembly>& lines, bool with_tangent);
  /// Puts one line's border into the solver, from blocks that hold_node() has not been at.
  void put_line(int index, const LineAssembly& line, const SystemState& state, const Weights& weights,
                const std::vector<HeldDirections>& held, BorderedSystem& solver);
  /// Sums up the corner: the bodies themselves and the parts that put_line() found.
  void put_corner(BorderedSystem& solver) const;
  /// Whether a body holds the first end of a line or a node between its ends, beside which contacts cannot be renewed
  /// alone.
  bool holds_before_last(int line) const;

  /// A held freedom stays where it is, and does not count among the unbalanced.
  void hold(int body, int freedom, bool held);
  bool held(int body, int freedom) const;

  /// Power on an end that goes into the body it is held by, as if it went with the body [W].
  double power_of_end(const Attachment& held, const LineAssembly& line, const SystemState& state) const;

  /// Forces left on the free bodies, six for each.
  const std::vector<double>& residual() const { return residual_; }
  /// Largest unbalanced force, moments over the body's arm, over its force scale; which body.
  double relative_residual(std::size_t number) const;

 private:
  struct Member {
    const FreeBody* body = nullptr;
    int index = 0;  ///< In System::bodies.
    BodyPose pose;
    HullBalance own;
    std::array<bool, 6> held{};
  };
  struct LinePart {
    std::vector<int> bodies;     ///< Free bodies that the line touches, ascending.
    std::vector<double> corner;  ///< Row-major, square.
    int unknowns() const { return 6 * static_cast<int>(bodies.size()); }
  };
  /// A body's place in the border of a line: its first column there.
  struct Place {
    int line = 0, first = 0;
    const BodyPose* pose = nullptr;
  };

  /// An end of a wire: the free body that it is on, or where it is led [m].
  struct WireEnd {
    int number = -1;
    Vec3 place = Vec3::Zero();
  };

  void lead_wires(const Surroundings& now);
  void add_wire_forces();
  void put_wires(BorderedSystem& solver) const;
  Place place_of(int line, int number) const;
  void add_contact_forces(const LineAssembly& line);
  void add_end_force(const Attachment& held, const LineAssembly& line, const LineState& state);
  void put_contacts(int index, const LineAssembly& line, const LineState& state, const Weights& weights,
                    BorderedSystem& solver);
  void put_end(const Attachment& held, const LineAssembly& line, const LineState& state, BorderedSystem& solver);
  void add_corner(const Place& place, const Mat6& part);
  void put_hinged_contact(int index, int number, int roller, const LineAssembly& line, const LineState& state,
                          const Weights& weights, BorderedSystem& solver);

  const System* system_;
  std::vector<int> number_;  ///< By body.
  std::vector<Member> bodies_;
  std::vector<LinePart> lines_;
  std::vector<double> residual_;
  HingedSections hinged_;
  std::vector<std::array<WireEnd, 2>> wire_ends_;
  std::vector<WirePull> wires_;
};

}  // namespace overbend
