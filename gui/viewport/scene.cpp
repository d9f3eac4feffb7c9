// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene.hpp"

#include "scene_impl.hpp"
#include "solids.hpp"
#include "vtk_arrays.hpp"

#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>

namespace wcam::viewport {

void setColour(vtkProperty* property, const Colour& colour) {
  property->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  // Lines come forward, so surfaces need not go back. A surface that does writes its own depth,
  // and then every hidden pixel of it is computed: with a software renderer most of the time.
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -2.0);
  actor->SetMapper(mapper);
  return actor;
}

Theme lightTheme() {
  return {{236, 240, 245}, {250, 251, 253}, {176, 190, 205},
          {52, 66, 82},    {158, 163, 170}, {30, 34, 40}};
}

Theme darkTheme() {
  return {{38, 43, 51},    {22, 25, 30},    {128, 146, 166},
          {205, 214, 224}, {104, 110, 118}, {225, 229, 235}};
}

Scene::Scene() : impl_(std::make_unique<Impl>()) {
  impl_->planes->AddItem(impl_->plane);
  impl_->renderer->AddCuller(impl_->culler);
  impl_->renderer->SetGradientBackground(true);
  impl_->renderer->UseFXAAOn();
  for (const Solid& solid : torchSolids()) {
    auto actor = makeActor(solidMesh(solid));
    setColour(actor->GetProperty(), solid.colour);
    actor->VisibilityOff();
    impl_->add(actor);
    impl_->torch.push_back(actor);
  }
  impl_->mark = makeActor(sphereMesh(1.0));
  impl_->mark->GetProperty()->SetColor(1.0, 0.25, 0.1);
  impl_->mark->GetProperty()->SetAmbient(0.6);
  impl_->mark->VisibilityOff();
  impl_->add(impl_->mark);
  setTheme(lightTheme());
}

Scene::~Scene() = default;

vtkRenderer* Scene::renderer() const {
  return impl_->renderer;
}

void Scene::setTheme(const Theme& theme) {
  impl_->theme = theme;
  const auto part = [](std::uint8_t c) { return c / 255.0; };
  impl_->renderer->SetBackground(part(theme.bottom[0]), part(theme.bottom[1]),
                                 part(theme.bottom[2]));
  impl_->renderer->SetBackground2(part(theme.top[0]), part(theme.top[1]), part(theme.top[2]));
  impl_->showParts();
  impl_->showSubstrate();
}

void Scene::setParts(std::vector<std::shared_ptr<const PreparedMesh>> parts) {
  for (PartItem& part : impl_->parts) {
    part.forSurface([this](vtkActor* actor) { impl_->remove(actor); });
    impl_->remove(part.edges);
  }
  impl_->parts.clear();
  setMarkedFaces({});
  setMarkedEdges({});
  for (std::shared_ptr<const PreparedMesh>& mesh : parts) {
    PartItem item;
    for (const vtkSmartPointer<vtkPolyData>& piece : mesh->pieces) {
      item.surface.push_back(makeActor(piece));
      impl_->place(item.surface.back());
      impl_->add(item.surface.back());
      if (mesh->coarse) {
        impl_->details[item.surface.back()] = Detail::Fine;
      }
    }
    if (mesh->coarse) {
      item.coarse = makeActor(mesh->coarse);
      impl_->place(item.coarse);
      impl_->add(item.coarse, Detail::Coarse);
    }
    if (mesh->edges) {
      item.edges = makeActor(mesh->edges);
      item.edges->GetProperty()->SetLineWidth(1.6F);
      item.edges->GetProperty()->SetLighting(false);
      impl_->place(item.edges);
      impl_->add(item.edges);
    }
    item.prepared = std::move(mesh);
    impl_->parts.push_back(std::move(item));
  }
  impl_->showParts();
}

void Scene::setPartStyle(PartStyle style) {
  impl_->partStyle = style;
  impl_->showParts();
}

void Scene::setSubstrate(std::shared_ptr<const PreparedMesh> mesh) {
  impl_->remove(impl_->substrate);
  impl_->remove(impl_->substrateEdges);
  impl_->substrate = nullptr;
  impl_->substrateEdges = nullptr;
  impl_->substrateMesh = mesh;
  if (!mesh) {
    return;
  }
  impl_->substrate = makeActor(mesh->surface);
  vtkNew<vtkPolyData> nothing;
  impl_->substrateEdges = makeActor(mesh->edges ? mesh->edges.Get() : nothing.Get());
  impl_->substrateEdges->GetProperty()->SetOpacity(0.4);
  for (vtkActor* actor : {impl_->substrate.Get(), impl_->substrateEdges.Get()}) {
    actor->SetUserMatrix(impl_->partPose);
    impl_->add(actor);
  }
  impl_->showSubstrate();
}

void Scene::setSubstrateVisible(bool visible) {
  impl_->substrateVisible = visible;
  impl_->showSubstrate();
}

