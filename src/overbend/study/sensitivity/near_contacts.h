/// Contacts that open or close when an input goes as far as its tolerance: there derivatives jump.
#pragma once

#include <map>
#include <optional>
#include <vector>

#include "results/sensitivity_results.h"
#include "study/sensitivity/result_values.h"
#include "study/sensitivity/sensitivity_lay.h"

namespace overbend {

/// How the contact of one roller changes with an input.
struct ContactSlope {
  double separation = 0.0;  ///< [m] per unit of the input.
  double reaction = 0.0;    ///< [N] likewise.
};

class NearContacts {
 public:
  /// Of the lay as it is, which must outlive this.
  explicit NearContacts(SensitivityLay& lay);

  /// Whether the rollers that carry are the same on both sides, and were on the way.
  bool stay(const ResultPair& pair) const;

  /// Of every roller, over `step` of an input either way.
  std::vector<ContactSlope> slopes_of(const ResultPair& pair, double step) const;

  /// Names the supports whose contact changes within the input's tolerance, and of each derivative the first on whose
  /// other side it differs by more than a hundredth, with what it is there.
  void mark(const std::vector<ContactSlope>& slopes, const std::vector<ResultValue>& results, SensitivityInput& input,
            std::vector<Derivative>& derivatives);

 private:
  struct Contact {
    int roller = 0;
    bool in_still = false;  ///< Of the lay in still water, on which checks hang.
    std::string support;
    double separation = 0.0, reaction = 0.0;
    double stiffness = 0.0;  ///< Of its law [N/m].
  };
  /// What a unit force of the roller on the pipe does.
  struct Influence {
    std::vector<double> results;
    ContactSlope own;
  };
  struct Change {
    std::size_t contact = 0;
    double way = 0.0;  ///< Of the input until it changes, signed.
  };
  std::vector<Change> changes(const std::vector<ContactSlope>& slopes, double tolerance) const;
  const std::optional<Influence>& influence(std::size_t contact, const std::vector<ResultValue>& results);

  SensitivityLay* lay_;
  void add_contacts(const StaticResults& results, bool in_still);

  std::vector<Contact> contacts_;  ///< In the order of the rollers; those in still water behind.
  std::map<std::size_t, std::optional<Influence>> influences_;
};

}  // namespace overbend
