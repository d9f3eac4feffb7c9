// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkCuller.h>
#include <vtkProp.h>
#include <vtkSmartPointer.h>

#include <unordered_set>
#include <vector>

namespace wcam::viewport {

/// Keeps all props out of a frame but those that were chosen for it; their visibility stays as it
/// is.
class PortionCuller : public vtkCuller {
public:
  static PortionCuller* New();
  vtkTypeMacro(PortionCuller, vtkCuller);

  double Cull(vtkRenderer* renderer, vtkProp** props, int& count, int& initialized) override;

  std::unordered_set<vtkProp*> chosen;
};

/// Something to draw and its triangles.
struct Drawable {
  vtkSmartPointer<vtkProp> prop;
  double triangles = 0.0;
  bool translucent = false;
};

/// A picture that is drawn by several frames onto each other: what is opaque in portions, all that
/// is translucent in the last frame.
class Portions {
public:
  void begin(std::vector<Drawable> drawables);
  /// Chooses what the next frame draws: as much as the capacity holds, and at least something.
  /// @return the triangles of it
  double next(double capacity, std::unordered_set<vtkProp*>& chosen);

  /// True when the last frame was chosen.
  [[nodiscard]] bool complete() const { return at_ >= drawables_.size(); }

private:
  std::vector<Drawable> drawables_;  ///< opaque ones first
  std::size_t at_ = 0;
};

}  // namespace wcam::viewport
