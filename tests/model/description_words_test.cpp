#include "model/description_words.h"

#include <gtest/gtest.h>

#include <set>

namespace overbend {
namespace {

template <typename Enum>
void expect_one_word_each(Enum last) {
  std::set<std::string> words;
  for (int i = 0; i <= static_cast<int>(last); ++i) {
    const auto value = static_cast<Enum>(i);
    ASSERT_NO_THROW(words.insert(word_of(value)));
    EXPECT_EQ(from_word<Enum>(word_of(value)), value);
  }
  EXPECT_EQ(words.size(), words_of<Enum>().size());
}

TEST(description_words, every_enumerator_has_one_word_of_its_own) {
  expect_one_word_each(MaterialLaw::moment_curvature);
  expect_one_word_each(WaveType::user);
  expect_one_word_each(VesselMotion::coupled);
  expect_one_word_each(Guide::pinned);
  expect_one_word_each(TensionerMode::constant);
  expect_one_word_each(RollerDamping::textbook);
  expect_one_word_each(RollerStiffness::penalty);
  expect_one_word_each(Structure::stinger);
  expect_one_word_each(SupportContact::gap_springs);
  expect_one_word_each(StaticMethod::dynamic_relaxation);
  expect_one_word_each(LayHistory::monotonic);
  expect_one_word_each(CheckCodes::api);
  expect_one_word_each(SafetyClass::high);
  expect_one_word_each(Manufacture::uoe);
  expect_one_word_each(YieldBasis::fy);
  expect_one_word_each(ApiEdition::fifth);
  expect_one_word_each(CurrentLoad::functional);
  expect_one_word_each(true);
}

}  // namespace
}  // namespace overbend
