// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "band_matrix.hpp"
#include "gradient.hpp"
#include "refine.hpp"

#include <array>
#include <vector>

/// The parts of refine(): unknowns, first-order data of points, normal equations. Private.
namespace wcam::motion::detail {

/// Where the unknowns are: for each bead a cubic B-spline, the active scalars of a pole side by
/// side.
class SplineLayout {
public:
  SplineLayout(const Task& task, const RefineFrame& frame);

  /// Support of a bead point: its first pole's first unknown and the four weights.
  struct Support {
    Eigen::Index first = 0;
    std::array<double, 4> weight{};
  };

  /// Poles that a residual may touch: two steps of 3 spans and the support of 4.
  static constexpr int kBand = 12;

  [[nodiscard]] Eigen::Index size() const { return size_; }

  [[nodiscard]] int scalars() const { return static_cast<int>(active_.size()); }

  [[nodiscard]] const std::vector<FreeScalar>& active() const { return active_; }

  [[nodiscard]] Eigen::Index halfBand() const { return kBand * scalars() - 1; }

  /// Targets on beads, in order.
  [[nodiscard]] const std::vector<std::size_t>& points() const { return points_; }

  [[nodiscard]] const Support& support(std::size_t point) const { return supports_[point]; }

  /// Values of the active scalars at a point.
  [[nodiscard]] std::array<double, kFreeScalars> valuesAt(std::size_t point,
                                                          const Eigen::VectorXd& x) const;
  /// Poles that fit the choices best.
  [[nodiscard]] Eigen::VectorXd fit(const std::vector<FreeChoice>& choices) const;
  /// Choices of all targets; travel moves take those of their bead's end.
  [[nodiscard]] std::vector<FreeChoice> choices(const Eigen::VectorXd& x) const;

private:
  [[nodiscard]] double offsetOf(std::size_t target, const FreeChoice& choice, FreeScalar s) const;

  const Task& task_;
  const RefineFrame& frame_;
  std::vector<FreeScalar> active_;
  std::vector<std::size_t> points_;
  std::vector<Support> supports_;
  Eigen::Index size_ = 0;
};

/// Objective, penalties and their normal equations at a motion.
struct Model {
  double merit = 0.0;
  BandMatrix normal;
  Eigen::VectorXd gradient;
};

class ModelBuilder {
public:
  ModelBuilder(const Task& task, const RefineFrame& frame, const SplineLayout& layout);

  /// @param penalty weight of squared violations, in degrees
  Model build(const std::vector<FreeChoice>& choices,
              const Motion& motion,
              double penalty,
              const JobContext& context) const;

private:
  struct Point;
  struct Row;
  class Sum;

  void linearise(std::size_t k,
                 const std::vector<FreeChoice>& choices,
                 const Motion& motion,
                 Point& point) const;
  void addPoint(const Point& point, double penalty, Sum& sum) const;
  static void addJoints(const Point& point,
                        double residual,
                        double weight,
                        std::initializer_list<int> joints,
                        std::initializer_list<double> factors,
                        Sum& sum);
  void addArm(const Point& point, double penalty, Sum& sum) const;
  void addSum(const Point& point, const cell::JointSum& own, double penalty, Sum& sum) const;
  void addStep(const Point& from, const Point& to, double penalty, Sum& sum) const;
  void addBend(const Point& before, const Point& at, const Point& after, Sum& sum) const;
  void addTransition(const Point& from, const Point& to, Sum& sum) const;

  const Task& task_;
  const RefineFrame& frame_;
  const SplineLayout& layout_;
  CellModel model_;
  ObjectiveValues weights_;
  double perPoint_;  ///< 1 over the number of bead points
};

}  // namespace wcam::motion::detail
