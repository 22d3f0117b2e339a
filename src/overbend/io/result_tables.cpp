#include <fmt/format.h>

#include <numbers>
#include <vector>

#include "io/result_field.h"
#include "io/results_writer.h"

namespace overbend {
namespace {

constexpr double kKilo = 1e-3, kMega = 1e-6, kPercent = 100.0, kDegrees = 180.0 / std::numbers::pi;

/// Rows by RFC 4180: commas, CR LF, quotes where a text needs them; twelve digits.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<const char*>& names) {
    for (const char* name : names) cell(std::string(name));
    end_row();
  }
  CsvTable& cell(const std::string& text) {
    if (!row_start_) text_ += ',';
    row_start_ = false;
    if (text.find_first_of(",\"\r\n") == std::string::npos) {
      text_ += text;
      return *this;
    }
    text_ += '"';
    for (const char c : text) text_ += (c == '"') ? std::string("\"\"") : std::string(1, c);
    text_ += '"';
    return *this;
  }
  CsvTable& cell(double value) { return cell(fmt::format("{:.12g}", value == 0.0 ? 0.0 : value)); }
  void end_row() {
    text_ += "\r\n";
    row_start_ = true;
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
  bool row_start_ = true;
};

}  // namespace

std::string pipe_table(const StaticResults& results) {
  CsvTable table({"s [m]",
                  "x [m]",
                  "y [m]",
                  "z [m]",
                  "tension [kN]",
                  "bending moment [kN m]",
                  "curvature [1/m]",
                  "axial stress [MPa]",
                  "bending stress [MPa]",
                  "hoop stress [MPa]",
                  "von Mises stress [MPa]",
                  "strain [%]",
                  "astern [m]",
                  "inclination [deg]",
                  "wall tension [kN]",
                  "vertical moment [kN m]",
                  "lateral moment [kN m]",
                  "seabed reaction [kN/m]",
                  "penetration [m]",
                  "region"});
  for (const Station& p : results.stations) {
    table.cell(p.s).cell(p.p_W.x()).cell(p.p_W.y()).cell(p.p_W.z());
    table.cell(p.effective_tension * kKilo).cell(p.bending_moment * kKilo).cell(p.curvature);
    table.cell(p.axial_stress * kMega).cell(p.bending_stress * kMega).cell(p.hoop_stress * kMega);
    table.cell(p.von_mises * kMega).cell(p.strain * kPercent).cell(p.astern).cell(p.inclination * kDegrees);
    table.cell(p.wall_tension * kKilo).cell(p.vertical_moment * kKilo).cell(p.lateral_moment * kKilo);
    table.cell(p.seabed_reaction * kKilo).cell(p.penetration).cell(std::string(word(p.region)));
    table.end_row();
  }
  return table.text();
}

std::string supports_table(const StaticResults& results) {
  CsvTable table({"name", "row", "position", "reaction normal [kN]", "reaction vertical [kN]",
                  "reaction longitudinal [kN]", "reaction lateral [kN]", "separation [m]", "x [m]", "y [m]", "z [m]",
                  "pipe s [m]"});
  for (const SupportResult& support : results.supports) {
    for (std::size_t i = 0; i < support.rows.size(); ++i) {
      for (const RollerResult& roller : support.rows[i].rollers) {
        table.cell(support.name).cell(std::to_string(i + 1)).cell(std::string(word(roller.position)));
        table.cell(roller.reaction * kKilo).cell(roller.vertical * kKilo).cell(roller.longitudinal * kKilo);
        table.cell(roller.lateral * kKilo).cell(roller.separation);
        table.cell(roller.p_W.x()).cell(roller.p_W.y()).cell(roller.p_W.z());
        if (support.rows[i].s < 0.0) {
          table.cell(std::string());  // the pipe does not cross the row
        } else {
          table.cell(support.rows[i].s);
        }
        table.end_row();
      }
    }
  }
  return table.text();
}

}  // namespace overbend
