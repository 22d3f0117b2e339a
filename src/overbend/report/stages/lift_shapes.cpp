#include "report/stages/lift_shapes.h"

#include <algorithm>
#include <limits>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "model/model.h"
#include "report/page/curve_chart.h"
#include "report/stages/stage_labels.h"

namespace overbend {
namespace {

struct Course {
  Vec3 origin = Vec3::Zero(), direction = Vec3::UnitX();  ///< `way` is a horizontal unit vector.

  double at(const Vec3& place) const { return direction.dot(place - origin); }
};

Course find_course(const LiftedLine& line) {
  const bool first_held = line.second.free && !line.first.free;
  const Vec3 &held = first_held ? line.first.location.place : line.second.location.place,
             &free = first_held ? line.second.location.place : line.first.location.place;
  Vec3 direction = free - held;
  direction.z() = 0.0;
  return {held, direction.norm() > 1e-9 ? Vec3(direction.normalized()) : Vec3::UnitX()};
}

/// One chart in the plane of the first pipe; a colour for every stage.
class SideView {
 public:
  explicit SideView(const Course& course) : course_(course), scale_(shown_unit("m").factor) {
    const std::string metres = " [" + shown_name("m") + "]";
    chart_.across = "Along the pipe, from its held end" + metres;
    chart_.up = "z" + metres;
  }

  void add(const std::string& title, const StaticResults& lay, std::size_t colour) {
    bool first = true;
    for (const LiftedLine& line : lay.lift->lines) {
      ChartCurve& curve = add_curve(title + (first ? "" : ", " + line.name), CurveLook::line, colour);
      curve.in_legend = first;
      first = false;
      for (const LiftedNode& node : line.nodes) {
        if (is_near(line, node.location.arc_length)) curve.points.push_back(point(node.location.place));
      }
    }
    for (const LineResult& line : lay.lines) {
      if (ranges::find(lay.lift->lines, line.name, &LiftedLine::name) != lay.lift->lines.end()) continue;
      ChartCurve& curve = add_curve(title + ", " + line.name, CurveLook::thin, colour);
      for (const LineNodeResult& node : line.nodes) curve.points.push_back(point(node.place));
    }
    for (const LiftedWire& wire : lay.lift->davits) {
      add_curve(title + ", " + wire.name + " on " + wire.on, CurveLook::marks, colour).points = {
          point(wire.location.place)};
    }
    if (lay.lift->join) {
      add_curve(title + ", weld", CurveLook::marks, colour).points = {point(lay.lift->join->location.place)};
    }
  }

  void add_surroundings(const std::optional<Description>& description) {
    chart_.water.push_back({"water level", {{-1e9, 0.0}, {1e9, 0.0}}});
    if (!description) return;
    constexpr int kParts = 60;
    const SeabedSurface bed = build_model(*description).seabed.surface;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const ChartCurve& curve : chart_.curves) {
      for (const auto& [across, up] : curve.points) {
        low = std::min(low, across);
        high = std::max(high, across);
      }
    }
    ChartCurve& line = chart_.ground.emplace_back();
    line.name = "seabed";
    for (int i = 0; i <= kParts; ++i) {
      const double across = low + (high - low) * i / kParts;
      const Vec3 place = course_.origin + across / scale_ * course_.direction;
      line.points.emplace_back(across, scale_ * bed.height(place.x(), place.y()));
    }
  }

  const CurveChart& chart() const { return chart_; }

 private:
  /// Pipe far behind the lift-off is omitted: it is uniform.
  static bool is_near(const LiftedLine& line, double arc_length) {
    const double length = line.nodes.back().location.arc_length;
    const double from_free = line.second.free && !line.first.free ? length - arc_length : arc_length;
    return from_free <= 1.15 * line.suspended_length + 10.0;
  }

  std::pair<double, double> point(const Vec3& place) const { return {scale_ * course_.at(place), scale_ * place.z()}; }

  ChartCurve& add_curve(const std::string& name, CurveLook look, std::size_t colour) {
    chart_.curves.push_back({name, {}, look, colour, false});
    return chart_.curves.back();
  }

  Course course_;
  double scale_;
  CurveChart chart_;
};

}  // namespace

Blocks lift_side_view(const OperationResults& results, const std::optional<Description>& description) {
  std::optional<SideView> view;
  for (std::size_t i = 0; i < results.stages.size(); ++i) {
    const std::optional<StaticResults>& lay = results.stages[i].lay;
    if (!lay || !lay->lift || lay->lift->lines.empty()) continue;
    if (!view) view.emplace(find_course(lay->lift->lines.front()));
    view->add(stage_title(results, i), *lay, i);
  }
  if (!view) return {};
  view->add_surroundings(description);
  return curve_figure(view->chart(),
                      "Side view of all lines at every stage: pipe thick, other lines thin, circles at attachments "
                      "and welds; dashed: water level and seabed");
}

}  // namespace overbend
