/// A first model from a few numbers: sizes by API 5L, the rest by plain rules of thumb that the written file explains.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <variant>

namespace overbend {

/// Defaults for questions without an answer.
inline constexpr const char* kUsualPipe = "16";
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

/// Of "BGL-1", and a typical one for "barge" or "ship".
VesselSize vessel_size(const std::string& vessel);

/// Margins added to the rules of thumb where checks of the resulting model are exceeded.
struct NewMargins {
  int walls = 0;         ///< Sizes of the list of walls beyond the least.
  double tension = 1.0;  ///< Times the least horizontal tension.
  double radius = 1.0;   ///< Times the least stinger radius.
};

/// The numbers of a new model, SI.
struct NewModel {
  NewOptions said;  ///< The input it was made from.
  std::string title, vessel = "barge";
  bool stinger = true;  ///< S-lay.
  double diameter = 0.0, wall = 0.0, yield = 0.0, coating = 0.0, concrete = 0.0;
  double depth = 0.0, tension = 0.0, stinger_radius = 0.0;
  double departure_angle = 0.0;                   ///< Of a catenary of that tension [rad].
  int ramp_boxes = 0, boxes = 0;                  ///< On the ramp, on the stinger.
  double circle_start = 0.0;                      ///< Frame S: where ramp and stinger, one circle, leave the level [m].
  double stinger_start = 0.0, stinger_tip = 0.0;  ///< Frame S: first and last box of the stinger [m].
  double weight_in_air = 0.0, submerged_weight = 0.0;  ///< [N/m]
  double tensioner_height = 0.0;                       ///< Pipe axis above the stern shoe [m].
  std::string note;  ///< Problems that remain with the given input; a comment in the file.
};

/// The model with everything chosen that was not said, or a sentence that says what is wrong. Rules of thumb alone: the
/// lay is not calculated here.
std::variant<NewModel, std::string> choose_model(const NewOptions& options, const NewMargins& margins = {});

/// The text as typed, where it is a quantity of this value [SI]; else the value in `unit`.
std::string as_said(const std::string& text, double value, const std::string& si_unit, const std::string& unit);

/// The commented model file.
std::string model_text(const NewModel& model);

/// Wall thicknesses of API 5L, thinnest first [mm].
std::span<const double> api_walls();

/// Outside diameter [m] of a nominal pipe size in inches (API 5L); empty when there is none.
std::optional<double> nominal_diameter(double inches);

}  // namespace overbend
