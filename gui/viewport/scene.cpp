// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene.hpp"

#include "prepared_vtk.hpp"
#include "solids.hpp"
#include "vtk_arrays.hpp"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkCellArray.h>
#include <vtkGenericCell.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace wcam::viewport {

namespace {

void setColour(vtkProperty* property, const Colour& colour) {
  property->SetColor(colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0);
}

vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  actor->SetMapper(mapper);
  return actor;
}

}  // namespace

Theme lightTheme() {
  return {{236, 240, 245}, {250, 251, 253}, {176, 190, 205},
          {52, 66, 82},    {158, 163, 170}, {30, 34, 40}};
}

Theme darkTheme() {
  return {{38, 43, 51},    {22, 25, 30},    {128, 146, 166},
          {205, 214, 224}, {104, 110, 118}, {225, 229, 235}};
}

namespace {

/// A chunk of the path in the scene: what it shows at present.
struct Chunk {
  PreparedChunk* prepared = nullptr;
  vtkSmartPointer<vtkActor> actor;
  std::size_t shownBegin = 0;
  std::size_t shownEnd = 0;
};

struct PartItem {
  std::shared_ptr<const PreparedMesh> prepared;
  vtkSmartPointer<vtkActor> surface;
  vtkSmartPointer<vtkActor> edges;
};

}  // namespace

struct Scene::Impl {
  vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::New();
  Theme theme = lightTheme();
  vtkNew<vtkMatrix4x4> partPose;

  std::vector<PartItem> parts;
  PartStyle partStyle = PartStyle::Solid;
  vtkSmartPointer<vtkActor> substrate;
  vtkSmartPointer<vtkActor> substrateEdges;
  bool substrateVisible = true;
  vtkSmartPointer<vtkActor> markedFaces;
  vtkSmartPointer<vtkActor> markedEdges;

  std::shared_ptr<PreparedPath> path;
  std::vector<Chunk> solids;
  std::vector<Chunk> lines;
  std::vector<Chunk> travel;
  std::vector<std::uint8_t> colours;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool travelVisible = false;
  bool stale = false;
  bool coarse = false;
  std::size_t uploads = 0;

  vtkSmartPointer<vtkActor> mark;
  std::vector<std::vector<vtkSmartPointer<vtkActor>>> bodies;
  std::vector<bool>
      surroundings;  ///< per body: floor and fences, left out when everything is fitted
  bool bodiesVisible = false;
  std::vector<vtkSmartPointer<vtkActor>> torch;
  bool torchShown = false;

  vtkNew<vtkPlane> plane;
  vtkNew<vtkPlaneCollection> planes;
  bool section = false;

  vtkSmartPointer<vtkActor> measureLine;
  vtkSmartPointer<vtkBillboardTextActor3D> measureText;

  [[nodiscard]] bool asLines() const { return path && path->onlyLines(); }

  void add(vtkActor* actor) { renderer->AddActor(actor); }

  void remove(vtkProp* actor) {
    if (actor != nullptr) {
      renderer->RemoveActor(actor);
    }
  }

  void place(vtkActor* actor) {
    actor->SetUserMatrix(partPose);
    applySection(actor);
  }

  void applySection(vtkActor* actor) {
    actor->GetMapper()->RemoveAllClippingPlanes();
    if (section) {
      actor->GetMapper()->SetClippingPlanes(planes);
    }
  }

  template <class Visit>
  void forBuilt(const Visit& visit) {
    for (PartItem& part : parts) {
      visit(part.surface.Get());
      if (part.edges) {
        visit(part.edges.Get());
      }
    }
    for (auto* list : {&solids, &lines, &travel}) {
      for (Chunk& chunk : *list) {
        visit(chunk.actor.Get());
      }
    }
    for (vtkActor* actor : {markedFaces.Get(), markedEdges.Get()}) {
      if (actor != nullptr) {
        visit(actor);
      }
    }
  }

