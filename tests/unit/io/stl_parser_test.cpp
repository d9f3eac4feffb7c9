// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "stl_parser.hpp"

#include "wcam/base/error.hpp"

#include "io_files.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace wcam::io {
namespace {

using geometry::TriangleMesh;
using geometry::Vec3;
using testing::HasSubstr;

ParsedMesh parse(const std::string& bytes) {
  return parseStl(bytes, "part.stl", JobContext());
}

std::string messageOf(const std::string& bytes) {
  try {
    parse(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_THAT(error.what(), HasSubstr("part.stl"));
    return error.what();
  }
  ADD_FAILURE() << "no error";
  return {};
}

const char* const kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\n"
    "endfacet\n";

TEST(StlParser, BinaryTorusIsWelded) {
  const TriangleMesh torus = test::torusMesh(60, 40, 50, 15);
  const ParsedMesh parsed = parse(test::binaryStl(torus));
  EXPECT_EQ(parsed.mesh.vertices.size(), torus.vertices.size());
  EXPECT_EQ(parsed.mesh.triangles.size(), torus.triangles.size());
  EXPECT_EQ(parsed.weldedPoints, 3 * torus.triangles.size() - torus.vertices.size());
  EXPECT_TRUE(geometry::HalfEdges(parsed.mesh).closed());
  EXPECT_NEAR(test::signedVolume(parsed.mesh) / test::signedVolume(torus), 1.0, 1e-6);
}

TEST(StlParser, OrderOfTrianglesInTheFileDoesNotMatterForTheSurface) {
  TriangleMesh torus = test::torusMesh(30, 20, 50, 15);
  const ParsedMesh first = parse(test::binaryStl(torus));
  const unsigned seed = 7;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::shuffle(torus.triangles.begin(), torus.triangles.end(), random);
  const ParsedMesh second = parse(test::binaryStl(torus));
  EXPECT_EQ(first.mesh.vertices.size(), second.mesh.vertices.size());
  EXPECT_NEAR(test::signedVolume(first.mesh), test::signedVolume(second.mesh), 1e-6);
}

TEST(StlParser, TrianglesAreSortedByTheirLowestVertex) {
  const ParsedMesh parsed = parse(test::binaryStl(test::torusMesh(60, 40, 50, 15)));
  std::uint32_t last = 0;
  for (const auto& t : parsed.mesh.triangles) {
    const std::uint32_t lowest = std::min({t[0], t[1], t[2]});
    EXPECT_GE(lowest, last);
    last = lowest;
  }
}

TEST(StlParser, NegativeZeroIsZero) {
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(-0.0, -0.0, 0.0)};
  mesh.triangles = {{0, 1, 2}, {3, 2, 1}};
  EXPECT_EQ(parse(test::binaryStl(mesh)).mesh.vertices.size(), 3U);
}

TEST(StlParser, BinaryFileMayStartWithSolid) {
  std::string bytes = test::binaryStl(test::torusMesh(10, 10, 50, 15));
  bytes.replace(0, 17, "solid facet loop ");
  EXPECT_EQ(parse(bytes).mesh.triangles.size(), 200U);
  EXPECT_TRUE(looksLikeStl(bytes));
}

TEST(StlParser, AsciiIsTolerant) {
  const std::string facet = kFacet;
  const ParsedMesh plain = parse("solid wall\n" + facet + "endsolid wall\n");
  EXPECT_EQ(plain.name, "wall");
  EXPECT_FALSE(plain.endMissing);
  EXPECT_EQ(plain.mesh.triangles.size(), 1U);

  std::string windows = "  SOLID\r\n" + facet + "ENDSOLID\r\nsolid b\r\n" + facet + "endsolid b";
  EXPECT_EQ(parse(windows).mesh.triangles.size(), 2U);
  EXPECT_EQ(parse(windows).mesh.vertices.size(), 3U);

  const ParsedMesh nanNormal = parse(
      "solid\nFACET NORMAL nan nan nan\nOUTER LOOP\nVERTEX +1.5E+00 0 0\nVERTEX 1e-400 .5 0\n"
      "VERTEX 0 0 -1\nENDLOOP\nENDFACET\nendsolid\n");
  EXPECT_EQ(nanNormal.mesh.triangles.size(), 1U);

  EXPECT_TRUE(parse("solid\n" + facet).endMissing);
}

TEST(StlParser, AsciiErrorsNameTheLine) {
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n"),
              HasSubstr("line 4: 'x' is not a number"));
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1,5\n"),
              HasSubstr("line 4"));
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1\n"),
              HasSubstr("ends inside facet 0"));
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 1\nouter loop\nendloop\nendfacet\nendsolid\n"),
              HasSubstr("0 vertices instead of three"));
  EXPECT_THAT(messageOf("solid\nfacet\nvertex 0 0 0 vertex 1 0 0 vertex 0 1 0 vertex 1 1 0\n"),
              HasSubstr("more than three"));
  EXPECT_THAT(messageOf("solid\n" + std::string(kFacet) + "\x01\xff rubbish"),
              HasSubstr("'?\?' is not part of an STL file"));
}

