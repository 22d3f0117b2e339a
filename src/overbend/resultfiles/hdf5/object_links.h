/// The group /objects of results.h5: results by object, as other names of the groups that hold them.
#pragma once

#include <string>

#include "resultfiles/hdf5/hdf5_file.h"
#include "results/static_results.h"

namespace overbend {

/// Links what the table of results/fields/object_names.h names to the groups that the file has. `group`: the group that
/// holds the statics, as of a stage; `object`: the place in the tree, "/stages/NAME" of a stage.
void link_objects(Hdf5Writer& file, const StaticResults& results, const std::string& group = "",
                  const std::string& object = "");

}  // namespace overbend