void Scene::setMarkedFaces(const std::vector<std::pair<int, int>>& faces) {
  impl_->remove(impl_->markedFaces);
  impl_->markedFaces = nullptr;
  MeshData marked;
  for (const auto& [part, face] : faces) {
    if (part < 0 || part >= static_cast<int>(impl_->parts.size())) {
      continue;
    }
    const MeshData& mesh = impl_->parts[static_cast<std::size_t>(part)].prepared->mesh;
    for (std::size_t t = 0; t < mesh.faces.size(); ++t) {
      if (mesh.faces[t] == face) {
        for (int c = 0; c < 3; ++c) {
          const float* p = &mesh.positions[3 * mesh.triangles[3 * t + c]];
          marked.triangles.push_back(static_cast<std::uint32_t>(marked.positions.size() / 3));
          marked.positions.insert(marked.positions.end(), p, p + 3);
        }
      }
    }
  }
  if (marked.empty()) {
    return;
  }
  impl_->markedFaces = makeActor(surfaceOf(marked));
  impl_->markedFaces->GetProperty()->SetColor(1.0, 0.6, 0.1);
  impl_->markedFaces->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-4.0, -4.0);
  impl_->place(impl_->markedFaces);
  impl_->add(impl_->markedFaces);
}

void Scene::setMarkedEdges(const std::vector<std::pair<int, int>>& edges) {
  impl_->remove(impl_->markedEdges);
  impl_->markedEdges = nullptr;
  MeshData marked;
  marked.edgeBegin.push_back(0);
  for (const auto& [part, edge] : edges) {
    if (part < 0 || part >= static_cast<int>(impl_->parts.size())) {
      continue;
    }
    const MeshData& mesh = impl_->parts[static_cast<std::size_t>(part)].prepared->mesh;
    for (std::size_t e = 0; e + 1 < mesh.edgeBegin.size(); ++e) {
      if (mesh.edgeIds[e] == edge) {
        marked.edgePositions.insert(marked.edgePositions.end(),
                                    mesh.edgePositions.begin() + 3 * mesh.edgeBegin[e],
                                    mesh.edgePositions.begin() + 3 * mesh.edgeBegin[e + 1]);
        marked.edgeBegin.push_back(static_cast<std::uint32_t>(marked.edgePositions.size() / 3));
      }
    }
  }
  if (marked.edgePositions.empty()) {
    return;
  }
  impl_->markedEdges = makeActor(edgesOf(marked));
  impl_->markedEdges->GetProperty()->SetColor(1.0, 0.55, 0.05);
  impl_->markedEdges->GetProperty()->SetLineWidth(4.0F);
  impl_->markedEdges->GetProperty()->SetLighting(false);
  impl_->place(impl_->markedEdges);
  impl_->add(impl_->markedEdges);
}

void Scene::setMark(std::optional<Point> position) {
  impl_->mark->SetVisibility(position.has_value());
  if (position) {
    impl_->mark->SetUserMatrix(impl_->partPose);
    impl_->mark->SetPosition(position->data());
    const std::array<double, 6> box = bounds();
    const double size = std::max({box[1] - box[0], box[3] - box[2], box[5] - box[4], 1.0});
    impl_->mark->SetScale(0.012 * size);
  }
}

void Scene::setBodies(const std::vector<Body>& bodies) {
  for (const auto& actors : impl_->bodies) {
    for (vtkActor* actor : actors) {
      impl_->remove(actor);
    }
  }
  impl_->bodies.clear();
  impl_->surroundings.clear();
  for (const Body& body : bodies) {
    std::vector<vtkSmartPointer<vtkActor>> actors;
    const bool surroundings = body.name == "world";
    const auto addActor = [&](vtkPolyData* data, const Colour& colour) {
      auto actor = makeActor(data);
      // What stands around must not hide what is built.
      actor->GetProperty()->SetOpacity(surroundings ? 0.25 : 1.0);
      setColour(actor->GetProperty(), colour);
      actor->GetProperty()->SetSpecular(0.25);
      actor->GetProperty()->SetSpecularPower(25.0);
      actor->GetProperty()->SetAmbient(0.3);
      actor->SetVisibility(impl_->bodiesVisible);
      impl_->add(actor);
      actors.push_back(actor);
    };
    for (const Solid& solid : body.solids) {
      addActor(solidMesh(solid), solid.colour);
    }
    for (const MeshData& mesh : body.meshes) {
      addActor(surfaceOf(mesh), body.meshColour);
    }
    impl_->bodies.push_back(std::move(actors));
    impl_->surroundings.push_back(surroundings);
  }
}

void Scene::setBodyPoses(const std::vector<Matrix>& poses) {
  for (std::size_t i = 0; i < poses.size() && i < impl_->bodies.size(); ++i) {
    vtkNew<vtkMatrix4x4> matrix;
    matrix->DeepCopy(poses[i].data());
    for (vtkActor* actor : impl_->bodies[i]) {
      actor->SetUserMatrix(matrix);
    }
  }
}

