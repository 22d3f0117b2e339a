/// Complete lays compared with solutions of the planar extensible elastica.
#include <fmt/core.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "base/json.h"
#include "groups.h"
#include "lay.h"
#include "statics/equations/touchdown.h"

namespace overbend::validation {
namespace {

constexpr double kAngle = 0.05 * std::numbers::pi / 180.0;
constexpr double kPlace = 0.10;           ///< [m]
constexpr double kCountsAsContact = 1e3;  ///< [N]

/// Rows of one case.
class CaseTable {
 public:
  explicit CaseTable(const std::string& name)
      : name_(name),
        lay_(build_model(case_description(name))),
        expected_(read_json_file(OVERBEND_SOURCE_DIR "/validation/static_cases/" + name + ".expected.json")),
        more_(read_json_file(OVERBEND_SOURCE_DIR "/validation/cases_public.json")["static"]) {}

  Table make() {
    add_section();
    add_whole_line();
    add_regions();
    add_supports();
    add_stations();
    if (more_.contains(name_)) {
      add_details(more_[name_]["expected"]);
    }
    return {name_, lay_.results().title, std::move(rows_)};
  }

 private:
  void add(const std::string& quantity, const std::string& unit, double scale, double ours, double reference,
           double allowed, const std::string& basis) {
    rows_.push_back({name_, quantity, unit, scale * ours, scale * reference, scale * allowed, basis});
  }
  /// Adds the value if the case has it; the file holds it in the printed unit.
  void add_if(const Json& from, const char* key, const std::string& quantity, const std::string& unit, double scale,
              double ours, double share, double min_value, const std::string& basis) {
    if (from.contains(key)) {
      const double reference = from[key].get<double>() / scale;
      add(quantity, unit, scale, ours, reference, relative_tolerance(reference, share, min_value), basis);
    }
  }

  void add_section() {
    const DerivedSection& s = lay_.results().sections.front();
    const Json& d = expected_["derived"];
    const char* basis = "arithmetic; digits the inputs give";
    add("EA", "MN", 1e-6, s.EA, d["EA"], relative_tolerance(d["EA"], 1e-6), basis);
    add("EI", "kN m2", 1e-3, s.EI, d["EI"], relative_tolerance(d["EI"], 1e-6), basis);
    add("weight in air", "kN/m", 1e-3, s.weight_in_air, d["weight_in_air"],
        relative_tolerance(d["weight_in_air"], 1e-6), basis);
    add("submerged weight", "kN/m", 1e-3, s.weight_submerged, d["weight_submerged"],
        relative_tolerance(d["weight_submerged"], 2e-6), basis);
  }

  void add_whole_line() {
    const StaticResults& r = lay_.results();
    const Json& e = expected_["static"];
    const double T = e["top_tension"], H = e["bottom_tension"];
    add("tension at the tensioner", "kN", 1e-3, r.top_tension, T, relative_tolerance(T, 1e-3), "elastica, 0.1 %");
    add("tension on the bed", "kN", 1e-3, lay_.solution().state.far_force, H, relative_tolerance(H, 1e-3),
        "elastica, 0.1 %");
    add_if(e, "lay_back", "lay-back", "m", 1.0, r.lay_back, 0.0, kPlace, "elastica, 0.10 m");
    add_if(e, "top_to_touchdown", "top to touchdown, horizontal", "m", 1.0, r.top_to_touchdown, 0.0, kPlace,
           "elastica, 0.10 m");
    add_if(e, "length_top_to_touchdown", "top to touchdown, unstressed length", "m", 1.0, r.length_top_to_touchdown,
           0.0, kPlace, "elastica, 0.10 m");
    add_if(e, "departure_angle", "departure angle", "rad", 1.0, r.departure_angle, 0.0, kAngle, "elastica, 0.05 deg");
  }

