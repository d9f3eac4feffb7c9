// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the CAD parts of the example projects: make_example_parts RESOURCES/projects
#include "wcam/base/file_io.hpp"
#include "wcam/base/quantity.hpp"

#include "export_brep.hpp"
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRep_Builder.hxx>
#include <Geom_Circle.hxx>
#include <Geom_SphericalSurface.hxx>
#include <Geom_ToroidalSurface.hxx>
#include <Precision.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <gp_Ax2.hxx>
#include <gp_Ax3.hxx>

#include <exception>
#include <iostream>

namespace {

constexpr double kGuideRadius = 50.0;
constexpr double kTubeRadius = 15.0;
constexpr double kSphereRadius = 45.0;

TopoDS_Shape shellOf(const TopoDS_Face& face) {
  TopoDS_Shell shell;
  const BRep_Builder builder;
  builder.MakeShell(shell);
  builder.Add(shell, face);
  return shell;
}

/// Quarter torus of Chalvin Eq. 2.11 with its guide: a circle about (−R, 0, 0) that starts at the
/// origin along +Z and bends to −X.
void writeElbow(const std::filesystem::path& file) {
  const gp_Pnt centre(-kGuideRadius, 0.0, 0.0);
  const gp_Dir axis(0.0, -1.0, 0.0);
  const gp_Dir start(1.0, 0.0, 0.0);
  const Handle(Geom_ToroidalSurface) torus =
      new Geom_ToroidalSurface(gp_Ax3(centre, axis, start), kGuideRadius, kTubeRadius);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(torus, 0.0, wcam::kPi / 2.0, 0.0,
                                                   2.0 * wcam::kPi, Precision::Confusion());
  const Handle(Geom_Circle) circle = new Geom_Circle(gp_Ax2(centre, axis, start), kGuideRadius);
  const TopoDS_Edge guide = BRepBuilderAPI_MakeEdge(circle, 0.0, wcam::kPi / 2.0);
  wcam::io::writeStep({{shellOf(face), "elbow"}, {guide, "guide"}}, file);
}

/// Upper half of a sphere about the origin.
void writeHemisphere(const std::filesystem::path& file) {
  const Handle(Geom_SphericalSurface) sphere =
      new Geom_SphericalSurface(gp_Ax3(gp::XOY()), kSphereRadius);
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(sphere, 0.0, 2.0 * wcam::kPi, 0.0,
                                                   wcam::kPi / 2.0, Precision::Confusion());
  wcam::io::writeStep({{shellOf(face), "hemisphere"}}, file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_example_parts FOLDER\n";
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    wcam::createFolder(folder / "elbow");
    wcam::createFolder(folder / "hemisphere");
    writeElbow(folder / "elbow" / "elbow.step");
    writeHemisphere(folder / "hemisphere" / "hemisphere.step");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
