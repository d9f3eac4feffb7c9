// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "cad_mesh.hpp"

#include "occt_session.hpp"
#include <BRepAdaptor_Surface.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Vertex.hxx>

#include <algorithm>
#include <cstdint>
#include <unordered_map>
#include <utility>

namespace wcam::io {

namespace {

using geometry::Vec2;
using geometry::Vec3;

constexpr std::uint32_t kNone = geometry::HalfEdges::kNone;

Vec3 toVec3(const gp_Pnt& p) {
  return {p.X(), p.Y(), p.Z()};
}

/// Two neighbouring nodes of a face's triangulation on a CAD edge.
struct Segment {
  std::int32_t edge = -1;
  int firstNode = 0;
  double firstParameter = 0.0;
  double secondParameter = 0.0;
};

std::uint64_t segmentKey(int a, int b) {
  const auto [low, high] = std::minmax(a, b);
  return (static_cast<std::uint64_t>(low) << 32U) | static_cast<std::uint32_t>(high);
}

/// Distance within which a border node counts as lying on its surface, mm.
constexpr double kOnSurface = 1e-10;
constexpr int kMaxSteps = 4;
/// Smallest usable sine between the derivatives of a surface.
constexpr double kSmallestSine = 1e-6;

/// Parameters of the surface point nearest to p, by Gauss-Newton from uv: borders lie on their
/// faces only within the tolerance of the file. Never farther away than uv.
Vec2 footPoint(const BRepAdaptor_Surface& surface, Vec2 uv, const Vec3& p) {
  gp_Pnt q;
  gp_Vec su, sv;
  surface.D1(uv.x(), uv.y(), q, su, sv);
  double distance = (toVec3(q) - p).norm();
  for (int step = 0; step < kMaxSteps && distance > kOnSurface; ++step) {
    const double a = su.SquareMagnitude();
    const double b = su.Dot(sv);
    const double c = sv.SquareMagnitude();
    const double determinant = a * c - b * b;
    if (!(determinant > kSmallestSine * kSmallestSine * a * c)) {
      break;
    }
    const gp_Vec gap(p.x() - q.X(), p.y() - q.Y(), p.z() - q.Z());
    const double gu = su.Dot(gap);
    const double gv = sv.Dot(gap);
    const Vec2 next = uv + Vec2((c * gu - b * gv) / determinant, (a * gv - b * gu) / determinant);
    surface.D1(next.x(), next.y(), q, su, sv);
    const double nextDistance = (toVec3(q) - p).norm();
    if (!(nextDistance < distance)) {
      break;
    }
    distance = nextDistance;
    uv = next;
  }
  return uv;
}

class MeshBuilder {
public:
  MeshBuilder(const TopoDS_Shape& shape, const geometry::Brep::Impl& brep, CadMesh& result)
      : brep_(brep), result_(result) {
    TopExp::MapShapes(shape, TopAbs_VERTEX, vertexShapes_);
    vertexIndex_.assign(static_cast<std::size_t>(vertexShapes_.Extent()) + 1, kNone);
    for (const TopoDS_Edge& edge : brep.edges) {
      edgeShapes_.Add(edge);
    }
    edgePoints_.resize(brep.edges.size());
  }

  void addFace(int index) {
    const TopoDS_Face face =
        TopoDS::Face(brep_.faces[static_cast<std::size_t>(index)].Oriented(TopAbs_FORWARD));
    TopLoc_Location location;
    const Handle(Poly_Triangulation)& triangulation = BRep_Tool::Triangulation(face, location);
    if (triangulation.IsNull() || triangulation->NbTriangles() == 0 ||
        !triangulation->HasUVNodes()) {
      result_.unmeshedFaces.push_back(index);
      return;
    }
    nodes_.assign(static_cast<std::size_t>(triangulation->NbNodes()) + 1, kNone);
    pole_.assign(nodes_.size(), false);
    segments_.clear();
    for (TopExp_Explorer it(face, TopAbs_EDGE); it.More(); it.Next()) {
      joinEdge(TopoDS::Edge(it.Current()), *triangulation, triangulation, location);
    }
    placeNodes(face, *triangulation, location);
    const bool reversed = brep_.faceInfos[static_cast<std::size_t>(index)].reversed;
    for (int t = 1; t <= triangulation->NbTriangles(); ++t) {
      addTriangle(index, *triangulation, t, reversed);
    }
  }

private:
  std::uint32_t& node(int n) { return nodes_[static_cast<std::size_t>(n)]; }

