// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "vtk_arrays.hpp"

#include <vtkPointData.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <cmath>

namespace wcam::viewport {

vtkSmartPointer<vtkFloatArray> vectorsOf(const std::vector<float>& values) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size() / 3));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  return array;
}

vtkSmartPointer<vtkPoints> pointsOf(const std::vector<float>& positions) {
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetData(vectorsOf(positions));
  return points;
}

namespace {

vtkSmartPointer<vtkTypeInt64Array> integersOf(const long long* values, std::size_t count) {
  auto array = vtkSmartPointer<vtkTypeInt64Array>::New();
  array->SetNumberOfValues(static_cast<vtkIdType>(count));
  std::copy(values, values + count, array->GetPointer(0));
  return array;
}

struct Vector {
  float x;
  float y;
  float z;
};

Vector triangleNormal(const MeshData& mesh, std::size_t t) {
  const float* a = &mesh.positions[3 * mesh.triangles[3 * t]];
  const float* b = &mesh.positions[3 * mesh.triangles[3 * t + 1]];
  const float* c = &mesh.positions[3 * mesh.triangles[3 * t + 2]];
  const Vector u = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const Vector v = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  // Not normalised: large triangles weigh more in the mean at a vertex.
  return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

Vector unit(const Vector& v) {
  const float length = std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z);
  return length > 0.0F ? Vector{v.x / length, v.y / length, v.z / length} : Vector{0, 0, 1};
}

}  // namespace

vtkSmartPointer<vtkCellArray> cellsOf(const std::vector<long long>& offsets,
                                      const std::vector<long long>& corners) {
  auto cells = vtkSmartPointer<vtkCellArray>::New();
  cells->SetData(integersOf(offsets.data(), offsets.size()),
                 integersOf(corners.data(), corners.size()));
  return cells;
}

vtkSmartPointer<vtkCellArray> cellRange(vtkCellArray* cells, std::size_t first, std::size_t last) {
  const long long* offsets = cells->GetOffsetsArray64()->GetPointer(0);
  const long long* corners = cells->GetConnectivityArray64()->GetPointer(0);
  std::vector<long long> own(offsets + first, offsets + last + 1);
  const long long base = own.front();
  for (long long& offset : own) {
    offset -= base;
  }
  auto part = vtkSmartPointer<vtkCellArray>::New();
  part->SetData(integersOf(own.data(), own.size()),
                integersOf(corners + base, static_cast<std::size_t>(own.back())));
  return part;
}

vtkSmartPointer<vtkPolyData> surfaceOf(const MeshData& mesh) {
  // Normals are averaged over the triangles of the same face around a vertex whose normals differ
  // by less than the crease angle. Corners of a vertex that get the same normal share it: most of
  // them do, and a renderer computes each vertex once.
  constexpr float kCrease = 0.8F;  // cosine of 37°
  const std::size_t count = mesh.triangles.size() / 3;
  std::vector<Vector> normals(count);
  for (std::size_t t = 0; t < count; ++t) {
    normals[t] = triangleNormal(mesh, t);
  }
  std::vector<std::uint32_t> first(mesh.positions.size() / 3 + 1, 0);
  for (const std::uint32_t v : mesh.triangles) {
    ++first[v + 1];
  }
  for (std::size_t v = 1; v < first.size(); ++v) {
    first[v] += first[v - 1];
  }
  std::vector<std::uint32_t> around(mesh.triangles.size());
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    around[fill[mesh.triangles[i]]++] = static_cast<std::uint32_t>(i / 3);
  }
  std::vector<float> positions;
  std::vector<float> cornerNormals;
  std::vector<long long> offsets = {0};
  std::vector<long long> corners;
  std::vector<long long> latest(mesh.positions.size() / 3, -1);  // vertex made last for a vertex
  std::vector<long long> before;  // per vertex made: the one before for the same vertex
  corners.reserve(mesh.triangles.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t v = mesh.triangles[i];
    const Vector own = unit(normals[i / 3]);
    Vector sum = {0, 0, 0};
    for (std::uint32_t k = first[v]; k < first[v + 1]; ++k) {
      const Vector other = unit(normals[around[k]]);
      const bool sameFace = mesh.faces.empty() || mesh.faces[around[k]] == mesh.faces[i / 3];
      if (sameFace && own.x * other.x + own.y * other.y + own.z * other.z > kCrease) {
        sum = {sum.x + normals[around[k]].x, sum.y + normals[around[k]].y,
               sum.z + normals[around[k]].z};
      }
    }
    const Vector n = unit(sum);
    const auto same = [&](long long made) {
      const float* old = &cornerNormals[3 * static_cast<std::size_t>(made)];
      return old[0] == n.x && old[1] == n.y && old[2] == n.z;
    };
    long long made = latest[v];
    while (made >= 0 && !same(made)) {
      made = before[static_cast<std::size_t>(made)];
    }
    if (made < 0) {
      made = static_cast<long long>(before.size());
      before.push_back(latest[v]);
      latest[v] = made;
      positions.insert(positions.end(), &mesh.positions[3 * v], &mesh.positions[3 * v] + 3);
      cornerNormals.insert(cornerNormals.end(), {n.x, n.y, n.z});
    }
    corners.push_back(made);
    if (i % 3 == 2) {
      offsets.push_back(static_cast<long long>(i + 1));
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(positions));
  data->SetPolys(cellsOf(offsets, corners));
  data->GetPointData()->SetNormals(vectorsOf(cornerNormals));
  return data;
}

vtkSmartPointer<vtkPolyData> edgesOf(const MeshData& mesh) {
  std::vector<long long> offsets(mesh.edgeBegin.begin(), mesh.edgeBegin.end());
  std::vector<long long> corners(mesh.edgePositions.size() / 3);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    corners[i] = static_cast<long long>(i);
  }
  if (offsets.empty()) {
    offsets.push_back(0);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(pointsOf(mesh.edgePositions));
  data->SetLines(cellsOf(offsets, corners));
  return data;
}

}  // namespace wcam::viewport
