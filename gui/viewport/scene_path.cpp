// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_impl.hpp"
#include "vtk_arrays.hpp"

#include <vtkCellArray.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>

namespace wcam::viewport {

namespace {

void setCells(PreparedChunk& chunk, vtkCellArray* cells) {
  if (chunk.isLines) {
    chunk.data->SetLines(cells);
  } else {
    chunk.data->SetPolys(cells);
  }
  chunk.data->Modified();
}

}  // namespace

void Scene::Impl::colour(Chunk& chunk) {
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

void Scene::Impl::clear(std::vector<Chunk>& chunks) {
  for (Chunk& chunk : chunks) {
    remove(chunk.actor);
  }
  chunks.clear();
}

void Scene::Impl::addChunks(std::vector<PreparedChunk>& prepared, std::vector<Chunk>& chunks) {
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

void Scene::Impl::makePath() {
  addChunks(path->fine, fine);
  addChunks(path->coarse, coarse);
  const auto finish = [this](Chunk& chunk, Detail detail) {
    details[chunk.actor] = detail;
    vtkProperty* property = chunk.actor->GetProperty();
    if (chunk.prepared->isLines) {
      property->SetLineWidth(2.0F);
      property->SetLighting(false);
    } else {
      property->SetAmbient(0.22);
      property->SetDiffuse(0.8);
      property->SetSpecular(0.1);
      property->SetSpecularPower(12.0);
    }
  };
  for (Chunk& chunk : fine) {
    finish(chunk, Detail::Fine);
  }
  for (Chunk& chunk : coarse) {
    finish(chunk, Detail::Coarse);
  }
}

void Scene::Impl::makeTravel() {
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

void Scene::Impl::show(Chunk& chunk, bool wanted) {
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
    const std::size_t first = from == range.begin ? 0 : prepared.cellsUpTo[from - range.begin - 1];
    setCells(prepared, cellRange(prepared.all, first, prepared.cellsUpTo[to - range.begin - 1]));
  }
  ++uploads;
}

void Scene::Impl::showPath() {
  if (!path) {
    return;
  }
  if (travelVisible && travel.empty()) {
    makeTravel();
  }
  for (Chunk& chunk : fine) {
    show(chunk, true);
  }
  const std::size_t before = uploads;
  for (Chunk& chunk : coarse) {
    show(chunk, true);
  }
  uploads = before;  // of what stands for it
  for (Chunk& chunk : travel) {
    show(chunk, travelVisible);
  }
}

void Scene::setPath(std::shared_ptr<PreparedPath> path) {
  impl_->clear(impl_->fine);
  impl_->clear(impl_->coarse);
  impl_->clear(impl_->travel);
  impl_->path = std::move(path);
  impl_->colours.clear();
  impl_->begin = 0;
  impl_->end = impl_->path ? impl_->path->data->size() : 0;
  if (impl_->path) {
    impl_->makePath();
  }
  impl_->showPath();
}

void Scene::setPathColours(const std::vector<std::uint8_t>& colours) {
  impl_->colours = colours;
  for (auto* list : {&impl_->fine, &impl_->coarse}) {
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

bool Scene::drawsLines() const {
  return impl_->asLines();
}

std::size_t Scene::uploads() const {
  return impl_->uploads;
}

}  // namespace wcam::viewport
