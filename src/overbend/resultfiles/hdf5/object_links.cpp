#include "resultfiles/hdf5/object_links.h"

#include <string_view>
#include <vector>

#include "resultfiles/hdf5/dataset_path.h"
#include "results/fields/object_names.h"

namespace overbend {
namespace {

/// Objects of a kind, in the order of the model.
struct Named {
  std::string_view placeholder;
  std::vector<std::string> names;
};

template <class Rows>
Named named(std::string_view placeholder, const Rows& rows) {
  Named objects{placeholder, {}};
  for (const auto& row : rows) objects.names.push_back(row.name);
  return objects;
}

std::string replaced(std::string text, std::string_view placeholder, const std::string& value) {
  const std::size_t place = text.find(placeholder);
  return place == std::string::npos ? text : text.replace(place, placeholder.size(), value);
}

/// Adds a link, unless the target is missing or the name is taken by another object.
void link_group(Hdf5Writer& file, const std::string& link, const std::string& target) {
  if (!file.has(target) || file.has(link)) return;
  make_groups_above(file, link, "Results by object: other names of the groups that hold them");
  file.link(link, target);
}

}  // namespace

void link_objects(Hdf5Writer& file, const StaticResults& results, const std::string& group, const std::string& object) {
  const std::vector<MooringLineResult> none;
  const Named kinds[] = {named("<line>", results.lines),
                         named("<mooring>", results.moorings ? results.moorings->rest.moorings : none),
                         named("<support>", results.supports), named("<body>", results.bodies)};
  for (const ObjectLink& row : object_links()) {
    const std::string link = "/objects" + object + "/" + std::string(row.link), target = group + std::string(row.group);
    bool listed = false;
    for (const Named& kind : kinds) {
      if (link.find(kind.placeholder) == std::string::npos) continue;
      listed = true;
      for (std::size_t i = 0; i < kind.names.size(); ++i) {
        if (kind.names[i] == "pipe" && results.has_pipe()) continue;  // the laid pipe uses that name
        const std::string name = dataset_path(kind.names[i]);
        link_group(file, replaced(link, kind.placeholder, name),
                   replaced(replaced(target, kind.placeholder, name), "<number>", std::to_string(i)));
      }
    }
    if (!listed && (results.has_pipe() || !row.link.starts_with("lines/pipe"))) link_group(file, link, target);
  }
}

}  // namespace overbend
