// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene.hpp"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wcam::viewport {

/// An image, rows from the top, three bytes per pixel.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;
};

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
  void initializeGl();
  void releaseGl();
  [[nodiscard]] bool ready() const;
  void resize(int width, int height);
  /// Draws, and gives the framebuffer object that holds the picture.
  unsigned render();
  /// After the toolkit has copied the picture.
  void endFrame();
  /// Of the last render, s.
  [[nodiscard]] double frameTime() const;

  // The camera.
  void orbit(double dx, double dy);
  void pan(double dx, double dy);
  void zoom(double factor, double x, double y);
  void setStandardView(StandardView view);
  void fit();
  void setParallel(bool on);
  [[nodiscard]] bool parallel() const;
  void lookAt(const Point& target);
  /// While the user moves the camera a slow scene is drawn as lines.
  void setMoving(bool moving);

  /// What lies under a pixel: path points first, then edges, then faces.
  struct Wanted {
    bool moves = true;
    bool edges = true;
    bool faces = true;
  };

  [[nodiscard]] Pick pick(double x, double y, Wanted wanted) const;
  /// Pixel at which a point of the world is drawn.
  [[nodiscard]] std::array<double, 2> project(const Point& p) const;

  /// The last picture. Call with the context current.
  [[nodiscard]] Image image();
  /// Writes the last picture as PNG. @return false when the file cannot be written
  bool savePng(const std::string& file);

private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::viewport
