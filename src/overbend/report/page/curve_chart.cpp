#include "report/page/curve_chart.h"

#include <array>

#include "report/page/json_number.h"

namespace overbend {
namespace {

const char* word(CurveLook look) {
  constexpr std::array kEnumNames = {"line", "thin", "marks"};
  return kEnumNames[static_cast<std::size_t>(look)];
}

Json curves_json(const std::vector<ChartCurve>& curves) {
  Json list = Json::array();
  for (const ChartCurve& curve : curves) {
    Json points = Json::array();
    for (const auto& [across, up] : curve.points) points.push_back({json_number(across), json_number(up)});
    Json json = {{"name", curve.name}, {"points", points}, {"look", word(curve.look)}, {"in_legend", curve.in_legend}};
    if (curve.colour) json["colour"] = *curve.colour;
    list.push_back(std::move(json));
  }
  return list;
}

}  // namespace

Blocks curve_figure(const CurveChart& chart, const std::string& caption) {
  return block::figure({"curves", caption, {"whole"}}, {{"across", chart.across},
                                                        {"up", chart.up},
                                                        {"curves", curves_json(chart.curves)},
                                                        {"ground", curves_json(chart.ground)},
                                                        {"water", curves_json(chart.water)}});
}

}  // namespace overbend
