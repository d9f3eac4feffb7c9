// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "scene_controller.hpp"

#include "wcam/cell/kinematics.hpp"
#include "wcam/cell/unwrap.hpp"

#include "model/shapes.hpp"

namespace wcam::gui {

SceneController::SceneController(ViewState& state, VtkWidget* view, QObject* parent)
    : QObject(parent), state_(state), view_(view) {
  listener_ = state_.listen([this](unsigned changes) { show(changes); });
}

SceneController::~SceneController() {
  state_.forget(listener_);
}

void SceneController::redraw() {
  if (view_ != nullptr) {
    view_->redraw();
  }
}

void SceneController::setResults(const Generated& results, const std::string& operation) {
  const GeneratedOperation* shown = results.operation(operation);
  if (view_ != nullptr) {
    viewport::Scene& scene = view_->scene();
    std::vector<std::shared_ptr<const viewport::PreparedMesh>> parts;
    for (const GeneratedPart& part : results.parts) {
      if (part.mesh) {
        parts.push_back(part.mesh);
      }
    }
    if (parts != shownParts_) {
      shownParts_ = parts;
      scene.setParts(std::move(parts));
    }
    // Without an operation there is a plate all the same.
    std::shared_ptr<const viewport::PreparedMesh> plate = shown != nullptr ? shown->substrate
                                                          : !results.plates.empty()
                                                              ? results.plates.front().mesh
                                                              : nullptr;
    if (plate != shownSubstrate_) {
      shownSubstrate_ = std::move(plate);
      scene.setSubstrate(shownSubstrate_);
    }
    if (results.cell != cell_) {
      cell_ = results.cell;
      scene.setBodies(cell_ ? bodiesOf(*cell_) : std::vector<viewport::Body>());
      scene.setBodiesVisible(cellVisible_);
      // A robot that comes into the view must not come around the camera.
      fitted_ = fitted_ && !cellVisible_;
    }
  }
  const std::shared_ptr<const PathModel> path = shown != nullptr ? shown->path : nullptr;
  if (path != state_.path()) {
    state_.setPath(path);
  } else {
    showPose();
  }
  keepInView();
  redraw();
}

void SceneController::keepInView() {
  if (view_ == nullptr) {
    return;
  }
  const std::array<double, 6> box = view_->scene().bounds();
  if (box[0] > box[1]) {
    fitted_ = false;  // nothing is there
    return;
  }
  // The first part takes the view from the plate alone; what moved out of it is followed.
  const bool hasParts = !shownParts_.empty();
  if (!fitted_ || hasParts != fittedParts_ || (box != shownBox_ && !view_->view().sees(box))) {
    view_->view().fit();
    fitted_ = true;
    fittedParts_ = hasParts;
  }
  shownBox_ = box;
}

void SceneController::lookAt(const viewport::Point& p) {
  if (view_ != nullptr) {
    const geometry::Vec3 world = T_world_part_ * geometry::Vec3(p[0], p[1], p[2]);
    view_->view().lookAt({world.x(), world.y(), world.z()});
    redraw();
  }
}

void SceneController::show(unsigned changes) {
  if ((changes & (ViewState::PathChanged | ViewState::ColourChanged)) != 0) {
    colours_ =
        state_.path() ? colourPath(*state_.path(), state_.colour(), state_.range()) : Coloured();
  }
  if (view_ != nullptr) {
    viewport::Scene& scene = view_->scene();
    if ((changes & ViewState::PathChanged) != 0) {
      scene.setPath(state_.path() ? state_.path()->prepared() : nullptr);
    }
    if ((changes & (ViewState::PathChanged | ViewState::ColourChanged)) != 0) {
      scene.setPathColours(colours_.rgb);
    }
    if ((changes & (ViewState::PathChanged | ViewState::LayersChanged | ViewState::MoveChanged)) !=
        0) {
      scene.setRange(state_.begin(),
                     state_.path() && state_.path()->size() > 0 ? state_.move() + 1 : 0);
      showPose();
    }
    if ((changes & ViewState::SelectionChanged) != 0) {
      scene.setMark(state_.selected() && state_.path()
                        ? std::optional(state_.path()->position(*state_.selected()))
                        : std::nullopt);
    }
    redraw();
  }
  if ((changes & (ViewState::PathChanged | ViewState::ColourChanged)) != 0) {
    emit coloursChanged();
  }
}

void SceneController::showPose() {
  if (view_ == nullptr) {
    return;
  }
  viewport::Scene& scene = view_->scene();
  const motion::Waypoint* waypoint =
      state_.path() ? state_.path()->waypoint(state_.move()) : nullptr;
  geometry::Pose& T_world_part = T_world_part_;
  T_world_part = geometry::Pose::Identity();
  if (cell_ && cellVisible_) {
    const cell::JointVector q =
        waypoint != nullptr && waypoint->joints.size() == cell_->jointCount()
            ? waypoint->joints
            : cell::neutralJoints(*cell_);
    T_world_part = cell_->T_world_base * cell::T_base_part(*cell_, q);
    std::vector<viewport::Matrix> poses;
    for (const geometry::Pose& pose : bodyPoses(*cell_, q)) {
      poses.push_back(matrixOf(cell_->T_world_base * pose));
    }
    scene.setBodyPoses(poses);
  }
  scene.setPartPose(matrixOf(T_world_part));
  // At rest on the last move nothing is being deposited: the torch would only hide the part.
  const bool working =
      waypoint != nullptr && (state_.move() + 1 < state_.end() || state_.playing() || cellVisible_);
  scene.setTorch(torchVisible_ && working ? std::optional(matrixOf(waypoint->T_part_tcp))
                                          : std::nullopt);
}

void SceneController::setStale(bool stale) {
  if (view_ != nullptr) {
    view_->scene().setStale(stale);
    redraw();
  }
}

void SceneController::setPartStyle(viewport::PartStyle style) {
  if (view_ != nullptr) {
    view_->scene().setPartStyle(style);
    redraw();
  }
}

void SceneController::setSubstrateVisible(bool visible) {
  if (view_ != nullptr) {
    view_->scene().setSubstrateVisible(visible);
    redraw();
  }
}

void SceneController::setCellVisible(bool visible) {
  cellVisible_ = visible;
  if (view_ != nullptr) {
    view_->scene().setBodiesVisible(visible);
    showPose();
    view_->view().fit();
    redraw();
  }
}

void SceneController::setTravelVisible(bool visible) {
  if (view_ != nullptr) {
    view_->scene().setTravelVisible(visible);
    redraw();
  }
}

void SceneController::setTorchVisible(bool visible) {
  torchVisible_ = visible;
  showPose();
  redraw();
}

void SceneController::setDark(bool dark) {
  if (view_ != nullptr) {
    view_->scene().setTheme(dark ? viewport::darkTheme() : viewport::lightTheme());
    redraw();
  }
}

void SceneController::setSection(bool on, int axis, double fraction) {
  if (view_ == nullptr) {
    return;
  }
  const std::array<double, 6> box = view_->scene().bounds();
  viewport::Point origin{};
  viewport::Point normal{};
  const auto i = static_cast<std::size_t>(axis);
  // What is kept lies on the normal's side.
  normal[i] = axis == 1 ? 1.0 : -1.0;
  for (std::size_t k = 0; k < 3; ++k) {
    origin[k] = box[2 * k] + (k == i ? fraction : 0.5) * (box[2 * k + 1] - box[2 * k]);
  }
  view_->scene().setSection(on, origin, normal);
  redraw();
}

}  // namespace wcam::gui
