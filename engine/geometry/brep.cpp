// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "wcam/geometry/brep.hpp"

#include "wcam/base/error.hpp"

#include "brep_impl.hpp"
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <GCPnts_AbscissaPoint.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <gp_Pnt.hxx>
#include <gp_Vec.hxx>

#include <algorithm>
#include <cmath>

namespace wcam::geometry {

namespace {

/// du and dv count as parallel (or one as zero) below this sine relative to the larger of them:
/// far above the rounding of a cross product, far below any angle of a usable parametrisation.
constexpr double kSingularSine = 1e-9;
/// Relative step towards the middle of the face where the second order vanishes too.
constexpr double kInwardStep = 1e-4;

Vec3 toVec3(const gp_XYZ& p) {
  return {p.X(), p.Y(), p.Z()};
}

Vec3 toVec3(const gp_Vec& v) {
  return toVec3(v.XYZ());
}

Vec3 toVec3(const gp_Pnt& p) {
  return toVec3(p.XYZ());
}

const char* surfaceTypeName(GeomAbs_SurfaceType type) {
  switch (type) {
    case GeomAbs_Plane:
      return "plane";
    case GeomAbs_Cylinder:
      return "cylinder";
    case GeomAbs_Cone:
      return "cone";
    case GeomAbs_Sphere:
      return "sphere";
    case GeomAbs_Torus:
      return "torus";
    case GeomAbs_BezierSurface:
    case GeomAbs_BSplineSurface:
      return "bspline";
    default:
      return "other";
  }
}

BrepFaceInfo faceInfo(const TopoDS_Face& face) {
  BrepFaceInfo info;
  info.surfaceType = surfaceTypeName(BRepAdaptor_Surface(face, Standard_False).GetType());
  BRepTools::UVBounds(face, info.uvBounds[0], info.uvBounds[1], info.uvBounds[2], info.uvBounds[3]);
  info.reversed = face.Orientation() == TopAbs_REVERSED;
  return info;
}

int distinctFaces(const TopTools_ListOfShape& faces) {
  TopTools_MapOfShape distinct;
  for (const TopoDS_Shape& face : faces) {
    distinct.Add(face);
  }
  return distinct.Extent();
}

BrepEdgeInfo edgeInfo(const TopoDS_Edge& edge, int faceCount) {
  const BRepAdaptor_Curve curve(edge);
  BrepEdgeInfo info;
  info.range = {curve.FirstParameter(), curve.LastParameter()};
  info.length = GCPnts_AbscissaPoint::Length(curve);
  info.faceCount = faceCount;
  return info;
}

bool hasCurve(const TopoDS_Edge& edge) {
  return !BRep_Tool::Degenerated(edge) && BRep_Tool::IsGeometric(edge);
}

/// The cross product of the derivatives as a unit vector; zero when they do not span a plane.
Vec3 unitNormal(const Vec3& du, const Vec3& dv) {
  const Vec3 n = du.cross(dv);
  const double scale = std::max(du.norm(), dv.norm());
  const double length = n.norm();
  return length > kSingularSine * scale * scale ? Vec3(n / length) : Vec3(Vec3::Zero());
}

/// Limit of the unit normal when uv is approached from the direction (a, b): where du × dv
/// vanishes, its derivative along (a, b) gives the direction.
Vec3 limitNormal(const BRepAdaptor_Surface& surface, const Vec2& uv, const Vec2& direction) {
  gp_Pnt p;
  gp_Vec du, dv, duu, dvv, duv;
  surface.D2(uv.x(), uv.y(), p, du, dv, duu, dvv, duv);
  const gp_Vec n = (duu * direction.x() + duv * direction.y()).Crossed(dv) +
                   du.Crossed(duv * direction.x() + dvv * direction.y());
  const double scale = std::max({du.SquareMagnitude(), dv.SquareMagnitude(), duu.SquareMagnitude(),
                                 dvv.SquareMagnitude(), duv.SquareMagnitude()}) *
                       direction.norm();
  const double length = n.Magnitude();
  return length > kSingularSine * scale ? toVec3(n / length) : Vec3(Vec3::Zero());
}

constexpr const char* kNoFace = "face %1 does not exist; the part has %2";
constexpr const char* kNoEdge = "edge %1 does not exist; the part has %2";

template <class Items>
const auto& itemAt(const Items& items, int index, const char* missing) {
  if (index < 0 || static_cast<std::size_t>(index) >= items.size()) {
    throw Error(ErrorCode::InvalidArgument,
                text(missing, {std::to_string(index), std::to_string(items.size())}));
  }
  return items[static_cast<std::size_t>(index)];
}

}  // namespace

std::unique_ptr<Brep::Impl> makeBrepImpl(const TopoDS_Shape& shape) {
  auto impl = std::make_unique<Brep::Impl>();
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    impl->faces.push_back(TopoDS::Face(faces.FindKey(i)));
    impl->faceInfos.push_back(faceInfo(impl->faces.back()));
  }
  TopTools_IndexedDataMapOfShapeListOfShape edges;
  TopExp::MapShapesAndAncestors(shape, TopAbs_EDGE, TopAbs_FACE, edges);
  for (int i = 1; i <= edges.Extent(); ++i) {
    const TopoDS_Edge edge = TopoDS::Edge(edges.FindKey(i).Oriented(TopAbs_FORWARD));
    if (hasCurve(edge)) {
      impl->edges.push_back(edge);
      impl->edgeInfos.push_back(edgeInfo(edge, distinctFaces(edges.FindFromIndex(i))));
    }
  }
  return impl;
}