  void showParts() {
    for (PartItem& part : parts) {
      part.surface->SetVisibility(partStyle == PartStyle::Solid ||
                                  partStyle == PartStyle::Translucent);
      vtkProperty* property = part.surface->GetProperty();
      setColour(property, theme.part);
      property->SetOpacity(partStyle == PartStyle::Translucent ? 0.22 : 1.0);
      property->SetAmbient(0.18);
      property->SetDiffuse(0.82);
      property->SetSpecular(0.12);
      property->SetSpecularPower(20.0);
      if (part.edges) {
        part.edges->SetVisibility(partStyle != PartStyle::Hidden);
        setColour(part.edges->GetProperty(), theme.edge);
        part.edges->GetProperty()->SetOpacity(partStyle == PartStyle::Solid ? 1.0 : 0.55);
      }
    }
  }

  void showSubstrate() {
    if (substrate) {
      substrate->SetVisibility(substrateVisible);
      setColour(substrate->GetProperty(), theme.substrate);
      // The light comes from the eye, which looks along the plate: without this it would be dark.
      substrate->GetProperty()->SetAmbient(0.5);
      substrate->GetProperty()->SetDiffuse(0.6);
      substrateEdges->SetVisibility(substrateVisible);
      setColour(substrateEdges->GetProperty(), theme.edge);
    }
  }

  void colour(Chunk& chunk) {
    const PreparedChunk& prepared = *chunk.prepared;
    const std::size_t count = prepared.moveOfVertex.size();
    vtkPointData* values = prepared.data->GetPointData();
    auto* scalars = vtkUnsignedCharArray::SafeDownCast(values->GetScalars());
    if (scalars == nullptr) {
      vtkNew<vtkUnsignedCharArray> made;
      made->SetNumberOfComponents(3);
      made->SetNumberOfTuples(static_cast<vtkIdType>(count));
      values->SetScalars(made);
      scalars = made;
    }
    std::uint8_t* out = scalars->GetPointer(0);
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t move = prepared.moveOfVertex[i];
      for (std::size_t c = 0; c < 3; ++c) {
        int value = 3 * move + 2 < colours.size() ? colours[3 * move + c] : 150;
        if (stale) {
          value = 150 + (value - 150) / 5;
        }
        out[3 * i + c] = static_cast<std::uint8_t>(value);
      }
    }
    scalars->Modified();
    prepared.data->Modified();
  }

  void clear(std::vector<Chunk>& chunks) {
    for (Chunk& chunk : chunks) {
      remove(chunk.actor);
    }
    chunks.clear();
  }

  /// Puts prepared chunks into the scene.
  void addChunks(std::vector<PreparedChunk>& prepared, std::vector<Chunk>& chunks) {
    for (PreparedChunk& one : prepared) {
      Chunk chunk;
      chunk.prepared = &one;
      chunk.shownBegin = one.range.begin;
      chunk.shownEnd = one.range.end;
      // It may have been in the scene before.
      setCells(one, one.all);
      chunk.actor = makeActor(one.data);
      place(chunk.actor);
      add(chunk.actor);
      chunks.push_back(chunk);
    }
  }

  static void setCells(PreparedChunk& chunk, vtkCellArray* cells) {
    if (chunk.isLines) {
      chunk.data->SetLines(cells);
    } else {
      chunk.data->SetPolys(cells);
    }
    chunk.data->Modified();
  }

  void makeSolids() {
    if (path->solids.empty()) {
      path->solids = prepareChunks(*path->data, ChunkKind::Solid);
    }
    addChunks(path->solids, solids);
    for (Chunk& chunk : solids) {
      vtkProperty* property = chunk.actor->GetProperty();
      property->SetAmbient(0.22);
      property->SetDiffuse(0.8);
      property->SetSpecular(0.1);
      property->SetSpecularPower(12.0);
      colour(chunk);
    }
  }

  void makeLines() {
    if (path->lines.empty()) {
      path->lines = prepareChunks(*path->data, ChunkKind::Lines);
    }
    addChunks(path->lines, lines);
    for (Chunk& chunk : lines) {
      chunk.actor->GetProperty()->SetLineWidth(2.0F);
      chunk.actor->GetProperty()->SetLighting(false);
      colour(chunk);
    }
  }

  void makeTravel() {
    if (path->travel.empty()) {
      path->travel = prepareChunks(*path->data, ChunkKind::Travel);
    }
    addChunks(path->travel, travel);
    for (Chunk& chunk : travel) {
      vtkProperty* property = chunk.actor->GetProperty();
      property->SetLineWidth(1.0F);
      property->SetLighting(false);
      property->SetColor(0.85, 0.45, 0.1);
      property->SetOpacity(0.7);
    }
  }

  /// Shows the moves of a chunk that lie in [begin, end): the rest is left out of its cells.
  void show(Chunk& chunk, bool wanted) {
    PreparedChunk& prepared = *chunk.prepared;
    const ChunkRange& range = prepared.range;
    const std::size_t from = std::clamp(begin, range.begin, range.end);
    const std::size_t to = std::clamp(end, range.begin, range.end);
    chunk.actor->SetVisibility(wanted && from < to);
    if (!wanted || from >= to || (from == chunk.shownBegin && to == chunk.shownEnd)) {
      return;
    }
    chunk.shownBegin = from;
    chunk.shownEnd = to;
    if (from == range.begin && to == range.end) {
      setCells(prepared, prepared.all);
    } else {
      const std::size_t first =
          from == range.begin ? 0 : prepared.cellsUpTo[from - range.begin - 1];
      setCells(prepared, cellRange(prepared.all, first, prepared.cellsUpTo[to - range.begin - 1]));
    }
    ++uploads;
  }

  void showPath() {
    if (!path) {
      return;
    }
    const bool useLines = asLines() || coarse;
    if (useLines && lines.empty()) {
      makeLines();
    }
    if (!useLines && solids.empty()) {
      makeSolids();
    }
    if (travelVisible && travel.empty()) {
      makeTravel();
    }
    for (Chunk& chunk : solids) {
      show(chunk, !useLines);
    }
    for (Chunk& chunk : lines) {
      show(chunk, useLines);
    }
    for (Chunk& chunk : travel) {
      show(chunk, travelVisible);
    }
  }
};

