#include "modelfile/schema/member.h"

#include "modelfile/schema/field_value.h"

namespace overbend {
namespace member_values {

void read(const FieldValue& value, double& target) {
  target = value.number;
}

void read(const FieldValue& value, int& target) {
  target = static_cast<int>(value.integer);
}

void read(const FieldValue& value, std::uint64_t& target) {
  target = static_cast<std::uint64_t>(value.integer);
}

void read(const FieldValue& value, std::string& target) {
  target = value.text;
}

const std::string& text(const FieldValue& value) {
  return value.text;
}

}  // namespace member_values

namespace field_rows {

Member read_elsewhere() {
  Member member;
  member.put = [](Target&, const FieldValue&) { return Target(); };
  return member;
}

}  // namespace field_rows
}  // namespace overbend
