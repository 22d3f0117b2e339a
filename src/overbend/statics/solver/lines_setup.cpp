#include "statics/solver/lines_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "mechanics/ground.h"
#include "model/bodies.h"
#include "model/waves/wave_theory.h"
#include "statics/solver/lines_statics.h"
#include "statics/solver/linked_lines.h"
#include "system/assembly.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

/// Whether an end is one of pipe along the bed.
bool lies_at(const FreeLineDescription& line, const LineEndDescription& end) {
  return end.kind == LineEndKind::bed && end.clamped && has_pipe_section(line);
}

/// Pipe that is led along the bed lies at rest where it is held: on its underside, as deep as it sinks in.
void rest_on_bed(const Model& model, double radius, Attachment& held) {
  const Vec3 normal = model.seabed.surface.normal(held.place.x(), held.place.y());
  held.place += radius / normal.z() * Vec3::UnitZ();
  held.direction = (held.direction - normal.dot(held.direction) * normal).normalized();
  held.free_along = normal;
}

Attachment attachment_of(const Model& model, const LineEndDescription& end, int line, LineEnd which) {
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

constexpr double kFelt = 3.0;          ///< Waves are felt down to this over their wave number: 5 % are left there.
constexpr double kWaveElement = 0.15;  ///< Element there, over the same wave number.
constexpr double kShortest = 1.0;      ///< No shorter [m].
constexpr double kMostPieces = 150.0;  ///< Nor more of them than this, where much of a line floats.

/// Wave number that the most of a sea's energy has [1/m]; 0 in calm water.
double main_wave_number(const EnvironmentDescription& around) {
  const WavesDescription& waves = around.waves;
  double omega = 0.0;
  switch (waves.type) {
    case WaveType::none:
      return 0.0;
    case WaveType::airy:
    case WaveType::stokes5:
      omega = 2.0 * std::numbers::pi / waves.period;
      break;
    case WaveType::jonswap:
    case WaveType::pierson_moskowitz:
      omega = 2.0 * std::numbers::pi / waves.tp;
      break;
    case WaveType::user: {
      const auto lower = [](const auto& a, const auto& b) { return a.density < b.density; };
      const auto peak = std::max_element(waves.spectrum.begin(), waves.spectrum.end(), lower);
      if (peak == waves.spectrum.end()) return 0.0;
      omega = peak->omega;
      break;
    }
  }
  return omega > 0.0 ? linear_wave_number(omega, around.water_depth) : 0.0;
}

/// Where a line of shape `q` is near enough to the surface to feel the waves. Their motion dies away with depth by
/// exp(kz); taken linearly over an element of a twentieth of a long line, most of what acts on it is not there.
std::vector<FineStretch> stretches_in_waves(double k, const LineMesh& mesh, const std::vector<double>& q) {
  const double deepest = -kFelt / k;
  std::vector<FineStretch> fine;
  double felt = 0.0;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    const double below = q[6 * e + 2] - deepest, above = q[6 * e + 8] - deepest;
    if (below <= 0.0 && above <= 0.0) continue;
    const double crossing = below * above < 0.0 ? mesh.s[e] + mesh.length[e] * below / (below - above) : mesh.s[e];
    fine.push_back({below > 0.0 ? mesh.s[e] : crossing, above > 0.0 ? mesh.s[e + 1] : crossing, 0.0});
    felt += fine.back().to - fine.back().from;
  }
  for (FineStretch& stretch : fine) stretch.size = std::max({kWaveElement / k, kShortest, felt / kMostPieces});
  return fine;
}

/// The lines of a model, each on the mesh that is made for it; those not given on that of their first guess.
LinesSetup setup_on(const Model& model, const std::vector<std::vector<FineStretch>>& fine) {
  LinesSetup setup;
  System& system = setup.system;
  system.bodies.resize(1 + model.description.bodies.size());
  int number = 0;
  for (const FreeLineDescription& line : model.description.lines) {
    const CableParts parts{line.segments, line.points};
    const Vec3 first = end_place(model, line.first), second = end_place(model, line.second);
    const CableStart start = cable_start(model, parts, first, second);
    CableMesh mesh = wanted_mesh(model, line, parts);
    mesh.touchdown = start.touchdown();
    if (!fine.empty()) mesh.fine = fine[static_cast<std::size_t>(number)];
    system.lines.push_back(cable_line(model, parts, mesh, first, second));
    system.lines.back().name = line.name;
    setup.start.push_back(start.shape(system.lines.back().mesh));
    setup.lines.push_back(number);
    setup.wires.push_back(-1);
    system.attachments.push_back(attachment_of(model, line.first, number, LineEnd::first));
    system.attachments.push_back(attachment_of(model, line.second, number, LineEnd::last));
    const LineElements& elements = system.lines.back().elements;
    if (lies_at(line, line.first)) rest_on_bed(model, elements.radius.front(), *(system.attachments.end() - 2));
    if (lies_at(line, line.second)) {
      rest_on_bed(model, elements.radius[static_cast<std::size_t>(elements.count) - 1], system.attachments.back());
    }
    ++number;
  }
  system.surroundings = resting_surroundings(body_poses(model), system.attachments);
  return setup;
}

