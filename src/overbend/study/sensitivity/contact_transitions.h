/// Contacts that open or close within the tolerance of an input: derivatives jump there.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "results/sensitivity_results.h"
#include "study/sensitivity/result_values.h"
#include "study/sensitivity/sensitivity_lay.h"

namespace overbend {

/// Derivatives of the contact of one roller by an input.
struct ContactSlope {
  double separation = 0.0;  ///< [m] per unit of the input.
  double reaction = 0.0;    ///< [N] per unit of the input.
};

class ContactTransitions {
 public:
  /// Contacts of a lay, which must outlive this.
  explicit ContactTransitions(SensitivityLay& lay);

  /// True if the same rollers carry load on both sides and did so in between.
  bool stay(const ResultPair& pair) const;

  /// Derivatives of all rollers; the pair is `step` apart from the input in both directions.
  std::vector<ContactSlope> contact_slopes(const ResultPair& pair, double step) const;

  /// Adds the supports whose contact changes within the input's tolerance, and for each derivative the first contact
  /// beyond which it differs by more than 1 %, with its value there.
  void mark(const std::vector<ContactSlope>& slopes, const std::vector<ResultValue>& results, SensitivityInput& input,
            std::vector<Derivative>& derivatives);

 private:
  struct Contact {
    int roller = 0;
    bool in_still_water = false;  ///< Belongs to the lay in still water, on which checks depend.
    std::string support;
    double separation = 0.0, reaction = 0.0;
    double stiffness = 0.0;  ///< Contact stiffness [N/m].
  };
  /// Effect of a unit force of the roller on the pipe.
  struct Influence {
    std::vector<double> results;
    ContactSlope contact;
  };
  struct Change {
    std::size_t contact = 0;
    double distance = 0.0;  ///< Change of the input until the contact changes, signed.
  };
  std::vector<Change> changes(const std::vector<ContactSlope>& slopes, double tolerance) const;
  const std::optional<Influence>& influence(std::size_t contact, const std::vector<ResultValue>& results);

  SensitivityLay* lay_;
  void add_contacts(const StaticResults& results, bool in_still_water);

  std::vector<Contact> contacts_;  ///< In the order of the rollers, followed by those in still water.
  std::map<std::size_t, std::optional<Influence>> influences_;
};

}  // namespace overbend
