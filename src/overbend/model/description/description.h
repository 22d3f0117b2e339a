/// Description of the lay: the content of the model file in SI units, before frames, mesh and derived properties.
///
/// Units are m, kg, s, N, Pa, rad. Azimuths stay as on a chart: clockwise from north, in rad. Vessel positions are in
/// the vessel frame V (origin midship on the water, x forward, y port, z up); ramp, stinger and tensioner in the frame
/// S (origin on the stern shoe, X astern, Z up). A member without a value in the file carries the default written here;
/// `std::optional` is used only where "not given" has a meaning of its own.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/finding.h"
#include "model/description/analysis_description.h"
#include "model/description/body_description.h"
#include "model/description/check_settings.h"
#include "model/description/environment_description.h"
#include "model/description/fatigue_description.h"
#include "model/description/lay_table_description.h"
#include "model/description/line_description.h"
#include "model/description/mooring_description.h"
#include "model/description/pipe_description.h"
#include "model/description/route_description.h"
#include "model/description/supports_description.h"
#include "model/description/tensioner_description.h"
#include "model/description/vessel_description.h"

namespace overbend {

/// Document control: what the head of the report says of itself. Plain words of the user, empty where not given.
struct ReportDescription {
  std::string client, project, document, revision, prepared, checked;
};

/// The whole model file.
struct Description {
  Description();  // These six are compiled once: a copy of all members is long, and many sources make one.
  Description(const Description&);
  Description(Description&&) noexcept;
  Description& operator=(const Description&);
  Description& operator=(Description&&) noexcept;
  ~Description();

  std::string title;
  ReportDescription report;
  std::string source_file;  ///< Path as given by the user.
  std::string source_text;  ///< The file's text, echoed into the results.
  EnvironmentDescription environment;
  bool has_pipe =
      true;  ///< False: hull and moorings, or lines, by themselves; pipe, tensioner and supports say nothing.
  PipeDescription pipe;
  VesselDescription vessel;
  TensionerDescription tensioner;
  std::vector<RollerKindDescription> rollers;
  SupportsDescription supports;
  RouteDescription route;  ///< On which the pipe is laid.
  MeshDescription mesh;
  StaticSettings statics;
  std::optional<DynamicSettings> dynamics;
  CheckSettings checks;
  std::optional<FatigueDescription> fatigue;
  std::optional<MooringsDescription> moorings;
  std::vector<FreeLineDescription> lines;  ///< Besides the pipe, or alone.
  std::vector<BodyDescription> bodies;     ///< Besides the vessel, that ends of lines are on.
  std::optional<StationKeepingDescription> station_keeping;
  OperationDescription operation;
  std::optional<LayTableDescription> lay_table;
  /// The stage of an operation on the line that this is, see model/lay_stage.h; none: the line as laid.
  std::optional<LayStageDescription> stage;
  Findings findings;  ///< Unusual input that was accepted.
};

}  // namespace overbend
