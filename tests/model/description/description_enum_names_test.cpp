#include "model/description/description_enum_names.h"

#include <gtest/gtest.h>

#include <set>

namespace overbend {
namespace {

template <typename Enum>
void expect_one_word_each(Enum last) {
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto value = static_cast<Enum>(i);
    ASSERT_NO_THROW(texts.insert(enum_name(value)));
    EXPECT_EQ(from_enum_name<Enum>(enum_name(value)), value);
  }
  EXPECT_EQ(texts.size(), enum_names<Enum>().size());
}

TEST(description_enum_names, every_enumerator_has_one_word_of_its_own) {
  expect_one_word_each(MaterialLaw::moment_curvature);
  expect_one_word_each(WaveType::elevation);
  expect_one_word_each(VesselMotion::coupled);
  expect_one_word_each(Guide::pinned);
  expect_one_word_each(TensionerMode::constant);
  expect_one_word_each(RollerDamping::textbook);
  expect_one_word_each(RollerStiffness::penalty);
  expect_one_word_each(Structure::stinger);
  expect_one_word_each(LayTableVary::depth);
  expect_one_word_each(RouteTension::minimum);
  expect_one_word_each(SupportContact::gap_springs);
  expect_one_word_each(StaticMethod::dynamic_relaxation);
  expect_one_word_each(LayHistory::monotonic);
  expect_one_word_each(SeabedLayHistory::pulled_sideways);
  expect_one_word_each(RollerFriction::haul);
  expect_one_word_each(SoilModel::bilinear);
  expect_one_word_each(CheckCodes::api);
  expect_one_word_each(SafetyClass::high);
  expect_one_word_each(Manufacture::uoe);
  expect_one_word_each(YieldBasis::fy);
  expect_one_word_each(ApiEdition::fifth);
  expect_one_word_each(CurrentLoad::functional);
  expect_one_word_each(Radiation::convolution);
  expect_one_word_each(WaveDrift::newman);
  expect_one_word_each(WaveDriftDamping::aranha);
  expect_one_word_each(Ballast::as_given);
  expect_one_word_each(HullCurrentModel::ufc);
  expect_one_word_each(CurrentRelativeTo::earth);
  expect_one_word_each(CoefficientAxes::from_stern_ocimf);
  expect_one_word_each(RopeCore::fibre);
  expect_one_word_each(ChainLink::studlink);
  expect_one_word_each(PointKind::buoy);
  expect_one_word_each(BuoyShape::cylinder);
  expect_one_word_each(LineEndKind::water);
  expect_one_word_each(MooringModel::quasi_static);
  expect_one_word_each(WinchMode::tension);
  expect_one_word_each(FindMooring::lengths);
  expect_one_word_each(OperationType::hold_back);
  expect_one_word_each(StageTension::seek);
  expect_one_word_each(MoveShape::zero_vibration);
  expect_one_word_each(true);
}

}  // namespace
}  // namespace overbend
