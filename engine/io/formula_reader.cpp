// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula_reader.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/figure.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/text.hpp"
#include "wcam/geometry/guide_curve.hpp"

#include "formula.hpp"
#include "formula_spline.hpp"
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <Precision.hxx>
#include <TopoDS_Face.hxx>
#include <gp_Ax1.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace wcam::io {

using geometry::CurveFrame;
using geometry::Formula;
using geometry::GuideCurve;
using geometry::Vec3;

namespace {

/// A radius that is this small compared to the part is a point of the axis.
constexpr double kOnAxis = 1e-9;
/// How far a range may go beyond the formula's own, and pieces may lie apart, mm and in parts of
/// the size: what a number with few decimals misses.
constexpr double kLoose = 1e-4;
constexpr double kLooseRelative = 1e-7;
/// An end that was cut back to the formula's own is on the axis when it is as near, mm.
constexpr double kCutOnAxis = 1e-2;

/// An object of the file with its place, for messages.
class Section {
public:
  Section(const Value& value, std::string place, const std::set<std::string>& keys)
      : value_(value), place_(std::move(place)) {
    if (!value.isObject()) {
      fail("is not an object");
    }
    for (const auto& [key, item] : value.asObject()) {
      if (keys.count(key) == 0) {
        fail(wcam::text("has an unknown key \"%1\"", {key}));
      }
    }
  }

  [[nodiscard]] const std::string& place() const { return place_; }

  [[nodiscard]] const Value& at(const std::string& key) const {
    const Value* item = value_.find(key);
    if (item == nullptr) {
      fail(wcam::text("lacks \"%1\"", {key}));
    }
    return *item;
  }

  [[nodiscard]] std::string text(const std::string& key) const {
    const Value& item = at(key);
    if (item.isNumber()) {
      return formatReal(item.asReal());
    }
    if (!item.isString()) {
      fail(wcam::text("needs a text for \"%1\"", {key}));
    }
    return item.asString();
  }

  [[nodiscard]] std::optional<bool> flag(const std::string& key) const {
    const Value* item = value_.find(key);
    if (item == nullptr) {
      return std::nullopt;
    }
    if (!item->isBool()) {
      fail(wcam::text("needs true or false for \"%1\"", {key}));
    }
    return item->asBool();
  }

  [[nodiscard]] Formula formula(const std::string& key,
                                const std::vector<std::string>& variables) const {
    return makeFormula(text(key), variables, place_ + "." + key);
  }

  /// Two numbers, or formulas of numbers such as "2*pi", in ascending order.
  [[nodiscard]] std::array<double, 2> range(const std::string& key) const {
    const Value& item = at(key);
    if (!item.isArray() || item.size() != 2) {
      fail(wcam::text("needs two numbers for \"%1\"", {key}));
    }
    std::array<double, 2> range{};
    for (std::size_t i = 0; i < 2; ++i) {
      const Value& end = item.asArray()[i];
      if (!end.isNumber() && !end.isString()) {
        fail(wcam::text("needs numbers or formulas for \"%1\"", {key}));
      }
      range[i] =
          end.isNumber() ? end.asReal() : makeFormula(end.asString(), {}, place_ + "." + key)();
    }
    if (!(range[0] < range[1]) || !std::isfinite(range[1] - range[0])) {
      fail(wcam::text("needs an ascending range for \"%1\"", {key}));
    }
    return range;
  }

  [[noreturn]] void fail(const Text& what) const {
    throw Error(ErrorCode::InputInvalid, wcam::text("the description %1", {what}), place_,
                "see the page on part formats");
  }

private:
  static Formula makeFormula(const std::string& text,
                             const std::vector<std::string>& variables,
                             const std::string& place) {
    try {
      return Formula(text, variables, place);
    } catch (const Error& error) {
      throw Error(ErrorCode::InputInvalid, error.messageText(), error.contextText(),
                  error.hintText());
    }
  }

