#include "report/page/front_of.h"

#include "modelfile/reading/yaml_reader.h"

namespace overbend {

std::optional<Description> description_of(const std::string& model_text) {
  return read_stored_model(model_text, "model.yaml").description;
}

FrontPage front_of(const std::string& kind, const std::string& title, const std::optional<Description>& description,
                   const Findings& findings) {
  FrontPage front;
  front.kind = kind;
  front.title = title;
  if (description) front.control = description->report;
  front.findings = sorted_by_severity(findings);
  return front;
}

}  // namespace overbend
