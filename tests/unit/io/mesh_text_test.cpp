// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// Text meshes written in all the ways that writers have: the surface stays the same.
#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"

#include "file_format.hpp"
#include "foreign_format.hpp"
#include "io_files.hpp"
#include "mesh_readers.hpp"
#include "random_source.hpp"
#include "stl_parser.hpp"
#include "text_scanner.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace wcam::io {
namespace {

using geometry::TriangleMesh;
using geometry::Vec3;
using ::testing::HasSubstr;
using wcam::testing::RandomSource;
using wcam::testing::testSeeds;

const Vec3 kSize(20, 30, 40);

TriangleMesh box() {
  return test::boxMesh(Vec3(0, 0, 0), kSize);
}

void expectBox(const TriangleMesh& mesh, const std::string& bytes) {
  EXPECT_EQ(mesh.triangles.size(), 12U) << bytes;
  EXPECT_EQ(mesh.vertices.size(), 8U) << bytes;
  EXPECT_TRUE(geometry::HalfEdges(mesh).closed()) << bytes;
  EXPECT_NEAR(test::signedVolume(mesh), 24000.0, 1e-9) << bytes;
}

/// Writes words with random blanks, line ends, comments and capitals.
class Writer {
public:
  explicit Writer(RandomSource& random)
      : random_(random),
        lineEnd_(random.pick(std::vector<std::string>{"\n", "\r\n", "\r"})),
        mark_(random.chance(0.3)),
        utf16_(random.chance(0.2)) {}

  void word(const std::string& text) {
    text_ += (atStart_ ? "" : blank()) + text, atStart_ = false;
  }

  void number(double x) {
    switch (random_.below(5)) {
      case 0:
        word("+" + formatReal(x));
        return;
      case 1:
        word(formatReal(x / 10.0) + "E+01");
        return;
      case 2:
        word(formatReal(x * 10.0) + "D-01");
        return;
      case 3:
        word(std::to_string(static_cast<int>(x)));
        return;
      default:
        word(formatReal(x));
    }
  }

  void endLine() {
    text_ += random_.chance(0.2) ? " \t" : "";
    for (std::size_t n = 1 + random_.below(2); n-- > 0;) {
      text_ += lineEnd_;
    }
    atStart_ = true;
  }

  /// With a byte order mark or in UTF-16, and filled up at the end.
  std::string finish(bool fill) {
    if (fill && random_.chance(0.3)) {
      text_ += random_.chance(0.5) ? std::string("\x1a") : std::string(random_.below(600), '\0');
    }
    if (utf16_) {
      std::string wide = "\xFF\xFE";
      for (const char c : text_) {
        wide += c;
        wide += '\0';
      }
      return wide;
    }
    return (mark_ ? "\xEF\xBB\xBF" : "") + text_;
  }

  [[nodiscard]] const std::string& lineEnd() const { return lineEnd_; }

private:
  std::string blank() { return random_.pick(std::vector<std::string>{" ", "  ", "\t", " \t "}); }