  const Value& value_;
  std::string place_;
};

struct FormulaShape {
  TopoDS_Shape shape;
  double deviation = 0.0;
};

/// Sign that turns du × dv away from the middle of the closed direction's sections; 0 when there is
/// no such side.
int outwardSide(const Handle(Geom_BSplineSurface) & surface, bool closedU, bool closedV) {
  if (!closedU && !closedV) {
    return 0;
  }
  constexpr int kSamples = 24;
  std::array<double, 4> b{};
  surface->Bounds(b[0], b[1], b[2], b[3]);
  double sum = 0.0;
  for (int i = 1; i < kSamples; ++i) {
    std::vector<std::array<gp_XYZ, 2>> ring;
    gp_XYZ centre(0, 0, 0);
    for (int j = 0; j < kSamples; ++j) {
      const double along = static_cast<double>(i) / kSamples;
      const double around = static_cast<double>(j) / kSamples;
      const double u = b[0] + (b[1] - b[0]) * (closedV ? along : around);
      const double v = b[2] + (b[3] - b[2]) * (closedV ? around : along);
      gp_Pnt p;
      gp_Vec du, dv;
      surface->D1(u, v, p, du, dv);
      ring.push_back({p.XYZ(), du.Crossed(dv).XYZ()});
      centre += p.XYZ() / kSamples;
    }
    for (const auto& [p, n] : ring) {
      sum += n.Dot(p - centre);
    }
  }
  return sum > 0.0 ? 1 : -1;
}

FormulaShape faceOf(const Fitted<Geom_BSplineSurface>& fitted,
                    bool closedU,
                    bool closedV,
                    bool flip,
                    const std::string& place) {
  BRepBuilderAPI_MakeFace maker(fitted.spline, Precision::Confusion());
  if (!maker.IsDone()) {
    throw Error(ErrorCode::InputInvalid, "the surface has no area or crosses itself", place,
                "check the formulas and their ranges");
  }
  TopoDS_Face face = maker.Face();
  if ((outwardSide(fitted.spline, closedU, closedV) < 0) != flip) {
    face.Reverse();
  }
  return {face, fitted.deviation};
}

FormulaShape readParametric(const Value& value,
                            const std::string& place,
                            const JobContext& context) {
  const Section section(value, place,
                        {"type", "x", "y", "z", "u", "v", "closed_u", "closed_v", "flip"});
  const std::vector<std::string> variables = {"u", "v"};
  const Formula x = section.formula("x", variables);
  const Formula y = section.formula("y", variables);
  const Formula z = section.formula("z", variables);
  const bool closedU = section.flag("closed_u").value_or(false);
  const bool closedV = section.flag("closed_v").value_or(false);
  const auto fitted =
      fitSurface([&](double u, double v) { return Vec3(x(u, v), y(u, v), z(u, v)); },
                 section.range("u"), section.range("v"), closedU, closedV, place, context);
  return faceOf(fitted, closedU, closedV, section.flag("flip").value_or(false), place);
}

/// Frames along a guide at any parameter: Frenet's, or rotation-minimising ones from a fine table.
class GuideFrames {
public:
  GuideFrames(const GuideCurve& guide, bool frenet, const std::string& place)
      : guide_(guide), frenet_(frenet), place_(place) {
    if (!frenet) {
      for (int i = 0; i <= kFrames; ++i) {
        parameters_.push_back(guide.begin() + (guide.end() - guide.begin()) * i / kFrames);
      }
      frames_ = geometry::rotationMinimisingFrames(guide, parameters_, seed(guide));
    }
  }

  [[nodiscard]] CurveFrame at(double t) const {
    if (!frenet_) {
      const auto upper = std::upper_bound(parameters_.begin() + 1, parameters_.end() - 1, t);
      const auto i = static_cast<std::size_t>(upper - parameters_.begin()) - 1;
      return geometry::rotationMinimisingFrames(guide_, {parameters_[i], t}, frames_[i].normal)[1];
    }
    bool valid = false;
    const CurveFrame frame = geometry::frenetFrame(guide_.evaluate(t), &valid);
    if (!valid) {
      throw Error(ErrorCode::InputInvalid,
                  wcam::text("the guide is straight at t = %1 and has no Frenet frame",
                             {formatFixed(t, 6)}),
                  place_, "write \"frame\": \"minimal\"");
    }
    return frame;
  }

private:
  /// Fine enough that a step from one frame to the next is exact to rounding.
  static constexpr int kFrames = 4096;

