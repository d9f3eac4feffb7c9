// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/cell/shapes.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"

#include "scenes.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace wcam::collision::test {
namespace {

using testing::HasSubstr;

Value cellFile() {
  return shippedCell("fanuc_arcmate120ic").source;
}

cell::Cell withTorch(const std::string& shapes, const std::filesystem::path& folder = {}) {
  Value file = cellFile();
  file.findMutable("torch")->set("collision", parseJson(shapes, "shapes"));
  return cell::cellFromValue(file, "cell test", JobContext(), folder);
}

std::string problemsOf(const std::string& shapes) {
  try {
    withTorch(shapes);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::ProjectInvalid);
    return error.what();
  }
  return {};
}

TEST(Shapes, everyKind) {
  const cell::Cell cell = withTorch(R"([
    {"name": "a", "type": "sphere", "centre": [1, 2, 3], "radius": 4},
    {"name": "b", "type": "capsule", "from": [0, 0, 10], "to": [0, 30, 10], "radius": 5, "frame": "J4"},
    {"name": "c", "type": "cylinder", "from": [0, 0, 10], "to": [0, 0, 50], "radius": 6, "ignore": ["table"]},
    {"name": "d", "type": "box", "size": [1, 2, 3], "pose": {"xyz": [7, 8, 9]}}])");
  const auto& shapes = cell.shapes.torch;
  ASSERT_EQ(shapes.size(), 6U);  // after the two of the neck
  EXPECT_EQ(shapes[2].frame, "tcp");
  EXPECT_EQ(shapes[2].T_frame_shape.translation(), Vec3(1, 2, 3));
  EXPECT_EQ(shapes[3].frame, "J4");
  EXPECT_EQ(shapes[3].length, 30.0);
  EXPECT_NEAR((shapes[3].T_frame_shape * Vec3(0, 0, 15) - Vec3(0, 30, 10)).norm(), 0.0, 1e-13);
  EXPECT_EQ(shapes[4].ignore, std::vector<std::string>{"table"});
  EXPECT_EQ(shapes[5].size, Vec3(1, 2, 3));
  EXPECT_EQ(shapes[5].T_frame_shape.translation(), Vec3(7, 8, 9));
}

TEST(Shapes, allProblemsAtOnceWithTheirPaths) {
  const std::string text = problemsOf(R"([
    {"name": "a", "type": "sphere", "centre": [1, 2, 3], "radius": 0},
    {"name": "b", "type": "capsule", "from": [0, 0, 10], "to": [0, 0, 10], "radius": -5},
    {"name": "c", "type": "cylinder", "from": [0, 0], "to": [0, 0, 50], "radius": 6, "frame": "J9"},
    {"name": "d", "type": "box", "size": [1, -2, 3]},
    {"name": "e", "type": "cone"},
    {"type": "sphere", "centre": [1, 2, 3], "radius": 1, "raduis": 2},
    {"name": "g", "type": "mesh", "file": "nowhere.stl"},
    "torch"])");
  for (const char* expected :
       {"torch.collision[0].radius: must be greater than 0",
        "torch.collision[1].radius: must be greater than 0",
        "torch.collision[2].frame: the cell has no frame 'J9'; it has world, base",
        "torch.collision[2].from: expected a list of 3 numbers",
        "torch.collision[3].size: must be greater than 0",
        "torch.collision[4].type: 'cone' is not one of", "torch.collision[5].name: is missing",
        "torch.collision[5].raduis: is not known here", "torch.collision[6].file: ", "nowhere.stl",
        "torch.collision[7]: expected an object", "cell test"}) {
    EXPECT_THAT(text, HasSubstr(expected));
  }
  EXPECT_THAT(problemsOf(R"({"radius": 22})"),
              HasSubstr("torch.collision: expected a list of shapes"));
  EXPECT_THAT(
      problemsOf(
          R"([{"name": "b", "type": "capsule", "from": [0, 0, 1], "to": [0, 0, 1], "radius": 5}])"),
      HasSubstr("from and to are the same point"));
}

TEST(Shapes, meshesAreReadBesideTheFile) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "wcam_shapes_test";
  createFolder(folder);
  writeFileAtomically(folder / "box.stl",
                      "solid t\n"
                      "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 10 0 0\n"
                      "vertex 0 10 0\nendloop\nendfacet\n"
                      "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 10 0\n"
                      "vertex 0 0 10\nendloop\nendfacet\n"
                      "endsolid t\n");
  const std::string shapes = R"([{"name": "m", "type": "mesh", "file": "box.stl"}])";
  const cell::Cell cell = withTorch(shapes, folder);
  ASSERT_EQ(cell.shapes.torch.size(), 3U);
  ASSERT_NE(cell.shapes.torch[2].mesh, nullptr);
  EXPECT_EQ(cell.shapes.torch[2].mesh->triangles.size(), 2U);
  const auto files = cell::shapeFiles(cell.source, folder);
  ASSERT_EQ(files.size(), 1U);
  EXPECT_EQ(files[0], folder / "box.stl");
}

}  // namespace
}  // namespace wcam::collision::test
