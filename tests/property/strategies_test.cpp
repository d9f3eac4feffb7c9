// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Every strategy on every real file: layers that hold, or a refusal with its reason.

#include "wcam/base/file_io.hpp"
#include "wcam/geometry/level_set.hpp"
#include "wcam/geometry/surface_projector.hpp"
#include "wcam/process/process.hpp"

#include "path_checks.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace wcam::test {
namespace {

using geometry::Vec3;

struct PartFile {
  std::string path;  ///< under tests/data
  std::string unit = "auto";
};

/// Of points on the surface, mm.
constexpr double kOnSurface = 1e-6;

/// Layers on a flat face pass through its vertices, which lie that far off its plane, mm.
double flatTolerance(const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts) {
  double tolerance = 0.0;
  for (const auto& part : parts) {
    tolerance = std::max(tolerance, part->exact() ? 0.0 : geometry::flatTolerance(part->mesh));
  }
  return tolerance;
}

const std::vector<PartFile>& partFiles() {
  static const std::vector<PartFile> files = {
      {"compas_slicer/branches_70_closed_low_res.stl"},
      {"compas_slicer/connection3legs_open_low_res.stl"},
      {"compas_slicer/distorted_a_closed_mid_res.stl"},
      {"compas_slicer/overhang_coin_closed_low_res.stl"},
      {"compas_slicer/vase_curved.obj", "mm"},
      {"compas_slicer/wavy_vase_open_low_res.stl"},
      {"five_axis_slicer/supportless_sample.stp"},
      {"ram/bridge.ply", "m"},
      {"ram/cone_truncated.ply", "m"},
      {"ram/dome.ply", "m"},
      {"ram/inclined_wall.stl", "m"},
      {"ram/inversed_pyramid.ply", "m"},
      {"step/bent_tube.step"},
      {"step/vase_rim.step"},
      {"step/y_branch.step"},
  };
  return files;
}

struct Strategy {
  std::string id;
  std::string params;  ///< STEP stands for the step
};

const std::vector<Strategy>& strategies() {
  static const std::vector<Strategy> list = {
      {"wcam.slicing.planar", R"({"step": STEP})"},
      {"wcam.slicing.guide", R"({"step": STEP, "automatic_guide": true})"},
      {"wcam.slicing.geodesic", R"({"step": STEP})"},
      {"wcam.slicing.isovalues", R"({"step": STEP})"},
      {"wcam.slicing.constant", R"({"step": STEP})"},
      {"wcam.slicing.isoparam", R"({"step": STEP})"},
      {"wcam.slicing.spiral", R"({"step": STEP, "infeasible": "report"})"},
      {"wcam.slicing.branches", R"({"step": STEP})"},
      {"wcam.slicing.bulk", R"({"step": STEP})"},
      {"wcam.slicing.radial", R"({"step": STEP})"},
      {"wcam.slicing.cladding", "{}"},
  };
  return list;
}

/// A part standing on the plate z = 0, with its size.
struct StandingPart {
  std::shared_ptr<const geometry::PartSurface> surface;
  double size = 0.0;
  double height = 0.0;
  /// How far the file's own edges lie beside its faces, mm: a point on an edge is no nearer.
  double gap = 0.0;
};

double gapOf(const geometry::PartSurface& part) {
  if (!part.exact()) {
    return 0.0;
  }
  constexpr int kSamples = 4;
  const geometry::BrepEvaluator evaluator(*part.brep);
  std::map<int, std::vector<Vec3>> pointsOf;  // of the edges around each face
  for (std::uint32_t h = 0; h < part.binding.edge.size(); ++h) {
    if (part.binding.edge[h] >= 0) {
      const auto& [begin, end] = part.binding.edgeParam[h];
      for (int i = 0; i <= kSamples; ++i) {
        pointsOf[part.binding.face[h / 3]].push_back(
            evaluator.curve(part.binding.edge[h], begin + (end - begin) * i / kSamples).p);
      }
    }
  }
  double gap = 0.0;
  for (const auto& [face, points] : pointsOf) {
    const geometry::PartSurface alone = geometry::selectFaces(part, {face});
    const auto feet = geometry::SurfaceProjector(alone).project(points);
    for (std::size_t i = 0; i < feet.size(); ++i) {
      gap = std::max(gap, (feet[i].p - points[i]).norm());
    }
  }
  return gap;
}

StandingPart loadPart(const PartFile& file) {
  static std::map<std::string, StandingPart> loaded;
  const auto known = loaded.find(file.path);
  if (known != loaded.end()) {
    return known->second;
  }
  io::ImportOptions options =
      io::importOptionsSchema().read(io::importOptionsSchema().params().complete(
          parseJson(R"({"unit": ")" + file.unit + R"("})")));
  const std::string path = std::string(WCAM_TEST_DATA) + "/" + file.path;
  auto surface = io::importPart(path, options, geometry::Pose::Identity(), JobContext()).surface;
  geometry::Pose pose = geometry::Pose::Identity();
  const geometry::Box bounds = surface->mesh.bounds();
  pose.translation() = -Vec3(0.5 * (bounds.min.x() + bounds.max.x()),
                             0.5 * (bounds.min.y() + bounds.max.y()), bounds.min.z());
  surface = io::importPart(path, options, pose, JobContext()).surface;
  const StandingPart part{surface, bounds.diagonal(), bounds.max.z() - bounds.min.z(),
                          gapOf(*surface)};
  return loaded.emplace(file.path, part).first->second;
}

std::string firstOf(const std::vector<std::string>& lines) {
  return std::to_string(lines.size()) + " times, first: " + (lines.empty() ? "" : lines.front());
}

class EveryStrategy : public ::testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

TEST_P(EveryStrategy, GivesSoundLayersOrTheReason) {
  const PartFile& file = partFiles()[std::get<0>(GetParam())];
  const Strategy& strategy = strategies()[std::get<1>(GetParam())];
  const StandingPart part = loadPart(file);
  // Some twenty layers on any size of part.
  const double step = std::max(part.height, 0.1 * part.size) / 20.0;
  std::string params = strategy.params;
  const auto at = params.find("STEP");
  if (at != std::string::npos) {
    params.replace(at, 4, std::to_string(step));
  }
  plugin::SliceInput input{{part.surface}, plate(), nullptr, {0.01 * step, 2.0 * step}};
  input.bead = {0.7 * step, 1.3 * step, 3.0 * step};
  const JobContext context;
  toolpath::SlicedLayers sliced;
  try {
    sliced = slice(strategy.id, input, params, context);
  } catch (const Error& error) {
    EXPECT_FALSE(error.message().empty());
    EXPECT_FALSE(error.hint().empty()) << "a refusal without a remedy: " << error.what();
    EXPECT_NE(error.code(), ErrorCode::Internal) << error.what();
    RecordProperty("refused", error.message());
    return;
  }
  const auto broken = brokenContours(sliced, input.sampling);
  EXPECT_TRUE(broken.empty()) << firstOf(broken);
  const auto off =
      pointsOffSurface(sliced, input.parts, kOnSurface + part.gap + flatTolerance(input.parts));
  EXPECT_TRUE(off.empty()) << firstOf(off);
  const auto inside = pointsInSubstrate(sliced, *input.substrate, 1e-6 * part.size);
  EXPECT_TRUE(inside.empty()) << firstOf(inside);
  const auto crossing = crossingBeads(sliced);
  EXPECT_TRUE(crossing.empty()) << firstOf(crossing);
  // δ inside the process's range, or a finding that says where not.
  toolpath::PathParams pathParams;
  pathParams.chordError = Length(input.sampling.chordError);
  pathParams.maxSpacing = Length(input.sampling.maxSpacing);
  process::ProcessParams process;
  process.heightMin = Length(input.bead.heightMin);
  process.heightMax = Length(input.bead.heightMax);
  process.beadWidth = Length(input.bead.width);
  const toolpath::Toolpath path = process::applyProcess(
      toolpath::buildToolpath(sliced, *input.substrate, pathParams, context), process, context);
  bool outside = false;
  for (const toolpath::Layer& layer : path.layers) {
    for (const toolpath::Bead& bead : layer.beads) {
      for (const toolpath::PathPoint& point : bead.points) {
        ASSERT_TRUE(point.p.allFinite() && point.axis.allFinite() && point.t.allFinite());
        ASSERT_TRUE(std::isfinite(point.height) && point.height > 0.0);
        ASSERT_NEAR(point.axis.norm(), 1.0, 1e-9);
        outside = outside || point.height < input.bead.heightMin * (1.0 - 1e-9) ||
                  point.height > input.bead.heightMax * (1.0 + 1e-9);
      }
    }
  }
  if (outside) {
    const auto findings = context.diagnostics().items();
    EXPECT_TRUE(std::any_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
      return finding.code == "process.height_out_of_range";
    })) << "heights outside of the range without a finding";
  }
}

std::string nameOf(const ::testing::TestParamInfo<std::tuple<std::size_t, std::size_t>>& info) {
  std::string name = partFiles()[std::get<0>(info.param)].path + "_" +
                     strategies()[std::get<1>(info.param)].id.substr(13);
  for (char& c : name) {
    c = std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Matrix,
                         EveryStrategy,
                         ::testing::Combine(::testing::Range<std::size_t>(0, partFiles().size()),
                                            ::testing::Range<std::size_t>(0, strategies().size())),
                         nameOf);

}  // namespace
}  // namespace wcam::test
