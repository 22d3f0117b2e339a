// Extension module overbend._core.
#include <string>

#include "base/shown_unit.h"
#include "base/text.h"
#include "python/bindings.h"
#include "python/interpreter_lock.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "Engine of the package overbend. Use the package: this module is internal and may change.";
  static auto* const lock = new overbend::InterpreterLock;  // not destroyed, because threads may outlive the module
  overbend::set_hdf5_lock(*lock);
  module.attr("version") = OVERBEND_VERSION;
  module.def(
      "use_units",
      [](const pybind11::str& word) {
        const std::string system = word;
        if (system != "metric" && system != "us") {
          throw pybind11::value_error("system: found '" + overbend::for_display(system) +
                                      "', expected 'metric' or 'us'");
        }
        overbend::use_units(system == "us" ? overbend::UnitSystem::us : overbend::UnitSystem::metric);
      },
      pybind11::arg("system"),
      "Units of all texts, tables of text, reports and figures: 'metric' (kN, m, MPa), the default, or 'us' (kip, ft,\n"
      "ksi). Numbers of results stay in SI. ValueError for another word.");
  const auto as_tuple = [](const overbend::ShownUnit& unit) {
    return pybind11::make_tuple(std::string(unit.name), unit.factor, unit.digits);
  };
  module.def(
      "shown_unit",
      [=](const std::string& name, const std::string& units) { return as_tuple(overbend::shown_unit(name, units)); },
      pybind11::arg("name"), pybind11::arg("units"),
      "Returns name, factor from SI and decimals of the unit a quantity is shown in.");
  module.def(
      "section_length", [=] { return as_tuple(overbend::section_length()); },
      "The same for gaps and dimensions of a cross-section.");
  overbend::add_errors(module);
  overbend::add_results(module);
  overbend::add_model(module);
  overbend::add_imports(module);
  overbend::add_statics(module);
  overbend::add_controllers(module);
  overbend::add_dynamics(module);
  overbend::add_operations(module);
  overbend::add_seek(module);
  overbend::add_lay_tables(module);
  overbend::add_sensitivities(module);
  overbend::add_studies(module);
  overbend::add_comparisons(module);
  overbend::add_simulation(module);
}
