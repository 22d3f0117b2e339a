#include "report/page/make_front_page.h"

#include "modelfile/reading/yaml_reader.h"

namespace overbend {

std::optional<Description> read_description(const std::string& model_text) {
  return read_stored_model(model_text, "model.yaml").description;
}

FrontPage make_front_page(const std::string& kind, const std::string& title,
                          const std::optional<Description>& description, const Findings& findings) {
  FrontPage front;
  front.kind = kind;
  front.title = title;
  if (description) front.control = description->report;
  front.findings = sorted_by_severity(findings);
  return front;
}

}  // namespace overbend