  RandomSource& random_;
  std::string lineEnd_;
  bool mark_;
  bool utf16_;
  bool atStart_ = true;
  std::string text_;
};

std::string cased(RandomSource& random, std::string word) {
  if (random.chance(0.3)) {
    for (char& c : word) {
      c = static_cast<char>(c >= 'a' && c <= 'z' ? c - 32 : c);
    }
  }
  return word;
}

std::string randomStl(RandomSource& random) {
  Writer out(random);
  const bool oneLine = random.chance(0.2);
  const auto endLine = [&] {
    if (!oneLine && random.chance(0.9)) {
      out.endLine();
    }
  };
  const auto aside = [&] {
    if (!oneLine && random.chance(0.1)) {
      out.endLine();
      out.word(random.pick(std::vector<std::string>{"# facets of the box", "// endsolid", "; x"}));
      out.endLine();
    } else if (random.chance(0.1)) {
      out.word("color 0.5 0.5 0.9");
      endLine();
    }
  };
  const auto closing = [&](const std::string& what) {
    out.word(cased(random, random.chance(0.3) ? "end " + what : "end" + what));
  };
  if (random.chance(0.2)) {
    out.word("# made by hand");
    out.endLine();
  }
  out.word(cased(random, "solid"));
  out.word(random.pick(std::vector<std::string>{"", "box", "a facet of mine"}));
  endLine();
  const TriangleMesh mesh = box();
  for (const auto& t : mesh.triangles) {
    aside();
    out.word(cased(random, "facet"));
    out.word(cased(random, "normal"));
    const std::vector<std::string> normals{"0 0 0", "nan nan nan", "-1.#IND 0 0", "0 0"};
    out.word(random.pick(normals));
    endLine();
    aside();
    out.word(cased(random, "outer loop"));
    endLine();
    for (const std::uint32_t v : t) {
      out.word(cased(random, "vertex"));
      for (int k = 0; k < 3; ++k) {
        out.number(mesh.vertices[v][k]);
      }
      endLine();
    }
    closing("loop");
    endLine();
    closing("facet");
    endLine();
  }
  closing("solid");
  return out.finish(true);
}

TEST(MeshText, StlInEveryDress) {
  for (const std::uint64_t seed : testSeeds(300)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    const std::string bytes = randomStl(random);
    EXPECT_TRUE(looksLikeStl(bytes)) << bytes;
    EXPECT_EQ(detectFormat("part.stl", bytes), FileFormat::Stl);
    expectBox(parseStl(bytes, "part.stl", JobContext()).mesh, bytes);
    if (::testing::Test::HasFailure()) {
      return;
    }
  }
}

/// Polygons or triangles, before, after or among the vertices.
std::string randomObj(RandomSource& random) {
  Writer out(random);
  const TriangleMesh mesh = box();
  const bool facesFirst = random.chance(0.3);
  const auto wordOrContinuation = [&](const std::string& text) {
    if (random.chance(0.1)) {
      out.word(text + "\\" + out.lineEnd());
    } else if (random.chance(0.1)) {
      out.word(text + " \\ " + out.lineEnd());
    } else {
      out.word(text);
    }
  };
  const auto vertices = [&] {
    for (const Vec3& p : mesh.vertices) {
      out.word("v");
      for (int k = 0; k < 3; ++k) {
        out.number(p[k]);
      }
      out.word(random.pick(std::vector<std::string>{"", "1.0", "0.5 0.5 0.9"}));
      out.endLine();
    }
  };
  const auto faces = [&] {
    for (const auto& t : mesh.triangles) {
      out.word("f");
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t v = t[c];
        const std::string relative = std::to_string(static_cast<int>(v) - 8);
        const std::string index =
            facesFirst || random.chance(0.5) ? std::to_string(v + 1) : relative;
        const std::string corner =
            index + random.pick(std::vector<std::string>{"", "/1", "//1", "/1/1"});
        if (c < 2) {
          wordOrContinuation(corner);
        } else {
          out.word(corner);
        }
      }
      out.word(random.pick(std::vector<std::string>{"", "# a face", "#\\"}));
      out.endLine();
    }
  };
  out.word(random.pick(std::vector<std::string>{"# box", "mtllib a.mtl", "o body", "vp 0 0",
                                                "curv2 1 2", "vn 0 0 -1.#IND", "s off"}));
  out.endLine();
  if (facesFirst) {
    faces();
    vertices();
  } else {
    vertices();
    faces();
  }
  return out.finish(true);
}

TEST(MeshText, ObjInEveryDress) {
  for (const std::uint64_t seed : testSeeds(300)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    const std::string bytes = randomObj(random);
    expectBox(parseObj(bytes, "part.obj", JobContext()).mesh, bytes);
    if (::testing::Test::HasFailure()) {
      return;
    }
  }
}

/// A strip with every triangle of the box, restarted for each.
std::vector<int> strip(const TriangleMesh& mesh) {
  std::vector<int> list;
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      list.push_back(static_cast<int>(v));
    }
    list.push_back(-1);
  }
  return list;
}

