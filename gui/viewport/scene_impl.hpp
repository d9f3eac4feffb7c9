// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "portions.hpp"
#include "prepared_vtk.hpp"
#include "scene.hpp"

#include <vtkActor.h>
#include <vtkBillboardTextActor3D.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPlaneCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <unordered_map>
#include <unordered_set>

namespace wcam::viewport {

void setColour(vtkProperty* property, const Colour& colour);
vtkSmartPointer<vtkActor> makeActor(vtkPolyData* data);

/// A chunk of the path in the scene: what it shows at present.
struct Chunk {
  PreparedChunk* prepared = nullptr;
  vtkSmartPointer<vtkActor> actor;
  std::size_t shownBegin = 0;
  std::size_t shownEnd = 0;
};

struct PartItem {
  std::shared_ptr<const PreparedMesh> prepared;
  std::vector<vtkSmartPointer<vtkActor>> surface;  ///< in pieces
  vtkSmartPointer<vtkActor> coarse;                ///< null: the surface itself has few triangles
  vtkSmartPointer<vtkActor> edges;

  /// Visits the surface, fine and coarse.
  template <class Visit>
  void forSurface(const Visit& visit) const {
    for (const vtkSmartPointer<vtkActor>& piece : surface) {
      visit(piece.Get());
    }
    if (coarse) {
      visit(coarse.Get());
    }
  }
};

struct Scene::Impl {
  vtkSmartPointer<vtkRenderer> renderer = vtkSmartPointer<vtkRenderer>::New();
  Theme theme = lightTheme();
  vtkNew<vtkMatrix4x4> partPose;

  std::vector<PartItem> parts;
  PartStyle partStyle = PartStyle::Solid;
  vtkSmartPointer<vtkActor> substrate;
  vtkSmartPointer<vtkActor> substrateEdges;
  std::shared_ptr<const PreparedMesh> substrateMesh;
  bool substrateVisible = true;
  vtkSmartPointer<vtkActor> markedFaces;
  vtkSmartPointer<vtkActor> markedEdges;

  std::shared_ptr<PreparedPath> path;
  std::vector<Chunk> fine;
  std::vector<Chunk> coarse;
  std::vector<Chunk> travel;
  std::vector<std::uint8_t> colours;
  std::size_t begin = 0;
  std::size_t end = 0;
  bool travelVisible = false;
  bool stale = false;
  std::size_t uploads = 0;

  std::unordered_map<vtkProp*, Detail> details;  ///< of props that belong to one detail only
  std::unordered_set<vtkProp*> drawn;
  vtkNew<PortionCuller> culler;
  Portions portions;
  std::vector<vtkSmartPointer<vtkActor>> samples;

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

  void add(vtkActor* actor, Detail detail) {
    details[actor] = detail;
    add(actor);
  }

  void remove(vtkProp* actor) {
    if (actor != nullptr) {
      renderer->RemoveActor(actor);
      details.erase(actor);
      drawn.erase(actor);
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
      part.forSurface(visit);
      if (part.edges) {
        visit(part.edges.Get());
      }
    }
    for (auto* list : {&fine, &coarse, &travel}) {
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
      part.forSurface([this](vtkActor* surface) {
        surface->SetVisibility(partStyle == PartStyle::Solid ||
                               partStyle == PartStyle::Translucent);
        vtkProperty* property = surface->GetProperty();
        setColour(property, theme.part);
        property->SetOpacity(partStyle == PartStyle::Translucent ? 0.22 : 1.0);
        property->SetAmbient(0.18);
        property->SetDiffuse(0.82);
        property->SetSpecular(0.12);
        property->SetSpecularPower(20.0);
      });
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

  // scene_detail.cpp
  [[nodiscard]] double trianglesOf(vtkProp* prop) const;
  /// Everything that a picture shows.
  /// @param most triangles of translucent parts; coarse ones stand for more
  [[nodiscard]] std::vector<Drawable> drawables(Detail detail, double most) const;

  // scene_path.cpp
  void colour(Chunk& chunk);
  void clear(std::vector<Chunk>& chunks);
  /// Puts prepared chunks into the scene.
  void addChunks(std::vector<PreparedChunk>& prepared, std::vector<Chunk>& chunks);
  void makePath();
  void makeTravel();
  /// Shows the moves of a chunk that lie in [begin, end): the rest is left out of its cells.
  void show(Chunk& chunk, bool wanted);
  void showPath();
};

}  // namespace wcam::viewport
