// The schema's verdicts, given by python3-jsonschema, against the reader's.
#include "modelfile/reading/json_schema.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>

#include "base/json.h"
#include "base/units.h"
#include "base/yaml_document.h"
#include "modelfile/fields/field_table.h"
#include "modelfile/model_texts.h"
#include "modelfile/reading/reference_page.h"
#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

/// A scalar as YAML's core schema resolves it.
Json scalar_as_json(const YamlNode& node) {
  const std::optional<double> number = node.quoted ? std::nullopt : parse_number(node.text);
  if (node.quoted || (!number && node.text != "true" && node.text != "false")) return node.text;
  if (!number) return node.text == "true";
  const bool whole = node.text.find_first_of(".eE") == std::string::npos;
  return whole ? Json(std::stoll(node.text)) : Json(*number);
}

Json as_json(const YamlNode& node) {
  Json value;
  switch (node.kind) {
    case YamlNode::Kind::null:
      return nullptr;
    case YamlNode::Kind::scalar:
      return scalar_as_json(node);
    case YamlNode::Kind::list:
      value = Json::array();
      for (const YamlNode& item : node.items) value.push_back(as_json(item));
      return value;
    case YamlNode::Kind::map:
      value = Json::object();
      for (const YamlEntry& entry : node.entries) value[entry.key] = as_json(entry.value);
      return value;
  }
  return value;
}

Json parsed(const std::string& text) {
  Diagnostics diagnostics;
  const std::optional<YamlNode> root = parse_yaml(text, "test", diagnostics);
  return root ? as_json(*root) : Json();
}

/// Asks python3-jsonschema about each instance: one message per instance, empty when it is valid. The first answer is
/// about the schema itself.
std::vector<std::string> verdicts(const std::vector<Json>& instances) {
  constexpr const char* kScript = R"(
import json, sys, jsonschema
schema, instances = json.load(open(sys.argv[1])), json.load(open(sys.argv[2]))
validator = jsonschema.Draft7Validator
answers = [""]
try: validator.check_schema(schema)
except jsonschema.SchemaError as error: answers = [error.message]
for instance in instances:
    errors = sorted(validator(schema).iter_errors(instance), key=str)
    answers.append(errors[0].message[:300] if errors else "")
json.dump(answers, open(sys.argv[3], "w"))
)";
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("overbend_schema_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const auto write = [&](const char* name, const std::string& text) { std::ofstream(folder / name) << text; };
  write("schema.json", json_schema());
  write("instances.json", json_text(instances));
  write("judge.py", kScript);
  const std::string in = folder.string() + "/";
  const std::string command =
      "/usr/bin/python3 " + in + "judge.py " + in + "schema.json " + in + "instances.json " + in + "answers.json";
  EXPECT_EQ(std::system(command.c_str()), 0) << "needs python3-jsonschema";
  const Json answers = read_json_file(folder / "answers.json");
  std::filesystem::remove_all(folder);
  if (!answers.is_array()) return std::vector<std::string>(instances.size() + 1, "no answer");
  return answers.get<std::vector<std::string>>();
}

TEST(json_schema, is_a_schema_and_every_model_of_the_repository_is_valid) {
  std::vector<Json> instances = {parsed(testing::kGoodModel)};
  for (const auto& path : testing::good_files()) instances.push_back(parsed(testing::file_text(path)));
  ASSERT_GT(instances.size(), 10U);
  const std::vector<std::string> answers = verdicts(instances);
  ASSERT_EQ(answers.size(), instances.size() + 1);
  for (const std::string& answer : answers) EXPECT_EQ(answer, "");
}

TEST(json_schema, judges_the_bad_corpus_as_the_reader_does_where_a_schema_can) {
  std::vector<Json> instances;
  std::vector<std::string> claims;
  for (const testing::Spoiling& s : testing::bad_corpus()) {
    if (!s.schema_sees) continue;
    instances.push_back(parsed(testing::spoil(s)));
    claims.emplace_back(s.claim);
  }
  EXPECT_GT(claims.size(), 30U);
  const std::vector<std::string> answers = verdicts(instances);
  ASSERT_EQ(answers.size(), instances.size() + 1);
  for (std::size_t i = 0; i < claims.size(); ++i) {
    EXPECT_NE(answers[i + 1], "") << claims[i] << ": the reader rejects it, the schema does not";
  }
}

TEST(json_schema, every_row_of_the_table_is_in_it) {
  const std::string schema = json_schema();
  for (const Field& field : field_table()) {
    const std::size_t dot = field.path.find_last_of('.');
    const std::string key = dot == std::string::npos ? field.path : field.path.substr(dot + 1);
    if (key == "*" || key.ends_with("[]")) continue;
    EXPECT_NE(schema.find("\"" + key + "\""), std::string::npos) << field.path;
  }
}

TEST(field_table, every_row_has_a_label_and_a_unit_that_fits) {
  for (const Field& field : field_table()) {
    EXPECT_FALSE(field.text.empty()) << field.path;
    EXPECT_EQ(field.text.back(), '.') << field.path;
    if (field.kind == FieldKind::quantity) {
      EXPECT_TRUE(unit_factor(field.show, field.unit).has_value()) << field.path;
    }
    if (field.kind == FieldKind::choice) {
      EXPECT_FALSE(field.choices.empty()) << field.path;
    }
    EXPECT_FALSE(field.required && !field.fallback.empty()) << field.path << " is required and has a default";
  }
}

TEST(reference_page, the_committed_page_is_current) {
  EXPECT_EQ(testing::file_text(std::string(OVERBEND_SOURCE_DIR) + "/docs/input.md"), reference_page())
      << "run: build/release/overbend schema --reference > docs/input.md";
}

TEST(reference_page, every_key_has_a_row) {
  const std::string page = reference_page();
  for (const Field& field : field_table())
    EXPECT_NE(page.find("| `" + field.path + "` |"), std::string::npos) << field.path;
}

}  // namespace
}  // namespace overbend
