// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/skeleton.hpp"

#include "wcam/base/error.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/part_ends.hpp"
#include "wcam/geometry/topology_events.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace wcam::geometry {

namespace {

/// A bump lower than this part of the field's range is no branch.
constexpr double kBump = 0.05;
/// Level curves of a whole part through which its lines are drawn.
constexpr int kCurves = 48;
/// Levels keep this part of a branch's range away from its ends, where curves touch or are points.
constexpr double kClear = 0.02;

/// Centre of a closed or open polyline, weighted by length, and its length.
struct Centre {
  Vec3 p = Vec3::Zero();
  double length = 0.0;

  void add(const Vec3& a, const Vec3& b) {
    const double l = (b - a).norm();
    p += 0.5 * l * (a + b);
    length += l;
  }

  [[nodiscard]] Vec3 mean() const { return p / length; }
};

Centre centreOf(const LevelContour& contour) {
  Centre centre;
  for (std::size_t i = 1; i < contour.points.size(); ++i) {
    centre.add(contour.points[i - 1], contour.points[i]);
  }
  if (contour.closed && contour.points.size() > 1) {
    centre.add(contour.points.back(), contour.points.front());
  }
  return centre;
}

Vec3 centreOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& loop) {
  Centre centre;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    centre.add(mesh.vertices[loop[i]], mesh.vertices[loop[(i + 1) % loop.size()]]);
  }
  return centre.length > 0.0 ? centre.mean() : mesh.vertices[loop.front()];
}

/// The field, its branches and the centres of each branch's curves, lowest first.
struct Lines {
  PartEnds ends;
  std::vector<double> field;
  FieldTopology topology;
  std::vector<std::vector<Vec3>> centres;  ///< per branch
};

std::pair<double, double> rangeOf(const std::vector<double>& field) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const double value : field) {
    if (std::isfinite(value)) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  return {low, high};
}

/// The branch to which most nodes of a curve belong.
std::uint32_t branchOf(const FieldTopology& topology, const LevelContour& contour, double level) {
  std::map<std::uint32_t, std::size_t> votes;
  for (const std::uint32_t h : contour.halfEdges) {
    const std::uint32_t branch = topology.branchOf[h / 3];
    if (branch != HalfEdges::kNone && topology.branches[branch].from <= level &&
        level <= topology.branches[branch].to) {
      ++votes[branch];
    }
  }
  std::uint32_t best = HalfEdges::kNone;
  for (const auto& [branch, count] : votes) {
    if (best == HalfEdges::kNone || count > votes[best]) {
      best = branch;
    }
  }
  return best;
}

Lines linesOf(const TriangleMesh& mesh,
              const HalfEdges& halfEdges,
              const Vec3& up,
              const JobContext& context) {
  Lines lines;
  if (mesh.triangles.empty()) {
    throw Error(ErrorCode::InvalidArgument, "the surface has no triangles", "skeleton");
  }
  lines.ends = partEnds(mesh, halfEdges, up);
  lines.field = endToEndField(mesh, halfEdges, lines.ends, up);
  context.check();
  const auto [low, high] = rangeOf(lines.field);
  lines.topology = fieldTopology(mesh, halfEdges, lines.field, kBump * (high - low));
  lines.centres.resize(lines.topology.branches.size());
  std::vector<double> levels;
  for (int i = 0; i < kCurves; ++i) {
    levels.push_back(low + (high - low) * (i + 0.5) / kCurves);
  }
  if (!(low < high)) {
    return lines;
  }
  const auto curves = traceLevels(mesh, halfEdges, lines.field, levels, 0.0, context);
  for (std::size_t l = 0; l < levels.size(); ++l) {
    std::vector<Centre> centres(lines.centres.size());
    for (const LevelContour& contour : curves[l]) {
      const std::uint32_t branch = branchOf(lines.topology, contour, levels[l]);
      if (branch == HalfEdges::kNone) {
        continue;
      }
      // Of several curves in one branch (bumps that do not count) the longest is the wall.
      const Centre centre = centreOf(contour);
      if (centre.length > centres[branch].length) {
        centres[branch] = centre;
      }
    }
    for (std::size_t b = 0; b < centres.size(); ++b) {
      const FieldBranch& branch = lines.topology.branches[b];
      const double clear = kClear * (branch.to - branch.from);
      if (centres[b].length > 0.0 && levels[l] > branch.from + clear &&
          levels[l] < branch.to - clear) {
        lines.centres[b].push_back(centres[b].mean());
      }
    }
  }
  return lines;
}

/// The ends of branches that meet in one event: which branches begin there and which end.
struct Joint {
  std::vector<std::size_t> ending;
  std::vector<std::size_t> beginning;
};

/// Joints of all branches, and for each branch the joints at its lower and its upper end.
std::vector<Joint> jointsOf(const FieldTopology& topology,
                            std::vector<std::array<std::size_t, 2>>& ofBranch) {
  std::vector<Joint> joints;
  constexpr std::size_t kUnset = std::numeric_limits<std::size_t>::max();
  ofBranch.assign(topology.branches.size(), {kUnset, kUnset});
  for (std::size_t b = 0; b < topology.branches.size(); ++b) {
    if (ofBranch[b][0] == kUnset) {
      Joint joint;
      joint.ending = topology.branches[b].below;
      // Those that begin where the same ones end; without any below each begins on its own.
      joint.beginning = joint.ending.empty() ? std::vector<std::size_t>{b}
                                             : topology.branches[joint.ending.front()].above;
      for (const std::size_t other : joint.ending) {
        ofBranch[other][1] = joints.size();
      }
      for (const std::size_t other : joint.beginning) {
        ofBranch[other][0] = joints.size();
      }
      joints.push_back(std::move(joint));
    }
    if (ofBranch[b][1] == kUnset && topology.branches[b].above.empty()) {
      ofBranch[b][1] = joints.size();
      joints.push_back({{b}, {}});
    }
  }
  return joints;
}

