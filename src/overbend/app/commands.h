/// The commands of the program. Each prints results to stdout and complaints to stderr and returns the exit code.
#pragma once

#include <optional>
#include <string>

#include "app/new_model.h"
#include "model/description.h"

namespace overbend {

/// Reads a model; on failure every fault is told on stderr and nothing is returned.
std::optional<Description> load_model(const std::string& path);

int run_check(const std::string& model_file);
/// Statics of a model into the folder `output`; empty: "<stem>.results" in the current folder.
int run_static(const std::string& model_file, const std::string& output);

/// Writes report.html beside a results.h5, given that file or its folder.
int run_report(const std::string& place);

int run_schema(bool reference);
int run_new(const NewOptions& options);

}  // namespace overbend