  std::uint32_t addVertex(const Vec3& p) {
    result_.mesh.vertices.push_back(p);
    return static_cast<std::uint32_t>(result_.mesh.vertices.size() - 1);
  }

  std::uint32_t vertexOf(const TopoDS_Vertex& vertex) {
    const int shape = vertexShapes_.FindIndex(vertex);
    std::uint32_t& index = vertexIndex_[static_cast<std::size_t>(shape)];
    if (index == kNone) {
      index = addVertex(toVec3(BRep_Tool::Pnt(vertex)));
    }
    return index;
  }

  /// Gives the face's nodes on one edge the vertices that all faces of the edge share.
  void joinEdge(const TopoDS_Edge& edge,
                const Poly_Triangulation& nodes,
                const Handle(Poly_Triangulation) & triangulation,
                const TopLoc_Location& location) {
    const Handle(Poly_PolygonOnTriangulation)& polygon =
        BRep_Tool::PolygonOnTriangulation(edge, triangulation, location);
    if (polygon.IsNull()) {
      return;
    }
    const int count = polygon->NbNodes();
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    const TopoDS_Vertex first = TopExp::FirstVertex(forward);
    const TopoDS_Vertex last = TopExp::LastVertex(forward);
    if (BRep_Tool::Degenerated(edge)) {
      for (int k = 1; k <= count && !first.IsNull(); ++k) {
        node(polygon->Node(k)) = vertexOf(first);
        pole_[static_cast<std::size_t>(polygon->Node(k))] = true;
      }
      return;
    }
    const int shape = edgeShapes_.FindIndex(forward);
    if (shape == 0) {
      return;
    }
    const auto index = static_cast<std::size_t>(shape - 1);
    std::vector<std::uint32_t>& points = edgePoints_[index];
    if (points.empty()) {
      points.assign(static_cast<std::size_t>(count), kNone);
      for (int k = 2; k < count; ++k) {
        points[static_cast<std::size_t>(k - 1)] =
            addVertex(toVec3(nodes.Node(polygon->Node(k)).Transformed(location)));
      }
      setEnd(points.front(), first, nodes, polygon->Node(1), location);
      setEnd(points.back(), last, nodes, polygon->Node(count), location);
    }
    if (points.size() != static_cast<std::size_t>(count)) {
      return;  // divided differently in two faces: stays open and is reported as such
    }
    for (int k = 1; k <= count; ++k) {
      node(polygon->Node(k)) = points[static_cast<std::size_t>(k - 1)];
    }
    addSegments(*polygon, static_cast<std::int32_t>(index));
  }

  void setEnd(std::uint32_t& point,
              const TopoDS_Vertex& vertex,
              const Poly_Triangulation& nodes,
              int nodeIndex,
              const TopLoc_Location& location) {
    point = vertex.IsNull() ? addVertex(toVec3(nodes.Node(nodeIndex).Transformed(location)))
                            : vertexOf(vertex);
  }

  /// Vertices of the nodes inside the face, and (u,v) of all nodes.
  void placeNodes(const TopoDS_Face& face,
                  const Poly_Triangulation& triangulation,
                  const TopLoc_Location& location) {
    const BRepAdaptor_Surface surface(face, Standard_False);
    uFreeAtPole_.assign(nodes_.size(), false);
    uv_.resize(nodes_.size());
    for (int n = 1; n <= triangulation.NbNodes(); ++n) {
      const gp_Pnt2d stored = triangulation.UVNode(n);
      Vec2& uv = uv_[static_cast<std::size_t>(n)];
      uv = Vec2(stored.X(), stored.Y());
      if (node(n) == kNone) {
        node(n) = addVertex(toVec3(triangulation.Node(n).Transformed(location)));
      } else if (!pole_[static_cast<std::size_t>(n)]) {
        uv = footPoint(surface, uv, result_.mesh.vertices[node(n)]);
      } else {
        gp_Pnt q;
        gp_Vec su, sv;
        surface.D1(uv.x(), uv.y(), q, su, sv);
        uFreeAtPole_[static_cast<std::size_t>(n)] = su.SquareMagnitude() < sv.SquareMagnitude();
      }
    }
  }

