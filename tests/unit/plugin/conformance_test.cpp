// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/guide_curve.hpp"
#include "wcam/testing/plugin_conformance.hpp"

#include "error_matchers.hpp"
#include "sample_meshes.hpp"
#include <gtest/gtest.h>

using namespace wcam;
using namespace wcam::plugin;
using ::testing::HasSubstr;
using wcam::testing::errorOf;

namespace {

SliceInput torusOnPlate() {
  auto part = std::make_shared<geometry::PartSurface>();
  part->mesh = test::torusMesh(50.0, 15.0, 48, 96);
  part->halfEdges = geometry::HalfEdges(part->mesh);
  geometry::Pose T_part_substrate = geometry::Pose::Identity();
  T_part_substrate.translation().z() = -15.0;
  SliceInput input;
  input.parts.push_back(part);
  input.substrate =
      std::make_shared<toolpath::Substrate>(T_part_substrate, geometry::Vec3(200, 200, 10));
  input.guide = geometry::guideFromPoints({{0, 0, -15}, {5, 0, 0}, {0, 0, 15}});
  return input;
}

const PluginHost& builtIn() {
  static const PluginHost kHost(defaultPluginSearch({}, false));
  return kHost;
}

std::string verdict(const std::string& id) {
  const PluginHost host({{std::string(WCAM_PROBES) + "/org.wcam.probe.misbehaving.so"}, {}});
  return errorOf(ErrorCode::CheckFailed, [&] { wcam::testing::checkPost(*host.findPost(id)); });
}

}  // namespace

TEST(Conformance, BuiltInPostsPass) {
  for (const char* id : {"wcam.post.fanuc", "wcam.post.kuka", "example.post.csv"}) {
    EXPECT_NO_THROW(wcam::testing::checkPost(*builtIn().findPost(id))) << id;
  }
}

TEST(Conformance, BuiltInStrategiesPass) {
  for (const char* id : {"wcam.slicing.planar", "wcam.slicing.guide"}) {
    EXPECT_NO_THROW(wcam::testing::checkSlicing(*builtIn().findSlicing(id), torusOnPlate())) << id;
  }
}

TEST(Conformance, FindsBrokenRules) {
  EXPECT_THAT(verdict("probe.repetition"), HasSubstr("a second run gives another result"));
  EXPECT_THAT(verdict("probe.slow_cancel"), HasSubstr("must throw CancelledError"));
}
