// The extension module overbend._core.
#include "python/bindings.h"

PYBIND11_MODULE(_core, module) {
  module.doc() = "The engine behind the package overbend. Use that; nothing here is promised to stay.";
  module.attr("version") = OVERBEND_VERSION;
  overbend::add_errors(module);
  overbend::add_results(module);
  overbend::add_model(module);
  overbend::add_statics(module);
  overbend::add_controllers(module);
  overbend::add_dynamics(module);
  overbend::add_seek(module);
  overbend::add_operations(module);
  overbend::add_lay_tables(module);
  overbend::add_sensitivities(module);
  overbend::add_studies(module);
  overbend::add_comparisons(module);
  overbend::add_simulation(module);
}
