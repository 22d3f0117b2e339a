/// Fields of sensitivities; see result_field.h.
#pragma once

#include "results/fields/result_field.h"
#include "results/sensitivity_results.h"

namespace overbend {

template <class Row, class Visit>
void visit_sensitivity_input(Row& r, Visit& visit) {
  visit(ResultField{"key", "1", "Path in the model file, indices from 0"}.summary(), r.key);
  visit(ResultField{"name", "1", "The same with the names of items"}.summary(), r.name);
  visit(ResultField{"text", "1", "Description"}.summary(), r.text);
  visit(ResultField{"unit", "1", "SI unit of value and tolerance"}.summary(), r.unit);
  visit(ResultField{"show", "1", "Unit to show it in; empty for a plain number"}, r.show);
  visit(ResultField{"value", kVaries, "Value"}.summary(), r.value);
  visit(ResultField{"tolerance", kVaries, "Tolerance in both directions"}.summary(), r.tolerance);
  visit(ResultField{"own_tolerance", "1", "1 if the model file gives the tolerance, 0 for the default"}.summary(),
        r.own_tolerance);
}

template <class Row, class Visit>
void visit_sensitivity_output(Row& r, Visit& visit) {
  visit(ResultField{"name", "1", "Name of the result as in summary.json"}.summary(), r.name);
  visit(ResultField{"text", "1", "Description"}.summary(), r.text);
  visit(ResultField{"unit", "1", "SI unit of the value"}.summary(), r.unit);
  visit(ResultField{"value", kVaries, "Value"}.summary(), r.value);
  visit(ResultField{"key", "1", "1 if it is one of the key results, else 0"}.summary(), r.key);
}

/// A one-sided derivative.
template <class Row, class Visit>
void visit_one_sided(Row& r, Visit& visit) {
  visit(ResultField{"support", "1", "Support whose contact changes within the tolerance"}.summary(), r.support);
  visit(ResultField{"closes", "1", "1 if the contact closes, 0 if it opens"}.summary(), r.closes);
  visit(ResultField{"until", kVaries, "Value of the input at which it changes"}.summary(), r.until);
  visit(ResultField{"beyond", kVaries, "Derivative beyond that value"}.summary(), r.beyond);
}

}  // namespace overbend
