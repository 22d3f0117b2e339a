#include "checks/steel_grades.h"

#include <array>
#include <cmath>

namespace overbend {
namespace {

constexpr double kSlack = 2.5e6;  ///< Tolerance between a grade's values in MPa and those rounded from ksi [Pa].

constexpr std::array<SteelGrade, 18> kGrades = {{
    {"B", 241e6, 414e6},
    {"B", 245e6, 415e6},
    {"X42", 289e6, 414e6},
    {"X42", 290e6, 415e6},
    {"X46", 317e6, 434e6},
    {"X46", 320e6, 435e6},
    {"X52", 358e6, 455e6},
    {"X52", 360e6, 460e6},
    {"X56", 386e6, 489e6},
    {"X56", 390e6, 490e6},
    {"X60", 414e6, 517e6},
    {"X60", 415e6, 520e6},
    {"X65", 448e6, 531e6},
    {"X65", 450e6, 535e6},
    {"X70", 483e6, 565e6},
    {"X70", 485e6, 570e6},
    {"X80", 552e6, 621e6},
    {"X80", 555e6, 625e6},
}};

constexpr std::array<LayingLimits, 4> kLaying = {{
    {"X52", 358e6, 0.00205, 0.00260},
    {"X60", 414e6, 0.00230, 0.00290},
    {"X65", 448e6, 0.00250, 0.00305},
    {"X70", 483e6, 0.00270, 0.00325},
}};

}  // namespace

std::optional<SteelGrade> find_grade(double yield_stress) {
  std::optional<SteelGrade> nearest;
  double best = kSlack;
  for (const SteelGrade& grade : kGrades) {
    const double apart = std::abs(grade.yield_stress - yield_stress);
    if (apart <= best && (!nearest || apart < best)) {
      nearest = grade;
      best = apart;
    }
  }
  return nearest;
}

std::optional<LayingLimits> laying_limits(double yield_stress) {
  std::optional<LayingLimits> row;
  for (const LayingLimits& limits : kLaying) {
    if (limits.yield_stress <= yield_stress + kSlack) row = limits;
  }
  return row;
}

std::optional<LayingLimits> find_grade_limits(const std::string& grade) {
  for (const LayingLimits& limits : kLaying) {
    if (grade == limits.grade) return limits;
  }
  return std::nullopt;
}

}  // namespace overbend
