// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/context.hpp"
#include "wcam/geometry/brep.hpp"
#include "wcam/geometry/types.hpp"

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace wcam::geometry {

/// A C² space curve in the part frame, mm, over [begin, end]. Evaluation is const; a guide made
/// from a CAD edge evaluates under a lock.
class GuideCurve {
public:
  virtual ~GuideCurve();
  [[nodiscard]] virtual double begin() const = 0;
  [[nodiscard]] virtual double end() const = 0;
  [[nodiscard]] virtual CurvePoint evaluate(double t) const = 0;
};

/// Edge `edge` of a CAD part. @throws Error(InvalidArgument) when it does not exist
std::shared_ptr<const GuideCurve> guideFromEdge(std::shared_ptr<const Brep> brep,
                                                int edge,
                                                bool reversed = false);
/// C² cubic spline through points (at least 2), parametrised by chord length in mm.
/// @throws Error(InputInvalid) for repeated or too few points
std::shared_ptr<const GuideCurve> guideFromPoints(std::vector<Vec3> points);
/// Points of a text file: three numbers per line (comma, semicolon or blank separated), '#'
/// comments, an optional header line. @throws Error(InputInvalid) naming file and line
std::shared_ptr<const GuideCurve> guideFromFile(const std::string& file);
/// The same from the text of a file. @param file its name, for messages
std::shared_ptr<const GuideCurve> guideFromText(std::string_view text, const std::string& file);
/// Formulas x(t), y(t), z(t) over [begin, end] in mm; pi and the usual functions are known.
/// @throws Error(InvalidArgument) naming the formula and the position, or the parameter where the
/// curve jumps or leaves the range of plausible lengths
std::shared_ptr<const GuideCurve> guideFromFormula(const std::array<std::string, 3>& xyz,
                                                   double begin,
                                                   double end);

/// Moving frame of a curve: unit tangent, normal, binormal = tangent × normal.
struct CurveFrame {
  Vec3 tangent = Vec3::UnitZ();
  Vec3 normal = Vec3::UnitX();
  Vec3 binormal = Vec3::UnitY();
};

/// Frenet frame (Chalvin Eq. 2.24). Where the curvature is zero the normal is undefined: `valid` is
/// false.
CurveFrame frenetFrame(const CurvePoint& point, bool* valid = nullptr);
/// Rotation-minimising frames at the given parameters (ascending), by double reflection (Wang et
/// al. 2008). The first normal is the projection of `seed`.
std::vector<CurveFrame> rotationMinimisingFrames(const GuideCurve& curve,
                                                 const std::vector<double>& parameters,
                                                 const Vec3& seed);

/// Length between two parameters, mm, relative error about 1e-10.
double arcLength(const GuideCurve& curve, double from, double to);
/// Parameters t_0 = from, t_1, … with chords |g(t_{k+1}) − g(t_k)| = step (Chalvin A8), while t ≤
/// end. @throws Error(JobFailed) for more chords than a part has layers, CancelledError
std::vector<double> chordSteps(const GuideCurve& curve,
                               double step,
                               double from,
                               const JobContext& context = {});

}  // namespace wcam::geometry