void Scene::setBodiesVisible(bool visible) {
  impl_->bodiesVisible = visible;
  for (const auto& actors : impl_->bodies) {
    for (vtkActor* actor : actors) {
      actor->SetVisibility(visible);
    }
  }
}

void Scene::setTorch(std::optional<Matrix> pose) {
  for (vtkActor* actor : impl_->torch) {
    actor->SetVisibility(pose.has_value());
    if (pose) {
      vtkNew<vtkMatrix4x4> own;
      own->DeepCopy(pose->data());
      vtkNew<vtkMatrix4x4> matrix;
      vtkMatrix4x4::Multiply4x4(impl_->partPose, own, matrix);
      actor->SetUserMatrix(matrix);
    }
  }
}

void Scene::setPartPose(const Matrix& pose) {
  impl_->partPose->DeepCopy(pose.data());
}

void Scene::setSection(bool on, const Point& origin, const Point& normal) {
  impl_->section = on;
  impl_->plane->SetOrigin(origin.data());
  impl_->plane->SetNormal(normal.data());
  impl_->forBuilt([this](vtkActor* actor) { impl_->applySection(actor); });
}

void Scene::setMeasure(std::optional<std::pair<Point, Point>> ends, const std::string& text) {
  impl_->remove(impl_->measureLine);
  impl_->remove(impl_->measureText);
  impl_->measureLine = nullptr;
  impl_->measureText = nullptr;
  if (!ends) {
    return;
  }
  MeshData line;
  for (const Point& p : {ends->first, ends->second}) {
    for (const double c : p) {
      line.edgePositions.push_back(static_cast<float>(c));
    }
  }
  line.edgeBegin = {0, 2};
  impl_->measureLine = makeActor(edgesOf(line));
  impl_->measureLine->GetProperty()->SetColor(0.85, 0.1, 0.5);
  impl_->measureLine->GetProperty()->SetLineWidth(3.0F);
  impl_->measureLine->GetProperty()->SetLighting(false);
  impl_->add(impl_->measureLine);
  impl_->measureText = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  impl_->measureText->SetInput(text.c_str());
  impl_->measureText->SetPosition(0.5 * (ends->first[0] + ends->second[0]),
                                  0.5 * (ends->first[1] + ends->second[1]),
                                  0.5 * (ends->first[2] + ends->second[2]));
  impl_->measureText->GetTextProperty()->SetFontSize(18);
  impl_->measureText->GetTextProperty()->SetColor(0.85, 0.1, 0.5);
  impl_->measureText->GetTextProperty()->BoldOn();
  impl_->renderer->AddActor(impl_->measureText);
}

std::vector<std::array<double, 6>> Scene::obstacles(const Point& point) const {
  std::vector<std::array<double, 6>> boxes;
  for (std::size_t i = 0; i < impl_->bodies.size() && impl_->bodiesVisible; ++i) {
    for (vtkActor* actor : impl_->bodies[i]) {
      const double* own = actor->GetBounds();
      if (impl_->surroundings[i] || own == nullptr || own[0] > own[1]) {
        continue;
      }
      const std::array<double, 6> box = {own[0], own[1], own[2], own[3], own[4], own[5]};
      bool holds = true;
      for (std::size_t k = 0; k < 3; ++k) {
        holds = holds && point[k] >= box[2 * k] && point[k] <= box[2 * k + 1];
      }
      if (!holds) {
        boxes.push_back(box);
      }
    }
  }
  return boxes;
}

std::array<double, 6> Scene::bounds() const {
  std::array<double, 6> box = {1.0, -1.0, 1.0, -1.0, 1.0, -1.0};
  bool empty = true;
  const auto grow = [&](vtkActor* actor) {
    const double* own = actor != nullptr ? actor->GetBounds() : nullptr;
    if (own == nullptr || own[0] > own[1]) {
      return;
    }
    for (int i = 0; i < 6; i += 2) {
      box[i] = empty ? own[i] : std::min(box[i], own[i]);
      box[i + 1] = empty ? own[i + 1] : std::max(box[i + 1], own[i + 1]);
    }
    empty = false;
  };
  for (const PartItem& part : impl_->parts) {
    part.forSurface(grow);
  }
  for (const auto* list : {&impl_->fine, &impl_->coarse}) {
    for (const Chunk& chunk : *list) {
      grow(chunk.actor);
    }
  }
  if (empty || impl_->bodiesVisible) {
    grow(impl_->substrate);
  }
  if (impl_->bodiesVisible) {
    for (std::size_t i = 0; i < impl_->bodies.size(); ++i) {
      for (vtkActor* actor : impl_->bodies[i]) {
        grow(impl_->surroundings[i] ? nullptr : actor);
      }
    }
  }
  return box;
}

}  // namespace wcam::viewport