Scene::Scene() : impl_(std::make_unique<Impl>()) {
  impl_->planes->AddItem(impl_->plane);
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
    impl_->remove(part.surface);
    impl_->remove(part.edges);
  }
  impl_->parts.clear();
  setMarkedFaces({});
  setMarkedEdges({});
  for (std::shared_ptr<const PreparedMesh>& mesh : parts) {
    PartItem item;
    item.surface = makeActor(mesh->surface);
    impl_->place(item.surface);
    impl_->add(item.surface);
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
  impl_->markedFaces->GetMapper()->SetRelativeCoincidentTopologyPolygonOffsetParameters(-2.0, -2.0);
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

void Scene::setPath(std::shared_ptr<PreparedPath> path) {
  impl_->clear(impl_->solids);
  impl_->clear(impl_->lines);
  impl_->clear(impl_->travel);
  impl_->path = std::move(path);
  impl_->colours.clear();
  impl_->begin = 0;
  impl_->end = impl_->path ? impl_->path->data->size() : 0;
  impl_->showPath();
}

void Scene::setPathColours(const std::vector<std::uint8_t>& colours) {
  impl_->colours = colours;
  for (auto* list : {&impl_->solids, &impl_->lines}) {
    for (Chunk& chunk : *list) {
      impl_->colour(chunk);
    }
  }
}

void Scene::setRange(std::size_t begin, std::size_t end) {
  impl_->begin = begin;
  impl_->end = end;
  impl_->showPath();
}

void Scene::setTravelVisible(bool visible) {
  impl_->travelVisible = visible;
  impl_->showPath();
}

void Scene::setStale(bool stale) {
  if (stale != impl_->stale) {
    impl_->stale = stale;
    setPathColours(std::vector<std::uint8_t>(impl_->colours));
  }
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

void Scene::setCoarse(bool coarse) {
  if (coarse != impl_->coarse) {
    impl_->coarse = coarse;
    impl_->showPath();
  }
}

bool Scene::drawsLines() const {
  return impl_->asLines();
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
    grow(part.surface);
  }
  for (const auto* list : {&impl_->solids, &impl_->lines}) {
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

std::size_t Scene::uploads() const {
  return impl_->uploads;
}

// --- picking

namespace {

/// Pixel and depth of a point, or nothing when it lies behind the eye.
struct Projector {
  explicit Projector(const Scene::Ray& r, const Matrix& partPose) : ray(r) {
    for (int i = 0; i < 4; ++i) {
      for (int j = 0; j < 4; ++j) {
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) {
          sum += r.worldToClip[4 * i + k] * partPose[4 * k + j];
        }
        m[4 * i + j] = sum;
      }
    }
  }

  bool operator()(const float* p, double& x, double& y, double& depth) const {
    const auto row = [&](int i) {
      return m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
    };
    const double w = row(3);
    if (w <= 0.0) {
      return false;
    }
    x = (row(0) / w + 1.0) * 0.5 * ray.width;
    y = (row(1) / w + 1.0) * 0.5 * ray.height;
    depth = row(2) / w;
    return depth >= -1.0 && depth <= 1.0;
  }

  const Scene::Ray& ray;
  Matrix m{};
};

Matrix valuesOf(const vtkMatrix4x4* matrix) {
  Matrix values{};
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      values[4 * i + j] = matrix->GetElement(i, j);
    }
  }
  return values;
}

Point placed(const Matrix& m, const float* p) {
  Point out{};
  for (int i = 0; i < 3; ++i) {
    out[i] = m[4 * i] * p[0] + m[4 * i + 1] * p[1] + m[4 * i + 2] * p[2] + m[4 * i + 3];
  }
  return out;
}

/// The nearest to the eye of what lies within reach of the pixel; among equally near ones (a bead's
/// own points) the one that is nearest to the pixel.
struct Nearest {
  double best = std::numeric_limits<double>::infinity();

  bool take(double pixels, double depth, double reach) {
    // One pixel off counts like a small step in depth, so that the point aimed at wins.
    const double score = depth + 2e-3 * pixels;
    if (pixels > reach || score >= best) {
      return false;
    }
    best = score;
    return true;
  }
};

}  // namespace

