/// Search for the angles of a stinger's sections at which the moments about their hinges have wanted values.
#pragma once

#include <optional>
#include <vector>

#include "statics/stinger/stinger_equilibrium.h"

namespace overbend {

/// Pipe and stinger at trial angles of the floating sections.
struct StingerTrial {
  Eigen::VectorXd angles;   ///< [rad]
  Eigen::VectorXd moments;  ///< About their hinges [N m].
  Eigen::VectorXd scale;    ///< Sum of the magnitudes of the contributions to the moments [N m].
  StaticSolution solution;
};

class StingerSearch {
 public:
  /// `floating`: sections that may turn. `wanted`: moments to reach; zero if empty.
  StingerSearch(Model& model, const LoadHistory& past, std::vector<std::size_t> floating,
                std::vector<double> wanted = {});

  /// Searches from the angles of all sections, with a neighbouring equilibrium and the stiffness of the moments
  /// (floating sections, row by row) if known. Leaves the supports of the model at the solution.
  StaticOutcome find(const std::vector<double>& angles, const StaticSolution* start,
                     const std::vector<double>& stiffness);

  /// Solves the pipe at these angles; nullopt if it has no equilibrium.
  std::optional<StingerTrial> solve_at(const Eigen::VectorXd& angles);

  /// Decrease of the moments with the angles at an equilibrium, by central differences [N m/rad]. `angles`: those of
  /// all sections.
  std::optional<Eigen::MatrixXd> stiffness(const std::vector<double>& angles, const StaticSolution& solution);

 private:
  Eigen::VectorXd select_floating(const std::vector<double>& angles) const;
  bool begin(const Eigen::VectorXd& from);
  Eigen::VectorXd unbalanced_moment(const StingerTrial& trial) const;
  std::vector<int> free_sections(const StingerTrial& trial) const;
  bool is_balanced(const StingerTrial& trial, const std::vector<int>& free) const;
  Eigen::VectorXd direction(const std::vector<int>& free) const;
  bool step(const std::vector<int>& free);
  bool shorten(const Eigen::VectorXd& increment, double slope, double share, StingerTrial beyond);
  bool restart_cold(const StingerTrial& from);
  void update_stiffness(const StingerTrial& before, const StingerTrial& after);
  Eigen::VectorXd clipped(const Eigen::VectorXd& angles) const;
  bool turned_too_far() const;
  StaticFailure failure() const;

  Model& model_;
  const LoadHistory& past_;
  std::vector<std::size_t> floating_;
  Eigen::VectorXd wanted_, low_, high_;
  std::vector<double> angles_;  ///< All sections.
  std::optional<StaticSolution> last_;
  std::optional<StingerTrial> current_;
  std::optional<StaticFailure> pipe_failure_;
  Eigen::MatrixXd stiffness_;
  double max_step_ = 0.0;  ///< Maximum step [rad].
  int trials_ = 0;
  bool jumps_ = false;
  bool cold_ = false;  ///< Trials start without a warm start.
};

}  // namespace overbend
