/// Description of the lay: the content of the model file in SI units, before frames, mesh and derived properties.
/// Units are m, kg, s, N, Pa, rad. Azimuths are clockwise from north, in rad. Vessel positions are in the vessel frame
/// V (origin midship on the water, x forward, y port, z up); ramp, stinger and tensioner in the frame S (origin on the
/// stern shoe, X astern, Z up). A member without a value in the file carries the default written here; `std::optional`
/// is used only where "not given" has a meaning of its own.
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

/// Document control for the report's first page. Texts of the user, empty if not given.
struct ReportDescription {
  std::string client, project, document, revision, prepared, checked;
};

/// The whole model file.
struct Description {
  Description();  // Defined in one source file to limit code size.
  Description(const Description&);
  Description(Description&&) noexcept;
  Description& operator=(const Description&);
  Description& operator=(Description&&) noexcept;
  ~Description();

  std::string title;
  ReportDescription report;
  std::string source_file;  ///< Path as given by the user.
  std::string source_text;  ///< Text of the file, echoed into the results.
  EnvironmentDescription environment;
  bool has_pipe = true;  ///< False: hull and moorings or free lines only; pipe, tensioner and supports are unused.
  PipeDescription pipe;
  VesselDescription vessel;
  TensionerDescription tensioner;
  std::vector<RollerKindDescription> rollers;
  SupportsDescription supports;
  RouteDescription route;  ///< Route along which the pipe is laid.
  MeshDescription mesh;
  StaticSettings statics;
  std::optional<DynamicSettings> dynamics;
  CheckSettings checks;
  std::optional<FatigueDescription> fatigue;
  std::optional<MooringsDescription> moorings;
  std::vector<FreeLineDescription> lines;  ///< Free lines, with or without a pipe.
  std::vector<BodyDescription> bodies;     ///< Bodies other than the vessel to which line ends are attached.
  std::optional<StationKeepingDescription> station_keeping;
  OperationDescription operation;
  std::optional<LayTableDescription> lay_table;
  /// Operation stage that this description represents, see model/lay_stage.h; empty: the line as laid.
  std::optional<LayStageDescription> stage;
  Findings findings;  ///< Unusual input that was accepted.
};

}  // namespace overbend
