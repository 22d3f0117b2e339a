/// The moored barge of the examples, and the same barge on lines that stand by themselves in place of its moorings.
#pragma once

#include "modelfile/reading/yaml_reader.h"
#include "results/mooring_results.h"

namespace overbend::testing {

/// Without current, friction and much bending stiffness, pushed and turned by a load.
inline Description pushed_barge() {
  Description d = read_model(OVERBEND_SOURCE_DIR "/examples/moored-barge.yaml").description.value();
  d.environment.current.clear();
  d.environment.seabed.friction_axial = d.environment.seabed.friction_lateral = 0.0;
  for (MooringLineDescription& line : d.moorings->lines) {
    line.segments[0].type.friction = 0.0;
    line.segments[0].type.bending_stiffness = 10.0;
  }
  VesselLoadDescription& load = d.vessel.loads.emplace_back();
  load.force = Vec3(20e3, 200e3, 0.0);
  load.moment = Vec3(0.0, 0.0, 3e6);
  return d;
}

/// Lines of the lengths and between the places of mooring lines at rest, from their anchors.
inline Description on_lines(Description d, const std::vector<MooringLineResult>& moorings) {
  for (std::size_t i = 0; i < moorings.size(); ++i) {
    const MooringLineDescription& moored = d.moorings->lines[i];
    FreeLineDescription& line = d.lines.emplace_back();
    line.name = moorings[i].name;
    line.first.kind = LineEndKind::bed;
    line.first.at = moorings[i].anchor_W;
    line.second.kind = LineEndKind::body;
    line.second.at = moored.fairlead;
    line.segments = {moored.segments[0]};
    line.segments[0].length = moorings[i].length;
  }
  d.moorings.reset();
  return d;
}

}  // namespace overbend::testing
