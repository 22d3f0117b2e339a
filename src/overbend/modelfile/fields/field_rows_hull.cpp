#include <array>

#include "model/description/description_enum_names.h"
#include "modelfile/fields/row_makers.h"
#include "seafiles/hydrodynamics_reader.h"

namespace overbend::field_rows {
namespace {

const std::string kHull = "vessel.motion.coupled";
constexpr const char* kMirrored = "mirrored";

struct Freedom {
  const char* name;
  bool turns;
};
constexpr std::array<Freedom, 6> kFreedoms = {
    {{"surge", false}, {"sway", false}, {"heave", false}, {"roll", true}, {"pitch", true}, {"yaw", true}}};

CoupledHullDescription& take_coupled(VesselDescription& vessel, const FieldValue&) {
  vessel.motion = VesselMotion::coupled;
  return vessel.coupled.emplace();
}

std::vector<Field> body() {
  using Hull = CoupledHullDescription;
  const auto gyration = [](const char* key, int axis, const char* text) {
    return required(quantity_row(kHull + ".gyration." + key, component(axis), text, kLength,
                                 {.low = 0.0, .high = 1000.0, .low_open = true}));
  };
  const auto choice = [](const char* key, const Member& member, const char* text) {
    return row_of_kind(FieldKind::choice, kHull + "." + key, member, text);
  };
  Field files =
      required(row_of_kind(FieldKind::text, kHull + ".hydrodynamics", fills(&Hull::hydrodynamics),
                           "Hydrodynamic data of the hull, in the folder of the model file: the common stem of "
                           "WAMIT's .1, .3, .8 and .hst, or a file of another program. The contents decide how "
                           "it is read: WAMIT's .out, AQWA's .LIS or .AH1, Nemoh.cal, HDF5 of BEMIO, netCDF of "
                           "Capytaine, HydroDyn's input file, or an OrcaFlex text data file (.yml)."));
  files.file = true;
  std::vector<Field> rows = {
      group_row(kHull, opened_by<VesselDescription>(take_coupled),
                "The hull floats free: its motion follows from waves, current, lines and pipe."),
      files, required(quantity_row(kHull + ".mass", fills(&Hull::mass), "Mass of the loaded hull.", kMass, kPositive))};
  append(rows,
         vector_rows({.group = required(group_row(kHull + ".centre_of_gravity", enters(&Hull::centre_of_gravity),
                                                  "Centre of gravity, in the vessel's frame; the files refer to it.")),
                      .shown = kLength,
                      .texts = vessel_axis_texts()}));
  append(
      rows,
      {required(
           group_row(kHull + ".gyration", enters(&Hull::gyration), "Radii of gyration about the centre of gravity.")),
       gyration("roll", 0, "About the axis to the bow."), gyration("pitch", 1, "About the axis to port."),
       gyration("yaw", 2, "About the upward axis."),
       choice("ballast", defaults(&Hull::ballast),
              "trim: constant forces keep draught, heel and trim as given with lines and pipe attached; as_given: the "
              "hull sinks under them."),
       choice("radiation", defaults(&Hull::radiation),
              "Memory of radiated waves: state_space, a fitted sum of decaying exponentials; or direct convolution."),
       choice("wave_drift", defaults(&Hull::wave_drift),
              "Second-order forces: none, mean, or slowly varying (newman)."),
       choice("wave_drift_damping", defaults(&Hull::wave_drift_damping),
              "Change of the mean drift with low-frequency speed: none, or by Aranha's formula."),
       quantity_row(kHull + ".slow_period", defaults(&Hull::low_frequency_period),
                    "Corner period of the low-pass filter of position and heading.", kTime,
                    {.low = 1.0, .high = 1000.0})});
  return rows;
}

/// Decay test of a hull released from an offset.
std::vector<Field> release() {
  using Hull = CoupledHullDescription;
  const std::string r = kHull + ".release";
  std::vector<Field> rows = {group_row(
      r, {},
      "Offset from equilibrium at which a dynamic analysis releases the hull: a decay test, best in calm water.")};
  for (std::size_t i = 0; i < kFreedoms.size(); ++i) {
    const Freedom& f = kFreedoms[i];
    const auto take = [i](Hull& hull, const FieldValue& value) {
      (i < 3 ? hull.release_offset : hull.release_rotation)(static_cast<Eigen::Index>(i % 3)) = value.number;
    };
    rows.push_back(quantity_row(r + "." + f.name, with_default(taken_by<Hull>(take), 0.0),
                                "Offset in this degree of freedom.", f.turns ? kAngle : kLength,
                                f.turns ? Range{.low = -0.5, .high = 0.5} : Range{.low = -100.0, .high = 100.0}));
  }
  return rows;
}

/// Stiffness of a hull whose files have none.
std::vector<Field> missing_stiffness() {
  const std::string h = kHull + ".hydrostatics";
  return {otherwise(group_row(h, read_elsewhere(),
                              "Hydrostatic stiffness, weight included, about the centre of gravity, for files without "
                              "any."),
                    "that of the files"),
          required(quantity_row(h + ".heave", component(0), "Vertical force over heave.", {"N/m", "kN/m"}, kPositive)),
          required(quantity_row(h + ".roll", component(1), "Moment over roll, per radian.", kMoment, kPositive)),
          required(quantity_row(h + ".pitch", component(2), "Moment over pitch, per radian.", kMoment, kPositive))};
}

/// Points of the files in the vessel's frame.
void add_file_points(std::vector<Field>& rows, const std::string& convention) {
  using Source = HydrodynamicsSource;
  const auto reference = [](Source& source, const FieldValue&) -> Vec3& {
    return source.reference.emplace(Vec3::Zero());
  };
  append(rows, vector_rows({.group = otherwise(group_row(convention + ".reference", opened_by<Source>(reference),
                                                         "Reference point of the files' values, moments and motions; "
                                                         "they are transferred from it to the centre of gravity."),
                                               "as stated in the file, otherwise the centre of gravity"),
                            .shown = kLength,
                            .texts = vessel_axis_texts()}));
  rows.push_back(
      otherwise(row_of_kind(FieldKind::choice, convention + ".origin", fills(&Source::origin),
                            "Reference point of the files' values: waterline, the origin of their axes on the "
                            "water line; gravity_centre; or a group with a point, as reference."),
                "as stated in the file, otherwise the centre of gravity"));
  append(rows, vector_rows({.group = group_row(convention + ".origin", opened_by<Source>(reference),
                                               "Reference point in the vessel's frame, such as the keel."),
                            .shown = kLength,
                            .texts = vessel_axis_texts()}));
  append(rows, vector_rows({.group = otherwise(group_row(convention + ".file_origin", enters(&Source::file_origin),
                                                         "Origin of the axes in which a file gives its points."),
                                               "midship on the water line"),
                            .shown = kLength,
                            .texts = vessel_axis_texts()}));
}

/// Not part of the description; read by modelfile/reading/hull_files.h.
std::vector<Field> file_convention() {
  using Source = HydrodynamicsSource;
  const std::string c = kHull + ".convention";
  const auto take_sides = [](Source& source, const FieldValue& word) {
    source.mirror_headings = word.text == kMirrored;
  };
  Field headings =
      row_of_kind(FieldKind::choice, c + ".headings", with_default(taken_by<Source>(take_sides), "as_given"),
                  "as_given: the files cover all headings; mirrored: missing headings are taken from the other side of "
                  "a symmetric hull.");
  headings.choices = {"as_given", kMirrored};
  Field frequencies = otherwise(
      row_of_kind(
          FieldKind::choice, c + ".frequencies", fills(&Source::frequencies),
          "First column of WAMIT's files, as IPEROUT has it: periods, rad_per_s, hz, deep_wavenumbers (omega^2 L/g) "
          "or wavenumbers (k L). In all but periods 0 is zero and -1 infinite frequency; in periods the reverse."),
      "periods");
  std::vector<Field> rows = {
      group_row(c, read_elsewhere(), "Conventions of the files."),
      quantity_row(c + ".length_scale", defaults(&Source::length_scale), "ULEN of WAMIT.", kLength,
                   {.low = 0.0, .high = 1000.0, .low_open = true}),
      quantity_row(c + ".water_density", defaults(&Source::water_density),
                   "Water density by which the files' values are made dimensional.", {"kg/m^3", "kg/m^3"},
                   {.low = 900.0, .high = 1100.0}),
      quantity_row(c + ".gravity", defaults(&Source::gravity),
                   "Gravity by which the files' values are made dimensional.", {"m/s^2", "m/s^2"},
                   {.low = 9.0, .high = 11.0}),
      headings,
      frequencies,
      otherwise(row_of_kind(FieldKind::choice, c + ".stiffness", fills(&Source::stiffness),
                            "Stiffness in the files: with_weight (C44 = M g GM); hydrostatic_only, without the weight, "
                            "which is then added."),
                "with_weight; hydrostatic_only for HydroDyn"),
      otherwise(row_of_kind(FieldKind::integer, c + ".body", fills(&Source::body),
                            "Number of the body in a file of several.", {.low = 1.0, .high = 100.0}),
                "the only one"),
      otherwise(row_of_kind(FieldKind::text, c + ".vessel_type", fills(&Source::vessel_type),
                            "Name, if an OrcaFlex file has several vessel types."),
                "the only one"),
      otherwise(row_of_kind(FieldKind::text, c + ".draught", fills(&Source::draught),
                            "Name, if the vessel type has several draughts."),
                "the only one"),
      quantity_row(c + ".drift_from", defaults(&Source::drift_from),
                   "Frequency below which the mean drift is set to zero; panel programs give noise there.",
                   {"rad/s", "rad/s"}, {.low = 0.0, .high = 10.0})};
  add_file_points(rows, c);
  return rows;
}

/// `roll: 5 %` of critical damping, or a group of coefficients.
std::vector<Field> damping() {
  using Damping = ModeDampingDescription;
  using List = std::vector<Damping>;
  const std::string d = kHull + ".damping";
  std::vector<Field> rows = {
      otherwise(group_row(d, enters(&CoupledHullDescription::damping),
                          "Damping in addition to that of radiated waves, by degree of freedom."),
                "none")};
  const Range share = {.low = 0.0, .high = 2.0};
  for (const Freedom& f : kFreedoms) {
    const std::string p = d + "." + f.name;
    const auto open = [](List& list, const FieldValue& value) -> Damping& {
      Damping& mode = list.emplace_back();
      mode.mode = value.key;
      return mode;
    };
    const auto take = [open](List& list, const FieldValue& value) { open(list, value).ratio = value.number; };
    rows.push_back(quantity_row(p, taken_by<List>(take), "Fraction of critical damping; or a group of the keys below.",
                                {"1", "%"}, share));
    rows.push_back(group_row(p, opened_by<List>(open), "Damping of this degree of freedom."));
    rows.push_back(otherwise(
        quantity_row(p + ".ratio", fills(&Damping::ratio), "Fraction of critical damping.", {"1", "%"}, share),
        "none"));
    rows.push_back(otherwise(quantity_row(p + ".linear", fills(&Damping::linear), "Force over velocity.",
                                          f.turns ? Shown{"N*m*s", "kN*m*s"} : Shown{"N*s/m", "kN*s/m"}, kNotNegative),
                             "none"));
    rows.push_back(
        otherwise(quantity_row(p + ".quadratic", fills(&Damping::quadratic), "Force over squared velocity.",
                               f.turns ? Shown{"N*m*s^2", "kN*m*s^2"} : Shown{"N*s^2/m^2", "kN*s^2/m^2"}, kNotNegative),
                  "none"));
  }
  return rows;
}

/// Keys of a table of coefficients by direction.
template <class Owner>
std::vector<Field> coefficient_table(const std::string& p) {
  Field file = otherwise(row_of_kind(FieldKind::text, p + ".table", fills(&Owner::table_file),
                                     "CSV file with the columns angle_deg,cx,cy,cz, in the folder of the model file."),
                         "no table");
  file.file = true;
  return {
      file,
      otherwise(row_of_kind(FieldKind::choice, p + ".axes", fills(&Owner::axes),
                            "Convention of the angle and the signs of a table. to_from_bow: direction the flow goes "
                            "to, anticlockwise from the bow; from_bow: direction it comes from, clockwise from the "
                            "bow; from_stern_ocimf: as OCIMF, direction it comes from, anticlockwise from the stern. "
                            "In all three cx pushes forward, cy to port and cz turns the bow to port."),
                "required with a table"),
      otherwise(
          quantity_row(p + ".frontal_area", fills(&Owner::frontal_area), "Reference area of cx.", kArea, kPositive),
          "required with a table"),
      otherwise(quantity_row(p + ".lateral_area", fills(&Owner::lateral_area), "Reference area of cy and cz.", kArea,
                             kPositive),
                "required with a table"),
      otherwise(quantity_row(p + ".length", fills(&Owner::length), "Reference length of cz.", kLength, kPositive),
                "length of the vessel"),
  };
}

std::vector<Field> current() {
  using Current = HullCurrentDescription;
  const std::string c = kHull + ".current";
  const auto open = [](CoupledHullDescription& hull, const FieldValue& group) -> Current& {
    hull.current.stated = true;
    if (group.find("table") != nullptr) hull.current.form = HullCurrentModel::table;
    return hull.current;
  };
  const auto take = [](CoupledHullDescription& hull, const FieldValue&) {
    hull.current.stated = true;
    hull.current.form = HullCurrentModel::none;
  };
  const Range coefficient = {.low = 0.0, .high = 5.0};
  Field none =
      otherwise(row_of_kind(FieldKind::choice, c, taken_by<CoupledHullDescription>(take),
                            "none: the current does not act on the hull; otherwise a group of the keys below."),
                "strips; required if there is a current");
  none.choices = {enum_name(HullCurrentModel::none)};
  Field form = otherwise(row_of_kind(FieldKind::choice, c + ".form", fills(&Current::form),
                                     "strips: drag coefficients along the length; ufc: coefficients of UFC 4-159-03 by "
                                     "the hull's dimensions and the depth of water."),
                         "strips, or the table if given");
  form.choices = {enum_name(HullCurrentModel::strips), enum_name(HullCurrentModel::ufc)};
  std::vector<Field> rows = {
      none,
      group_row(c, opened_by<CoupledHullDescription>(open),
                "Forces of the current on the hull: strips, coefficients by its dimensions, or a table."),
      form,
      row_of_kind(FieldKind::number, c + ".transverse", defaults(&Current::transverse),
                  "Cross-flow drag coefficient of the strips, on length and draught.", coefficient),
      row_of_kind(FieldKind::number, c + ".longitudinal", defaults(&Current::longitudinal),
                  "Form drag coefficient along the hull, on beam and draught.", coefficient),
      row_of_kind(FieldKind::choice, c + ".relative_to", defaults(&Current::relative_to),
                  "water: the flow includes the orbital velocity of the waves; earth: the current alone."),
  };
  append(rows, coefficient_table<Current>(c));
  return rows;
}

std::vector<Field> wind() {
  using Wind = WindDescription;
  using Area = WindAreaDescription;
  const std::string w = kHull + ".wind", a = w + ".areas[]";
  std::vector<Field> rows = {
      otherwise(group_row(w, enters(&CoupledHullDescription::wind), "Steady wind on the vessel."), "no wind"),
      quantity_row(w + ".speed", defaults(&Wind::speed), "Mean speed.", kSpeed, {.low = 0.0, .high = 100.0}),
      quantity_row(w + ".from", defaults(&Wind::from), "Azimuth it comes from, clockwise from north.", kAngle,
                   azimuth()),
      quantity_row(w + ".air_density", defaults(&Wind::air_density), "Density of the air.", {"kg/m^3", "kg/m^3"},
                   {.low = 0.0, .high = 2.0, .low_open = true}),
      list_row(w + ".areas", enters(&Wind::areas), "Areas exposed to the wind; or a table.", "none"),
      group_row(a, appends_named<Area>("area"), "One area."),
      otherwise(row_of_kind(FieldKind::text, a + ".name", fills(&Area::name), "For the report."), "area 1, 2, ..."),
      required(quantity_row(a + ".area", fills(&Area::area), "Projected area.", kArea, kPositive)),
      row_of_kind(FieldKind::number, a + ".shape", defaults(&Area::shape),
                  "Shape coefficient: 1 for hull and deckhouses, 1.25 for open truss work.", {.low = 0.0, .high = 5.0}),
      row_of_kind(FieldKind::number, a + ".height", defaults(&Area::height), "Height coefficient.",
                  {.low = 0.0, .high = 5.0}),
      row_of_kind(FieldKind::choice, a + ".frontal", defaults(&Area::frontal),
                  "yes: faces the bow; no: faces the side."),
  };
  append(rows, coefficient_table<Wind>(w));
  append(rows, vector_rows({.group = required(
                                group_row(a + ".centre", enters(&Area::centre), "Its centre, in the vessel's frame.")),
                            .shown = kLength,
                            .texts = vessel_axis_texts()}));
  return rows;
}

std::vector<Field> hydrostatics() {
  using Stiffness = HydrostaticsDescription;
  const std::string h = "vessel.hydrostatics";
  return {
      otherwise(
          group_row(h, enters(&VesselDescription::hydrostatics),
                    "Restoring stiffness of a hull that floats in statics, balanced as drawn without lines and pipe."),
          "the hull is held as drawn, or vessel.motion.coupled"),
      required(quantity_row(h + ".heave", fills(&Stiffness::heave), "Vertical force over heave.", {"N/m", "kN/m"},
                            kPositive)),
      required(quantity_row(h + ".roll", fills(&Stiffness::roll), "Moment over roll, per radian.", kMoment, kPositive)),
      required(
          quantity_row(h + ".pitch", fills(&Stiffness::pitch), "Moment over pitch, per radian.", kMoment, kPositive)),
  };
}

}  // namespace

std::vector<Field> vessel_load_rows(const std::string& p) {
  using Load = VesselLoadDescription;
  const std::string l = p + "[]";
  const std::vector<std::string> along = {"Forward.", "To port.", "Upwards."};
  const std::vector<std::string> about = {"About the axis to the bow, starboard down.",
                                          "About the axis to port, bow down.", "About the upward axis, bow to port."};
  std::vector<Field> rows = {
      group_row(l, appends_named<Load>("load"),
                "One load: its direction stays along the vessel as drawn, its point moves with the hull."),
      otherwise(row_of_kind(FieldKind::text, l + ".name", fills(&Load::name), "For the report."), "load 1, 2, ...")};
  append(rows, vector_rows({.group = group_row(l + ".at", enters(&Load::at),
                                               "Point of application of the force, in the vessel's frame."),
                            .shown = kLength,
                            .texts = vessel_axis_texts(),
                            .all = false}));
  append(rows, vector_rows({.group = group_row(l + ".force", enters(&Load::force), "The force."),
                            .shown = kForce,
                            .texts = along,
                            .all = false}));
  append(rows, vector_rows({.group = group_row(l + ".moment", enters(&Load::moment), "Additional moment."),
                            .shown = kMoment,
                            .texts = about,
                            .all = false}));
  return rows;
}

std::vector<Field> hull() {
  std::vector<Field> rows = body();
  append(rows, missing_stiffness());
  append(rows, file_convention());
  append(rows, damping());
  append(rows, release());
  append(rows, current());
  append(rows, wind());
  append(rows, hydrostatics());
  append(rows, {list_row("vessel.loads", enters(&VesselDescription::loads), "Constant loads on the vessel.", "none")});
  append(rows, vessel_load_rows("vessel.loads"));
  return rows;
}

std::vector<Field> station_keeping() {
  using Keeping = StationKeepingDescription;
  const std::string d = "station_keeping.dp";
  std::vector<Field> rows = {
      otherwise(group_row("station_keeping", enters(&Description::station_keeping),
                          "Station keeping of the vessel in addition to lines."),
                "nothing"),
      required(group_row(d, {}, "Dynamic positioning: spring, damper and limit on the low-frequency motion."))};
  const auto part = [](Vec3 Keeping::*vector, int i) {
    return taken_by<Keeping>(
        [vector, i](Keeping& keeping, const FieldValue& value) { (keeping.*vector)[i] = value.number; });
  };
  int i = 0;
  for (const char* freedom : {"surge", "sway", "yaw"}) {
    const std::string p = d + "." + freedom;
    const bool turns = i == 2;
    append(rows, {group_row(p, {}, "This degree of freedom."),
                  required(quantity_row(p + ".stiffness", part(&Keeping::stiffness, i),
                                        turns ? "Moment over turn, per radian." : "Force over offset.",
                                        turns ? kMoment : Shown{"N/m", "kN/m"}, kPositive)),
                  quantity_row(p + ".damping", with_default(part(&Keeping::damping, i), 0.0),
                               turns ? "Moment over rate of turn." : "Force over velocity.",
                               turns ? Shown{"N*m*s", "kN*m*s"} : Shown{"N*s/m", "kN*s/m"}, kNotNegative),
                  otherwise(quantity_row(p + ".thrust_limit", part(&Keeping::limit, i),
                                         turns ? "Maximum moment of the thrusters." : "Maximum force of the thrusters.",
                                         turns ? kMoment : kForce, kPositive),
                            "not limited")});
    ++i;
  }
  return rows;
}

}  // namespace overbend::field_rows
