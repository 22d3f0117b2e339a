#include "study/sensitivity/contact_transitions.h"

#include <algorithm>
#include <cmath>

#include "base/ranges.h"

namespace overbend {
namespace {

constexpr double kForce = 1.0;            ///< Force for the influence of a roller [N].
constexpr double kReportedChange = 0.01;  ///< Relative change of a derivative that is reported [-].

constexpr double kMinEffect = 1e-5;  ///< Relative change of a result over the tolerance that is reported [-].

template <class Each>
void for_rollers(const StaticResults& results, Each each) {
  for (const SupportResult& support : results.supports) {
    for (const RowResult& row : support.rows) {
      for (const RollerResult& roller : row.rollers) each(support, roller);
    }
  }
}

}  // namespace

ContactTransitions::ContactTransitions(SensitivityLay& lay) : lay_(&lay) {
  add_contacts(lay.results(), false);
  if (lay.still_water_results() != nullptr) add_contacts(*lay.still_water_results(), true);
}

void ContactTransitions::add_contacts(const StaticResults& results, bool in_still_water) {
  int index = 0;
  for_rollers(results, [&](const SupportResult& support, const RollerResult& roller) {
    contacts_.push_back({index, in_still_water, support.name, roller.separation, roller.reaction,
                         lay_->tangent().system().rollers().roller(index).law.stiffness});
    ++index;
  });
}

bool ContactTransitions::stay(const ResultPair& pair) const {
  std::size_t i = 0;
  bool same = pair.contacts_stay;
  const auto look = [&](const StaticResults& results) {
    for_rollers(results, [&](const SupportResult&, const RollerResult& roller) {
      same = same && (roller.reaction > 0.0) == (contacts_[i++].reaction > 0.0);
    });
  };
  look(pair.before);
  if (pair.still_water_before) look(*pair.still_water_before);
  i = 0;
  look(pair.after);
  if (pair.still_water_after) look(*pair.still_water_after);
  return same;
}

std::vector<ContactSlope> ContactTransitions::contact_slopes(const ResultPair& pair, double step) const {
  std::vector<ContactSlope> slopes;
  const auto add = [&](const StaticResults& before, const StaticResults& after) {
    std::size_t i = slopes.size();
    for_rollers(after, [&](const SupportResult&, const RollerResult& roller) {
      slopes.push_back({roller.separation, roller.reaction});
    });
    for_rollers(before, [&](const SupportResult&, const RollerResult& roller) {
      ContactSlope& slope = slopes[i++];
      slope = {(slope.separation - roller.separation) / (2.0 * step),
               (slope.reaction - roller.reaction) / (2.0 * step)};
    });
  };
  add(pair.before, pair.after);
  if (pair.still_water_before) add(*pair.still_water_before, *pair.still_water_after);
  return slopes;
}

/// Sorted by the distance of the change.
std::vector<ContactTransitions::Change> ContactTransitions::changes(const std::vector<ContactSlope>& slopes,
                                                                    double tolerance) const {
  std::vector<Change> found;
  for (std::size_t i = 0; i < contacts_.size() && i < slopes.size(); ++i) {
    if (slopes[i].separation == 0.0) continue;
    const double distance = -contacts_[i].separation / slopes[i].separation;
    if (std::abs(distance) <= tolerance) found.push_back({i, distance});
  }
  ranges::sort(found, {}, [](const Change& change) { return std::abs(change.distance); });
  return found;
}

const std::optional<ContactTransitions::Influence>& ContactTransitions::influence(
    std::size_t contact, const std::vector<ResultValue>& results) {
  const auto [place, fresh] = influences_.try_emplace(contact);
  if (!fresh) return place->second;
  const std::optional<ResultPair> pair =
      lay_->push(contacts_[contact].roller, kForce, contacts_[contact].in_still_water);
  if (!pair) return place->second;
  const std::vector<ResultValue> low = result_values(pair->before), high = result_values(pair->after);
  if (low.size() != results.size() || high.size() != results.size()) return place->second;
  Influence& found = place->second.emplace();
  for (std::size_t i = 0; i < results.size(); ++i) {
    const bool is_reaction = results[i].name == "static.supports[" + contacts_[contact].support + "].reaction";
    // the force itself is a reaction there
    const double tried = is_reaction && !contacts_[contact].in_still_water ? 1.0 : 0.0;
    found.results.push_back((high[i].value - low[i].value) / (2.0 * kForce) + tried);
  }
  found.contact = contact_slopes(*pair, kForce)[contact];
  return place->second;
}

void ContactTransitions::mark(const std::vector<ContactSlope>& slopes, const std::vector<ResultValue>& results,
                              SensitivityInput& input, std::vector<Derivative>& derivatives) {
  for (const Change& change : changes(slopes, input.tolerance)) {
    const Contact& contact = contacts_[change.contact];
    const std::string name = contact.support + (contact.in_still_water ? " (in still water)" : "");
    if (ranges::find(input.near, name) == input.near.end()) input.near.push_back(name);
    const std::optional<Influence>& by_force = influence(change.contact, results);
    if (!by_force) continue;
    const bool closes = contact.reaction <= 0.0;
    const ContactSlope& slope = slopes[change.contact];
    // The force added with the contact, in series with the pipe; or the replacement of the lost reaction.
    const double force =
        closes ? -contact.stiffness * slope.separation / (1.0 + contact.stiffness * by_force->contact.separation)
               : -slope.reaction / (1.0 + by_force->contact.reaction);
    for (std::size_t r = 0; r < derivatives.size(); ++r) {
      Derivative& derivative = derivatives[r];
      const double jump = by_force->results[r] * force;
      const double larger = std::max(std::abs(derivative.value), std::abs(derivative.value + jump));
      const double threshold = kMinEffect * std::abs(results[r].value);
      if (derivative.one_sided() || std::abs(jump) <= kReportedChange * larger) continue;
      if (std::abs(jump) * input.tolerance <= threshold) continue;
      derivative.support = name;
      derivative.closes = closes;
      derivative.until = input.value + change.distance;
      derivative.beyond = derivative.value + jump;
    }
  }
}

}  // namespace overbend
