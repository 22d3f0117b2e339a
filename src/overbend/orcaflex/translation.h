/// State of the translation of an OrcaFlex file into a model: what was read, and what was written so far.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/vec.h"
#include "orcaflex/account.h"
#include "orcaflex/document.h"
#include "orcaflex/import_orcaflex.h"
#include "orcaflex/line_type.h"
#include "orcaflex/object.h"
#include "orcaflex/unit_system.h"

namespace overbend::orcaflex {

/// The vessel of the model. Lengths in m, angles in rad.
struct Vessel {
  std::string name;
  double length = 0.0;
  Vec3 position = Vec3::Zero();  ///< Position of its origin; z from the mean water level.
  double heading = 0.0;          ///< Direction of its bow, from X anticlockwise.
  double stern_shoe = 0.0;       ///< x of the stern shoe in the axes of the vessel.

  /// A point of the file's global axes in those of the vessel.
  Vec3 from_global(const Vec3& point) const;
  Vec3 to_global(const Vec3& point) const;
};

/// End of a line: `Connection, ConnectionX, ...`. Lengths in m, angles in rad.
struct LineEnd {
  enum class Kind { vessel, anchored, fixed, free, another };
  Kind kind = Kind::fixed;
  std::string connection;     ///< As in the file.
  Vec3 point = Vec3::Zero();  ///< In the axes of the vessel, or global; z of an anchored end from the bed.
  double azimuth = 0.0, declination = 0.0;
  bool is_clamped = false;
  std::optional<double> stiffness;  ///< Rotational spring, in the units of the file; empty if free or clamped.
  int line = 0;
};

/// Piece of a line of one type.
struct Piece {
  const LineType* type = nullptr;
  double length = 0.0;
};

struct Line {
  const Object* object = nullptr;
  std::string name;
  LineEnd ends[2];  ///< The upper one first.
  std::vector<Piece> pieces;
  double contents_density = 0.0;  ///< [kg/m^3]
  bool is_laid = false;           ///< The pipe being laid.
  bool is_mooring = false;

  double length() const;
};

struct Translation {
  Translation(const Document& read, const ImportOptions& settings, Diagnostics& messages)
      : document(read), options(settings), diagnostics(messages) {}

  const Document& document;
  const ImportOptions& options;
  Diagnostics& diagnostics;
  UnitSystemOfFile units;
  Account account;
  std::vector<Object> line_objects;  ///< Objects to which `Line::object` refers.
  std::map<std::string, LineType> line_types;
  Vessel vessel;
  std::optional<Object> vessel_object, vessel_type;
  std::vector<Line> lines;
  double water_level = 0.0;  ///< Z of the mean water level in the file [m].

  const Line* laid_pipe() const;

  /// Group with a single object, such as General.
  std::optional<Object> group(const std::string& name) const;
  /// All objects of a group that is a list.
  std::vector<Object> objects(const std::string& name) const;

  void translated(std::string text) { account.translated.push_back(std::move(text)); }
  void approximated(std::string text) { account.approximated.push_back(std::move(text)); }
  void left_out(std::string text, bool matters = false) { account.left_out.push_back({std::move(text), matters}); }
};

/// A number as it stands in a model: twelve digits, without those that rounding leaves.
std::string number_text(double value);
/// `number_text` with a unit: "0.3239 m".
std::string quantity_text(double value, const char* unit);
/// A name as a YAML scalar.
std::string name_text(const std::string& name);

// Each reads its part of the file and returns the keys of the model, as lines of YAML. In this order: what a part reads
// serves those after it.
void read_vessel(Translation& translation);
void read_lines(Translation& translation);
std::string environment_text(Translation& translation);
std::string pipe_text(Translation& translation);
std::string vessel_text(Translation& translation);
std::string tensioner_text(Translation& translation);
std::string supports_text(Translation& translation);
std::string moorings_text(Translation& translation);
std::string lines_text(Translation& translation);

}  // namespace overbend::orcaflex
