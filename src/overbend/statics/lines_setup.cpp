#include "statics/lines_setup.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/wave_theory.h"
#include "system/vessel_body.h"

namespace overbend {
namespace {

Attachment attachment_of(const Model& model, const LineEndDescription& end, int line, LineEnd which) {
  Attachment attachment;
  attachment.line = line;
  attachment.end = which;
  attachment.hold_place = true;
  attachment.hold_direction = end.clamped;
  attachment.direction = end.clamped ? Vec3(end.direction.normalized()) : Vec3::UnitX();
  attachment.body = end.kind == LineEndKind::body ? 0 : kGround;
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

/// Where a line is near enough to the surface to feel the waves, by its first shape. Their motion dies away with depth
/// by exp(kz); taken linearly over an element of a twentieth of a long line, most of what acts on it is not there.
std::vector<FineStretch> stretches_in_waves(const Model& model, const CableParts& parts, const CableStart& start,
                                            const CableMesh& plain) {
  const double k = main_wave_number(model.description.environment);
  if (k <= 0.0) return {};
  const double deepest = -kFelt / k;
  const LineMesh mesh = cable_mesh(parts, plain);
  const std::vector<double> q = start.shape(mesh);
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

}  // namespace

Vec3 end_place(const Model& model, const LineEndDescription& end) {
  switch (end.kind) {
    case LineEndKind::body:
      return model.mean_pose.p_WV + model.mean_pose.R_WV * end.at;
    case LineEndKind::bed:
      return {end.at.x(), end.at.y(), model.seabed.surface.height(end.at.x(), end.at.y())};
    case LineEndKind::fixed:
    case LineEndKind::water:
      break;
  }
  return end.at;
}

LinesSetup lines_setup(const Model& model) {
  LinesSetup setup;
  System& system = setup.system;
  system.bodies.resize(1);
  int number = 0;
  for (const FreeLineDescription& line : model.description.lines) {
    const CableParts parts{line.segments, line.points};
    const Vec3 first = end_place(model, line.first), second = end_place(model, line.second);
    const CableStart start = cable_start(model, parts, first, second);
    CableMesh mesh{start.touchdown(), line.element, 0.0, {}};
    mesh.fine = stretches_in_waves(model, parts, start, mesh);
    system.lines.push_back(cable_line(model, parts, mesh, first, second));
    setup.start.push_back(start.shape(system.lines.back().mesh));
    system.attachments.push_back(attachment_of(model, line.first, number, LineEnd::first));
    system.attachments.push_back(attachment_of(model, line.second, number, LineEnd::last));
    ++number;
  }
  // By value: the system may be moved.
  system.surroundings = [vessel = resting(model.mean_pose), ends = system.attachments](double, Surroundings& now) {
    now.bodies.front() = vessel;
    lead_attachments(ends, now);
  };
  return setup;
}

SystemState start_of(const LinesSetup& setup, double time) {
  return state_at_rest(setup.system, setup.start, time);
}

}  // namespace overbend
