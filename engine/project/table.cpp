// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/joint_text.hpp"
#include "wcam/project/report.hpp"

#include <charconv>
#include <map>
#include <tuple>

namespace wcam::project {

namespace {

constexpr int kVectorDecimals = 9;
constexpr int kFigureDecimals = 6;
/// Joints in degrees (a millionth is 17 nm on a robot of 1 m) or mm.
constexpr int kJointDecimals = 6;

class Row {
public:
  explicit Row(std::string& out) : out_(out) {}

  void text(std::string_view text) {
    separate();
    out_ += text;
  }

  void integer(int number) { text(std::to_string(number)); }

  void fixed(double number, int decimals) { text(formatFixed(number, decimals)); }

  /// Shortest text that reads back as the same double.
  void exact(double number) {
    char buffer[40];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, number == 0.0 ? 0.0 : number);
    text(std::string_view(buffer,
                          error == std::errc{} ? static_cast<std::size_t>(end - buffer) : 0));
  }

  void position(const geometry::Vec3& p) {
    exact(p.x());
    exact(p.y());
    exact(p.z());
  }

  void vector(const geometry::Vec3& v) {
    fixed(v.x(), kVectorDecimals);
    fixed(v.y(), kVectorDecimals);
    fixed(v.z(), kVectorDecimals);
  }

  void end() { out_ += '\n'; }

private:
  void separate() {
    if (!first_) {
      out_ += ',';
    }
    first_ = false;
  }

  std::string& out_;
  bool first_ = true;
};

using PointKey = std::tuple<int, int, int>;

}  // namespace

std::string operationTable(const OperationResult& result) {
  std::string out =
      "op,layer,bead,point,x_mm,y_mm,z_mm,nx,ny,nz,bx,by,bz,ax,ay,az,height_mm,width_mm,speed_mm_s,"
      "wire_m_min,arc,time_s,"
      "tcp_speed_mm_s";
  const int joints = result.cell->jointCount();
  for (int j = 0; j < joints; ++j) {
    out += ",j" + std::to_string(j + 1) + "_" + cell::jointUnit(result.cell->joint(j));
  }
  out += '\n';
  std::map<PointKey, const motion::Waypoint*> waypoints;
  for (const motion::Waypoint& waypoint : result.motion->motion.waypoints) {
    if (waypoint.point >= 0) {
      waypoints.emplace(PointKey(waypoint.layer, waypoint.bead, waypoint.point), &waypoint);
    }
  }
  for (std::size_t l = 0; l < result.path->layers.size(); ++l) {
    const toolpath::Layer& layer = result.path->layers[l];
    for (std::size_t b = 0; b < layer.beads.size(); ++b) {
      for (std::size_t i = 0; i < layer.beads[b].points.size(); ++i) {
        const toolpath::PathPoint& point = layer.beads[b].points[i];
        const auto found =
            waypoints.find(PointKey(static_cast<int>(l), static_cast<int>(b), static_cast<int>(i)));
        const motion::Waypoint* waypoint = found == waypoints.end() ? nullptr : found->second;
        Row row(out);
        row.text(result.id);
        row.integer(static_cast<int>(l));
        row.integer(static_cast<int>(b));
        row.integer(static_cast<int>(i));
        row.position(point.p);
        row.vector(layer.beads[b].outward(point));
        row.vector(point.b);
        row.vector(point.axis);
        row.fixed(point.height, kFigureDecimals);
        row.fixed(point.width, kFigureDecimals);
        row.fixed(point.speed, kFigureDecimals);
        // The motion may let the wire follow the speed.
        const double wire = waypoint != nullptr && i > 0 ? waypoint->wireSpeed : point.wireSpeed;
        row.fixed(toFileUnit(QuantityKind::WireSpeed, wire), kFigureDecimals);
        row.integer(i > 0 && point.arc ? 1 : 0);
        row.fixed(waypoint != nullptr ? waypoint->time : 0.0, kFigureDecimals);
        row.fixed(waypoint != nullptr ? waypoint->tcpSpeed : 0.0, kFigureDecimals);
        for (int j = 0; j < joints; ++j) {
          if (waypoint != nullptr && j < waypoint->joints.size()) {
            row.fixed(cell::toJointUnit(result.cell->joint(j), waypoint->joints[j]),
                      kJointDecimals);
          } else {
            row.text("");
          }
        }
        row.end();
      }
    }
  }
  return out;
}

}  // namespace wcam::project
