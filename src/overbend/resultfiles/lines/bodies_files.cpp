#include "resultfiles/lines/bodies_files.h"

#include "resultfiles/hdf5/hdf5_visitors.h"
#include "resultfiles/summary/summary_fields.h"
#include "resultfiles/summary/summary_json.h"
#include "resultfiles/tables/finite_visitor.h"
#include "results/fields/body_values.h"

namespace overbend {
namespace {

constexpr const char* kInTime = "/dynamic/bodies";

std::string numbered(const std::string& group, std::size_t i) {
  return group + "/" + std::to_string(i);
}

template <class Body, class Visit>
void write(DatasetSink& file, const std::string& group, const char* text, const std::vector<Body>& bodies,
           Visit visit) {
  if (bodies.empty()) return;
  file.group(group, text);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    file.group(numbered(group, i), "Body " + bodies[i].name);
    ValueWriter values{file, numbered(group, i)};
    visit(bodies[i], values);
  }
}

template <class Body, class Visit>
std::vector<Body> read(const Hdf5Reader& file, const std::string& group, Visit visit) {
  std::vector<Body> bodies;
  for (std::size_t i = 0; file.has(numbered(group, i)); ++i) {
    ValueReader values{file, numbered(group, i)};
    visit(bodies.emplace_back(), values);
  }
  return bodies;
}

template <class Body, class Visit>
void check(const std::string& place, const std::vector<Body>& bodies, Visit visit) {
  for (const Body& body : bodies) {
    FiniteVisitor values{place + body.name + "."};
    visit(body, values);
  }
}

const auto kAtRest = [](auto& body, auto& visit) { visit_body(body, visit); };
const auto kOverTime = [](auto& body, auto& visit) { visit_body_in_time(body, visit); };

}  // namespace

void write_bodies(DatasetSink& file, const std::string& group, const std::vector<BodyResult>& bodies) {
  write(file, group, "Bodies connected to lines, static results", bodies, kAtRest);
}

std::vector<BodyResult> read_bodies(const Hdf5Reader& file, const std::string& group) {
  return read<BodyResult>(file, group, kAtRest);
}

void write_bodies_in_time(DatasetSink& file, const std::vector<BodyDynamics>& bodies) {
  write(file, kInTime, "Bodies connected to lines, over time", bodies, kOverTime);
}

std::vector<BodyDynamics> read_bodies_in_time(const Hdf5Reader& file) {
  return read<BodyDynamics>(file, kInTime, kOverTime);
}

Json bodies_json(const std::vector<BodyResult>& bodies) {
  const SummaryStyle style;
  return style.rows(bodies, [&](const BodyResult& body) {
    return make_object(style, [&](auto& values) { visit_body(body, values); });
  });
}

void add_bodies(const StaticResults& results, Json& summary) {
  if (!results.bodies.empty()) summary["static"]["bodies"] = bodies_json(results.bodies);
}

void add_bodies_in_time(const DynamicResults& results, Json& summary) {
  if (results.bodies.empty()) return;
  const SummaryStyle style;
  summary["dynamic"]["bodies"] = style.rows(results.bodies, [&](const BodyDynamics& body) {
    return make_object(style, [&](auto& values) { visit_body_in_time(body, values); });
  });
}

void require_finite(const std::vector<BodyResult>& bodies) {
  check("bodies.", bodies, kAtRest);
}

void require_finite(const std::vector<BodyDynamics>& bodies) {
  check("dynamic.bodies.", bodies, kOverTime);
}

}  // namespace overbend
