#include "report/static/line_data.h"

#include "report/page/json_number.h"

namespace overbend {
namespace {

/// `in_time`: null without a run.
Json node_data(const LineResult& line, const LineDynamics* in_time) {
  Json s = Json::array(), places = Json::array(), tension = Json::array(), min_tension = Json::array(),
       max_tension = Json::array();
  for (std::size_t i = 0; i < line.nodes.size(); ++i) {
    const LineNodeResult& node = line.nodes[i];
    s.push_back(json_number(node.s));
    places.push_back({json_number(node.place.x()), json_number(node.place.y()), json_number(node.place.z())});
    tension.push_back(json_number(node.tension));
    min_tension.push_back(json_number(in_time != nullptr ? in_time->min_tension_at_nodes[i] : node.tension));
    max_tension.push_back(json_number(in_time != nullptr ? in_time->max_tension_at_nodes[i] : node.tension));
  }
  return {{"name", line.name},     {"s", s}, {"places", places}, {"tension", tension}, {"least", min_tension},
          {"largest", max_tension}};
}

}  // namespace

Json line_figure_data(const std::vector<LineResult>& lines, const std::vector<LineDynamics>& in_time) {
  Json data = Json::array();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    data.push_back(node_data(lines[i], in_time.empty() ? nullptr : &in_time[i]));
  }
  return data;
}

}  // namespace overbend
