// Boxes that give under the pipe.
#include <gtest/gtest.h>

#include "modelfile/reading/yaml_reader.h"
#include "statics/recovery/recovery.h"
#include "statics/solver/statics.h"

namespace overbend {
namespace {

/// A lay over boxes of one roller each, whose structure has this stiffness [N/m].
Model over_boxes(double structure) {
  Description d =
      read_model(std::string(OVERBEND_SOURCE_DIR) + "/validation/static_cases/BGL1-T250.yaml").description.value();
  for (RollerKindDescription& kind : d.rollers) {
    kind.stiffness.reset();
    kind.sides.reset();
    kind.default_stiffness = RollerStiffness::physical;
    kind.structure_stiffness = structure;
  }
  d.mesh.overbend_element = 1.0;
  d.mesh.touchdown_element = 3.0;
  d.mesh.max_element_length = 8.0;
  return build_model(d);
}

// Springs in series: the box sinks by the reaction over its own stiffness, in addition to shell and coating.
TEST(box_compliance, lets_a_box_sink_by_its_reaction_over_its_stiffness) {
  constexpr double kBox = 2e6;
  const Model model = over_boxes(kBox);
  const StaticResults lay = recover_state(model, solve_statics(model).solution.value());
  std::size_t number = 0;
  int loaded = 0;
  for (const SupportResult& support : lay.supports) {
    for (const RowResult& row : support.rows) {
      for (const RollerResult& roller : row.rollers) {
        const ContactStiffness parts = model.contact_parts(model.supports.rollers[number++]);
        if (roller.reaction < 1e3) continue;
        ++loaded;
        double sunk = roller.reaction / kBox;
        for (const double part : {parts.shell, parts.coating}) sunk += part > 0.0 ? roller.reaction / part : 0.0;
        EXPECT_NEAR(-roller.separation, sunk, 1e-3 * sunk) << support.name;
        EXPECT_GT(roller.reaction / kBox, 0.5 * sunk) << support.name;
      }
    }
  }
  EXPECT_GT(loaded, 4);
}

}  // namespace
}  // namespace overbend