std::string randomPly(RandomSource& random) {
  Writer out(random);
  const TriangleMesh mesh = box();
  const bool facesFirst = random.chance(0.4);
  const bool strips = random.chance(0.3);
  const bool normals = random.chance(0.5);
  const auto line = [&](const std::string& text) {
    out.word(text);
    out.endLine();
  };
  const std::string capital = random.chance(0.2) ? "XYZ" : "xyz";
  line("ply");
  line("format ascii 1.0");
  line("comment made by hand");
  const auto vertexHeader = [&] {
    line("element vertex 8");
    if (normals) {
      line("property float nx");
    }
    for (const char axis : capital) {
      line(std::string("property double ") + axis);
    }
    line("property uchar red");
  };
  const auto faceHeader = [&] {
    line(strips ? "element tristrips 1" : "element face 12");
    line("property list uchar int " +
         random.pick(std::vector<std::string>{"vertex_indices", "vertex_index", "vertices"}));
  };
  if (facesFirst) {
    faceHeader();
    vertexHeader();
  } else {
    vertexHeader();
    faceHeader();
  }
  line("obj_info none");
  line("end_header");
  const auto vertices = [&] {
    for (const Vec3& p : mesh.vertices) {
      if (normals) {
        out.word(random.pick(std::vector<std::string>{"-1.#IND", "nan", "0.5", "1.#QNAN"}));
      }
      for (int k = 0; k < 3; ++k) {
        out.number(p[k]);
      }
      out.word("200");
      out.endLine();
    }
  };
  const auto faces = [&] {
    if (strips) {
      const std::vector<int> list = strip(mesh);
      out.word(std::to_string(list.size()));
      for (const int v : list) {
        out.word(std::to_string(v));
      }
      out.endLine();
      return;
    }
    for (const auto& t : mesh.triangles) {
      out.word("3");
      for (const std::uint32_t v : t) {
        out.word(std::to_string(v));
      }
      out.endLine();
    }
  };
  if (facesFirst) {
    faces();
    vertices();
  } else {
    vertices();
    faces();
  }
  return out.finish(true);
}

TEST(MeshText, PlyInEveryDress) {
  for (const std::uint64_t seed : testSeeds(300)) {
    SCOPED_TRACE(seed);
    RandomSource random(seed);
    const std::string bytes = randomPly(random);
    EXPECT_EQ(detectFormat("part.ply", bytes), FileFormat::Ply) << bytes;
    expectBox(parsePly(bytes, "part.ply", JobContext()).mesh, bytes);
    if (::testing::Test::HasFailure()) {
      return;
    }
  }
}

TEST(MeshText, PlyStripsAlternateAndLeadOn) {
  // A ribbon of three triangles in one strip, with a corner doubled to lead on.
  const std::string bytes =
      "ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
      "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n7 1 0 3 2 5 5 4\n";
  const TriangleMesh mesh = parsePly(bytes, "part.ply", JobContext()).mesh;
  ASSERT_EQ(mesh.triangles.size(), 3U);
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_GT(mesh.normal(t).z(), 0.0) << t;
  }
}

TEST(MeshText, PlyHeaderOfReturnsAloneKeepsBinaryData) {
  // The first coordinate begins with the byte of a line feed.
  std::string bytes =
      "ply\rformat binary_little_endian 1.0\relement vertex 3\rproperty float x\rproperty float y\r"
      "property float z\relement face 1\rproperty list uchar int vertex_indices\rend_header\r";
  const float tiny = std::ldexp(static_cast<float>(0x00800A0A), -23);
  std::array<float, 9> xyz{tiny, 0, 0, 10, 0, 0, 0, 10, 0};
  std::uint32_t bits = 0;
  std::memcpy(&bits, &xyz[0], 4);
  ASSERT_EQ(bits & 0xFFU, 0x0AU);
  bytes.append(reinterpret_cast<const char*>(xyz.data()), sizeof(xyz));
  bytes.push_back('\3');
  const std::array<std::int32_t, 3> corners{0, 1, 2};
  bytes.append(reinterpret_cast<const char*>(corners.data()), sizeof(corners));
  EXPECT_EQ(parsePly(bytes, "part.ply", JobContext()).mesh.triangles.size(), 1U);
}

TEST(MeshText, FindingsOfWhatIsLeftOut) {
  const JobContext context;
  parseObj("v 0 0 0\nv 9 0 0\nv 0 9 0\nl 1 2\np 1\nf 1 2\nf 1 2 3\nsurf 0 1 0 1\ncall other.obj\n",
           "part.obj", context);
  EXPECT_EQ(context.diagnostics().count("import.edges_left_out"), 1U);
  EXPECT_EQ(context.diagnostics().count("import.free_form_left_out"), 1U);
  EXPECT_EQ(context.diagnostics().count("import.other_file_left_out"), 1U);
}

TEST(MeshText, LaterFacesNameTheirLine) {
  try {
    parseObj("f 1 2 3\nf 1 2 9\nv 0 0 0\nv 1 0 0\nv 0 1 0\n", "part.obj", JobContext());
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("line 2: the face refers to vertex 9; the file has 3"));
  }
}

