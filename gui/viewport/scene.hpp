// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "prepared.hpp"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace wcam::viewport {

enum class PartStyle { Hidden, Edges, Translucent, Solid };

/// Colours of the view; one set for light and one for dark.
struct Theme {
  Colour top;
  Colour bottom;
  Colour part;
  Colour edge;
  Colour substrate;
  Colour text;
};

Theme lightTheme();
Theme darkTheme();

/// Everything that is seen: parts, substrate, beads, cell, torch, marks. Belongs to the thread of
/// the view. A changed range of moves or pose touches no geometry of other chunks.
class Scene {
public:
  Scene();
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  [[nodiscard]] vtkRenderer* renderer() const;
  void setTheme(const Theme& theme);

  // What is built, in the part frame.
  void setParts(std::vector<std::shared_ptr<const PreparedMesh>> parts);
  void setPartStyle(PartStyle style);
  void setSubstrate(std::shared_ptr<const PreparedMesh> mesh);
  void setSubstrateVisible(bool visible);
  /// Faces and edges to mark, by part and index.
  void setMarkedFaces(const std::vector<std::pair<int, int>>& faces);
  void setMarkedEdges(const std::vector<std::pair<int, int>>& edges);

  // The path.
  /// Without colours until they are set.
  void setPath(std::shared_ptr<PreparedPath> path);
  /// Three bytes per move.
  void setPathColours(const std::vector<std::uint8_t>& colours);
  /// Shows moves [begin, end). Costs the chunks that change.
  void setRange(std::size_t begin, std::size_t end);
  void setTravelVisible(bool visible);
  void setStale(bool stale);
  /// Marks one move; none hides the mark.
  void setMark(std::optional<Point> position);
  [[nodiscard]] bool drawsLines() const;  ///< too many moves for solids

  // The cell; poses in the part frame.
  void setBodies(const std::vector<Body>& bodies);
  void setBodyPoses(const std::vector<Matrix>& poses);
  void setBodiesVisible(bool visible);
  /// Torch at the present move, in the part frame: z is the tool axis.
  void setTorch(std::optional<Matrix> pose);
  /// Pose of the part in the view: identity, or what the positioner does.
  void setPartPose(const Matrix& pose);

  void setSection(bool on, const Point& origin, const Point& normal);
  void setMeasure(std::optional<std::pair<Point, Point>> ends, const std::string& text);

  /// Bounds of what is built (xmin, xmax, ...); of everything with the cell when it is shown.
  [[nodiscard]] std::array<double, 6> bounds() const;

  /// Boxes of the bodies that are shown, but for the surroundings and those that hold the point
  /// itself, as the torch holds the tip of its wire.
  [[nodiscard]] std::vector<std::array<double, 6>> obstacles(const Point& point) const;

  /// What a ray from the eye through a pixel hits. Points and edges are found within `reach`
  /// pixels.
  /// What is hidden by a solid part, the substrate or other beads, or cut away, is left out.
  /// @param view the row-major matrix that maps world to clip coordinates, pixels from the lower
  /// left
  struct Ray {
    Matrix worldToClip{};
    Point eye{};
    Point direction{};
    double x = 0.0;
    double y = 0.0;
    double width = 1.0;
    double height = 1.0;
    double reach = 10.0;
  };

  [[nodiscard]] Pick pickMove(const Ray& ray) const;
  [[nodiscard]] Pick pickEdge(const Ray& ray) const;
  [[nodiscard]] Pick pickFace(const Ray& ray) const;

  /// Number of chunks in full detail whose cells were given to VTK since the start: tells tests
  /// what a change costs.
  [[nodiscard]] std::size_t uploads() const;

  // What a frame draws. A picture in full detail may take too long for one: then portions of it are
  // drawn onto each other. A coarse picture has lines for beads and fewer triangles of parts.
  enum class Detail { Fine, Coarse };
  /// Triangles of a picture. What was not drawn before counts more.
  [[nodiscard]] double triangles(Detail detail) const;
  /// The next frame draws a whole picture. @return its triangles
  double chooseAll(Detail detail);
  /// Begins a picture in portions.
  /// @param capacity triangles of a frame: translucent parts that have more are taken coarse, since
  /// they are mixed in one go
  void beginPortions(double capacity);
  /// The next frame draws the next portion. @return its triangles
  double choosePortion(double capacity);
  /// A small object of each kind that is drawn, for a first frame that nobody sees.
  void addSamples();
  void removeSamples();
  /// True when the last portion was chosen.
  [[nodiscard]] bool portionsComplete() const;

private:
  struct Impl;
  class Sight;
  std::unique_ptr<Impl> impl_;
};

}  // namespace wcam::viewport
