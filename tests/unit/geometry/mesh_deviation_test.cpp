// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/geometry/mesh_deviation.hpp"

#include "wcam/base/quantity.hpp"

#include "sample_meshes.hpp"
#include <gtest/gtest.h>

#include <cmath>

namespace wcam::geometry {
namespace {

PartSurface surfaceOf(TriangleMesh mesh) {
  PartSurface part;
  part.mesh = std::move(mesh);
  part.halfEdges = HalfEdges(part.mesh);
  return part;
}

TEST(MeshDeviation, IsTheSagittaOfTheFacetsOfACylinder) {
  for (const int around : {24, 60, 180}) {
    const double sagitta = 40.0 * (1.0 - std::cos(kPi / around));
    EXPECT_NEAR(meshDeviation(surfaceOf(test::tubeMesh(40.0, 100.0, around, 7))), sagitta,
                0.02 * sagitta)
        << around;
  }
}

TEST(MeshDeviation, FlatFacesAndSharpEdgesAreShape) {
  EXPECT_EQ(meshDeviation(surfaceOf(test::boxMesh({0, 0, 0}, {10, 20, 30}))), 0.0);
}

}  // namespace
}  // namespace wcam::geometry
