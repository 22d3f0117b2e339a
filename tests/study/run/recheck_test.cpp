#include "study/run/recheck.h"

#include <gtest/gtest.h>

#include "app/program.h"
#include "app/small_lay.h"
#include "resultfiles/dynamic/dynamic_reader.h"
#include "results/fields/check_fields.h"
#include "support/result_visitors.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;
using testing::BitsVisitor;
using testing::kSmallLay;
using testing::run_program;
using testing::Scratch;

const std::string kHigh = kSmallLay + "checks: {safety_class: high}\n";

/// Results of the small lay and of the same with safety class high, made once.
class Analyses {
 public:
  Analyses() {
    scratch_.write("low.yaml", kSmallLay);
    scratch_.write("high.yaml", kHigh);
    for (const std::string name : {"low", "high"}) {
      for (const std::string command : {"static", "dynamic"}) {
        const auto run = run_program(command + " " + scratch_.file(name + ".yaml") + " -o " + folder(command, name));
        if (run.code != 0) throw std::runtime_error(run.err);
      }
    }
  }
  std::string folder(const std::string& command, const std::string& name) const {
    return scratch_.file(command + "-" + name);
  }
  fs::path h5(const std::string& command, const std::string& name) const {
    return fs::path(folder(command, name)) / "results.h5";
  }

 private:
  Scratch scratch_;
};

const Analyses& analyses() {
  static const Analyses kAll;
  return kAll;
}

std::string result_bits(const CheckTable& table, const Assumptions& assumptions) {
  BitsVisitor bits;
  testing::visit_checks(table, bits);
  bits(ResultField{"assumptions"}, assumptions);
  return bits.text;
}

std::string result_bits(const Rechecked& r) {
  std::string text = result_bits(r.statics.checks, r.statics.assumptions);
  if (!r.dynamics) return text;
  BitsVisitor bits;
  visit_station_design(r.dynamics->design, bits);
  return text + result_bits(r.dynamics->checks, r.dynamics->assumptions) + bits.text;
}

/// As the analysis wrote them.
Rechecked stored(const fs::path& h5) {
  Rechecked as_is;
  if (has_dynamic(h5)) {
    StoredDynamics all = read_dynamic_results(h5);
    as_is.statics = all.statics.results;
    as_is.dynamics = all.results;
  } else {
    as_is.statics = read_static_results(h5).results;
  }
  return as_is;
}

std::string recheck_error(const std::string& command, const std::vector<std::string>& changes) {
  try {
    recheck(analyses().h5(command, "low"), changes);
  } catch (const RecheckError& error) {
    return error.what();
  }
  return "";
}

TEST(recheck, without_changes_gives_the_table_of_the_analysis_bit_for_bit) {
  for (const char* command : {"static", "dynamic"}) {
    const fs::path h5 = analyses().h5(command, "low");
    const Rechecked again = recheck(h5, {});
    EXPECT_GT(again.checks().rows.size(), 10U);
    EXPECT_EQ(result_bits(again), result_bits(stored(h5))) << command;
  }
}

TEST(recheck, with_another_safety_class_gives_the_table_of_a_new_analysis_bit_for_bit) {
  for (const char* command : {"static", "dynamic"}) {
    const fs::path low = analyses().h5(command, "low"), high = analyses().h5(command, "high");
    const std::string as_high = result_bits(stored(high));
    EXPECT_NE(result_bits(stored(low)), as_high) << command;
    EXPECT_EQ(result_bits(recheck(low, {"checks.safety_class=high"})), as_high) << command;
    EXPECT_EQ(result_bits(recheck(high, {"checks.safety_class="})), result_bits(stored(low))) << command;
  }
}

TEST(recheck, sets_limits_and_allowed_stresses_of_a_run_anew) {
  const Rechecked again = recheck(analyses().h5("dynamic", "low"),
                                  {"checks.limits.tension=100 kN", "checks.yield_share={sagbend_dynamic: 0.8}"});
  const auto has = [&](const std::string& id) {
    const std::vector<CheckRow>& rows = again.checks().rows;
    return std::any_of(rows.begin(), rows.end(), [&](const CheckRow& row) { return row.id == id; });
  };
  EXPECT_TRUE(has("tensioner_load"));
  EXPECT_EQ(again.description.checks.limits.tension, 100e3);
  EXPECT_EQ(again.checks().rows.size(), recheck(analyses().h5("dynamic", "low"), {}).checks().rows.size() + 2);
}

