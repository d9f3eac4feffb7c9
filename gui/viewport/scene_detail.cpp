// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_impl.hpp"
#include "vtk_arrays.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPropCollection.h>
#include <vtkUnsignedCharArray.h>

#include <limits>
#include <numeric>

namespace wcam::viewport {

namespace {

/// What a line costs, in triangles.
constexpr double kLine = 0.1;
/// What is drawn first has to be copied to the graphics card as well.
constexpr double kNew = 2.0;

double sumOf(const std::vector<Drawable>& drawables) {
  return std::accumulate(drawables.begin(), drawables.end(), 0.0,
                         [](double sum, const Drawable& d) { return sum + d.triangles; });
}

}  // namespace

double Scene::Impl::trianglesOf(vtkProp* prop) const {
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* mapper = actor != nullptr ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  vtkPolyData* data = mapper != nullptr ? mapper->GetInput() : nullptr;
  if (data == nullptr) {
    return 0.0;
  }
  vtkCellArray* polygons = data->GetPolys();
  vtkCellArray* polylines = data->GetLines();
  const auto triangles = static_cast<double>(polygons->GetNumberOfConnectivityIds() -
                                             2 * polygons->GetNumberOfCells());
  const auto segments =
      static_cast<double>(polylines->GetNumberOfConnectivityIds() - polylines->GetNumberOfCells());
  return (triangles + kLine * segments) * (drawn.count(prop) != 0 ? 1.0 : kNew);
}

std::vector<Drawable> Scene::Impl::drawables(Detail detail, double most) const {
  std::vector<Drawable> all;
  double mixed = 0.0;
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at = nullptr;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at)) {
    if (prop->GetVisibility() == 0) {
      continue;
    }
    Drawable one;
    one.prop = prop;
    one.triangles = trianglesOf(prop);
    one.translucent = prop->HasTranslucentPolygonalGeometry() != 0;
    const auto own = details.find(prop);
    mixed += one.translucent && own != details.end() && own->second == detail ? one.triangles : 0.0;
    all.push_back(one);
  }
  const bool tooMuch = mixed > most;
  std::vector<Drawable> shown;
  for (const Drawable& one : all) {
    const auto own = details.find(one.prop);
    const Detail wanted = one.translucent && tooMuch ? Detail::Coarse : detail;
    if (own == details.end() || own->second == wanted) {
      shown.push_back(one);
    }
  }
  return shown;
}

void Scene::addSamples() {
  MeshData mesh;
  mesh.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  mesh.triangles = {0, 1, 2};
  mesh.edgePositions = {0, 0, 0, 1, 0, 0};
  mesh.edgeBegin = {0, 2};
  const auto add = [this](vtkPolyData* data, bool coloured, double opacity, bool lit) {
    vtkSmartPointer<vtkActor> actor = makeActor(data);
    if (coloured) {
      vtkNew<vtkUnsignedCharArray> colours;
      colours->SetNumberOfComponents(3);
      colours->SetNumberOfTuples(data->GetNumberOfPoints());
      colours->Fill(150);
      data->GetPointData()->SetScalars(colours);
    }
    actor->GetProperty()->SetOpacity(opacity);
    actor->GetProperty()->SetLighting(lit);
    actor->GetProperty()->SetLineWidth(2.0F);
    actor->SetUserMatrix(impl_->partPose);
    impl_->add(actor);
    impl_->samples.push_back(actor);
  };
  add(surfaceOf(mesh), true, 1.0, true);    // beads
  add(surfaceOf(mesh), false, 1.0, true);   // parts and substrates
  add(surfaceOf(mesh), false, 0.22, true);  // translucent parts
  add(edgesOf(mesh), true, 1.0, false);     // beads as lines
  add(edgesOf(mesh), false, 1.0, false);    // edges
  add(edgesOf(mesh), false, 0.5, false);    // edges of translucent parts
}

void Scene::removeSamples() {
  for (vtkActor* actor : impl_->samples) {
    impl_->remove(actor);
  }
  impl_->samples.clear();
}

double Scene::triangles(Detail detail) const {
  return sumOf(impl_->drawables(detail, std::numeric_limits<double>::infinity()));
}

double Scene::chooseAll(Detail detail) {
  impl_->portions.begin(impl_->drawables(detail, std::numeric_limits<double>::infinity()));
  return choosePortion(std::numeric_limits<double>::infinity());
}

void Scene::beginPortions(double capacity) {
  impl_->portions.begin(impl_->drawables(Detail::Fine, capacity));
}

double Scene::choosePortion(double capacity) {
  const double triangles = impl_->portions.next(capacity, impl_->culler->chosen);
  impl_->drawn.insert(impl_->culler->chosen.begin(), impl_->culler->chosen.end());
  return triangles;
}

bool Scene::portionsComplete() const {
  return impl_->portions.complete();
}

}  // namespace wcam::viewport
