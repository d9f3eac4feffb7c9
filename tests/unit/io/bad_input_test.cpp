// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"
#include "wcam/io/import.hpp"

#include "io_files.hpp"
#include "zip_file.hpp"
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BinTools.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <random>

namespace wcam::io {
namespace {

using geometry::Pose;
using geometry::TriangleMesh;
using geometry::Vec3;
using test::TemporaryFolder;
using testing::HasSubstr;

const std::filesystem::path kProjects = std::filesystem::path(WCAM_RESOURCES) / "projects";

const std::vector<std::string> kExtensions = {".step", ".igs", ".brep", ".stl",
                                              ".obj",  ".ply", ".3mf"};

ImportedPart importFile(const std::filesystem::path& file) {
  return importPart(file, {}, Pose::Identity(), JobContext());
}

/// The message of the error with this code; it names the file and is plain text.
std::string messageOf(const std::filesystem::path& file, ErrorCode code = ErrorCode::InputInvalid) {
  try {
    importFile(file);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), code) << error.what();
    EXPECT_THAT(error.what(), HasSubstr(file.filename().string()));
    for (const char c : std::string(error.what())) {
      EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20) << error.what();
    }
    return error.what();
  }
  ADD_FAILURE() << file << " was read";
  return {};
}

/// A small valid file of each format.
class ValidFiles {
public:
  ValidFiles() {
    const TriangleMesh box = test::boxMesh(Vec3(0, 0, 0), Vec3(10, 20, 30));
    test::writeBytes(folder_ / "a.stl", test::binaryStl(box));
    std::string ascii = "solid a\n";
    std::string obj;
    std::string ply =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float "
        "y\nproperty float z\nelement face 12\nproperty list uchar int "
        "vertex_indices\nend_header\n";
    for (const Vec3& p : box.vertices) {
      const std::string xyz =
          formatReal(p.x()) + " " + formatReal(p.y()) + " " + formatReal(p.z()) + "\n";
      obj += "v " + xyz;
      ply += xyz;
    }
    for (const auto& t : box.triangles) {
      ascii += "facet normal 0 0 0\nouter loop\n";
      obj += "f";
      ply += "3";
      for (const std::uint32_t v : t) {
        const Vec3& p = box.vertices[v];
        ascii += "vertex " + formatReal(p.x()) + " " + formatReal(p.y()) + " " + formatReal(p.z()) +
                 "\n";
        obj += " " + std::to_string(v + 1);
        ply += " " + std::to_string(v);
      }
      ascii += "endloop\nendfacet\n";
      obj += "\n";
      ply += "\n";
    }
    test::writeBytes(folder_ / "b.stl", ascii + "endsolid a\n");
    test::writeBytes(folder_ / "a.obj", obj);
    test::writeBytes(folder_ / "a.ply", ply);
    test::writeThreeMf(folder_ / "a.3mf", box, "millimeter");
    std::filesystem::copy_file(kProjects / "elbow" / "elbow.step", folder_ / "a.step");
    const TopoDS_Shape shape = BRepPrimAPI_MakeBox(10, 20, 30);
    BRepTools::Write(shape, (folder_ / "a.brep").c_str());
    BinTools::Write(shape, (folder_ / "b.brep").c_str());
    IGESControl_Controller::Init();
    IGESControl_Writer writer("MM", 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    writer.Write((folder_ / "a.igs").c_str());
  }

  [[nodiscard]] std::vector<std::string> names() const {
    return {"a.stl", "b.stl", "a.obj", "a.ply", "a.3mf", "a.step", "a.brep", "b.brep", "a.igs"};
  }

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return folder_ / name;
  }

private:
  TemporaryFolder folder_;
};

