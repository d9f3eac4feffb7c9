// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "model/colours.hpp"
#include "model/generation.hpp"
#include "model/view_state.hpp"
#include "widgets/vtk_widget.hpp"

#include <QObject>

#include <array>
#include <memory>

namespace wcam::gui {

/// Shows results and the ViewState in the 3D view. Without a view (offscreen) it only keeps the
/// colours.
class SceneController : public QObject {
  Q_OBJECT

public:
  SceneController(ViewState& state, VtkWidget* view, QObject* parent = nullptr);
  ~SceneController() override;

  void setResults(const Generated& results, const std::string& operation);
  void setStale(bool stale);
  void setPartStyle(viewport::PartStyle style);
  void setSubstrateVisible(bool visible);
  void setCellVisible(bool visible);
  void setTravelVisible(bool visible);
  void setTorchVisible(bool visible);
  void setDark(bool dark);
  /// Cuts everything at a fraction of the bounds along an axis.
  void setSection(bool on, int axis, double fraction);
  /// Turns the camera to a point of the part, past the robot. @param p in the part frame
  void lookAt(const viewport::Point& p);

  [[nodiscard]] const Coloured& colours() const { return colours_; }

  [[nodiscard]] bool cellVisible() const { return cellVisible_; }

signals:
  void coloursChanged();

private:
  void show(unsigned changes);
  void showPose();
  void redraw();
  /// Fits the view when something comes that was not there, or what is built has moved out of it.
  void keepInView();

  ViewState& state_;
  VtkWidget* view_;
  int listener_ = 0;
  std::vector<std::shared_ptr<const viewport::PreparedMesh>> shownParts_;
  std::shared_ptr<const viewport::PreparedMesh> shownSubstrate_;
  std::shared_ptr<const cell::Cell> cell_;
  Coloured colours_;
  geometry::Pose T_world_part_ = geometry::Pose::Identity();  ///< as the part is drawn
  std::array<double, 6> shownBox_{};
  bool fitted_ = false;
  bool fittedParts_ = false;  ///< the view was fitted to parts, not to a plate alone
  bool cellVisible_ = false;
  bool torchVisible_ = true;
};

}  // namespace wcam::gui
