#include "model/structures.h"

#include <gtest/gtest.h>

#include "model/lay_stage.h"
#include "support/fixtures.h"

namespace overbend {
namespace {

StructureDescription arrestor(std::optional<double> sample) {
  StructureDescription s;
  s.name = "arrestor";
  s.at = sample;
  s.length = 3.0;
  s.weight_in_air = 30e3;
  s.weight_submerged = 18e3;
  s.bending_stiffness = 400e6;
  s.diameter = 0.7;
  return s;
}

Model with(std::vector<StructureDescription> structures, double segment = 0.0) {
  Description d = testing::plain_description();
  d.pipe.structures = std::move(structures);
  if (segment > 0.0) d.pipe.segments = {{"thick end", segment, d.pipe.section}};
  return build_model(d);
}

const Section& section_at(const Model& model, double from_top) {
  return model.sections[static_cast<std::size_t>(model.section_at(from_top))];
}

}  // namespace

TEST(structures, have_their_own_weight_stiffness_and_diameter_over_their_length) {
  const Model model = with({arrestor(50.0)});
  const Section& section = section_at(model, 50.0);
  EXPECT_EQ(section.kind, SectionKind::structure);
  EXPECT_DOUBLE_EQ(section.weight_in_air, 10e3);
  EXPECT_DOUBLE_EQ(section.weight_submerged, 6e3);
  EXPECT_DOUBLE_EQ(section.EI, 400e6);
  EXPECT_DOUBLE_EQ(section.EA, model.sections.front().EA);
  EXPECT_DOUBLE_EQ(section.outer_diameter, 0.7);
  EXPECT_NEAR(section.external_area * model.water_weight_density, 4e3, 1e-9);  // what it displaces: its weights differ
  EXPECT_EQ(model.kind_at(48.4), SectionKind::pipe);
  EXPECT_EQ(model.kind_at(48.6), SectionKind::structure);
  EXPECT_EQ(model.kind_at(51.4), SectionKind::structure);
  EXPECT_EQ(model.kind_at(51.6), SectionKind::pipe);
}

TEST(structures, cut_the_segment_in_which_they_lie) {
  const Model model = with({arrestor(50.0)}, 80.0);
  EXPECT_EQ(section_at(model, 40.0).name, "thick end");
  EXPECT_EQ(section_at(model, 50.0).name, "arrestor");
  EXPECT_EQ(section_at(model, 60.0).name, "thick end");
  EXPECT_EQ(section_at(model, 90.0).name, "pipe");
  double end = 0.0;
  for (const SectionSpan& span : model.spans) {  // by rising distance and not over each other, as the mesh takes them
    EXPECT_GE(span.from, end);
    end = span.to;
  }
}

TEST(structures, inboard_of_the_tensioner_are_left_out) {
  EXPECT_EQ(with({arrestor(0.0)}).spans.front().to, 1.5);
  Description d = testing::plain_description();
  d.pipe.structures = {arrestor(std::nullopt)};
  EXPECT_TRUE(build_model(d).spans.empty());
}

TEST(structures, pass_along_the_line_stage_by_stage) {
  Description d = testing::plain_description();
  d.pipe.structures = {arrestor(std::nullopt)};
  d.operation.type = OperationType::passage;
  d.operation.lay.structure = "arrestor";
  StageProgram& program = d.operation.lay.program.emplace();
  program.from = 10.0;
  program.to = 30.0;
  program.steps = 4;
  const auto stages = lay_stages(d);
  ASSERT_EQ(stages.size(), 5U);
  const Model model = build_model(make_stage_description(d, stages[1]));
  EXPECT_EQ(model.kind_at(15.0), SectionKind::structure);
  EXPECT_EQ(model.kind_at(12.0), SectionKind::pipe);
}

}  // namespace overbend