TEST(recheck, rejects_keys_that_ask_for_a_new_analysis_and_names_them) {
  EXPECT_NE(
      recheck_error("static", {"pipe.steel.wall_thickness=20 mm"}).find("pipe.steel.wall_thickness: only keys below"),
      std::string::npos);
  EXPECT_NE(recheck_error("static", {"checks.safety_class"}).find("expected a key and its value"), std::string::npos);
  EXPECT_NE(recheck_error("static", {"checks.safety_class=highest"}).find("checks.safety_class"), std::string::npos);
  EXPECT_NE(recheck_error("static", {"checks.safty_class=high"}).find("safety_class"),
            std::string::npos);  // the near one
  for (const std::string change :
       {"condition_factor=1.07", "system_effects=no", "point_load=yes", "manufacture=seamless", "alpha_fab=0.9",
        "alpha_u=1", "alpha_h=0.9", "ovality=0.01", "current_load=functional"}) {
    const std::string key = "checks." + change.substr(0, change.find('='));
    EXPECT_EQ(recheck_error("static", {"checks." + change}), "");
    EXPECT_EQ(recheck_error("dynamic", {"checks." + change}).find(key + " cannot be changed for these results"), 0U)
        << key;
  }
}

/// Every key of the checks is either among those rejected, or changes nothing that a run gathers step by step.
TEST(recheck, a_static_table_with_other_strengths_is_that_of_a_new_analysis) {
  const Scratch scratch;
  scratch.write("model.yaml", kSmallLay + "checks: {manufacture: seamless, ovality: 0.01, alpha_u: 1}\n");
  ASSERT_EQ(run_program("static " + scratch.file("model.yaml") + " -o " + scratch.file("out")).code, 0);
  const Rechecked again = recheck(analyses().h5("static", "low"),
                                  {"checks.manufacture=seamless", "checks.ovality=0.01", "checks.alpha_u=1"});
  EXPECT_EQ(result_bits(again), result_bits(stored(fs::path(scratch.file("out")) / "results.h5")));
}

TEST(recheck, writes_results_that_are_those_of_a_new_analysis_but_for_times) {
  for (const char* command : {"static", "dynamic"}) {
    const Scratch scratch;
    const fs::path low = analyses().h5(command, "low"), folder = scratch.file("again");
    const Rechecked again = recheck(low, {"checks.safety_class=high"});
    write_rechecked(again, low, folder);
    const fs::path h5 = folder / "results.h5";
    EXPECT_EQ(result_bits(stored(h5)), result_bits(again));
    EXPECT_EQ(result_bits(recheck(h5, {"checks.safety_class=low"})), result_bits(stored(low)));
    for (const char* table : {"checks.csv", "calculation_sheet.csv", "pipe.csv", "supports.csv"}) {
      const std::string written = scratch.read(std::string("again/") + table);
      std::ifstream second(fs::path(analyses().folder(command, "high")) / table, std::ios::binary);
      EXPECT_EQ(written, std::string(std::istreambuf_iterator<char>(second), {})) << table;
    }
    EXPECT_NE(scratch.read("again/summary.json").find("\"checks\""), std::string::npos);
    EXPECT_NE(scratch.read("again/report.html").find("safety class high"), std::string::npos);
    EXPECT_NE(read_static_results(h5).model_text.find("safety_class: high"), std::string::npos);
  }
}

TEST(recheck, keeps_the_long_data_of_a_run) {
  const Scratch scratch;
  const fs::path low = analyses().h5("dynamic", "low"), folder = scratch.file("again");
  write_rechecked(recheck(low, {"checks.safety_class=high"}), low, folder);
  const std::string read =
      "/usr/bin/python3 -c \"import h5py,sys; a,b=[h5py.File(f) for f in sys.argv[1:]]; "
      "t='/dynamic/histories/top_tension'; assert (a[t][:]==b[t][:]).all() and len(a[t])>10; "
      "assert a[t].dims[0][0][:].tolist()==b[t].dims[0][0][:].tolist()\" ";
  EXPECT_EQ(std::system((read + low.string() + " " + (folder / "results.h5").string()).c_str()), 0);
}

}  // namespace
}  // namespace overbend
