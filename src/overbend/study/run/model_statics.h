/// Statics of a model whatever it is: a lay, a hull on its mooring lines, lines by themselves.
#pragma once

#include <filesystem>
#include <optional>

#include "results/line_results.h"
#include "results/static_results.h"
#include "statics/moored/moored_lay.h"

namespace overbend {

/// One of the three kinds of results, or why there is none.
struct ModelStatics {
  std::optional<StaticResults> lay;        ///< With a pipe; its code checks included.
  std::optional<StaticSolution> solution;  ///< Of the lay: what the next one may start from.
  std::optional<MooringResults> moorings;  ///< Of a hull without a pipe.
  std::optional<LinesResults> lines;       ///< Of lines by themselves.
  std::optional<StaticFailure> failure;
};

/// The equilibrium of the model. `start`: of a lay close by; sets `model.mean_pose` as solve_lay does.
ModelStatics solve_model(Model& model, const StaticSolution* start = nullptr);

/// Adds what is told of a floating hull beside its rest: it is made anew for that.
void tell_hull(const Model& model, ModelStatics& statics);

/// Writes the files that belong to the kind of results, whole or not at all. Throws UnusableFolder.
void write_model_statics(const ModelStatics& statics, const Description& description,
                         const std::filesystem::path& folder);

}  // namespace overbend
