#include "statics/solver/lines_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/ranges.h"
#include "mechanics/ground.h"
#include "model/bodies.h"
#include "model/site/sea_statistics.h"
#include "model/waves/wave_theory.h"
#include "statics/solver/lines_statics.h"
#include "statics/solver/linked_lines.h"
#include "system/assembly.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

/// True if an end is one of pipe along the bed.
bool lies_at(const FreeLineDescription& line, const LineEndDescription& end) {
  return end.kind == LineEndKind::bed && end.clamped && has_pipe_section(line);
}

/// Places the end of a pipe on the bed at its static position: on its underside, at its penetration.
void move_end_to_bed(const Model& model, double radius, Attachment& held) {
  const Vec3 normal = model.seabed.surface.normal(held.place.x(), held.place.y());
  held.place += radius / normal.z() * Vec3::UnitZ();
  held.direction = (held.direction - normal.dot(held.direction) * normal).normalized();
  held.free_along = normal;
}

Attachment make_attachment(const Model& model, const LineEndDescription& end, int line, LineEnd which) {
  Attachment attachment;
  attachment.line = line;
  attachment.end = which;
  attachment.hold_place = true;
  attachment.hold_direction = end.clamped;
  attachment.direction = end.clamped ? Vec3(end.direction.normalized()) : Vec3::UnitX();
  attachment.body = end.kind == LineEndKind::body ? static_cast<int>(body_index(model.description, end.body)) : kGround;
  attachment.place = end.kind == LineEndKind::body ? end.at : end_place(model, end);
  return attachment;
}

constexpr double kWaveInfluenceDepths = 3.0;  ///< Depth of wave influence times the wave number; 5 % of the motion is
                                              ///< left there.
constexpr double kWaveElement = 0.15;         ///< Element length in that depth times the wave number.
constexpr double kMinElement = 1.0;           ///< Minimum element length [m].
constexpr double kMaxWaveElements = 150.0;    ///< Maximum number of such elements, for lines that float over much of
                                              ///< their length.

/// Returns the peak frequency of a group of waves [rad/s]; 0 without waves.
double peak_frequency(const WavesDescription& waves) {
  switch (waves.type) {
    case WaveType::none:
      return 0.0;
    case WaveType::airy:
    case WaveType::stokes5:
      return 2.0 * std::numbers::pi / waves.period;
    case WaveType::jonswap:
    case WaveType::pierson_moskowitz:
    case WaveType::ochi_hubble:
    case WaveType::torsethaugen:
      return waves.tp > 0.0 ? 2.0 * std::numbers::pi / waves.tp : 0.0;
    case WaveType::elevation: {
      const double tz = record_statistics(waves.record).tz;
      return tz > 0.0 ? 2.0 * std::numbers::pi / tz : 0.0;
    }
    case WaveType::user: {
      const auto lower = [](const auto& a, const auto& b) { return a.density < b.density; };
      const auto peak = std::max_element(waves.spectrum.begin(), waves.spectrum.end(), lower);
      return peak == waves.spectrum.end() ? 0.0 : peak->omega;
    }
  }
  return 0.0;
}

/// Returns the wave numbers at the spectral peaks of all groups of waves [1/m]; empty without waves.
std::vector<double> peak_wave_numbers(const EnvironmentDescription& around) {
  std::vector<double> numbers;
  for (const WavesDescription& waves : around.waves) {
    const double omega = peak_frequency(waves);
    if (omega > 0.0) numbers.push_back(linear_wave_number(omega, around.water_depth));
  }
  return numbers;
}

/// Stretches of a line of shape `q` that are close enough to the surface to be affected by waves. Wave motion decays
/// with depth as exp(kz); interpolated linearly over an element of a twentieth of a long line, most of the load would
/// be lost.
std::vector<FineStretch> stretches_in_waves(double k, const LineMesh& mesh, const std::vector<double>& q) {
  const double deepest = -kWaveInfluenceDepths / k;
  std::vector<FineStretch> fine;
  double felt = 0.0;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const double below = q[6 * e + 2] - deepest, above = q[6 * e + 8] - deepest;
    if (below <= 0.0 && above <= 0.0) continue;
    const double crossing = below * above < 0.0 ? mesh.s[e] + mesh.length[e] * below / (below - above) : mesh.s[e];
    fine.push_back({below > 0.0 ? mesh.s[e] : crossing, above > 0.0 ? mesh.s[e + 1] : crossing, 0.0});
    felt += fine.back().to - fine.back().from;
  }
  for (FineStretch& stretch : fine) stretch.size = std::max({kWaveElement / k, kMinElement, felt / kMaxWaveElements});
  return fine;
}

/// Builds the lines of a model on their meshes, refined by the stretches in `fine`; if it is empty, on the meshes of
/// their initial shapes.
LinesSetup setup_on(const Model& model, const std::vector<std::vector<FineStretch>>& fine) {
  LinesSetup setup;
  System& system = setup.system;
  system.bodies.resize(1 + model.description.bodies.size());
  int number = 0;
  for (const FreeLineDescription& line : model.description.lines) {
    const CableParts parts{line.segments, line.points};
    const Vec3 first = end_place(model, line.first), second = end_place(model, line.second);
    const CableShape start = make_cable_shape(model, parts, first, second);
    CableMesh mesh = make_mesh_requirements(model, line, parts);
    mesh.touchdown = start.touchdown();
    if (!fine.empty()) mesh.fine = fine[static_cast<std::size_t>(number)];
    system.lines.push_back(cable_line(model, parts, mesh, first, second));
    system.lines.back().name = line.name;
    setup.start.push_back(start.shape(system.lines.back().mesh));
    setup.lines.push_back(number);
    setup.wires.push_back(-1);
    system.attachments.push_back(make_attachment(model, line.first, number, LineEnd::first));
    system.attachments.push_back(make_attachment(model, line.second, number, LineEnd::last));
    const LineElements& elements = system.lines.back().elements;
    if (lies_at(line, line.first)) move_end_to_bed(model, elements.radius.front(), *(system.attachments.end() - 2));
    if (lies_at(line, line.second)) {
      move_end_to_bed(model, elements.radius[static_cast<std::size_t>(elements.count) - 1], system.attachments.back());
    }
    ++number;
  }
  system.surroundings = static_surroundings(body_poses(model), system.attachments);
  return setup;
}

