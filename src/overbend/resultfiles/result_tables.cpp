#include "resultfiles/result_tables.h"

#include "resultfiles/result_field.h"
#include "resultfiles/results_writer.h"

namespace overbend {

std::vector<std::string> pipe_head() {
  return {"s [m]",
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
          "residual curvature [1/m]",
          "region",
          "from tensioner [m]"};
}

void pipe_cells(CsvTable& table, const StaticResults& results, const Station& p) {
  table.cell(p.s).cell(p.p_W.x()).cell(p.p_W.y()).cell(p.p_W.z());
  table.cell(p.effective_tension * kKilo).cell(p.bending_moment * kKilo).cell(p.curvature);
  table.cell(p.axial_stress * kMega).cell(p.bending_stress * kMega).cell(p.hoop_stress * kMega);
  table.cell(p.von_mises * kMega).cell(p.strain * kPercent).cell(p.astern).cell(p.inclination * kDegrees);
  table.cell(p.wall_tension * kKilo).cell(p.vertical_moment * kKilo).cell(p.lateral_moment * kKilo);
  table.cell(p.seabed_reaction * kKilo)
      .cell(p.penetration)
      .cell(p.residual_curvature)
      .cell(std::string(word(p.region)))
      .cell(results.stations.back().s - p.s);
}

std::vector<std::string> supports_head() {
  return {"name",
          "row",
          "position",
          "reaction normal [kN]",
          "reaction vertical [kN]",
          "reaction longitudinal [kN]",
          "reaction lateral [kN]",
          "separation [m]",
          "x [m]",
          "y [m]",
          "z [m]",
          "pipe s [m]",
          "from tensioner [m]"};
}

void roller_cells(CsvTable& table, const StaticResults& results, const SupportResult& support, std::size_t row,
                  const RollerResult& roller) {
  table.cell(support.name).cell(std::to_string(row + 1)).cell(std::string(word(roller.position)));
  table.cell(roller.reaction * kKilo).cell(roller.vertical * kKilo).cell(roller.longitudinal * kKilo);
  table.cell(roller.lateral * kKilo).cell(roller.separation);
  table.cell(roller.p_W.x()).cell(roller.p_W.y()).cell(roller.p_W.z());
  if (support.rows[row].s < 0.0) {
    table.cell(std::string()).cell(std::string());  // the pipe does not cross the row
  } else {
    table.cell(support.rows[row].s).cell(results.stations.back().s - support.rows[row].s);
  }
}

std::string pipe_table(const StaticResults& results) {
  CsvTable table(pipe_head());
  for (const Station& station : results.stations) {
    pipe_cells(table, results, station);
    table.end_row();
  }
  return table.text();
}

std::string supports_table(const StaticResults& results) {
  CsvTable table(supports_head());
  for (const SupportResult& support : results.supports) {
    for (std::size_t i = 0; i < support.rows.size(); ++i) {
      for (const RollerResult& roller : support.rows[i].rollers) {
        roller_cells(table, results, support, i, roller);
        table.end_row();
      }
    }
  }
  return table.text();
}

}  // namespace overbend
