// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace wcam::viewport {

/// How much may be drawn at once so that the window answers in between. It learns from the times
/// that frames take: a graphics card soon gets everything in one frame, a software renderer some
/// ten thousand triangles.
class FrameBudget {
public:
  /// A frame should take no longer, s: with what the window toolkit does besides, a tenth of a
  /// second is never reached.
  static constexpr double kFrame = 0.025;
  /// Triangles of the first frame, before anything is known.
  static constexpr double kFirst = 16000.0;
  /// Never less: a frame costs some time however little is drawn.
  static constexpr double kLeast = 8000.0;

  /// Triangles of a frame.
  [[nodiscard]] double capacity() const { return capacity_; }

  /// Tells what a frame has taken.
  /// @param triangles of it
  /// @param seconds until it was finished
  void drawn(double triangles, double seconds);

private:
  double capacity_ = kFirst;
};

}  // namespace wcam::viewport
