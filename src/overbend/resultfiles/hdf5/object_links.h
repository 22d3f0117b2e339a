/// The group /objects of results.h5: results by object, as other names of the groups that hold them.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/static_results.h"

namespace overbend {

/// Links the names of results/fields/object_names.h to the groups that exist in the file. `group`: the group with the
/// static results, for instance of a stage; `object`: the position in the tree, "/stages/NAME" for a stage.
void link_objects(Hdf5Writer& file, const StaticResults& results, const std::string& group = "",
                  const std::string& object = "");

}  // namespace overbend