Pick Scene::pickMove(const Ray& ray) const {
  Pick pick;
  if (!impl_->path) {
    return pick;
  }
  const PathData& path = *impl_->path->data;
  const Matrix pose = valuesOf(impl_->partPose);
  const Projector project(ray, pose);
  Nearest nearest;
  for (std::size_t i = impl_->begin; i < std::min(impl_->end, path.size()); ++i) {
    // First points of beads are picked as well: the move after them deposits.
    if (path.deposits[i] == 0 && (i + 1 >= path.size() || path.deposits[i + 1] == 0)) {
      continue;
    }
    double x = 0.0;
    double y = 0.0;
    double depth = 0.0;
    if (project(&path.positions[3 * i], x, y, depth) &&
        nearest.take(std::hypot(x - ray.x, y - ray.y), depth, ray.reach)) {
      pick.kind = Pick::Kind::Move;
      pick.index = static_cast<int>(i);
    }
  }
  if (pick.kind == Pick::Kind::Move) {
    pick.position = placed(pose, &path.positions[3 * static_cast<std::size_t>(pick.index)]);
  }
  return pick;
}

Pick Scene::pickEdge(const Ray& ray) const {
  Pick pick;
  if (impl_->partStyle == PartStyle::Hidden) {
    return pick;
  }
  const Matrix pose = valuesOf(impl_->partPose);
  const Projector project(ray, pose);
  Nearest nearest;
  for (std::size_t part = 0; part < impl_->parts.size(); ++part) {
    const MeshData& mesh = impl_->parts[static_cast<std::size_t>(part)].prepared->mesh;
    for (std::size_t e = 0; e + 1 < mesh.edgeBegin.size(); ++e) {
      for (std::size_t i = mesh.edgeBegin[e]; i + 1 < mesh.edgeBegin[e + 1]; ++i) {
        std::array<double, 3> a{};
        std::array<double, 3> b{};
        if (!project(&mesh.edgePositions[3 * i], a[0], a[1], a[2]) ||
            !project(&mesh.edgePositions[3 * (i + 1)], b[0], b[1], b[2])) {
          continue;
        }
        const double dx = b[0] - a[0];
        const double dy = b[1] - a[1];
        const double length2 = dx * dx + dy * dy;
        const double t =
            length2 > 0.0
                ? std::clamp(((ray.x - a[0]) * dx + (ray.y - a[1]) * dy) / length2, 0.0, 1.0)
                : 0.0;
        const double off = std::hypot(a[0] + t * dx - ray.x, a[1] + t * dy - ray.y);
        if (nearest.take(off, a[2] + t * (b[2] - a[2]), 0.6 * ray.reach)) {
          pick.kind = Pick::Kind::Edge;
          pick.part = static_cast<int>(part);
          pick.index = mesh.edgeIds.empty() ? static_cast<int>(e) : mesh.edgeIds[e];
          const float* p = &mesh.edgePositions[3 * (t < 0.5 ? i : i + 1)];
          pick.position = placed(pose, p);
        }
      }
    }
  }
  return pick;
}

