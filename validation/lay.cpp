#include "lay.h"

#include <algorithm>
#include <stdexcept>

#include "modelfile/reading/yaml_reader.h"

namespace overbend::validation {

Lay::Lay(Model model) : model_(std::make_unique<Model>(std::move(model))) {
  StaticOutcome outcome = solve_statics(*model_);
  if (!outcome.solution) {
    throw std::runtime_error(model_->description.title + ": " + outcome.failure->what + ": " + outcome.failure->why);
  }
  solution_ = std::move(*outcome.solution);
  results_ = recover_statics(*model_, solution_);
  system_ = std::make_unique<StaticSystem>(*model_, model_->mean_pose, solution_.mesh);
  cuts_ = cut_forces(*system_, solution_.state);
}

Station Lay::station(int element, double xi) const {
  const CutForces cut = cut_at(*system_, solution_.state, cuts_, element, xi);
  return finish_stations(*model_, {make_station(*system_, solution_.state, cut, element, xi)}, system_->mesh(), {})
      .front();
}

Station Lay::station_at(double from_top) const {
  const LineMesh& mesh = system_->mesh();
  const double s = std::clamp(mesh.total_length() - from_top, 0.0, mesh.total_length());
  const auto after = std::upper_bound(mesh.s.begin(), mesh.s.end(), s);
  const int element = std::clamp(static_cast<int>(after - mesh.s.begin()) - 1, 0, mesh.elements() - 1);
  const std::size_t e = static_cast<std::size_t>(element);
  return station(element, (s - mesh.s[e]) / mesh.length[e]);
}

Station Lay::at_roller(std::size_t roller) const {
  const ClosestPoint& closest = system_->contacts()[roller].closest;
  return station(closest.element, closest.xi);
}

Description case_description(const std::string& name) {
  const ModelReading reading = read_model(OVERBEND_SOURCE_DIR "/validation/static_cases/" + name + ".yaml");
  if (!reading.description) {
    throw std::runtime_error("cannot read the case " + name);
  }
  return *reading.description;
}

}  // namespace overbend::validation