/// Where a line at rest on a mesh leaves the bed, away from where its first guess does. In waves such a line, whose
/// tension there is small, is laid down and lifted by elements: of a fortieth of the line they would make a swing of
/// the tension a third too large.
std::vector<FineStretch> stretches_at_bed(const Model& model, const FreeLineDescription& description, const Line& line,
                                          const CableStart& start, const std::vector<double>& q, bool waves) {
  constexpr double kInWaves = 0.4;
  constexpr double kGuessed = 0.05;  // of the length: so far the short elements of the first guess serve
  const CableParts parts{description.segments, description.points};
  CableMesh plain = wanted_mesh(model, description, parts);
  plain.touchdown = start.touchdown();
  const auto lies = [&](std::size_t node) {
    const std::size_t element = std::min(node, line.mesh.length.size() - 1);
    const Vec3 r = Eigen::Map<const Vec3>(q.data() + 6 * node);
    return ground_at(line.environment, r).clearance < 2.0 * line.elements.radius[element];
  };
  std::vector<FineStretch> fine;
  for (std::size_t node = 1; node < line.mesh.s.size(); ++node) {
    if (lies(node) == lies(node - 1)) continue;
    const double at = 0.5 * (line.mesh.s[node] + line.mesh.s[node - 1]);
    if (plain.touchdown && std::abs(at - *plain.touchdown) < kGuessed * parts.length()) continue;
    fine.push_back(stretch_at_touchdown(parts, plain, at));
    if (waves) fine.back().size *= kInWaves;
  }
  return fine;
}

/// Where shorter elements are wanted than the first guess asks for. The lines are brought to rest for that: the guess
/// is the catenary of a line's mean weight, and does not know the hog of a line with buoyancy, nor what a current does.
std::vector<std::vector<FineStretch>> stretches_at_rest(const Model& model, double k) {
  const LinesSetup rough = setup_on(model, {});
  Assembly assembly(rough.system);
  SystemState state = start_of(rough, 0.0);
  const LinesRest rest = rest_lines(assembly, state);
  std::vector<std::vector<FineStretch>> fine;
  for (std::size_t i = 0; i < rough.start.size(); ++i) {
    const FreeLineDescription& line = model.description.lines[i];
    const std::vector<double>& q = rest.lines[i].converged() ? state.lines[i].q : rough.start[i];
    const CableStart start =
        cable_start(model, {line.segments, line.points}, end_place(model, line.first), end_place(model, line.second));
    fine.push_back(stretches_at_bed(model, line, rough.system.lines[i], start, q, k > 0.0));
    if (k <= 0.0) continue;
    const std::vector<FineStretch> felt = stretches_in_waves(k, rough.system.lines[i].mesh, q);
    fine.back().insert(fine.back().end(), felt.begin(), felt.end());
  }
  return fine;
}

/// Whether the first guess of a line is its shape but for bending and current.
bool is_catenary(const FreeLineDescription& line) {
  return line.segments.size() == 1 && line.points.empty();
}

}  // namespace

CableMesh wanted_mesh(const Model& model, const FreeLineDescription& line, const CableParts& parts) {
  CableMesh mesh{std::nullopt, line.element, 0.0, {}};
  if (!mesh.element && parts.has_pipe()) mesh.element = pipe_element(model, parts);
  return mesh;
}

bool has_linked_lines(const Description& description) {
  return std::ranges::any_of(description.lines, [](const FreeLineDescription& line) {
    return is_linked(line) || (!has_pipe_section(line) && is_weightless(line));
  });
}

LinesSetup lines_setup(const Model& model) {
  if (has_linked_lines(model.description)) return linked_lines_setup(model);
  const double k = main_wave_number(model.description.environment);
  const std::vector<FreeLineDescription>& lines = model.description.lines;
  const bool guessed = k <= 0.0 && std::all_of(lines.begin(), lines.end(), is_catenary);
  return setup_on(model, guessed ? std::vector<std::vector<FineStretch>>{} : stretches_at_rest(model, k));
}

SurroundingsAt resting_surroundings(const std::vector<VesselPose>& poses, const std::vector<Attachment>& attachments) {
  std::vector<RigidMotion> bodies;
  for (const VesselPose& pose : poses) bodies.push_back(resting(pose));
  // By value: the system may be moved.
  return [bodies, ends = attachments](double, Surroundings& now) {
    std::ranges::copy(bodies, now.bodies.begin());
    lead_attachments(ends, now);
  };
}

SystemState start_of(const LinesSetup& setup, double time) {
  return state_at_rest(setup.system, setup.start, time);
}

}  // namespace overbend