TEST(MeshText, AsciiStlWithItsFirstLineFilledUpWithZeros) {
  RandomSource random(1);
  std::string header = "solid box";
  header.resize(80, '\0');
  const TriangleMesh mesh = box();
  std::string text = header + "\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t v : t) {
      const Vec3& p = mesh.vertices[v];
      text +=
          "vertex " + formatReal(p.x()) + " " + formatReal(p.y()) + " " + formatReal(p.z()) + "\n";
    }
    text += "endloop\nendfacet\n";
  }
  expectBox(parseStl(text + "endsolid", "part.stl", JobContext()).mesh, text);
}

TEST(MeshText, BinaryStlInEveryDress) {
  const std::string plain = test::binaryStl(box());
  for (const char* header :
       {"solid", "solid facet normal", "  Solid\n", "COLOR=\x80\x80\x80\xFF", "SOLID x"}) {
    for (const std::size_t trailing : {0U, 1U, 2U, 512U}) {
      for (const char filler : {'\0', '\n', 'x'}) {
        std::string bytes = plain;
        bytes.replace(0, std::strlen(header), header);
        bytes.append(trailing, filler);
        SCOPED_TRACE(header + std::string(" ") + std::to_string(trailing));
        const ParsedMesh parsed = parseStl(bytes, "part.stl", JobContext());
        expectBox(parsed.mesh, "binary");
        EXPECT_EQ(parsed.trailingBytes, trailing);
      }
    }
  }
}

TEST(MeshText, KindsOfFilesAreNamed) {
  const std::vector<std::pair<std::string, std::string>> kinds{
      {"\n <HTML><body>", "an HTML page"},
      {"<?xml version=\"1.0\"?>\n<!DOCTYPE html PUBLIC><html>", "an HTML page"},
      {"<?xml version=\"1.0\"?><amf unit=\"mm\">", "an AMF model"},
      {"<?xml version=\"1.0\"?><COLLADA>", "a COLLADA scene"},
      {"%PDF-1.7\n", "a PDF document"},
      {"\x89PNG\r\n\x1a\n", "a PNG picture"},
      {"\xFF\xD8\xFF\xE0", "a JPEG picture"},
      {"\x1F\x8B\x08", "a gzip archive"},
      {"Rar!\x1A\x07\x01", "a RAR archive"},
      {"\xD0\xCF\x11\xE0\xA1\xB1\x1A\xE1", "a compound document"},
      {"Kaydara FBX Binary  ", "an FBX scene"},
      {"glTF\x02", "a glTF scene"},
      {"#VRML V2.0 utf8", "a VRML scene"},
      {"  0\r\nSECTION\r\n  2\r\nHEADER", "a DXF drawing"},
      {"AC1027", "a DWG drawing"},
      {"version https://git-lfs.github.com/spec/v1\noid sha256:1", "a pointer of Git LFS"},
      {std::string(2000, '\0'), "a file of zeros only"},
      {"OFF\n8 12 0\n", "an OFF mesh"},
      {"# .PCD v0.7", "a PCD point cloud"},
      {"LASF", "a LAS point cloud"}};
  for (const auto& [bytes, name] : kinds) {
    for (const char* file : {"part.stl", "part.step", "part.obj", "part.unknown"}) {
      try {
        detectFormat(file, bytes);
        ADD_FAILURE() << name << " taken for a part";
      } catch (const Error& error) {
        EXPECT_THAT(error.what(), HasSubstr(name)) << file;
        EXPECT_FALSE(error.hintText().empty());
      }
    }
  }
}

TEST(MeshText, PartsAreNotTakenForOtherKinds) {
  RandomSource random(3);
  EXPECT_FALSE(foreignFormat(test::binaryStl(box())));
  EXPECT_FALSE(foreignFormat(randomStl(random)));
  EXPECT_FALSE(foreignFormat(randomObj(random)));
  EXPECT_FALSE(foreignFormat(randomPly(random)));
  EXPECT_FALSE(foreignFormat("ISO-10303-21;\nHEADER;"));
}

TEST(MeshText, NumbersAsFilesHaveThem) {
  EXPECT_EQ(scanNumber("1.5D+02"), 150.0);
  EXPECT_EQ(scanNumber("-2d0"), -2.0);
  EXPECT_FALSE(scanNumber("d1"));
  EXPECT_FALSE(scanNumber("1,5"));
  EXPECT_FALSE(scanNumber("1.#IND"));
  EXPECT_FALSE(scanNumber("0xD"));
}

}  // namespace
}  // namespace wcam::io
