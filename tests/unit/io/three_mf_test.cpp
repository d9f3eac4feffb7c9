// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/base/error.hpp"

#include "io_files.hpp"
#include "mesh_readers.hpp"
#include "raw_zip.hpp"
#include "three_mf_package.hpp"
#include "zip_file.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>

namespace wcam::io {
namespace {

using geometry::Vec3;
using test::rawZip;
using test::ZipDress;
using testing::AllOf;
using testing::HasSubstr;

const std::string kCore = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const std::string kMicrosoft = "http://schemas.microsoft.com/3dmanufacturing/";

std::string boxMeshXml(const Vec3& low, const Vec3& high) {
  return test::threeMfMesh(test::boxMesh(low, high));
}

std::string objectXml(const std::string& id, const std::string& attributes = {}) {
  return "<object id=\"" + id + "\" " + attributes + ">" +
         boxMeshXml(Vec3(0, 0, 0), Vec3(20, 30, 40)) + "</object>";
}

std::string modelXml(const std::string& resources,
                     const std::string& build,
                     const std::string& attributes = {}) {
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?><model unit=\"millimeter\" xmlns=\"" + kCore +
         "\" " + attributes + "><resources>" + resources + "</resources><build>" + build +
         "</build></model>";
}

std::string package(const std::string& model,
                    const ZipDress& dress = {},
                    const std::string& extraName = "Metadata/x.txt",
                    const std::string& extra = "x") {
  return rawZip({{"_rels/.rels", test::threeMfRelations("/3D/3dmodel.model")},
                 {"3D/3dmodel.model", model},
                 {extraName, extra}},
                dress);
}

RawMesh read(const std::string& bytes, const JobContext& context = JobContext()) {
  return parseThreeMf(bytes, "part.3mf", context);
}

std::string refusalOf(const std::string& bytes) {
  try {
    read(bytes);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::InputInvalid);
    EXPECT_THAT(error.what(), HasSubstr("part.3mf"));
    EXPECT_FALSE(error.hintText().empty());
    return error.what();
  }
  ADD_FAILURE() << "was read";
  return {};
}

const std::string kBox = modelXml(objectXml("1"), "<item objectid=\"1\"/>");

TEST(ThreeMf, EveryKindOfZip) {
  std::vector<ZipDress> dresses(9);
  dresses[1].sizes64 = true;
  dresses[2].sizes64 = true;
  dresses[2].directory64 = true;
  dresses[3].descriptor = true;
  dresses[4].sizes64 = true;
  dresses[4].descriptor = true;
  dresses[5].stored = true;
  dresses[6].before = "MZ a program that unpacks itself";
  dresses[7].after = "a comment with PK in it";
  dresses[8].directory64 = true;
  for (std::size_t i = 0; i < dresses.size(); ++i) {
    SCOPED_TRACE(i);
    const RawMesh mesh = read(package(kBox, dresses[i]));
    EXPECT_EQ(mesh.mesh.triangles.size(), 12U);
    EXPECT_NEAR(test::signedVolume(mesh.mesh), 24000.0, 1e-9);
  }
}

TEST(ThreeMf, DamagedArchivesAreRefused) {
  const std::string good = package(kBox);
  for (std::size_t size = 0; size < good.size(); size += 7) {
    refusalOf(good.substr(0, size));
  }
  ZipDress dress;
  dress.method = 12;
  EXPECT_THAT(refusalOf(package(kBox, dress)), HasSubstr("method 12"));
  dress = {};
  dress.encrypted = true;
  EXPECT_THAT(refusalOf(package(kBox, dress)), HasSubstr("encrypted"));
  dress = {};
  dress.unpacked = 10;
  EXPECT_THAT(refusalOf(package(kBox, dress)), HasSubstr("more than the 10 bytes"));
  std::string changed = good;
  changed[good.find("_rels/.rels") + 40] ^= 1;
  EXPECT_THAT(refusalOf(changed), HasSubstr("damaged"));
}

TEST(ThreeMf, BombsAreRefusedWithTheirFigures) {
  const auto start = std::chrono::steady_clock::now();
  // Blanks shrink a thousandfold.
  const std::string bomb =
      modelXml(objectXml("1"), "<item objectid=\"1\"/>" + std::string(80U << 20U, ' '));
  EXPECT_THAT(refusalOf(package(bomb)),
              AllOf(HasSubstr("3dmodel.model"), HasSubstr("83.9 MB"), HasSubstr("250 times")));
  // One attribute of many megabytes, in which the XML library takes the square of the length.
  std::string noise;
  std::uint32_t state = 1;
  while (noise.size() < 4U << 20U) {
    state = state * 1664525U + 1013904223U;
    noise.push_back(static_cast<char>('a' + (state >> 24U) % 26));
  }
  const std::string longTag =
      modelXml("<object id=\"1\" name=\"" + noise + "\"/>", "<item objectid=\"1\"/>");
  EXPECT_THAT(refusalOf(package(longTag)),
              AllOf(HasSubstr("line 1"), HasSubstr("longer than 1048576 bytes")));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

TEST(ThreeMf, TooManyRepeatedTriangles) {
  std::string resources = objectXml("1");
  std::string last = "1";
  for (int level = 2; level < 8; ++level) {
    const std::string id = std::to_string(level);
    resources += "<object id=\"" + id + "\"><components>";
    for (int k = 0; k < 9; ++k) {
      resources += "<component objectid=\"" + last + "\"/>";
    }
    resources += "</components></object>";
    last = id;
  }
  // 9⁶ boxes would fit; 9⁶ of 12 · 9 · 9 triangles do not, and are refused before they are built.
  EXPECT_THAT(
      refusalOf(package(modelXml(resources, "<item objectid=\"7\"/><item objectid=\"7\"/>"))),
      HasSubstr("repeats"));
  std::string large =
      "<object id=\"1\">" + test::threeMfMesh(test::torusMesh(100, 50, 50, 15)) + "</object>";
  resources.replace(0, resources.find("<object id=\"2\""), large);
  EXPECT_THAT(refusalOf(package(modelXml(resources, "<item objectid=\"6\"/>"))),
              HasSubstr("590490000 triangles; at most 100000000"));
}

TEST(ThreeMf, PartNamesAsUris) {
  EXPECT_EQ(Package::partName("/3D/My%20Model.model"), "3d/my model.model");
  EXPECT_EQ(Package::partName("3D\\a.model"), "3d/a.model");
  EXPECT_EQ(Package::partName("../../etc/passwd"), "etc/passwd");
  EXPECT_EQ(Package::partName("/3D/../3D/./a.model"), "3d/a.model");
  EXPECT_EQ(Package::partName("100%"), "100%");
  for (const auto& [target, entry] :
       {std::pair<std::string, std::string>{"/3D/my%20model.model", "3D/my model.model"},
        {"/3D/my model.model", "3D/my%20model.model"},
        {"/3d/MODEL.model", "3D/model.model"},
        {"3D/a.model", "3D\\a.model"},
        {"/3D/%C3%A4.model", "3D/ä.model"}}) {
    SCOPED_TRACE(target);
    EXPECT_EQ(read(rawZip({{"_rels/.rels", test::threeMfRelations(target)}, {entry, kBox}}))
                  .mesh.triangles.size(),
              12U);
  }
  EXPECT_THAT(refusalOf(rawZip({{"3D/a.model", kBox}, {"3d/A.model", kBox}})),
              HasSubstr("there twice"));
}

TEST(ThreeMf, ZipOfSomethingElseNamesItsContent) {
  EXPECT_THAT(refusalOf(rawZip({{"thing.stl", "solid"}})),
              AllOf(HasSubstr("no 3MF model"), HasSubstr("thing.stl")));
  EXPECT_THAT(refusalOf(package("<html><body/></html>")), HasSubstr("'html'"));
}

TEST(ThreeMf, RequiredExtensions) {
  const std::string item = "<item objectid=\"1\"/>";
  const auto with = [&](const std::string& space) {
    return package(
        modelXml(objectXml("1"), item, "xmlns:q=\"" + space + "\" requiredextensions=\"q\""));
  };
  for (const std::string known : {"production/2015/06", "material/2015/02", "beamlattice/2017/02",
                                  "slice/2015/07", "trianglesets/2021/07"}) {
    EXPECT_EQ(read(with(kMicrosoft + known)).mesh.triangles.size(), 12U) << known;
  }
  EXPECT_THAT(refusalOf(with("http://example.org/curved/2030")),
              AllOf(HasSubstr("'q'"), HasSubstr("http://example.org/curved/2030")));
  EXPECT_THAT(refusalOf(with(kMicrosoft + "volumetric/2022/01")), HasSubstr("'volumetric'"));
  EXPECT_THAT(refusalOf(with("http://schemas.3mf.io/3dmanufacturing/booleanoperations/2023/07")),
              HasSubstr("'boolean operations'"));
  EXPECT_THAT(refusalOf(package(modelXml(objectXml("1"), item, "requiredextensions=\"nowhere\""))),
              HasSubstr("not declared"));
}

TEST(ThreeMf, ElementsOfOtherNamespacesAreNotMeshes) {
  const std::string slice =
      "<s:slicestack id=\"9\" xmlns:s=\"" + kMicrosoft +
      "slice/2015/07\"><s:slice ztop=\"1\"><s:vertices><s:vertex x=\"0\" y=\"0\"/></s:vertices>"
      "</s:slice></s:slicestack>";
  const std::string own = "<v:object xmlns:v=\"http://example.org\" id=\"1\"/>";
  const JobContext context;
  const RawMesh mesh =
      read(package(modelXml(slice + own + objectXml("1"), "<item objectid=\"1\"/>")), context);
  EXPECT_EQ(mesh.mesh.triangles.size(), 12U);
  EXPECT_EQ(context.diagnostics().count("import.extension_left_out"), 1U);
}

TEST(ThreeMf, WhatIsNotBuiltIsTold) {
  const JobContext context;
  const std::string model = modelXml(
      objectXml("1") + objectXml("2", "type=\"support\"") + objectXml("3", "type=\"other\"") +
          objectXml("4", "type=\"solidsupport\"") +
          "<object id=\"5\"><metadatagroup><metadata name=\"cura:infill_mesh\">True</metadata>"
          "</metadatagroup>" +
          boxMeshXml(Vec3(0, 0, 0), Vec3(1, 1, 1)) + "</object>",
      "<item objectid=\"1\"/><item objectid=\"2\"/><item objectid=\"3\"/><item objectid=\"4\"/>"
      "<item objectid=\"5\"/><item objectid=\"1\" printable=\"false\"/>");
  const RawMesh mesh = read(package(model), context);
  EXPECT_EQ(mesh.mesh.triangles.size(), 12U);
  for (const auto& [code, count] : {std::pair{"import.support_left_out", 2.0},
                                    {"import.other_left_out", 1.0},
                                    {"import.modifier_left_out", 1.0},
                                    {"import.not_printable", 1.0}}) {
    bool found = false;
    for (const Diagnostic& d : context.diagnostics().items()) {
      if (d.code == code) {
        found = true;
        EXPECT_EQ(d.data.at(0).second, count) << code;
      }
    }
    EXPECT_TRUE(found) << code;
  }
  EXPECT_THAT(
      refusalOf(package(modelXml(objectXml("1"), "<item objectid=\"1\" printable=\"0\"/>"))),
      HasSubstr("not printable"));
}

/// Components of one object, as Bambu Studio and OrcaSlicer keep them.
TEST(ThreeMf, NegativePartsOfComponents) {
  const std::string model = modelXml(
      objectXml("1") + "<object id=\"2\">" + boxMeshXml(Vec3(10, -1, -1), Vec3(50, 50, 50)) +
          "</object>" + objectXml("3") +
          "<object id=\"8\"><components><component objectid=\"1\"/><component objectid=\"2\"/>"
          "<component objectid=\"3\" transform=\"1 0 0 0 1 0 0 0 1 0 100 "
          "0\"/></components></object>",
      "<item objectid=\"8\"/>");
  const std::string settings =
      "<?xml version=\"1.0\"?><config><object id=\"8\"><part id=\"1\" subtype=\"normal_part\">"
      "<metadata key=\"name\" value=\"body\"/></part><part id=\"2\" subtype=\"negative_part\">"
      "<metadata key=\"name\" value=\"hole\"/></part><part id=\"3\" subtype=\"modifier_part\"/>"
      "</object></config>";
  const JobContext context;
  const RawMesh mesh =
      read(package(model, {}, "Metadata/model_settings.config", settings), context);
  EXPECT_NEAR(test::signedVolume(mesh.mesh), 12000.0, 1e-6);
  ASSERT_EQ(mesh.bodies.size(), 1U);
  EXPECT_EQ(mesh.bodies[0].name, "body");
  EXPECT_EQ(context.diagnostics().count("import.negative_cut"), 1U);
  EXPECT_EQ(context.diagnostics().count("import.modifier_left_out"), 1U);
}

TEST(ThreeMf, NegativeVolumesThatCannotBeCutAreTold) {
  // The cutter is an open sheet.
  const std::string sheet =
      "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"5\"/><vertex x=\"9\" y=\"0\" z=\"5\"/><vertex "
      "x=\"0\" y=\"9\" z=\"5\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/>"
      "</triangles></mesh>";
  const std::string model =
      modelXml(objectXml("1") + "<object id=\"2\">" + sheet +
                   "</object><object id=\"8\"><components><component objectid=\"1\"/><component "
                   "objectid=\"2\"/></components></object>",
               "<item objectid=\"8\"/>");
  const std::string settings =
      "<config><object id=\"8\"><part id=\"2\" subtype=\"negative_part\"/></object></config>";
  const JobContext context;
  const RawMesh mesh =
      read(package(model, {}, "Metadata/model_settings.config", settings), context);
  EXPECT_EQ(mesh.mesh.triangles.size(), 12U);
  EXPECT_EQ(context.diagnostics().count("import.negative_left_out"), 1U);
}

TEST(ThreeMf, ErrorsNamePartAndLine) {
  const std::string item = "<item objectid=\"1\"/>";
  EXPECT_THAT(refusalOf(package(modelXml(objectXml("1") + objectXml("1"), item))),
              HasSubstr("object '1' is there twice"));
  EXPECT_THAT(refusalOf(package(modelXml(objectXml("1"),
                                         "\n\n<item objectid=\"1\" transform=\"1 0 0 0 1 0\"/>"))),
              HasSubstr("line 15: a transform does not have twelve numbers"));
  EXPECT_THAT(
      refusalOf(package(modelXml(
          objectXml("1"), "<item objectid=\"1\" transform=\"1 0 0 0 1 0 0 0 1 0 0 0 7\"/>"))),
      HasSubstr("twelve numbers"));
  EXPECT_THAT(refusalOf(package("<!DOCTYPE model [<!ENTITY a \"b\">]>" + kBox.substr(38))),
              HasSubstr("document type"));
}

}  // namespace
}  // namespace wcam::io
