// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the CAD parts on which every strategy is tried: make_strategy_parts tests/data/step
#include "wcam/base/file_io.hpp"
#include "wcam/base/quantity.hpp"

#include "export_brep.hpp"
#include <BRepAdaptor_Surface.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepOffsetAPI_ThruSections.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GeomAPI_PointsToBSpline.hxx>
#include <Geom_BSplineCurve.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>
#include <gp_Ax2.hxx>
#include <gp_Elips.hxx>

#include <cmath>
#include <exception>
#include <functional>
#include <initializer_list>
#include <iostream>
#include <utility>

namespace {

/// The faces that are wanted, sewn into one shell.
TopoDS_Shape shellOf(const TopoDS_Shape& shape,
                     const std::function<bool(const BRepAdaptor_Surface&)>& wanted) {
  BRepBuilderAPI_Sewing sewing;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next()) {
    const TopoDS_Face face = TopoDS::Face(it.Current());
    if (wanted(BRepAdaptor_Surface(face))) {
      sewing.Add(face);
    }
  }
  sewing.Perform();
  return sewing.SewedShape();
}

/// A tube along a quarter of a circle of 80 mm whose section changes from a circle of 20 mm to an
/// ellipse of 26 by 14 mm.
void writeBentTube(const std::filesystem::path& file) {
  BRepOffsetAPI_ThruSections loft(Standard_False, Standard_False);
  constexpr int kSections = 7;
  for (int i = 0; i < kSections; ++i) {
    const double s = static_cast<double>(i) / (kSections - 1);
    const double angle = 0.5 * wcam::kPi * s;
    const gp_Pnt centre(80.0 * (1.0 - std::cos(angle)), 0.0, 80.0 * std::sin(angle));
    const gp_Dir tangent(std::sin(angle), 0.0, std::cos(angle));
    const gp_Elips ellipse(gp_Ax2(centre, tangent, gp_Dir(0.0, 1.0, 0.0)), 20.0 + 6.0 * s,
                           20.0 - 6.0 * s);
    loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ellipse)));
  }
  loft.Build();
  wcam::io::writeStep({{loft.Shape(), "bent tube"}}, file);
}

/// A tube of 18 mm that ends in a ball, from which two tubes of 14 mm leave at 35° to either side.
void writeYBranch(const std::filesystem::path& file) {
  const TopoDS_Shape trunk = BRepPrimAPI_MakeCylinder(18.0, 42.0).Shape();
  const TopoDS_Shape ball = BRepPrimAPI_MakeSphere(gp_Pnt(0.0, 0.0, 42.0), 18.0).Shape();
  const auto branch = [](double side) {
    const double angle = wcam::degToRad(35.0);
    const gp_Dir direction(side * std::sin(angle), 0.0, std::cos(angle));
    return BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0.0, 0.0, 42.0), direction), 14.0, 70.0).Shape();
  };
  TopoDS_Shape fork = BRepAlgoAPI_Fuse(trunk, ball).Shape();
  for (const double side : {1.0, -1.0}) {
    fork = BRepAlgoAPI_Fuse(fork, branch(side)).Shape();
  }
  wcam::io::writeStep(
      {{shellOf(fork,
                [](const BRepAdaptor_Surface& face) { return face.GetType() != GeomAbs_Plane; }),
        "y branch"}},
      file);
}

/// A vase of revolution whose rim is the cut of a lying cylinder.
void writeVase(const std::filesystem::path& file) {
  constexpr int kPoints = 12;
  TColgp_Array1OfPnt points(1, kPoints);
  for (int i = 1; i <= kPoints; ++i) {
    const double z = 120.0 * (i - 1) / (kPoints - 1);
    points.SetValue(i, gp_Pnt(30.0 + 7.0 * std::sin(2.0 * wcam::kPi * z / 120.0), 0.0, z));
  }
  const Handle(Geom_BSplineCurve) profile = GeomAPI_PointsToBSpline(points).Curve();
  const TopoDS_Shape wall =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeEdge(profile).Shape(), gp_Ax1()).Shape();
  const TopoDS_Shape cutter =
      BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(-100.0, 0.0, 180.0), gp_Dir(1.0, 0.0, 0.0)), 80.0,
                               200.0)
          .Shape();
  const TopoDS_Shape cut = BRepAlgoAPI_Cut(wall, cutter).Shape();
  wcam::io::writeStep({{shellOf(cut, [](const BRepAdaptor_Surface&) { return true; }), "vase"}},
                      file);
}

/// A cup as a solid: a bottom of 6 mm and a wall whose outer side is a cone from 30 to 40 mm in
/// radius over 80 mm, 6 mm thick horizontally.
void writeCup(const std::filesystem::path& file) {
  BRepBuilderAPI_MakePolygon profile;
  const double inner = 24.0 + 10.0 * 6.0 / 80.0;
  for (const auto& [x, z] : std::initializer_list<std::pair<double, double>>{
           {0.0, 0.0}, {30.0, 0.0}, {40.0, 80.0}, {34.0, 80.0}, {inner, 6.0}, {0.0, 6.0}}) {
    profile.Add(gp_Pnt(x, 0.0, z));
  }
  profile.Close();
  const TopoDS_Face face = BRepBuilderAPI_MakeFace(profile.Wire());
  wcam::io::writeStep({{BRepPrimAPI_MakeRevol(face, gp_Ax1()).Shape(), "cup"}}, file);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: make_strategy_parts FOLDER\n";
    return 1;
  }
  try {
    const std::filesystem::path folder = argv[1];
    wcam::createFolder(folder);
    writeBentTube(folder / "bent_tube.step");
    writeYBranch(folder / "y_branch.step");
    writeVase(folder / "vase_rim.step");
    writeCup(folder / "cup.step");
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  return 0;
}