/// Refined stretches where a line in equilibrium leaves the bed, away from the touchdown of its initial shape. In waves
/// such a line, with little tension there, is laid down and lifted element by element: elements of a fortieth of the
/// line would overestimate the variation of tension by a third.
std::vector<FineStretch> stretches_at_bed(const Model& model, const FreeLineDescription& description, const Line& line,
                                          const CableShape& start, const std::vector<double>& q, bool waves) {
  constexpr double kInWaves = 0.4;
  // relative to the length: the range covered by the short elements of the initial shape
  constexpr double kGuessed = 0.05;
  const CableParts parts{description.segments, description.points};
  CableMesh plain = make_mesh_requirements(model, description, parts);
  plain.touchdown = start.touchdown();
  const auto lies = [&](std::size_t node) {
    const std::size_t element = std::min(node, line.mesh.length.size() - 1);
    const Vec3 r = Eigen::Map<const Vec3>(q.data() + 6 * node);
    return ground_at(line.environment, r).clearance < 2.0 * line.elements.radius[element];
  };
  std::vector<FineStretch> fine;
  for (std::size_t node = 1; node < line.mesh.s.size(); ++node) {
    if (lies(node) == lies(node - 1)) continue;
    const double touchdown = 0.5 * (line.mesh.s[node] + line.mesh.s[node - 1]);
    if (plain.touchdown && std::abs(touchdown - *plain.touchdown) < kGuessed * parts.length()) continue;
    fine.push_back(make_touchdown_stretch(parts, plain, touchdown));
    if (waves) fine.back().size *= kInWaves;
  }
  return fine;
}

/// Stretches that need shorter elements than those of the initial shape. Computed from the equilibrium of the lines, as
/// the initial shape is the catenary of the mean weight, without the hog of a line with buoyancy or the effect of
/// current.
std::vector<std::vector<FineStretch>> refined_stretches(const Model& model, const std::vector<double>& wave_numbers) {
  const LinesSetup rough = setup_on(model, {});
  Assembly assembly(rough.system);
  SystemState state = make_initial_state(rough, 0.0);
  const LinesEquilibriumReport rest = solve_lines_one_by_one(assembly, state);
  std::vector<std::vector<FineStretch>> fine;
  for (std::size_t i = 0; i < rough.start.size(); ++i) {
    const FreeLineDescription& line = model.description.lines[i];
    const std::vector<double>& q = rest.lines[i].converged() ? state.lines[i].q : rough.start[i];
    const CableShape start = make_cable_shape(model, {line.segments, line.points}, end_place(model, line.first),
                                              end_place(model, line.second));
    fine.push_back(stretches_at_bed(model, line, rough.system.lines[i], start, q, !wave_numbers.empty()));
    for (const double k : wave_numbers) {
      const std::vector<FineStretch> felt = stretches_in_waves(k, rough.system.lines[i].mesh, q);
      fine.back().insert(fine.back().end(), felt.begin(), felt.end());
    }
  }
  return fine;
}

/// True if the initial shape of a line is exact except for bending and current.
bool is_catenary(const FreeLineDescription& line) {
  return line.segments.size() == 1 && line.points.empty();
}

}  // namespace

CableMesh make_mesh_requirements(const Model& model, const FreeLineDescription& line, const CableParts& parts) {
  CableMesh mesh{std::nullopt, line.element, 0.0, {}};
  if (!mesh.element && parts.has_pipe()) mesh.element = pipe_element(model, parts);
  return mesh;
}

bool has_linked_lines(const Description& description) {
  return ranges::any_of(description.lines, [](const FreeLineDescription& line) {
    return is_linked(line) || (!has_pipe_section(line) && is_weightless(line));
  });
}

LinesSetup lines_setup(const Model& model) {
  if (has_linked_lines(model.description)) return linked_lines_setup(model);
  const std::vector<double> wave_numbers = peak_wave_numbers(model.description.environment);
  const std::vector<FreeLineDescription>& lines = model.description.lines;
  const bool guessed = wave_numbers.empty() && std::all_of(lines.begin(), lines.end(), is_catenary);
  return setup_on(model, guessed ? std::vector<std::vector<FineStretch>>{} : refined_stretches(model, wave_numbers));
}

SurroundingsAt static_surroundings(const std::vector<VesselPose>& poses, const std::vector<Attachment>& attachments) {
  std::vector<RigidMotion> bodies;
  for (const VesselPose& pose : poses) bodies.push_back(resting(pose));
  // Captured by value, as the system may be moved.
  return [bodies, ends = attachments](double, Surroundings& surroundings) {
    ranges::copy(bodies, surroundings.bodies.begin());
    set_attachment_motions(ends, surroundings);
  };
}

SystemState make_initial_state(const LinesSetup& setup, double time) {
  return state_at_rest(setup.system, setup.start, time);
}

}  // namespace overbend
