/// Parts of the Python extension module overbend._core, on which the Python package in python/overbend is based.
#pragma once

#include <pybind11/pybind11.h>

namespace overbend {

/// Registers the translation of C++ exceptions to Python exceptions.
void add_errors(pybind11::module_& module);
/// Datasets in memory and results files.
void add_results(pybind11::module_& module);
/// Models.
void add_model(pybind11::module_& module);
/// Import of files of other programs.
void add_imports(pybind11::module_& module);
/// Static analysis.
void add_statics(pybind11::module_& module);
/// Controllers of machines, and their machine readings.
void add_controllers(pybind11::module_& module);
/// Dynamic analyses written to folders.
void add_dynamics(pybind11::module_& module);
/// Goal seek.
void add_seek(pybind11::module_& module);
/// Operations with their stages.
void add_operations(pybind11::module_& module);
/// Lay tables.
void add_lay_tables(pybind11::module_& module);
/// Sensitivities.
void add_sensitivities(pybind11::module_& module);
/// Studies of many cases.
void add_studies(pybind11::module_& module);
/// Comparison of folders of results.
void add_comparisons(pybind11::module_& module);
/// Dynamic analyses advanced step by step.
void add_simulation(pybind11::module_& module);

}  // namespace overbend
