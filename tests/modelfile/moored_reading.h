// Reading models of floating hulls and lines, and the messages on their slips.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "modelfile/reading/yaml_reader.h"

namespace overbend::testing {

inline Description read_good(const std::string& text) {
  const ModelReading reading = read_model_text(text, std::string(OVERBEND_SOURCE_DIR) + "/examples/good.yaml");
  for (const std::string& line : reading.diagnostics.lines(Severity::error)) ADD_FAILURE() << line;
  return reading.description.value_or(Description{});
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t index = text.find(from);
  EXPECT_NE(index, std::string::npos) << from;
  return index == std::string::npos ? text : text.replace(index, from.size(), to);
}

struct ModelSlip {
  const char* claim;
  std::string find, replace;
  std::string key, expected_text;
};

inline void expect_reported(const std::string& good, const ModelSlip& slip) {
  SCOPED_TRACE(slip.claim);
  const ModelReading reading = read_model_text(replaced(good, slip.find, slip.replace), "slip.yaml");
  EXPECT_FALSE(reading.description);
  const std::vector<Diagnostic> all = reading.diagnostics.sorted();
  const bool reported = std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) {
    return d.severity == Severity::error && d.key == slip.key && d.line > 0 &&
           render(d).find(slip.expected_text) != std::string::npos;
  });
  EXPECT_TRUE(reported) << (all.empty() ? "nothing was said" : render(all.front()));
  EXPECT_EQ(reading.diagnostics.error_count(), 1);
}

}  // namespace overbend::testing