Pick Scene::pickFace(const Ray& ray) const {
  Pick pick;
  if (impl_->partStyle != PartStyle::Solid && impl_->partStyle != PartStyle::Translucent) {
    return pick;
  }
  vtkNew<vtkMatrix4x4> inverse;
  vtkMatrix4x4::Invert(impl_->partPose, inverse);
  const Matrix back = valuesOf(inverse);
  const auto map = [&back](const Point& p, double w) {
    Point out{};
    for (int i = 0; i < 3; ++i) {
      out[i] = back[4 * i] * p[0] + back[4 * i + 1] * p[1] + back[4 * i + 2] * p[2] +
               back[4 * i + 3] * w;
    }
    return out;
  };
  const Point from = map(ray.eye, 1.0);
  const Point along = map(ray.direction, 0.0);
  constexpr double kFar = 1e6;  // mm: beyond every cell
  double to[3] = {from[0] + kFar * along[0], from[1] + kFar * along[1], from[2] + kFar * along[2]};
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < impl_->parts.size(); ++i) {
    const PartItem& part = impl_->parts[i];
    double t = 0.0;
    double x[3];
    double local[3];
    int sub = 0;
    vtkIdType cell = -1;
    vtkNew<vtkGenericCell> generic;
    double start[3] = {from[0], from[1], from[2]};
    if (part.prepared->locator->IntersectWithLine(start, to, 1e-6, t, x, local, sub, cell,
                                                  generic) != 0 &&
        t < best) {
      best = t;
      pick.kind = Pick::Kind::Face;
      pick.part = static_cast<int>(i);
      pick.index = part.prepared->mesh.faces.empty()
                       ? -1
                       : part.prepared->mesh.faces[static_cast<std::size_t>(cell)];
      const float hit[3] = {static_cast<float>(x[0]), static_cast<float>(x[1]),
                            static_cast<float>(x[2])};
      pick.position = placed(valuesOf(impl_->partPose), hit);
    }
  }
  return pick;
}

}  // namespace wcam::viewport
