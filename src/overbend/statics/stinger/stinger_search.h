/// Angles of a stinger's sections at which the moments about their hinges are those wanted.
#pragma once

#include <optional>
#include <vector>

#include "statics/stinger/stinger_rest.h"

namespace overbend {

/// Pipe and stinger at trial angles of the sections that float.
struct StingerTrial {
  Eigen::VectorXd angles;   ///< [rad]
  Eigen::VectorXd moments;  ///< About their hinges [N m].
  Eigen::VectorXd scale;    ///< Sum of the magnitudes of what is added up in them [N m].
  StaticSolution solution;
};

class StingerSearch {
 public:
  /// `floating`: sections that may turn. The moments are brought to `wanted`, zero where it is empty.
  StingerSearch(Model& model, const LinePast& past, std::vector<std::size_t> floating, std::vector<double> wanted = {});

  /// From angles of all sections, and an equilibrium near them where there is one; the stiffness of the moments where
  /// that is known, of the floating sections row by row. The supports of the model are left where the answer is.
  StaticOutcome find(const std::vector<double>& angles, const StaticSolution* start,
                     const std::vector<double>& stiffness);

  /// Pipe and stinger at these angles; nothing where there is no equilibrium of the pipe.
  std::optional<StingerTrial> at(const Eigen::VectorXd& angles);

  /// Fall of the moments with the angles at an equilibrium, by central differences [N m/rad]. `angles` are those of
  /// all sections.
  std::optional<Eigen::MatrixXd> stiffness(const std::vector<double>& angles, const StaticSolution& solution);

 private:
  Eigen::VectorXd of_floating(const std::vector<double>& angles) const;
  bool begin(const Eigen::VectorXd& from);
  Eigen::VectorXd lack(const StingerTrial& trial) const;
  std::vector<int> free_ones(const StingerTrial& trial) const;
  bool at_rest(const StingerTrial& trial, const std::vector<int>& free) const;
  Eigen::VectorXd direction(const std::vector<int>& free) const;
  bool step(const std::vector<int>& free);
  bool shorten(const Eigen::VectorXd& way, double slope, double share, StingerTrial beyond);
  bool begin_afresh(const StingerTrial& from);
  void learn(const StingerTrial& before, const StingerTrial& after);
  Eigen::VectorXd clipped(const Eigen::VectorXd& angles) const;
  bool turned_too_far() const;
  StaticFailure failure() const;

  Model& model_;
  const LinePast& past_;
  std::vector<std::size_t> floating_;
  Eigen::VectorXd wanted_, low_, high_;
  std::vector<double> angles_;  ///< Of all sections.
  std::optional<StaticSolution> last_;
  std::optional<StingerTrial> now_;
  std::optional<StaticFailure> pipe_failure_;
  Eigen::MatrixXd stiffness_;
  double longest_ = 0.0;  ///< Step at most [rad].
  int trials_ = 0;
  bool jumps_ = false;
  bool afresh_ = false;  ///< Trials start from nothing.
};

}  // namespace overbend
