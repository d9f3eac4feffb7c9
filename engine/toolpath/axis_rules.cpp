// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "axis_rules.hpp"

#include "wcam/base/text.hpp"
#include "wcam/toolpath/tool_axis.hpp"

#include "frames.hpp"

#include <algorithm>
#include <string>

namespace wcam::toolpath {

namespace {

/// Mean of the local build directions over the length of the beads; the layer's where they cancel.
Vec3 meanDirection(const Layer& layer) {
  Vec3 sum = Vec3::Zero();
  double whole = 0.0;
  for (const Bead& bead : layer.beads) {
    for (std::size_t i = 1; i < bead.points.size(); ++i) {
      const double length = (bead.points[i].p - bead.points[i - 1].p).norm();
      sum += 0.5 * length * (bead.points[i].b + bead.points[i - 1].b);
      whole += length;
    }
  }
  return sum.norm() > kNoDirection * whole ? Vec3(sum.normalized()) : layer.up;
}

class AxisRules {
public:
  AxisRules(const Layer& layer, bool curved, const Substrate& substrate, const PathParams& params)
      : params_(params),
        layerUp_(layer.up),
        vertical_(substrate.up()),
        normal_(substrate.pose().linear() * Vec3(params.axisPlaneNormal[0],
                                                 params.axisPlaneNormal[1],
                                                 params.axisPlaneNormal[2])),
        mode_(params.axis) {
    if (mode_ == AxisMode::Auto) {
      mode_ = curved ? AxisMode::Local : AxisMode::Layer;
    }
    mean_ = mode_ == AxisMode::Mean ? meanDirection(layer) : layer.up;
  }

  void apply(Bead& bead, const Contour& contour) {
    std::vector<Vec3> ups;
    for (std::size_t i = 0; i < bead.points.size(); ++i) {
      const Vec3& given = contour.points[i % contour.points.size()].axis;
      const bool comesAlong = params_.axis == AxisMode::Auto && given.norm() > 0.0;
      ups.push_back(ruled(comesAlong ? Vec3(given.normalized()) : direction(bead.points[i])));
    }
    smooth(bead, ups);
    const bool tilts = params_.lead.value() != 0.0 || params_.lateralTilt.value() != 0.0;
    std::vector<Vec3> axes = ups;
    for (std::size_t i = 0; i < axes.size() && tilts; ++i) {
      axes[i] = tilted(bead.points[i].t, bead.outward(bead.points[i]), ups[i]);
    }
    if (tilts) {
      smooth(bead, axes);
    }
    for (std::size_t i = 0; i < axes.size(); ++i) {
      bead.points[i].up = ups[i];
      bead.points[i].axis = axes[i];
    }
  }

  void report(int layer, const JobContext& context) const {
    if (notProjected_ > 0) {
      context.add({Severity::Warning,
                   "toolpath.axis_not_projected",
                   text("%1 axes are perpendicular to the plane that they shall be projected on, "
                        "and stay as they are",
                        {std::to_string(notProjected_)}),
                   "choose another axis_plane_normal",
                   {{}, layer, -1, -1},
                   {{"points", static_cast<double>(notProjected_)}}});
    }
    if (deviation_ > params_.axisDeviation.value()) {
      context.add({Severity::Warning,
                   "toolpath.axis_smoothed",
                   text("the tool axis leaves its rule by up to %1 degrees to turn by at most %2 "
                        "degrees per mm",
                        {formatFixed(radToDeg(deviation_), 1), formatFixed(params_.axisRate, 2)}),
                   "raise axis_rate, or take an axis rule that turns less",
                   {{}, layer, -1, -1},
                   {{"deviation_deg", radToDeg(deviation_)}}});
    }
  }

private:
  [[nodiscard]] Vec3 direction(const PathPoint& point) const {
    switch (mode_) {
      case AxisMode::Local:
        return point.b;
      case AxisMode::Global:
        return vertical_;
      case AxisMode::Mean:
        return mean_;
      case AxisMode::Layer:
      case AxisMode::Auto:
        break;
    }
    return layerUp_;
  }

  Vec3 ruled(Vec3 axis) {
    if (params_.axisProject) {
      const std::optional<Vec3> projected = projectedAxis(axis, normal_);
      notProjected_ += projected ? 0U : 1U;
      axis = projected.value_or(axis);
    }
    return limitedAxis(axis, vertical_, params_.axisLimit);
  }

  [[nodiscard]] Vec3 tilted(const Vec3& travel, const Vec3& outward, const Vec3& up) const {
    const TiltFrame frame = tiltFrame(travel, outward, up);
    return tiltedAxis(frame.along, frame.outwards, up, params_.lead, params_.lateralTilt);
  }

  void smooth(const Bead& bead, std::vector<Vec3>& axes) {
    if (!(params_.axisRate > 0.0)) {
      return;
    }
    std::vector<Vec3> positions;
    for (const PathPoint& point : bead.points) {
      positions.push_back(point.p);
    }
    SmoothedAxes smoothed = smoothedAxes(positions, axes, bead.closed, degToRad(params_.axisRate));
    deviation_ = std::max(deviation_, smoothed.maxDeviation);
    axes = std::move(smoothed.axes);
  }

  const PathParams& params_;
  Vec3 layerUp_;
  Vec3 vertical_;
  Vec3 normal_;
  Vec3 mean_;
  AxisMode mode_;
  std::size_t notProjected_ = 0;
  double deviation_ = 0.0;
};

}  // namespace

void setAxes(Layer& layer,
             const std::vector<OrderedContour>& contours,
             bool curved,
             const Substrate& substrate,
             const PathParams& params,
             int layerIndex,
             const JobContext& context) {
  AxisRules rules(layer, curved, substrate, params);
  for (std::size_t b = 0; b < layer.beads.size(); ++b) {
    rules.apply(layer.beads[b], contours[b].contour);
  }
  rules.report(layerIndex, context);
}

}  // namespace wcam::toolpath
