#include "base/finding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/ranges.h"
#include "base/shown_unit.h"
#include "base/units.h"

namespace overbend {

FindingSeverity Finding::severity() const {
  const FindingSeverity default_severity = kind(code).severity;
  return accepted && default_severity == FindingSeverity::serious ? FindingSeverity::caution : default_severity;
}

Findings merge(Findings all, const Findings& more) {
  for (const Finding& finding : more) {
    if (ranges::find(all, finding) == all.end()) all.push_back(finding);
  }
  return all;
}

void append(Findings& all, Findings more) {
  ranges::move(more, std::back_inserter(all));
}

void accept(Findings& findings, const std::vector<std::string>& codes) {
  for (Finding& finding : findings) {
    finding.accepted = ranges::find(codes, kind(finding.code).name) != codes.end();
  }
}

Findings sorted_by_severity(const Findings& findings) {
  Findings sorted, repeated;
  std::set<FindingCode> codes;
  for (const Finding& finding : findings) {
    const bool again = finding.severity() == FindingSeverity::serious && !codes.insert(finding.code).second;
    (again ? repeated : sorted).push_back(finding);
  }
  ranges::move(repeated, std::back_inserter(sorted));
  ranges::stable_sort(sorted, {}, &Finding::severity);
  return sorted;
}

Findings serious_findings(const Findings& findings) {
  Findings serious;
  ranges::copy_if(findings, std::back_inserter(serious),
                  [](const Finding& finding) { return finding.severity() == FindingSeverity::serious; });
  return serious;
}

std::size_t count(const Findings& findings, FindingSeverity severity) {
  return static_cast<std::size_t>(ranges::count(findings, severity, &Finding::severity));
}

bool has_code(const Findings& findings, FindingCode code) {
  return ranges::find(findings, code, &Finding::code) != findings.end();
}

std::string severity_counts(const Findings& findings) {
  std::string text;
  for (const FindingSeverity severity : {FindingSeverity::serious, FindingSeverity::caution, FindingSeverity::note}) {
    const std::size_t number = count(findings, severity);
    if (number > 0) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", number, name(severity));
  }
  return text;
}

std::vector<std::string> messages(const Findings& findings) {
  std::vector<std::string> list;
  for (const Finding& finding : findings) list.push_back(finding.message);
  return list;
}

Json finding_json(const Finding& finding) {
  Json json = {{"code", kind(finding.code).name}, {"severity", name(finding.severity())}, {"message", finding.message}};
  if (!finding.object.empty()) json["object"] = finding.object;
  if (finding.from_top) json["from_top"] = *finding.from_top;
  if (finding.time) json["time"] = *finding.time;
  for (const FindingNumber& number : finding.numbers) {
    json["numbers"].push_back({{"name", number.name}, {"value", number.value}, {"unit", number.unit}});
  }
  if (finding.accepted) json["accepted"] = true;
  return json;
}

Json findings_json(const Findings& findings) {
  Json list = Json::array();
  for (const Finding& finding : findings) list.push_back(finding_json(finding));
  return list;
}

Finding read_finding(const Json& json) {
  Finding finding;
  finding.code = find_finding_code(json.at("code").get<std::string>()).value_or(FindingCode::unknown);
  finding.message = json.at("message").get<std::string>();
  finding.object = json.value("object", std::string());
  if (json.contains("from_top")) finding.from_top = json["from_top"].get<double>();
  if (json.contains("time")) finding.time = json["time"].get<double>();
  for (const Json& number : json.value("numbers", Json::array())) {
    finding.numbers.push_back({number.at("name"), number.at("value"), number.at("unit")});
  }
  finding.accepted = json.value("accepted", false);
  return finding;
}

Findings read_findings(const Json& list) {
  Findings findings;
  for (const Json& json : list) findings.push_back(read_finding(json));
  return findings;
}

namespace {

double severity_measure(const Finding& finding) {
  return finding.numbers.empty() ? 0.0 : std::abs(finding.numbers.front().value);
}

std::string spaced(std::string name) {
  ranges::replace(name, '_', ' ');
  return name;
}

/// Returns a text such as "effective tension -155.9 to -6.9 kN".
std::string range_text(const FindingNumber& number, double low, double high) {
  const ShownUnit unit = number.unit == "rad" ? ShownUnit{"rad", "rad"} : shown_unit(number.unit);
  return fmt::format("{} {} to {}", spaced(number.name), shown_digits_number(low, unit, 4),
                     shown_digits(high, unit, 4));
}

void add_to(SharedFinding& shared, const Finding& finding) {
  for (std::size_t i = 0; i < std::min(shared.low.size(), finding.numbers.size()); ++i) {
    shared.low[i] = std::min(shared.low[i], finding.numbers[i].value);
    shared.high[i] = std::max(shared.high[i], finding.numbers[i].value);
  }
  if (severity_measure(finding) > severity_measure(shared.worst)) shared.worst = finding;
}

}  // namespace

std::string SharedFinding::text() const {
  std::string ranges;
  for (std::size_t i = 0; i < std::min(low.size(), worst.numbers.size()); ++i) {
    if (low[i] == high[i]) continue;
    ranges += (ranges.empty() ? "" : ", ") + range_text(worst.numbers[i], low[i], high[i]);
  }
  return ranges.empty() ? worst.message : worst.message + " (over the runs: " + ranges + ")";
}

std::vector<SharedFinding> shared_findings(const std::vector<Findings>& runs) {
  std::vector<SharedFinding> all;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    for (const Finding& finding : runs[run]) {
      const auto same = [&](const SharedFinding& shared) {
        // plain findings are distinguished by their message
        const bool is_plain = finding.object.empty() && finding.numbers.empty();
        return shared.worst.code == finding.code && shared.worst.object == finding.object &&
               (!is_plain || shared.worst.message == finding.message);
      };
      auto known = ranges::find_if(all, same);
      if (known == all.end()) {
        SharedFinding shared{finding};
        for (const FindingNumber& number : finding.numbers) shared.low.push_back(number.value);
        shared.high = shared.low;
        known = all.insert(known, std::move(shared));
      } else {
        add_to(*known, finding);
      }
      if (known->runs.empty() || known->runs.back() != run) known->runs.push_back(run);
    }
  }
  return all;
}

}  // namespace overbend