  /// At a pole one parameter is free; the mean of the other corners' keeps the triangle's (u,v) in
  /// its own sector.
  void freePoleParameters(const std::array<int, 3>& n, std::array<Vec2, 3>& uv) const {
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = static_cast<std::size_t>(n[c]);
      if (pole_[at]) {
        const int free = uFreeAtPole_[at] ? 0 : 1;
        uv[c][free] = 0.5 * (uv[(c + 1) % 3][free] + uv[(c + 2) % 3][free]);
      }
    }
  }

  void addSegments(const Poly_PolygonOnTriangulation& polygon, std::int32_t edge) {
    if (!polygon.HasParameters()) {
      return;
    }
    for (int k = 1; k < polygon.NbNodes(); ++k) {
      segments_[segmentKey(polygon.Node(k), polygon.Node(k + 1))] = {
          edge, polygon.Node(k), polygon.Parameter(k), polygon.Parameter(k + 1)};
    }
  }

  void addTriangle(int face, const Poly_Triangulation& triangulation, int t, bool reversed) {
    std::array<int, 3> n{};
    triangulation.Triangle(t).Get(n[0], n[1], n[2]);
    if (reversed) {
      std::swap(n[1], n[2]);
    }
    const std::array<std::uint32_t, 3> triangle = {node(n[0]), node(n[1]), node(n[2])};
    if (triangle[0] == triangle[1] || triangle[1] == triangle[2] || triangle[2] == triangle[0]) {
      return;  // collapsed at a pole
    }
    geometry::BrepBinding& binding = result_.binding;
    result_.mesh.triangles.push_back(triangle);
    binding.face.push_back(face);
    std::array<Vec2, 3> uv;
    for (std::size_t c = 0; c < 3; ++c) {
      uv[c] = uv_[static_cast<std::size_t>(n[c])];
      const int from = n[c];
      const auto it = segments_.find(segmentKey(from, n[(c + 1) % 3]));
      if (it == segments_.end()) {
        binding.edge.push_back(-1);
        binding.edgeParam.push_back({0.0, 0.0});
      } else {
        const Segment& s = it->second;
        const bool forward = s.firstNode == from;
        binding.edge.push_back(s.edge);
        binding.edgeParam.push_back({forward ? s.firstParameter : s.secondParameter,
                                     forward ? s.secondParameter : s.firstParameter});
      }
    }
    freePoleParameters(n, uv);
    binding.uv.push_back(uv);
  }

  const geometry::Brep::Impl& brep_;
  CadMesh& result_;
  TopTools_IndexedMapOfShape vertexShapes_;
  TopTools_IndexedMapOfShape edgeShapes_;
  std::vector<std::uint32_t> vertexIndex_;              ///< mesh vertex per TopoDS_Vertex
  std::vector<std::vector<std::uint32_t>> edgePoints_;  ///< mesh vertices along each CAD edge
  std::vector<std::uint32_t> nodes_;                    ///< mesh vertex per node of this face
  std::vector<Vec2> uv_;                                ///< per node of this face
  std::vector<bool> pole_;                              ///< per node: on a degenerated edge
  std::vector<bool> uFreeAtPole_;                       ///< per pole node: u is free, else v
  std::unordered_map<std::uint64_t, Segment> segments_;
};

}  // namespace

CadMesh meshShape(const TopoDS_Shape& shape,
                  const geometry::Brep::Impl& brep,
                  double chord,
                  double angle,
                  const JobContext& context) {
  BRepTools::Clean(shape);
  IMeshTools_Parameters parameters;
  parameters.Deflection = chord;
  parameters.Angle = angle;
  parameters.InParallel = Standard_False;
  parameters.Relative = Standard_False;
  const Handle(OcctProgress) progress = new OcctProgress(context.portion(0.0, 0.9));
  const BRepMesh_IncrementalMesh mesher(shape, parameters, progress->Start());
  context.check();
  CadMesh result;
  MeshBuilder builder(shape, brep, result);
  for (int face = 0; face < static_cast<int>(brep.faces.size()); ++face) {
    context.check();
    builder.addFace(face);
  }
  return result;
}

}  // namespace wcam::io
