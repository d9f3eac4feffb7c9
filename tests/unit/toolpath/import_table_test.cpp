// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/toolpath/import_table.hpp"

#include "hand_made_layers.hpp"
#include "slicing_fixture.hpp"
#include <gtest/gtest.h>

namespace wcam::toolpath {
namespace {

constexpr const char* kPlain =
    "layer,bead,x_mm,y_mm,z_mm\n"
    "0,0,0,0,2\n0,0,10,0,2\n0,0,10,10,2\n"
    "\n# a remark\n"
    "0,1,20,0,2\r\n0,1,30,0,2\r\n"
    "2,0,0,0,4\n2,0,10,0,4\n2,0,10,10,4\n2,0,0,0,4\n";

TEST(ImportTable, LayersBeadsAndClosedBeads) {
  const ImportedPath path = readPathTable(kPlain, "p.csv");
  ASSERT_EQ(path.layers.size(), 2U);
  ASSERT_EQ(path.layers[0].size(), 2U);
  EXPECT_FALSE(path.layers[0][0].closed);
  EXPECT_EQ(path.layers[0][0].points.size(), 3U);
  EXPECT_EQ(path.layers[0][1].points[1].p, Vec3(30, 0, 2));
  EXPECT_TRUE(path.layers[1][0].closed);
  EXPECT_EQ(path.layers[1][0].points.size(), 3U);
  EXPECT_EQ(path.layers[1][0].feature, BeadFeature::Imported);
  EXPECT_FALSE(path.hasNormals || path.hasAxes);
}

TEST(ImportTable, MovesWithTheArcOffAreLeftOutAndPartABead) {
  const ImportedPath path = readPathTable(
      "layer,bead,x_mm,y_mm,z_mm,arc,height_mm,width_mm,speed_mm_s\n"
      "0,0,-5,0,2,0,1.5,8,3\n0,0,0,0,2,0,1.5,8,3\n0,0,5,0,2,1,1.5,8,3\n0,0,9,0,2,1,1.6,7,3\n"
      "0,0,20,0,2,0,1.5,8,3\n0,0,25,0,2,1,1.5,8,3\n0,0,24,0,4,0,1.5,8,3\n",
      "p.csv");
  ASSERT_EQ(path.layers[0].size(), 2U);
  ASSERT_EQ(path.layers[0][0].points.size(), 3U);
  EXPECT_EQ(path.layers[0][0].points[0].p, Vec3(0, 0, 2));
  EXPECT_EQ(path.layers[0][0].points[2].height, 1.6);
  EXPECT_EQ(path.layers[0][0].points[2].width, 7.0);
  EXPECT_EQ(path.layers[0][1].points[0].p, Vec3(20, 0, 2));
}

TEST(ImportTable, NormalsFollowFromTheBuildDirection) {
  const ImportedPath path = readPathTable(
      "layer,bead,x_mm,y_mm,z_mm,bx,by,bz,ax,ay,az\n"
      "0,0,0,0,2,0,0,1,0,0.6,0.8\n0,0,10,0,2,0,0,2,0,6,8\n",
      "p.csv");
  EXPECT_TRUE(path.hasNormals && path.hasAxes);
  EXPECT_NEAR((path.layers[0][0].points[0].n - Vec3::UnitY()).norm(), 0.0, 1e-12);
  EXPECT_NEAR((path.layers[0][0].points[1].axis - Vec3(0, 0.6, 0.8)).norm(), 0.0, 1e-12);
}

void expectRefused(const std::string& text, const std::string& part, const std::string& place) {
  try {
    (void)readPathTable(text, "p.csv");
    FAIL() << "accepted: " << text;
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_NE(error.message().find(part), std::string::npos) << error.what();
    EXPECT_EQ(error.context(), place) << error.what();
    EXPECT_FALSE(error.hint().empty());
  }
}

TEST(ImportTable, BadInputNamesLineAndRemedy) {
  const std::string head = "layer,bead,x_mm,y_mm,z_mm\n";
  expectRefused("", "empty", "p.csv");
  expectRefused("hello\n1\n", "no column layer", "p.csv, line 1");
  expectRefused("layer,bead,x_mm,y_mm\n", "no column z_mm", "p.csv, line 1");
  expectRefused("layer,bead,x_in,y_in,z_in\n", "'x_in' is not in mm", "p.csv, line 1");
  expectRefused("layer,bead,x,y,z\n", "'x' is not in mm", "p.csv, line 1");
  expectRefused("layer,bead,x_mm,y_mm,z_mm,height_in\n", "'height_in' is not in mm",
                "p.csv, line 1");
  expectRefused("layer,bead,x_mm,y_mm,z_mm,x_mm\n", "twice", "p.csv, line 1");
  expectRefused("layer,bead,x_mm,y_mm,z_mm,nx,ny\n", "only a part", "p.csv, line 1");
  expectRefused(head, "no bead", "p.csv, line 1");
  expectRefused(head + "0,0,1,2,3\n", "no bead", "p.csv, line 2");
  expectRefused(head + "0,0,1,2\n", "4 cells", "p.csv, line 2");
  expectRefused(head + "0,0,1,2,3\n0,0,nan,2,3\n", "'nan'", "p.csv, line 3");
  expectRefused(head + "0,0,1,2,inf\n", "'inf'", "p.csv, line 2");
  expectRefused(head + "0,0,1,2,3mm\n", "'3mm'", "p.csv, line 2");
  expectRefused(head + "0,0,1,2,1e300\n", "1e300", "p.csv, line 2");
  expectRefused(head + "0.5,0,1,2,3\n", "whole number", "p.csv, line 2");
  expectRefused(head + "-1,0,1,2,3\n", "whole number", "p.csv, line 2");
  expectRefused(head + "1,0,1,2,3\n1,0,2,2,3\n0,0,1,2,3\n", "follows layer 1", "p.csv, line 4");
  expectRefused(head + "0,1,1,2,3\n0,0,1,2,3\n", "follows layer 0, bead 1", "p.csv, line 3");
  expectRefused("op," + head + "a,0,0,1,2,3\nb,0,0,1,2,3\n", "second operation", "p.csv, line 3");
  expectRefused("layer,bead,x_mm,y_mm,z_mm,ax,ay,az\n0,0,1,2,3,0,0,0\n", "no length",
                "p.csv, line 2");
  expectRefused("layer,bead,x_mm,y_mm,z_mm,height_mm\n0,0,1,2,3,-1\n", "negative", "p.csv, line 2");
}

plugin::SliceInput inputOf(const std::string& text) {
  plugin::SliceInput input{{}, test::plate(), nullptr, {}};
  input.imported = std::make_shared<const ImportedPath>(readPathTable(text, "p.csv"));
  return input;
}

TEST(ImportStrategy, KeepsOrderAndMakesAxes) {
  const SlicedLayers kept = test::slice("wcam.slicing.import", inputOf(kPlain), "{}");
  EXPECT_TRUE(kept.asGiven);
  EXPECT_FALSE(kept.curved);
  const Toolpath path = buildToolpath(kept, *test::plate(), PathParams{}, JobContext());
  EXPECT_EQ(path.layers[0].beads[1].points[0].p, Vec3(20, 0, 2));
  EXPECT_EQ(path.layers[1].beads[0].points[2].axis, Vec3::UnitZ());
  EXPECT_FALSE(
      test::slice("wcam.slicing.import", inputOf(kPlain), R"({"keep_order": false})").asGiven);
  plugin::SliceInput none{{}, test::plate(), nullptr, {}};
  EXPECT_THROW((void)test::slice("wcam.slicing.import", none, "{}"), Error);
}

}  // namespace
}  // namespace wcam::toolpath
