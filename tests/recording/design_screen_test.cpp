// Values skipped by the screen of the design recorder are never a new maximum utilisation.
#include "recording/design_screen.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "modelfile/reading/yaml_reader.h"

namespace overbend {
namespace {

constexpr std::size_t kNodes = 7;
constexpr SectionRun kAll{0, 0, kNodes};

/// A line with random load effects about those of its static state.
class RandomLine {
 public:
  RandomLine() {
    const Description d = read_model(OVERBEND_SOURCE_DIR "/examples/bgl1.yaml").description.value();
    for (std::size_t i = 0; i < kSafetyClasses; ++i) {
      CheckSettings settings = d.checks;
      settings.safety_class = static_cast<SafetyClass>(i);
      capacities_.push_back(make_check_section(d.pipe.section, settings));
    }
    for (std::size_t i = 0; i < kSafetyClasses; ++i) sections[i] = &capacities_[i];
    for (std::size_t node = 0; node < kNodes; ++node) {
      rest_values.tangent.set(node, direction());
      rest_values.moment.set(node, 200e3 * direction());
      rest_values.strain.set(node, 1e-3 * direction());
      rest_values.force[node] = 3e5;
    }
  }

  /// Overpressures are about `mean` [Pa].
  void next(double mean) {
    for (std::size_t node = 0; node < kNodes; ++node) {
      tangents.set(node, (rest_values.tangent[node] + 0.1 * direction()).normalized());
      moments.set(node, rest_values.moment[node] + 100e3 * normal_(generator_) * direction());
      strain[node] = 1e-3 + 2e-4 * std::abs(normal_(generator_));
      force[node] = 3e5 + 2e5 * normal_(generator_);
      overpressure[node] = mean + 2e5 * normal_(generator_);
    }
  }

  PresentEffects now() const { return {moments, tangents, strain, force}; }

  double load_used(const LoadFactors& f, std::size_t of_class, std::size_t node) const {
    const Vec3 functional = transported(rest_values.moment[node], rest_values.tangent[node], tangents[node]);
    const double moment = design_size(f, functional, moments[node] - functional);
    const double axial = design_value(f, rest_values.force[node], force[node] - rest_values.force[node]);
    return load_terms(sections[of_class]->load, moment, axial, overpressure[node], 0.0).utilisation();
  }
  double design_strain(const LoadFactors& f, std::size_t node) const {
    const Vec3 functional = transported(rest_values.strain[node], rest_values.tangent[node], tangents[node]);
    const Vec3 all = strain[node] / moments[node].norm() * moments[node];
    return sections[0]->strain_factor * design_size(f, functional, all - functional);
  }

  SectionOfClasses sections{};
  FunctionalEffects rest_values{kNodes};
  std::vector<double> overpressure = std::vector<double>(kNodes);

 private:
  Vec3 direction() { return Vec3(normal_(generator_), normal_(generator_), normal_(generator_)).normalized(); }

  std::mt19937_64 generator_{5};
  std::normal_distribution<double> normal_;
  std::vector<CheckSection> capacities_;
  VectorColumns moments{kNodes}, tangents{kNodes};
  std::vector<double> strain = std::vector<double>(kNodes), force = std::vector<double>(kNodes);
};

const std::vector<LoadFactors> kCombinations = {local_check_factors(1.0), system_check_factors(1.0)};

TEST(design_screen, no_larger_utilisation_under_combined_load_is_passed_over) {
  for (const double mean : {9e5, 0.0}) {
    RandomLine line;
    DesignScreen screen(kNodes, kCombinations);
    double max_value[kSafetyClasses][kNodes] = {};
    int looked = 0;
    for (int instant = 0; instant < 400; ++instant) {
      line.next(mean);
      screen.find_loads(kAll, line.sections, line.rest_values, line.now(), line.overpressure);
      for (std::size_t node = 0; node < kNodes; ++node) {
        looked += screen.loads_more(node) && line.overpressure[node] >= 0.0 ? 1 : 0;
        for (std::size_t i = 0; i < kSafetyClasses; ++i) {
          for (const LoadFactors& f : kCombinations) {
            const double used = line.load_used(f, i, node);
            if (used <= max_value[i][node]) continue;
            ASSERT_TRUE(screen.loads_more(node)) << instant << " " << node;
            max_value[i][node] = used;
            screen.keep_load(i, node, used);
          }
        }
      }
    }
    EXPECT_LT(looked, 400);  // of 2800
  }
}

TEST(design_screen, no_larger_utilisation_by_strain_is_passed_over) {
  for (const double mean : {9e5, 0.0}) {
    RandomLine line;
    DesignScreen screen(kNodes, kCombinations);
    double max_value[kSafetyClasses][kNodes] = {};
    int looked = 0;
    for (int instant = 0; instant < 400; ++instant) {
      line.next(mean);
      screen.find_strains(kAll, line.sections, line.rest_values, line.now(), line.overpressure);
      for (std::size_t node = 0; node < kNodes; ++node) {
        looked += screen.strains_more(node) ? 1 : 0;
        for (std::size_t i = 0; i < kSafetyClasses; ++i) {
          for (const LoadFactors& f : kCombinations) {
            const double strain = line.design_strain(f, node);
            const StrainCapacity& capacity = line.sections[i]->strain;
            const double used = strain_terms(capacity, strain, line.overpressure[node], 0.0).utilisation();
            if (used <= max_value[i][node]) continue;
            ASSERT_TRUE(screen.strains_more(node)) << instant << " " << node;
            max_value[i][node] = used;
            screen.keep_strain(i, node, used, strain, capacity);
          }
        }
      }
    }
    // Number out of 2800. Where inside and outside take turns in being the higher pressure the bound is wider.
    EXPECT_LT(looked, mean > 0.0 ? 400 : 1400);
  }
}

TEST(design_screen, forces_are_the_largest_of_all_combinations) {
  RandomLine line;
  line.next(9e5);
  DesignScreen screen(kNodes, kCombinations);
  screen.find_loads(kAll, line.sections, line.rest_values, line.now(), line.overpressure);
  std::vector<double> max_value(kNodes, 0.0);
  screen.raise_forces(kAll, max_value);
  for (std::size_t node = 0; node < kNodes; ++node) {
    const double at_rest = line.rest_values.force[node], added = line.now().force[node] - at_rest;
    const double single = std::abs(design_value(kCombinations[0], at_rest, added));
    const double two = std::abs(design_value(kCombinations[1], at_rest, added));
    EXPECT_DOUBLE_EQ(max_value[node], std::max(single, two));  // kernels round a product and a sum once
  }
}

}  // namespace
}  // namespace overbend
