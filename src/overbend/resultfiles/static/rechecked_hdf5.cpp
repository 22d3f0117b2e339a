#include "resultfiles/static/rechecked_hdf5.h"

#include "resultfiles/hdf5/check_hdf5.h"
#include "resultfiles/hdf5/hdf5_file.h"
#include "resultfiles/hdf5/hdf5_visitors.h"
#include "results/fields/check_fields.h"
#include "results/fields/dynamic_scalars.h"
#include "results/fields/static_scalars.h"

namespace overbend {
namespace {

/// Rewrites assumptions and findings, and ignores all other fields.
struct AssumptionWriter {
  Hdf5Writer& file;
  std::string group;

  template <class Value>
  void operator()(const ResultField& field, const Value& value) {
    if constexpr (std::is_same_v<Value, Assumptions>) {
      for (const std::string& name : {field.name, std::string(kAssumptionRanks)}) {
        if (file.has(group + "/" + name)) file.remove(group + "/" + name);
      }
      ValueWriter{file, group}(field, value);
    } else if constexpr (std::is_same_v<Value, Findings>) {
      for (const char* name : {"/findings", "/warnings"}) {
        if (file.has(group + name)) file.remove(group + name);
      }
      ValueWriter{file, group}(field, value);
    }
  }
};

void replace_checks(Hdf5Writer& file, const std::string& group, const CheckTable& table) {
  if (file.has(group)) file.remove(group);
  write_checks(file, group, table);
}

}  // namespace

void copy_rechecked(const std::filesystem::path& from, const std::filesystem::path& to, const StaticResults& statics,
                    const DynamicResults& dynamics, const Description& description) {
  std::filesystem::copy_file(from, to, std::filesystem::copy_options::overwrite_existing);
  Hdf5Writer file = Hdf5Writer::reopen(to);
  file.remove("/model/text");
  file.remove("/model/hash");
  write_model_text(file, description.source_text);
  AssumptionWriter of_statics{file, "/static"}, of_run{file, "/dynamic"};
  visit_key_results(statics, of_statics);
  visit_dynamic_keys(dynamics, of_run, false);
  const auto overwrite = [&](const ResultField& field, const std::vector<double>& values) {
    file.overwrite("/dynamic/design/" + field.name, values);
  };
  if (!dynamics.design.load.empty()) visit_station_design(dynamics.design, overwrite);
  replace_checks(file, "/static/checks", statics.checks);
  replace_checks(file, "/dynamic/checks", dynamics.checks);
  file.close();
}

}  // namespace overbend
