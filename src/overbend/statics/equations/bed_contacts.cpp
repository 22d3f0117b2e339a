#include "statics/equations/bed_contacts.h"

#include "model/pipe_attachments.h"

namespace overbend {
namespace {

constexpr int kSamplesPerElement = 6;  ///< Number of clearance samples per element.

ElementPlace place_at(const StaticSystem& system, int element, double xi) {
  const std::size_t e = static_cast<std::size_t>(element);
  return {element, xi, system.mesh().s[e] + xi * system.mesh().length[e]};
}

/// Finds the zero of the clearance between two places of an element by bisection; `touching`: contact at the first.
ElementPlace edge(const StaticSystem& system, const LineState& state, int element, double xi, double next,
                  bool touching) {
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (xi + next);
    const bool same = (bed_clearance(system, state, element, middle) <= 0.0) == touching;
    (same ? xi : next) = middle;
  }
  return place_at(system, element, xi);
}

}  // namespace

bool may_span(const Model& model) {
  return model.seabed.surface.shape() != nullptr || !pipe_attachments(model.description).empty();
}

std::vector<BedContact> bed_contacts(const StaticSystem& system, const LineState& state) {
  std::vector<BedContact> contacts;
  bool touching = false;
  for (int e = system.mesh().elements() - 1; e >= 0; --e) {
    for (int look = 0; look <= kSamplesPerElement; ++look) {
      const double xi = 1.0 - static_cast<double>(look) / kSamplesPerElement;
      const bool in_contact = bed_clearance(system, state, e, xi) <= 0.0;
      if (in_contact == touching) continue;
      const double before = look == 0 ? 1.0 : xi + 1.0 / kSamplesPerElement;
      const ElementPlace place = edge(system, state, e, before, xi, touching);
      if (in_contact) contacts.push_back({place, place_at(system, 0, 0.0)});
      if (!in_contact) contacts.back().to = place;
      touching = in_contact;
    }
  }
  return contacts;
}

std::vector<ElementPlace> contact_places(const StaticSystem& system, const LineState& state) {
  std::vector<ElementPlace> places;
  if (!may_span(system.model())) return places;
  for (const BedContact& contact : bed_contacts(system, state)) {
    places.push_back(contact.from);
    if (contact.to.s > 0.0) places.push_back(contact.to);
  }
  return places;
}

std::vector<LineStretch> contact_edges(const StaticSystem& system, const std::vector<BedContact>& contacts) {
  constexpr double kClose = 1.0;  // edges closer than this form one stretch [m]
  const double total = system.mesh().total_length();
  std::vector<LineStretch> edges;
  for (const BedContact& contact : contacts) {
    for (const ElementPlace& place : {contact.from, contact.to}) {
      const double from_top = total - place.s;
      if (place.s <= 0.0) continue;
      if (!edges.empty() && from_top - edges.back().to < kClose) {
        edges.back().to = from_top;
      } else {
        edges.push_back({from_top, from_top});
      }
    }
  }
  return edges;
}

}  // namespace overbend