/// Reads a file that may or may not be usable: no crash, no other exception, no endless loop.
void readAnything(const std::filesystem::path& file) {
  const auto start = std::chrono::steady_clock::now();
  try {
    const ImportedPart part = importFile(file);
    EXPECT_FALSE(part.surface->mesh.triangles.empty());
    for (const Vec3& p : part.surface->mesh.vertices) {
      ASSERT_TRUE(p.allFinite());
    }
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid) << error.what();
    EXPECT_THAT(error.what(), HasSubstr(file.filename().string()));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(BadInput, ValidFilesAreRead) {
  const ValidFiles files;
  for (const std::string& name : files.names()) {
    SCOPED_TRACE(name);
    EXPECT_NO_THROW(importFile(files / name));
  }
}

TEST(BadInput, MissingFileOfEveryFormat) {
  const TemporaryFolder folder;
  for (const std::string& extension : kExtensions) {
    EXPECT_THAT(messageOf(folder / ("gone" + extension), ErrorCode::InputNotFound),
                HasSubstr("does not exist"));
  }
}

TEST(BadInput, EmptyFileOfEveryFormat) {
  const TemporaryFolder folder;
  for (const std::string& extension : kExtensions) {
    test::writeBytes(folder / ("empty" + extension), "");
    EXPECT_THAT(messageOf(folder / ("empty" + extension)), HasSubstr("empty"));
  }
}

TEST(BadInput, FolderInsteadOfAFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "part.step");
  EXPECT_THAT(messageOf(folder / "part.step"), HasSubstr("folder"));
}

TEST(BadInput, UnknownFormat) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "notes.txt", "nothing to build here\n");
  EXPECT_THAT(messageOf(folder / "notes.txt"), HasSubstr("format"));
}

TEST(BadInput, RandomBytesOfEveryFormat) {
  const TemporaryFolder folder;
  const unsigned seed = 99;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const std::string& extension : kExtensions) {
    for (int run = 0; run < 10; ++run) {
      std::string bytes(1 + random() % 5000, '\0');
      for (char& c : bytes) {
        c = static_cast<char>(random());
      }
      const auto file = folder / ("random" + extension);
      test::writeBytes(file, bytes);
      messageOf(file);
    }
  }
}

TEST(BadInput, RandomBytesAfterAValidStart) {
  const ValidFiles files;
  const TemporaryFolder folder;
  const unsigned seed = 5;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const std::string& name : files.names()) {
    SCOPED_TRACE(name);
    const std::string valid = test::readBytes(files / name);
    for (int run = 0; run < 10; ++run) {
      std::string bytes = valid.substr(0, 80 + random() % (valid.size() - 80));
      for (int i = 0; i < 500; ++i) {
        bytes.push_back(static_cast<char>(random()));
      }
      test::writeBytes(folder / name, bytes);
      readAnything(folder / name);
    }
  }
}

TEST(BadInput, CutOffAnywhere) {
  const ValidFiles files;
  const TemporaryFolder folder;
  const unsigned seed = 6;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const std::string& name : files.names()) {
    const std::string valid = test::readBytes(files / name);
    for (int run = 0; run < 12; ++run) {
      const std::size_t size = 1 + random() % (valid.size() - 1);
      SCOPED_TRACE(name + " cut at " + std::to_string(size));
      test::writeBytes(folder / name, valid.substr(0, size));
      readAnything(folder / name);
    }
  }
}

TEST(BadInput, CutInTheMiddleIsRefused) {
  const ValidFiles files;
  const TemporaryFolder folder;
  for (const std::string name :
       {"a.stl", "b.stl", "a.ply", "a.3mf", "a.step", "a.brep", "b.brep", "a.igs"}) {
    SCOPED_TRACE(name);
    const std::string valid = test::readBytes(files / name);
    test::writeBytes(folder / name, valid.substr(0, valid.size() / 2));
    messageOf(folder / name);
  }
}

TEST(BadInput, ChangedBytes) {
  const ValidFiles files;
  const TemporaryFolder folder;
  const unsigned seed = 8;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const std::string& name : files.names()) {
    const std::string valid = test::readBytes(files / name);
    for (int run = 0; run < 12; ++run) {
      SCOPED_TRACE(name + " run " + std::to_string(run));
      std::string bytes = valid;
      for (int i = 0; i < 5; ++i) {
        bytes[random() % bytes.size()] = static_cast<char>(random());
      }
      test::writeBytes(folder / name, bytes);
      readAnything(folder / name);
    }
  }
}

