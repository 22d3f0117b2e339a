/// The parts of the Python extension module overbend._core. What users see is the Python package in python/overbend; it
/// stands on these few functions and classes.
#pragma once

#include <pybind11/pybind11.h>

namespace overbend {

/// Makes Python exceptions of the engine's.
void add_errors(pybind11::module_& module);
/// Trees of datasets and files of results.
void add_results(pybind11::module_& module);
/// Models.
void add_model(pybind11::module_& module);
/// Statics of a model.
void add_statics(pybind11::module_& module);
/// Controllers of machines, and what they see.
void add_controllers(pybind11::module_& module);
/// Dynamic analyses into folders.
void add_dynamics(pybind11::module_& module);
/// Goal seek.
void add_seek(pybind11::module_& module);
/// Operations on the line.
void add_operations(pybind11::module_& module);
/// Lay tables.
void add_lay_tables(pybind11::module_& module);
/// What results hang on.
void add_sensitivities(pybind11::module_& module);
/// Studies of many cases.
void add_studies(pybind11::module_& module);
/// Folders of results beside each other.
void add_comparisons(pybind11::module_& module);
/// Dynamic analyses step by step.
void add_simulation(pybind11::module_& module);

}  // namespace overbend
