// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/part_surface.hpp"
#include "wcam/toolpath/slice_field.hpp"
#include "wcam/toolpath/substrate.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace wcam::toolpath {

/// The wall of a part: what lies below the substrate is cut away, and the flat bottom on which a
/// closed body stands is left out, so that the wall has a lower border. A part that has one already
/// comes back as it is.
/// @throws Error(JobFailed) when nothing is left
/// Cost: O(n).
geometry::PartSurface openWall(const geometry::PartSurface& part, const Substrate& substrate);

struct IsoValueOptions {
  double step = 2.0;        ///< wanted mean layer height, mm
  double firstLayer = 1.0;  ///< place of the first layer above the lower border, in steps
  /// Several upper borders: true gives each the layer that its distance from the base asks for,
  /// false the same last layer.
  bool bordersByDistance = true;
  double conductivityUp = 1.0;  ///< conduction along the build direction over that across it
  double geodesicShare = 0.0;   ///< 0: harmonic, 1: by distances from the lower and upper borders
};

/// A field whose level curves follow the borders, in mm: grows by `step` from layer to layer, so
/// that the mean height of all layers is the step (rounded to whole layers), and each upper border
/// is itself a layer.
struct IsoField {
  std::vector<double> values;  ///< per vertex; NaN on pieces without base
  std::size_t layers = 0;      ///< of the piece with the most
};

/// Iso-values between the borders (Diourté M18): harmonic where a connected piece has upper
/// borders, otherwise the distance from its base (M17). The mean height of the layers is the area
/// of the surface over the total length of its level curves, hence A·Δφ/∫|∇φ|dA.
///
/// Findings: those of findBase.
/// @throws Error(JobFailed) when a piece is lower than half a layer or its field has no gradient,
/// Error(InvalidArgument) for options out of range
/// Cost: one or two sparse factorisations.
IsoField isoValueField(const geometry::PartSurface& wall,
                       const Substrate& substrate,
                       const IsoValueOptions& options,
                       const JobContext& context);

/// The same for a piece between given vertices: harmonic from 0 on the lower to layers·step on the
/// upper ones. A piece lower than half a layer has none.
/// @throws Error as harmonicField
IsoField isoValuesBetween(const geometry::PartSurface& piece,
                          const std::vector<std::uint32_t>& lower,
                          const std::vector<std::uint32_t>& upper,
                          double step,
                          const JobContext& context);

/// Levels firstLayer·step, + step, … up to `layers`, each with the mean direction in which the
/// fields grow there.
std::vector<LayerLevel> isoLevels(
    const std::vector<std::shared_ptr<const geometry::PartSurface>>& parts,
    const VertexField& field,
    double step,
    double firstLayer,
    std::size_t layers,
    const Vec3& up);

}  // namespace wcam::toolpath
