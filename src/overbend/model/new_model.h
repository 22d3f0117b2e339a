/// First model from a few numbers: sizes by API 5L, the rest by simple rules of thumb that the written file explains.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

namespace overbend {

/// Defaults for options that are not given.
inline constexpr const char* kDefaultPipe = "16";
inline constexpr const char* kUsualDepth = "90 m";

/// The user's input as typed: quantities with units. Empty = choose.
struct NewOptions {
  std::string pipe, depth, wall, concrete, stinger_radius, tension, vessel, title;
  std::string yield = "414 MPa";
  std::string coating = "3.2 mm";
  std::string lay = "s";  ///< "s" or "j".
  int boxes = 0;          ///< 0 = choose.
  std::string output;     ///< Empty = standard output.
  bool force = false;
};

/// Main dimensions of a vessel [m].
struct VesselSize {
  double length, beam, depth, draught;
};

/// Returns the dimensions of "BGL-1", or typical ones for "barge" or "ship".
VesselSize vessel_size(const std::string& vessel);

/// Margins on the rules of thumb, increased if checks of the resulting model are exceeded.
struct NewMargins {
  int walls = 0;         ///< Sizes of the list of walls above the minimum.
  double tension = 1.0;  ///< Factor on the minimum horizontal tension.
  double radius = 1.0;   ///< Factor on the minimum stinger radius.
};

/// Numbers of a new model, SI.
struct NewModel {
  NewOptions said;  ///< Options from which the model was made.
  std::string title, vessel = "barge";
  bool stinger = true;  ///< S-lay.
  double diameter = 0.0, wall = 0.0, yield = 0.0, coating = 0.0, concrete = 0.0;
  double depth = 0.0, tension = 0.0, stinger_radius = 0.0;
  double departure_angle = 0.0;                   ///< Departure angle of a catenary with that tension [rad].
  int ramp_boxes = 0, boxes = 0;                  ///< Number of boxes on the ramp and on the stinger.
  double circle_start = 0.0;                      ///< Frame S: beginning of the common circle of ramp and stinger [m].
  double stinger_start = 0.0, stinger_tip = 0.0;  ///< Frame S: first and last box of the stinger [m].
  double weight_in_air = 0.0, submerged_weight = 0.0;  ///< [N/m]
  double tensioner_height = 0.0;                       ///< Pipe axis above the stern shoe [m].
  std::string note;  ///< Remaining problems with the given input; written as a comment in the file.
};

/// Returns the model with all missing options chosen, or an error message. Uses rules of thumb only: the lay is not
/// calculated here.
std::variant<NewModel, std::string> choose_model(const NewOptions& options, const NewMargins& margins = {});

/// Returns the text as typed if it is a quantity of this value [SI]; otherwise the value in `unit`.
std::string text_or_value(const std::string& text, double value, const std::string& si_unit, const std::string& unit);

/// Returns the commented model file.
std::string model_text(const NewModel& model);

/// Returns the wall thicknesses of API 5L in increasing order [mm].
std::span<const double> api_walls();

/// Returns the outside diameter [m] of a nominal pipe size in inches (API 5L); empty if there is none.
std::optional<double> nominal_diameter(double inches);

}  // namespace overbend