  void add_region(const Json& e, const RegionResult& region, const std::string& where, double share,
                  const std::string& basis) {
    const double moment = e["max_bending_moment"], stress = e["max_bending_stress"];
    add("largest bending moment, " + where, "kN m", 1e-3, region.bending_moment.value, moment,
        relative_tolerance(moment, share), basis);
    add("largest bending stress, " + where, "MPa", 1e-6, region.bending_stress.value, stress,
        relative_tolerance(stress, share), basis);
  }

  void add_regions() {
    const Json& e = expected_["static"];
    if (e.contains("overbend")) {
      add_region(e["overbend"], lay_.results().overbend.value(), "overbend", 1e-3, "elastica, 0.1 % at the contact");
    }
    add_region(e["sagbend"], lay_.results().sagbend, "sagbend", 3e-3, "elastica, 0.3 %");
  }

  void add_supports() {
    if (!expected_["static"].contains("supports")) {
      return;
    }
    for (const Json& e : expected_["static"]["supports"]) {
      const std::string support = e["name"];
      const SupportResult& ours = support_named(support);
      const double reaction = e["reaction"];
      if (reaction >= kCountsAsContact) {
        add(support + ": reaction", "kN", 1e-3, ours.reaction, reaction, relative_tolerance(reaction, 0.01, 500.0),
            "elastica, the larger of 1 % and 0.5 kN");
      } else {
        add(support + ": gap", "mm", 1e3, ours.separation, e["separation"], 5e-3, "elastica, 5 mm");
      }
    }
  }

  const SupportResult& support_named(const std::string& name) const {
    for (const SupportResult& support : lay_.results().supports) {
      if (support.name == name) {
        return support;
      }
    }
    throw std::runtime_error("no support " + name);
  }

  void add_stations() {
    double x = 0.0, z = 0.0, angle = 0.0, tension = 0.0, moment = 0.0, max_moment = 0.0;
    const Json& stations = expected_["stations_from_top"];
    int count = 0;
    for (const Json& e : stations) {
      if (e["s"].get<double>() > lay_.system().mesh().total_length()) {
        continue;  // our line lies on the bed for a shorter stretch
      }
      const Station ours = lay_.station_at(e["s"]);
      const auto worst = [](double& difference, double a, double b) {
        difference = std::max(difference, std::abs(a - b));
      };
      const double origin = expected_["static"].contains("supports") ? 0.0 : tensioner_astern();
      worst(x, ours.astern - origin, e["x"]);
      worst(z, ours.p_W.z(), e["z"]);
      worst(angle, ours.inclination, e["inclination"]);
      worst(tension, ours.effective_tension, e["effective_tension"]);
      worst(moment, ours.vertical_moment, e["bending_moment"]);
      max_moment = std::max(max_moment, std::abs(e["bending_moment"].get<double>()));
      ++count;
    }
    const std::string over = fmt::format(", largest difference at {} stations", count);
    const double top = expected_["static"]["top_tension"];
    add("x" + over, "m", 1.0, x, 0.0, 0.05, "elastica, 0.05 m");
    add("z" + over, "m", 1.0, z, 0.0, 0.05, "elastica, 0.05 m");
    add("inclination" + over, "rad", 1.0, angle, 0.0, kAngle, "elastica, 0.05 deg");
    add("tension" + over, "kN", 1e-3, tension, 0.0, 1e-3 * top, "elastica, 0.1 % of the top tension");
    add("moment" + over, "kN m", 1e-3, moment, 0.0, 3e-3 * max_moment, "elastica, 0.3 % of the largest");
  }

  double tensioner_astern() const { return lay_.results().stations.back().astern; }