TEST(StlParser, NotFiniteCoordinatesNameTheTriangle) {
  TriangleMesh torus = test::torusMesh(10, 10, 50, 15);
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    TriangleMesh mesh = torus;
    mesh.vertices.push_back(Vec3(0, bad, 0));
    mesh.triangles[123][1] = static_cast<std::uint32_t>(mesh.vertices.size() - 1);
    EXPECT_THAT(messageOf(test::binaryStl(mesh)), HasSubstr("triangle 123 "));
  }
  EXPECT_THAT(messageOf("solid\n" + std::string(kFacet) +
                        "facet normal 0 0 1\nouter loop\nvertex 0 inf 0\n"),
              HasSubstr("triangle 1 "));
  EXPECT_THAT(messageOf("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 1e999 0\n"),
              HasSubstr("triangle 0 "));
}

TEST(StlParser, LyingTriangleCountIsRefusedBeforeAllocating) {
  const TriangleMesh torus = test::torusMesh(10, 10, 50, 15);
  EXPECT_THAT(messageOf(test::binaryStl(torus, 4294967295)), HasSubstr("4294967295 triangles"));
  EXPECT_THAT(messageOf(test::binaryStl(torus, 201)), HasSubstr("has only 10084 bytes"));
  const ParsedMesh fewer = parse(test::binaryStl(torus, 199));
  EXPECT_EQ(fewer.mesh.triangles.size(), 199U);
  EXPECT_EQ(fewer.trailingBytes, 50U);
}

TEST(StlParser, CutOffFilesAreRefused) {
  const std::string bytes = test::binaryStl(test::torusMesh(10, 10, 50, 15));
  for (const std::size_t size : {1U, 5U, 79U, 83U, 84U, 85U, 133U, 5000U, 10083U}) {
    messageOf(bytes.substr(0, size));
  }
}

TEST(StlParser, RandomBytesNeverCrash) {
  const unsigned seed = 20260722;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int run = 0; run < 2000; ++run) {
    std::string bytes(random() % 600, '\0');
    for (char& c : bytes) {
      c = static_cast<char>(random());
    }
    if (run % 2 == 0) {
      bytes = "solid x\nfacet " + bytes;
    } else if (bytes.size() > 84) {
      bytes.resize(84 + (bytes.size() - 84) / 50 * 50);
      const auto count = static_cast<std::uint32_t>((bytes.size() - 84) / 50);
      std::memcpy(bytes.data() + 80, &count, 4);
    }
    try {
      const ParsedMesh parsed = parse(bytes);
      for (const Vec3& p : parsed.mesh.vertices) {
        EXPECT_TRUE(p.allFinite());
      }
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    }
  }
}

TEST(StlParser, HugeCoordinatesKeepTheirOrder) {
  TriangleMesh mesh;
  const double m = std::numeric_limits<float>::max();
  mesh.vertices = {Vec3(-m, -m, -m), Vec3(m, m, m), Vec3(m, 0, -m)};
  mesh.triangles = {{0, 1, 2}};
  EXPECT_EQ(parse(test::binaryStl(mesh)).mesh.vertices.size(), 3U);
}

TEST(StlParser, CancelIsAnswered) {
  std::stop_source stop;
  stop.request_stop();
  const std::string bytes = test::binaryStl(test::torusMesh(10, 10, 50, 15));
  EXPECT_THROW(parseStl(bytes, "part.stl", JobContext(stop.get_token())), CancelledError);
}

}  // namespace
}  // namespace wcam::io