/// Place of a joint: the border or the point at a free end, else the middle of the lines that meet.
Vec3 placeOf(const Joint& joint, const Lines& lines, const TriangleMesh& mesh) {
  const bool lower = joint.ending.empty();
  const std::size_t branch = lower ? joint.beginning.front() : joint.ending.front();
  if (joint.ending.size() + joint.beginning.size() == 1) {
    const auto& centres = lines.centres[branch];
    const auto& borders = lower ? lines.ends.lower : lines.ends.upper;
    if (!borders.empty() && !centres.empty()) {
      const Vec3& near = lower ? centres.front() : centres.back();
      Vec3 best = centreOf(mesh, borders.front());
      for (const auto& loop : borders) {
        const Vec3 centre = centreOf(mesh, loop);
        best = (centre - near).norm() < (best - near).norm() ? centre : best;
      }
      return best;
    }
    const FieldBranch& b = lines.topology.branches[branch];
    for (const TopologyEvent& event : lines.topology.events) {
      if (event.kind == (lower ? TopologyEvent::Kind::Begin : TopologyEvent::Kind::End) &&
          event.level == (lower ? b.from : b.to)) {
        return event.place;
      }
    }
  }
  Vec3 sum = Vec3::Zero();
  double count = 0.0;
  for (const std::size_t b : joint.ending) {
    if (!lines.centres[b].empty()) {
      sum += lines.centres[b].back();
      count += 1.0;
    }
  }
  for (const std::size_t b : joint.beginning) {
    if (!lines.centres[b].empty()) {
      sum += lines.centres[b].front();
      count += 1.0;
    }
  }
  return count > 0.0 ? Vec3(sum / count) : lines.topology.events.front().place;
}

}  // namespace

bool Skeleton::singleBranch() const {
  const auto ends = std::count(degree.begin(), degree.end(), std::size_t{1});
  const bool fork = std::any_of(degree.begin(), degree.end(), [](std::size_t d) { return d > 2; });
  return ends == 2 && !fork;
}

Skeleton skeletonOf(const TriangleMesh& mesh,
                    const HalfEdges& halfEdges,
                    const Vec3& up,
                    const JobContext& context) {
  const Lines lines = linesOf(mesh, halfEdges, up, context);
  std::vector<std::array<std::size_t, 2>> ofBranch;
  const std::vector<Joint> joints = jointsOf(lines.topology, ofBranch);
  Skeleton skeleton;
  for (const Joint& joint : joints) {
    skeleton.nodes.push_back(placeOf(joint, lines, mesh));
  }
  for (std::size_t b = 0; b < ofBranch.size(); ++b) {
    auto last = static_cast<std::uint32_t>(ofBranch[b][0]);
    for (const Vec3& centre : lines.centres[b]) {
      skeleton.edges.push_back({last, static_cast<std::uint32_t>(skeleton.nodes.size())});
      last = static_cast<std::uint32_t>(skeleton.nodes.size());
      skeleton.nodes.push_back(centre);
    }
    skeleton.edges.push_back({last, static_cast<std::uint32_t>(ofBranch[b][1])});
  }
  skeleton.degree.assign(skeleton.nodes.size(), 0);
  for (const auto& [a, b] : skeleton.edges) {
    ++skeleton.degree[a];
    ++skeleton.degree[b];
  }
  return skeleton;
}

std::shared_ptr<const GuideCurve> automaticGuide(const PartSurface& surface,
                                                 const Vec3& up,
                                                 const JobContext& context) {
  const Lines lines = linesOf(surface.mesh, surface.halfEdges, up, context);
  if (lines.topology.branches.size() != 1) {
    throw Error(ErrorCode::JobFailed,
                text("the part branches: its axis has %1 pieces",
                     {std::to_string(lines.topology.branches.size())}),
                "automatic guide", "draw a guide yourself, or slice the part as a branching one");
  }
  if (lines.ends.lower.size() != 1) {
    throw Error(ErrorCode::JobFailed,
                lines.ends.lower.empty() ? "the part has no lower border"
                                         : "the part has more than one lower border",
                "automatic guide", "use the faces of the wall as working surface");
  }
  std::vector<Vec3> points{centreOf(surface.mesh, lines.ends.lower.front())};
  points.insert(points.end(), lines.centres.front().begin(), lines.centres.front().end());
  const auto end = std::find_if(
      lines.topology.events.begin(), lines.topology.events.end(),
      [](const TopologyEvent& event) { return event.kind == TopologyEvent::Kind::End; });
  points.push_back(lines.ends.upper.empty() ? end->place
                                            : centreOf(surface.mesh, lines.ends.upper.front()));
  // Neighbours nearer than this part of the part's size would make the spline turn at will.
  constexpr double kNear = 1e-3;
  const double near = kNear * surface.mesh.bounds().diagonal();
  std::vector<Vec3> spaced;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool last = i + 1 == points.size();
    while (last && spaced.size() > 1 && (points[i] - spaced.back()).norm() < near) {
      spaced.pop_back();
    }
    if (spaced.empty() || last || (points[i] - spaced.back()).norm() >= near) {
      spaced.push_back(points[i]);
    }
  }
  if (spaced.size() < 2 || (spaced.back() - spaced.front()).norm() == 0.0) {
    throw Error(ErrorCode::JobFailed, "the part is too short for an axis", "automatic guide",
                "draw a guide yourself");
  }
  return guideFromPoints(std::move(spaced));
}

}  // namespace wcam::geometry
