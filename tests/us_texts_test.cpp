// Findings and assumptions where the program prints US customary units.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "modelfile/reading/yaml_reader.h"
#include "statics/solver/statics.h"
#include "study/run/input_findings.h"
#include "study/run/static_analysis.h"
#include "support/bgl1_in_time.h"
#include "support/memory_sink.h"
#include "support/us_units.h"

namespace overbend {
namespace {

Description example(const std::string& name) {
  return read_model(OVERBEND_SOURCE_DIR "/examples/" + name).description.value();
}

template <class Results>
void add_texts(const Results& results, std::vector<std::string>& all) {
  for (std::string& text : messages(results.findings)) all.push_back(std::move(text));
  for (std::string& text : texts(results.assumptions)) all.push_back(std::move(text));
}

/// All that is said of a model and of its statics.
std::vector<std::string> collect_texts(const Description& description) {
  Model model = build_model(description);
  std::vector<std::string> all = messages(input_findings(model));
  for (std::string& text : texts(assumptions(model))) all.push_back(std::move(text));
  const StaticRun statics = run_statics(model);
  if (statics.failure) all.push_back(statics.failure->why);
  if (statics.results) add_texts(*statics.results, all);
  return all;
}

std::vector<double> numbers_before(const std::string& unit, const std::vector<std::string>& texts) {
  const std::regex quantity("(-?[0-9.]+) " + unit + "(?![a-z0-9/])");
  std::vector<double> numbers;
  for (const std::string& text : texts) {
    for (std::sregex_iterator found(text.begin(), text.end(), quantity), end; found != end; ++found) {
      numbers.push_back(std::stod((*found)[1]));
    }
  }
  return numbers;
}

void expect_no_metric_unit(const std::vector<std::string>& texts) {
  const std::regex metric("( kN| MN| MPa| GPa| mm| km| kg| N/m| 1/m|[0-9] m|[0-9] t)(?![a-z0-9])");
  for (const std::string& text : texts) EXPECT_FALSE(std::regex_search(text, metric)) << text;
}

/// Texts of a lay with findings, and of one whose tension does not carry the pipe.
std::vector<std::string> texts_with_findings() {
  std::vector<std::string> all = collect_texts(example("bgl1-as-printed.yaml"));
  Description low = example("bgl1.yaml");
  low.tensioner.tension = 30e3;
  for (std::string& text : collect_texts(low)) all.push_back(std::move(text));
  std::erase_if(all, [](const std::string& text) { return text.find("laid pipe is extended") != std::string::npos; });
  return all;  // without the 3 km, which are feet as well
}

TEST(us_texts, have_the_numbers_of_the_metric_ones_times_the_ratio_of_their_units) {
  struct Pair {
    const char *metric, *us;
    double ratio;
  };
  const std::vector<std::string> metric = texts_with_findings();
  const UsUnits units;
  const std::vector<std::string> us = texts_with_findings();
  for (const Pair& pair : {Pair{"kN", "kip", 0.224809}, Pair{"m", "ft", 3.28084}, Pair{"MPa", "ksi", 0.145038},
                           Pair{"mm", "in", 0.0393701}, Pair{"MN/m", "kip/in", 5.710147}}) {
    const std::vector<double> was = numbers_before(pair.metric, metric), is = numbers_before(pair.us, us);
    ASSERT_EQ(is.size(), was.size()) << pair.us;
    EXPECT_FALSE(is.empty()) << pair.us;
    for (std::size_t i = 0; i < is.size(); ++i) {
      EXPECT_NEAR(is[i], pair.ratio * was[i], 0.02 + 0.01 * std::abs(is[i])) << pair.us;  // both are rounded
    }
  }
}

TEST(us_texts, of_all_examples_have_no_metric_unit) {
  const UsUnits units;
  for (const auto& file : std::filesystem::directory_iterator(OVERBEND_SOURCE_DIR "/examples")) {
    if (file.path().extension() == ".yaml")
      expect_no_metric_unit(collect_texts(example(file.path().filename().string())));
  }
}

TEST(us_texts, of_a_run_have_no_metric_unit) {
  const UsUnits units;
  testing::MemorySink sink;
  std::vector<std::string> all;
  add_texts(testing::TimedLay(testing::workable()).results(sink), all);
  EXPECT_FALSE(numbers_before("kip", all).empty());
  expect_no_metric_unit(all);
}

}  // namespace
}  // namespace overbend