  /// Adds the values that only the file with all details has.
  void add_details(const Json& e) {
    const StaticResults& r = lay_.results();
    const Station top = lay_.station_at(0.0), landing = lay_.station_at(r.length_top_to_touchdown);
    double penetration = 0.0;
    for (const Station& s : r.stations) {
      penetration = std::max(penetration, s.penetration);
    }
    add_if(e, "M_top_kNm", "moment at the top", "kN m", 1e-3, top.vertical_moment, 1.5e-2, 10.0, "elastica, 1.5 %");
    add_if(e, "T_touchdown_kN", "tension at touchdown", "kN", 1e-3, landing.effective_tension, 1e-3, 0.0,
           "elastica, 0.1 %");
    add_if(e, "M_touchdown_kNm", "moment at touchdown", "kN m", 1e-3, landing.vertical_moment, 0.0,
           3e-3 * 1e3 * e["sagbend_max_moment_kNm"].get<double>(), "elastica, 0.3 % of the sagbend's");
    const double deepest = e["max_penetration_m"];
    add("largest penetration of the bed", "mm", 1e3, penetration, deepest, relative_tolerance(deepest, 0.01),
        "elastica, 1 %");
    if (const auto waterline = find_waterline(lay_.system(), lay_.solution().state); waterline) {
      add_if(e, "s_waterline", "length from the top to the water", "m", 1.0,
             lay_.system().mesh().total_length() - waterline->s, 0.0, 0.05, "elastica, 0.05 m");
    }
    const double sag = r.sagbend.von_mises.value;
    const double all = r.overbend ? std::max(sag, r.overbend->von_mises.value) : sag;
    add_if(e, "von_mises_max_MPa", "largest von Mises stress", "MPa", 1e-6, all, 0.01, 0.0, "elastica, 1 %");
    add_if(e, "von_mises_sagbend_max_MPa", "largest von Mises stress, sagbend", "MPa", 1e-6, sag, 0.01, 0.0,
           "elastica, 1 %");
    add_if(e, "sagbend_max_moment_x", "place of the largest moment of the sagbend, x", "m", 1.0,
           r.sagbend.bending_moment.astern - (e.contains("supports") ? 0.0 : tensioner_astern()), 0.0, 3.0,
           "elastica; a flat maximum sampled at stations");
    if (e.contains("supports")) {
      add_contacts(e["supports"]);
    }
  }

  void add_contacts(const Json& supports) {
    double angle = 0.0, moment = 0.0, max_moment = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      if (supports[i]["reaction_kN"].get<double>() < 1.0) {
        continue;
      }
      const Station ours = lay_.at_roller(i);
      const double reference = 1e3 * supports[i]["M_kNm"].get<double>();
      const double theta = -supports[i]["theta_deg"].get<double>() * std::numbers::pi / 180.0;
      moment = std::max(moment, std::abs(ours.vertical_moment - reference));
      angle = std::max(angle, std::abs(ours.inclination - theta));
      max_moment = std::max(max_moment, std::abs(reference));
      ++count;
    }
    const std::string over = fmt::format(", largest difference at {} contacts", count);
    add("moment" + over, "kN m", 1e-3, moment, 0.0, 1e-3 * max_moment, "elastica, 0.1 % of the largest");
    add("inclination" + over, "rad", 1.0, angle, 0.0, kAngle, "elastica, 0.05 deg");
  }

  std::string name_;
  Lay lay_;
  Json expected_, more_;
  std::vector<Row> rows_;
};

}  // namespace

Group static_cases() {
  Group group{
      "Complete lays",
      "elastica by spectral collocation",
      "Complete lays: tensioner, ramp, stinger, sagbend and seabed. The references are solutions of the planar "
      "extensible elastica by spectral collocation with an active set of rollers, with an error below 1e-8; the "
      "tolerances correspond to the scatter of a chain of rigid links of 0.25 to 1 m. Bending moments are taken at the "
      "contact itself. Differences larger than rounding have two causes: our rollers have a stiffness of 1e6 kN/m "
      "while those of the references are rigid (except in S16-T300-kc1e4, where both are flexible), and our pipe is "
      "shortened by water pressure (Poisson's ratio), that of the references is not.",
      {}};
  for (const char* name : {"S16-T250", "S16-T300", "S16-T400", "S16-T300-kc1e4", "S16-T300-2roll", "S16-T300-z2printed",
                           "BGL1-T250", "J12-D400-T560"}) {
    group.tables.push_back(CaseTable(name).make());
  }
  return group;
}

}  // namespace overbend::validation
