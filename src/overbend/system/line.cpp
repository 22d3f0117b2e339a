#include "system/line.h"

namespace overbend {

double weight_from(const LineMesh& mesh, const LineElements& elements, double from) {
  double weight = 0.0;
  for (std::size_t e = 0; e < mesh.length.size(); ++e) {
    if (mesh.s[e] >= from) weight += elements.weight[e] * mesh.length[e];
  }
  return weight;
}

Line pipe_line(const Model& model, LineMesh mesh, const LayRoute& route) {
  Line line;
  line.mesh = std::move(mesh);
  line.elements = line_elements(model, line.mesh.length, line.mesh.section);
  line.environment = line_environment(model, route);
  line.route = route.pieces();
  line.yielding = yielding_elements(model, line.mesh);
  line.force_scale = weight_from(line.mesh, line.elements, line.mesh.s.front());
  return line;
}

}  // namespace overbend
