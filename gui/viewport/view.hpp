// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "frame_budget.hpp"
#include "scene.hpp"

#include <functional>
#include <memory>

namespace wcam::viewport {

/// The 3D view in an OpenGL context that somebody else owns: the window toolkit makes the context
/// and copies what is drawn; this class knows cameras and pixels. Pixels count from the upper left.
class View {
public:
  View();
  ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;

  [[nodiscard]] Scene& scene();

  // The context. Its functions are called with the context current.
  void setMakeCurrent(std::function<void()> makeCurrent);
  /// Also draws a little of everything once: a renderer compiles its programs when they are needed
  /// first, which would hold up the first pictures.
  void initializeGl();
  void releaseGl();
  [[nodiscard]] bool ready() const;
  void resize(int width, int height);
  /// True when the whole picture can be drawn at once without keeping anybody waiting.
  [[nodiscard]] bool fitsOneFrame() const;
  /// Draws a whole picture at once.
  void render(Scene::Detail detail);
  /// Draws the next portion of a picture onto those before it; the first one clears.
  /// @return true when the picture is complete
  bool renderPortion(bool first);
  /// Framebuffer object of the last picture; 0 before there is a context.
  [[nodiscard]] unsigned framebuffer() const;
  [[nodiscard]] const FrameBudget& budget() const;

  // The camera.
  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  void zoom(double factor, double x, double y);
  void setStandardView(StandardView view);
  void fit();
  /// Pixels at the left that fitting leaves free, for what stands over the view.
  void setInset(int left);
  void setParallel(bool on);
  [[nodiscard]] bool parallel() const;
  /// Moves the camera so that the target is in the middle. It keeps direction and distance unless
  /// a robot would stand around the camera or before the target: then it looks from the nearest
  /// direction that is free.
  void lookAt(const Point& target);
  /// True when a box (xmin, xmax, ...) is in the picture, or the camera looks at something in it.
  [[nodiscard]] bool sees(const std::array<double, 6>& box) const;
  [[nodiscard]] Point eye() const;
  [[nodiscard]] Point focus() const;

  /// What is seen under a pixel: path points first, then edges, then faces. What something opaque
  /// hides, or a section takes away, is not picked.
  struct Wanted {
    bool moves = true;
    bool edges = true;
    bool faces = true;
  };

  [[nodiscard]] Pick pick(double x, double y, Wanted wanted) const;
  /// Pixel at which a point of the world is drawn.
  [[nodiscard]] std::array<double, 2> project(const Point& p) const;

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::viewport