Brep::Brep(std::unique_ptr<const Impl> impl) : impl_(std::move(impl)) {
  WCAM_ASSERT(impl_ != nullptr);
}

Brep::~Brep() = default;

int Brep::faceCount() const noexcept {
  return static_cast<int>(impl_->faces.size());
}

int Brep::edgeCount() const noexcept {
  return static_cast<int>(impl_->edges.size());
}

const BrepFaceInfo& Brep::face(int index) const {
  return itemAt(impl_->faceInfos, index, kNoFace);
}

const BrepEdgeInfo& Brep::edge(int index) const {
  return itemAt(impl_->edgeInfos, index, kNoEdge);
}

struct BrepEvaluator::Impl {
  explicit Impl(const Brep& b)
      : brep(&b), surfaces(b.impl().faces.size()), curves(b.impl().edges.size()) {}

  const BRepAdaptor_Surface& surface(int face) {
    const TopoDS_Face& shape = itemAt(brep->impl().faces, face, kNoFace);
    auto& adaptor = surfaces[static_cast<std::size_t>(face)];
    if (!adaptor) {
      // Unrestricted: a Newton step may leave the face for a moment.
      adaptor = std::make_unique<BRepAdaptor_Surface>(shape, Standard_False);
    }
    return *adaptor;
  }

  const BRepAdaptor_Curve& curve(int edge) {
    const TopoDS_Edge& shape = itemAt(brep->impl().edges, edge, kNoEdge);
    auto& adaptor = curves[static_cast<std::size_t>(edge)];
    if (!adaptor) {
      adaptor = std::make_unique<BRepAdaptor_Curve>(shape);
    }
    return *adaptor;
  }

  const Brep* brep;
  std::vector<std::unique_ptr<BRepAdaptor_Surface>> surfaces;
  std::vector<std::unique_ptr<BRepAdaptor_Curve>> curves;
};

BrepEvaluator::BrepEvaluator(const Brep& brep) : impl_(std::make_unique<Impl>(brep)) {}

BrepEvaluator::~BrepEvaluator() = default;
BrepEvaluator::BrepEvaluator(BrepEvaluator&&) noexcept = default;
BrepEvaluator& BrepEvaluator::operator=(BrepEvaluator&&) noexcept = default;

SurfacePoint BrepEvaluator::surface(int face, const Vec2& uv) const {
  gp_Pnt p;
  gp_Vec du, dv;
  impl_->surface(face).D1(uv.x(), uv.y(), p, du, dv);
  return {toVec3(p), toVec3(du), toVec3(dv)};
}

CurvePoint BrepEvaluator::curve(int edge, double t) const {
  gp_Pnt p;
  gp_Vec d1, d2;
  impl_->curve(edge).D2(t, p, d1, d2);
  return {toVec3(p), toVec3(d1), toVec3(d2)};
}

Vec3 BrepEvaluator::normal(int face, const Vec2& uv) const {
  return normal(face, uv, surface(face, uv));
}

Vec3 BrepEvaluator::normal(int face, const Vec2& uv, const SurfacePoint& point) const {
  Vec3 n = unitNormal(point.du, point.dv);
  const BrepFaceInfo& info = impl_->brep->face(face);
  if (n.isZero()) {
    const auto& bounds = info.uvBounds;
    const Vec2 middle(0.5 * (bounds[0] + bounds[1]), 0.5 * (bounds[2] + bounds[3]));
    const Vec2 inward = middle - uv;
    n = limitNormal(impl_->surface(face), uv, inward);
    if (n.isZero()) {
      const SurfacePoint inside = surface(face, uv + kInwardStep * inward);
      n = unitNormal(inside.du, inside.dv);
    }
  }
  return info.reversed ? Vec3(-n) : n;
}

}  // namespace wcam::geometry