TEST(BadInput, PlyCountsAreCheckedBeforeAllocating) {
  const TemporaryFolder folder;
  const std::string head = "ply\nformat binary_little_endian 1.0\n";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  test::writeBytes(folder / "a.ply",
                   head + "element vertex 4000000000\n" + xyz + "end_header\n1234");
  EXPECT_THAT(messageOf(folder / "a.ply"), HasSubstr("4000000000"));
  test::writeBytes(folder / "b.ply", head + "element vertex 1\n" + xyz +
                                         "element face 1000000000000\nproperty list uchar int "
                                         "vertex_indices\nend_header\n123456789012");
  EXPECT_THAT(messageOf(folder / "b.ply"), HasSubstr("face"));
}

TEST(BadInput, ObjErrorsNameTheLine) {
  const TemporaryFolder folder;
  test::writeBytes(folder / "a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n");
  EXPECT_THAT(messageOf(folder / "a.obj"), HasSubstr("line 4"));
  test::writeBytes(folder / "b.obj", "v 0 0 0\nv 1 0 nan\n");
  EXPECT_THAT(messageOf(folder / "b.obj"), HasSubstr("line 2"));
  test::writeBytes(folder / "c.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n");
  EXPECT_THAT(messageOf(folder / "c.obj"), HasSubstr("no triangles"));
}

TEST(BadInput, ThreeMfThatRefersToItself) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& resources) {
    test::writeZip(folder / "a.3mf",
                   {{"_rels/.rels", test::threeMfRelations("/3D/3dmodel.model")},
                    {"3D/3dmodel.model", "<model><resources>" + resources +
                                             "</resources><build><item objectid=\"1\"/></build>"
                                             "</model>"}});
  };
  write("<object id=\"1\"><components><component objectid=\"1\"/></components></object>");
  EXPECT_THAT(messageOf(folder / "a.3mf"), HasSubstr("circle"));
  write("<object id=\"1\"><components><component objectid=\"7\"/></components></object>");
  EXPECT_THAT(messageOf(folder / "a.3mf"), HasSubstr("does not exist"));
  std::string bomb;
  for (int i = 1; i < 50; ++i) {
    const std::string next = std::to_string(i + 1);
    bomb += "<object id=\"" + std::to_string(i) + "\"><components><component objectid=\"" + next +
            "\"/><component objectid=\"" + next + "\"/></components></object>";
  }
  write(bomb + "<object id=\"50\"/>");
  EXPECT_THAT(messageOf(folder / "a.3mf"), HasSubstr("repeats"));
  test::writeZip(folder / "b.3mf", {{"other.txt", "x"}});
  EXPECT_THAT(messageOf(folder / "b.3mf"), HasSubstr("3dmodel.model"));
}

TEST(BadInput, OnlyDegenerateTriangles) {
  const TemporaryFolder folder;
  TriangleMesh mesh;
  mesh.vertices = {Vec3(0, 0, 0), Vec3(10, 0, 0)};
  mesh.triangles = {{0, 1, 1}, {0, 0, 1}};
  test::writeBytes(folder / "a.stl", test::binaryStl(mesh));
  EXPECT_THAT(messageOf(folder / "a.stl"), HasSubstr("no triangle is left"));
}

TEST(BadInput, CancelDuringMeshImport) {
  const ValidFiles files;
  for (const std::string& name : files.names()) {
    std::stop_source stop;
    const JobContext context(stop.get_token(),
                             [&](double, const std::string&) { stop.request_stop(); });
    EXPECT_THROW(importPart(files / name, {}, Pose::Identity(), context), CancelledError) << name;
  }
}

}  // namespace
}  // namespace wcam::io