  /// The curvature's direction at the start, so that v = 0 is where Frenet's frame has it.
  static Vec3 seed(const GuideCurve& guide) {
    return geometry::frenetFrame(guide.evaluate(guide.begin())).normal;
  }

  const GuideCurve& guide_;
  bool frenet_;
  const std::string& place_;
  std::vector<double> parameters_;
  std::vector<CurveFrame> frames_;
};

/// The section of a tube at one parameter (Chalvin Eq. 2.25).
struct TubeSection {
  double t = std::numeric_limits<double>::quiet_NaN();
  Vec3 centre, normal, binormal;
};

FormulaShape readTube(const Value& value, const std::string& place, const JobContext& context) {
  const Section section(value, place, {"type", "guide", "radius", "frame", "flip"});
  const std::string guidePlace = place + ".guide";
  const Section guideSection(section.at("guide"), guidePlace, {"x", "y", "z", "t"});
  const std::array<double, 2> range = guideSection.range("t");
  std::shared_ptr<const GuideCurve> guide;
  try {
    guide = geometry::guideFromFormula(
        {guideSection.text("x"), guideSection.text("y"), guideSection.text("z")}, range[0],
        range[1]);
  } catch (const Error& error) {
    throw Error(ErrorCode::InputInvalid, error.messageText(),
                wcam::text("%1, %2", {guidePlace, error.contextText()}), error.hintText());
  }
  const Formula radius = section.formula("radius", {"t"});
  const std::string frame = value.contains("frame") ? section.text("frame") : "minimal";
  if (frame != "minimal" && frame != "frenet") {
    section.fail("needs \"minimal\" or \"frenet\" for \"frame\"");
  }
  const GuideFrames frames(*guide, frame == "frenet", guidePlace);
  TubeSection at;
  const auto point = [&](double t, double v) -> Vec3 {
    const double r = radius(t);
    if (!(r > 0.0)) {
      throw Error(ErrorCode::InputInvalid,
                  wcam::text("the radius is %1 at t = %2", {formatFixed(r, 6), formatFixed(t, 6)}),
                  place + ".radius", "the radius must be positive along the whole guide");
    }
    if (t != at.t) {
      const geometry::CurvePoint g = guide->evaluate(t);
      const double speed2 = g.d1.squaredNorm();
      const double bend = g.d1.cross(g.d2).norm() / (speed2 * std::sqrt(speed2));
      if (!(speed2 > 0.0) || !(bend * r < 1.0)) {
        throw Error(
            ErrorCode::InputInvalid,
            wcam::text(
                "the tube folds at t = %1: its radius reaches the guide's radius of curvature",
                {formatFixed(t, 6)}),
            place, "use a smaller radius or a straighter guide");
      }
      const CurveFrame f = frames.at(t);
      at = {t, g.p, f.normal, f.binormal};
    }
    return at.centre + r * (std::cos(v) * at.normal + std::sin(v) * at.binormal);
  };
  const auto fitted = fitSurface(point, range, {0.0, 2.0 * kPi}, false, true, place, context);
  return faceOf(fitted, false, true, section.flag("flip").value_or(false), place);
}

/// A smooth piece of a profile r(z).
struct ProfilePiece {
  std::string place;
  std::array<double, 2> z{};
  Formula radius;
  std::array<bool, 2> cut{};  ///< ends that were cut back to the formula's own
  double moved = 0.0;         ///< by which an end was moved, mm
};

/// How a piece is parametrised over [0, 1], so that an end with a vertical tangent (a pole) is
/// regular.
struct ProfileMap {
  bool steepStart = false;
  bool steepEnd = false;

