#include "resultfiles/static/passage_json.h"

namespace overbend {
namespace {

Json peak_json(const PassagePeak& peak) {
  return {{"value", peak.value}, {"stage", peak.stage}, {"passed", peak.passed}};
}

}  // namespace

Json passage_json(const PassageResults& passage) {
  Json boxes = Json::array();
  for (const PassageBox& box : passage.boxes) {
    boxes.push_back({{"name", box.name},
                     {"max_roller_reaction", peak_json(box.roller)},
                     {"max_reaction", peak_json(box.reaction)},
                     {"max_strain", peak_json(box.strain)}});
  }
  return {{"structure", passage.structure},
          {"max_reaction", peak_json(passage.reaction)},
          {"support", passage.support},
          {"max_bending_moment", peak_json(passage.bending_moment)},
          {"max_strain_beside", peak_json(passage.strain)},
          {"max_von_mises_beside", peak_json(passage.von_mises)},
          {"supports", boxes}};
}

}  // namespace overbend
