// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "cad_mend.hpp"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Curve.hxx>
#include <Geom2d_Line.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideClosed.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include <cmath>

namespace wcam::io {

namespace {

/// Parameters along a seam that differ by less are the same but for rounding.
constexpr double kStraight = 1e-7;

/// The line of constant u (or v) that a curve is but for rounding; null where it is none.
Handle(Geom2d_Curve)
    straightened(const Handle(Geom2d_Curve) & curve, double first, double last, int fixed) {
  const gp_Pnt2d a = curve->Value(first);
  const gp_Pnt2d b = curve->Value(last);
  const double off = b.Coord(fixed) - a.Coord(fixed);
  const double along = b.Coord(3 - fixed) - a.Coord(3 - fixed);
  // A seam has the parameters of its curve.
  if (std::abs(off) > kStraight || std::abs(std::abs(along) - (last - first)) > kStraight) {
    return nullptr;
  }
  const double sign = along < 0.0 ? -1.0 : 1.0;
  gp_Pnt2d origin = a;
  origin.SetCoord(fixed, 0.5 * (a.Coord(fixed) + b.Coord(fixed)));
  origin.SetCoord(3 - fixed, a.Coord(3 - fixed) - sign * first);
  return new Geom2d_Line(origin, fixed == 1 ? gp_Dir2d(0.0, sign) : gp_Dir2d(sign, 0.0));
}

void straightenSeam(const TopoDS_Edge& edge, const TopoDS_Face& face) {
  const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
  const TopoDS_Edge reversed = TopoDS::Edge(edge.Oriented(TopAbs_REVERSED));
  double first = 0.0;
  double last = 0.0;
  const Handle(Geom2d_Curve) one = BRep_Tool::CurveOnSurface(forward, face, first, last);
  const Handle(Geom2d_Curve) other = BRep_Tool::CurveOnSurface(reversed, face, first, last);
  if (one.IsNull() || other.IsNull()) {
    return;
  }
  for (const int fixed : {1, 2}) {
    const Handle(Geom2d_Curve) a = straightened(one, first, last, fixed);
    const Handle(Geom2d_Curve) b = straightened(other, first, last, fixed);
    if (!a.IsNull() && !b.IsNull()) {
      const BRep_Builder builder;
      builder.UpdateEdge(forward, a, b, face, BRep_Tool::Tolerance(edge));
      builder.Range(forward, face, first, last);
      return;
    }
  }
}

}  // namespace

void straightenSeams(const geometry::Brep::Impl& brep, const std::vector<int>& faces) {
  for (const int index : faces) {
    const TopoDS_Face face =
        TopoDS::Face(brep.faces[static_cast<std::size_t>(index)].Oriented(TopAbs_FORWARD));
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      const TopoDS_Edge edge = TopoDS::Edge(it.Current());
      if (BRep_Tool::IsClosed(edge, face)) {
        straightenSeam(edge, face);
      }
    }
  }
}

TopoDS_Shape divideClosedFaces(const TopoDS_Shape& shape, CadModel& model) {
  ShapeUpgrade_ShapeDivideClosed divide(shape);
  divide.SetNbSplitPoints(1);
  if (!divide.Perform() || divide.Result().IsNull()) {
    return shape;
  }
  std::vector<CadItem> renamed;
  for (const std::vector<CadItem>* items : {&model.bodies, &model.named}) {
    for (const CadItem& item : *items) {
      for (TopExp_Explorer it(item.shape, TopAbs_FACE); it.More(); it.Next()) {
        renamed.push_back({divide.GetContext()->Apply(it.Current()), item.name, {}});
      }
    }
  }
  model.named.insert(model.named.end(), renamed.begin(), renamed.end());
  return divide.Result();
}

}  // namespace wcam::io