  explicit ProfileMap(const ProfilePiece& piece) {
    // The slope of a square root grows tenfold when the distance shrinks a hundredfold.
    constexpr double kNear = 1e-4;
    constexpr double kNearer = 1e-6;
    constexpr double kGrowth = 3.0;
    const double length = piece.z[1] - piece.z[0];
    const auto slope = [&](double end, double step) {
      return std::abs(piece.radius(end) - piece.radius(end + step)) / std::abs(step);
    };
    steepStart =
        slope(piece.z[0], kNearer * length) > kGrowth * slope(piece.z[0], kNear * length) + 1.0;
    steepEnd =
        slope(piece.z[1], -kNearer * length) > kGrowth * slope(piece.z[1], -kNear * length) + 1.0;
  }

  [[nodiscard]] double z(const std::array<double, 2>& range, double s) const {
    if (s <= 0.0 || s >= 1.0) {
      return s <= 0.0 ? range[0] : range[1];
    }
    const double length = range[1] - range[0];
    if (steepStart && steepEnd) {
      return range[0] + length * 0.5 * (1.0 - std::cos(kPi * s));
    }
    if (steepStart) {
      return range[0] + length * s * s;
    }
    return steepEnd ? range[1] - length * (1.0 - s) * (1.0 - s) : range[0] + length * s;
  }
};

double looseness(double size) {
  return std::max(kLoose, kLooseRelative * size);
}

/// Cuts a range that goes a little beyond the formula's own, such as sqrt(r^2 - z^2) to a rounded
/// r, back to where the formula has a value.
void cutToFormula(ProfilePiece& piece, double size) {
  const auto isValue = [&](double z) { return std::isfinite(piece.radius(z)); };
  for (const std::size_t end : {std::size_t{0}, std::size_t{1}}) {
    double out = piece.z[end];
    double in = out + (end == 0 ? 1.0 : -1.0) * looseness(size);
    if (isValue(out) || !isValue(in) || !(piece.z[0] < in) || !(in < piece.z[1])) {
      continue;
    }
    const double inside = piece.radius(in);
    constexpr int kBisections = 80;
    for (int k = 0; k < kBisections; ++k) {
      const double middle = 0.5 * (in + out);
      (isValue(middle) ? in : out) = middle;
    }
    if (std::abs(piece.radius(in) - inside) > size) {
      continue;  // a pole: there is no end to cut back to
    }
    piece.moved = std::max(piece.moved, std::abs(in - piece.z[end]));
    piece.z[end] = in;
    piece.cut[end] = true;
  }
}

std::vector<ProfilePiece> profilePieces(const Section& section) {
  std::vector<ProfilePiece> pieces;
  const Value& radius = section.at("radius");
  if (!radius.isArray()) {
    pieces.push_back({section.place() + ".radius",
                      section.range("z"),
                      section.formula("radius", {"z"}),
                      {},
                      0.0});
    return pieces;
  }
  for (std::size_t i = 0; i < radius.size(); ++i) {
    const std::string place = section.place() + ".radius[" + std::to_string(i) + "]";
    const Section piece(radius.asArray()[i], place, {"z", "radius"});
    pieces.push_back({place, piece.range("z"), piece.formula("radius", {"z"}), {}, 0.0});
    if (i > 0) {
      const double apart = std::abs(pieces[i].z[0] - pieces[i - 1].z[1]);
      if (apart > looseness(pieces[i].z[1] - pieces[0].z[0])) {
        piece.fail(wcam::text("must begin where the piece before it ends, and not %1 mm from there",
                              {formatFigure(apart)}));
      }
      pieces[i].z[0] = pieces[i - 1].z[1];
      pieces[i].moved = apart;
    }
  }
  if (pieces.empty()) {
    section.fail("needs at least one piece of \"radius\"");
  }
  return pieces;
}

/// Place on the profile, with the axis met exactly; in the plane y = 0.
Vec3 profilePoint(const ProfilePiece& piece, double z, double size) {
  const double r = piece.radius(z);
  if (!std::isfinite(r)) {
    throw Error(ErrorCode::InputInvalid,
                wcam::text("the formula has no value at z = %1", {formatFixed(z, 9)}), piece.place,
                "look for a division by zero or the root of a negative number, and change the "
                "formula or its range");
  }
  if (!(r >= -kOnAxis * size)) {
    throw Error(ErrorCode::InputInvalid,
                wcam::text("the radius is %1 at z = %2", {formatFixed(r, 6), formatFixed(z, 6)}),
                piece.place, "the radius must not be negative");
  }
  const bool cut = (piece.cut[0] && z == piece.z[0]) || (piece.cut[1] && z == piece.z[1]);
  return {r <= (cut ? kCutOnAxis : kOnAxis * size) ? 0.0 : r, 0.0, z};
}

FormulaShape readRevolution(const Value& value,
                            const std::string& place,
                            const JobContext& context) {
  const Section section(value, place, {"type", "radius", "z", "flip"});
  std::vector<ProfilePiece> pieces = profilePieces(section);
  double size = pieces.back().z[1] - pieces.front().z[0];
  for (ProfilePiece& piece : pieces) {
    cutToFormula(piece, size);
  }
  for (const ProfilePiece& piece : pieces) {
    for (const double z : piece.z) {
      const double r = piece.radius(z);
      size = std::isfinite(r) ? std::max(size, r) : size;
    }
  }
  BRepBuilderAPI_MakeWire wire;
  FormulaShape result;
  gp_Pnt last;
  for (const ProfilePiece& piece : pieces) {
    const ProfileMap map(piece);
    const auto fitted =
        fitCurve([&](double s) { return profilePoint(piece, map.z(piece.z, s), size); }, size,
                 piece.place, context);
    result.deviation = std::max({result.deviation, fitted.deviation, piece.moved});
    // A jump of the radius becomes a flat ring, so that the surface stays in one piece.
    const gp_Pnt start = fitted.spline->StartPoint();
    if (&piece != &pieces.front() && start.Distance(last) > Precision::Confusion()) {
      wire.Add(BRepBuilderAPI_MakeEdge(last, start).Edge());
    }
    wire.Add(BRepBuilderAPI_MakeEdge(fitted.spline).Edge());
    last = fitted.spline->EndPoint();
  }
  BRepPrimAPI_MakeRevol revolution(wire.Wire(), gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
  if (!revolution.IsDone()) {
    throw Error(ErrorCode::InputInvalid, "the profile cannot be revolved", place,
                "check the radius and its range");
  }
  result.shape = revolution.Shape();
  // The profile climbs, so that du × dv (around, then up) points away from the axis.
  if (section.flag("flip").value_or(false)) {
    result.shape.Reverse();
  }
  return result;
}

}  // namespace

CadModel readFormulaSurface(std::string_view bytes,
                            const std::string& file,
                            const JobContext& context) {
  const Value document = parseJson(bytes, file);
  const Section section(document, file, {"format_version", "name", "surface"});
  const Value& version = section.at("format_version");
  if (!version.isInteger() || version.asInteger() != 1) {
    section.fail("has a format_version other than 1");
  }
  const std::string place = file + ": surface";
  const Value& surface = section.at("surface");
  const Value* type = surface.find("type");
  const std::string kind = type != nullptr && type->isString() ? type->asString() : "";
  FormulaShape shape;
  if (kind == "parametric") {
    shape = readParametric(surface, place, context);
  } else if (kind == "tube") {
    shape = readTube(surface, place, context);
  } else if (kind == "revolution") {
    shape = readRevolution(surface, place, context);
  } else {
    throw Error(ErrorCode::InputInvalid,
                "the type of the surface is not \"parametric\", \"tube\" or \"revolution\"", place,
                "see the page on part formats");
  }
  CadModel model;
  model.bodies.push_back({shape.shape, document.contains("name") ? section.text("name") : "", {}});
  model.unit = "mm";
  model.deviation = shape.deviation;
  return model;
}

}  // namespace wcam::io
