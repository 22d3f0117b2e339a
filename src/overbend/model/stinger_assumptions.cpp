#include "model/stinger_assumptions.h"

#include <fmt/format.h>

#include <algorithm>

namespace overbend {
namespace {

using Described = StingerSectionDescription;

bool any(const std::vector<Described>& sections, bool (*holds)(const Described&)) {
  return std::any_of(sections.begin(), sections.end(), holds);
}

}  // namespace

void assume_stinger(Assumptions& list, const Model& model) {
  const std::vector<Described>& sections = model.description.supports.sections;
  if (sections.empty()) return;
  list.push_back(
      {AssumptionRank::other,
       fmt::format("The stinger rotates about {}; its boxes move with their section as parts of a rigid body. Angles "
                   "are positive when the tip goes down from where it is drawn; boxes without a given inclination take "
                   "it from the curve as drawn.",
                   sections.size() == 1 ? std::string("its hinge") : fmt::format("{} hinges", sections.size()))});
  if (any(sections, [](const Described& s) { return s.floats() && !s.angle; })) {
    list.push_back(
        {AssumptionRank::other,
         "In statics the moment about each hinge of roller forces, weight, buoyancy, springs and the current's drag on "
         "all parts outboard of it is zero, or a stop carries the remainder. The equilibrium is the one reached from "
         "where the stinger is drawn; sensitivities hold the stinger at its equilibrium angle."});
  }
  if (any(sections, [](const Described& s) { return s.body.has_value(); })) {
    list.push_back(
        {AssumptionRank::other, "Weight and buoyancy of a stinger's body are constant and act at points fixed in it."});
  }
  if (any(sections, [](const Described& s) { return !s.tanks.empty(); })) {
    list.push_back({AssumptionRank::other,
                    "A tank's buoyancy is that of the part of its axis below the mean water level, with a sharp cut at "
                    "the water line; its weight and that of its ballast water act at mid-length."});
  }
  if (any(sections, [](const Described& s) { return s.hinge_friction > 0.0 && s.floats(); })) {
    list.push_back({AssumptionRank::other,
                    "The angle of the stinger is that without hinge friction; the range of angles within which "
                    "friction may hold it is reported, for each section with the others held."});
  }
  if (model.description.moorings) {
    list.push_back({AssumptionRank::other,
                    "The balance of the hull as drawn contains weight and buoyancy of the stinger as drawn; changes "
                    "from it act on the hull."});
  }
}

}  // namespace overbend
