// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/quantity.hpp"

#include "main_window.hpp"
#include "widgets/text.hpp"

#include <QLabel>
#include <QMenu>
#include <QToolTip>

#include <algorithm>
#include <cmath>

namespace wcam::gui {

const GeneratedPart* MainWindow::pickedPart(const viewport::Pick& pick) const {
  // The view counts the parts that could be read.
  int index = 0;
  for (const GeneratedPart& part : session_->generated().parts) {
    if (part.mesh && index++ == pick.part) {
      return &part;
    }
  }
  return nullptr;
}

void MainWindow::showPick(const viewport::Pick& pick) {
  if (measuring_) {
    measure(pick);
    return;
  }
  if (view_ == nullptr) {
    return;
  }
  viewport::Scene& scene = view_->scene();
  scene.setMarkedFaces({});
  scene.setMarkedEdges({});
  if (pick.kind == viewport::Pick::Kind::Move) {
    state_.jumpTo(static_cast<std::size_t>(pick.index));
  } else {
    state_.select(std::nullopt);
    if (pick.kind == viewport::Pick::Kind::Face && pick.index >= 0) {
      scene.setMarkedFaces({{pick.part, pick.index}});
    } else if (pick.kind == viewport::Pick::Kind::Edge) {
      scene.setMarkedEdges({{pick.part, pick.index}});
    }
  }
  view_->redraw();
}

void MainWindow::measure(const viewport::Pick& pick) {
  if (pick.kind == viewport::Pick::Kind::None || view_ == nullptr) {
    return;
  }
  if (!measureFrom_) {
    measureFrom_ = pick.position;
    view_->scene().setMeasure(std::nullopt, {});
    status_->setText(tr("Pick the second place"));
  } else {
    const viewport::Point a = *measureFrom_;
    const viewport::Point b = pick.position;
    const double d = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
    const QString text = QString("%1 mm").arg(figureText(d, 3));
    view_->scene().setMeasure(std::pair(a, b), utf8(text));
    status_->setText(tr("Distance %1 (Δx %2, Δy %3, Δz %4)")
                         .arg(text)
                         .arg(figureText(b[0] - a[0], 3))
                         .arg(figureText(b[1] - a[1], 3))
                         .arg(figureText(b[2] - a[2], 3)));
    measureFrom_.reset();
  }
  view_->redraw();
}

namespace {

QString moveTip(const PathModel& path, std::size_t move) {
  QString tip = MainWindow::tr("<b>Layer %1, bead %2, point %3</b>")
                    .arg(path.layer(move) + 1)
                    .arg(path.bead(move) + 1)
                    .arg(path.point(move) + 1);
  const auto row = [&tip](const QString& name, const QString& value) {
    tip += QString("<tr><td>%1&nbsp;</td><td align='right'>%2</td></tr>").arg(name, value);
  };
  tip += "<table>";
  const toolpath::PathPoint* point = path.pathPoint(move);
  if (point != nullptr) {
    row(MainWindow::tr("Position"),
        QStringList(
            {figureText(point->p.x(), 2), figureText(point->p.y(), 2), figureText(point->p.z(), 2)})
                .join(listSeparator()) +
            " mm");
    row(nameOf(Quantity::Height), QString("%1 mm").arg(figureText(point->height, 3)));
    row(nameOf(Quantity::Distance), QString("%1 mm").arg(figureText(point->distance, 3)));
    row(nameOf(Quantity::Width), QString("%1 mm").arg(figureText(point->width, 2)));
    row(nameOf(Quantity::TravelSpeed), QString("%1 mm/s").arg(figureText(point->speed, 2)));
    row(nameOf(Quantity::WireSpeed),
        QString("%1 m/min")
            .arg(figureText(toFileUnit(QuantityKind::WireSpeed, point->wireSpeed), 2)));
  }
  if (const motion::Waypoint* waypoint = path.waypoint(move)) {
    row(nameOf(Quantity::TcpSpeed), QString("%1 mm/s").arg(figureText(waypoint->tcpSpeed, 2)));
    row(nameOf(Quantity::Time), QString("%1 s").arg(figureText(waypoint->time, 1)));
    const cell::Cell* cell = path.result().cell.get();
    QStringList joints;
    for (int j = 0; cell != nullptr && j < waypoint->joints.size(); ++j) {
      const bool slides = cell->joint(j).prismatic();
      joints.append(
          QString("%1 %2%3")
              .arg(qt(cell->joint(j).name))
              .arg(slides ? waypoint->joints[j] : radToDeg(waypoint->joints[j]), 0, 'f', 1)
              .arg(slides ? " mm" : "°"));
    }
    row(MainWindow::tr("Joints"), joints.join(" "));
  }
  return tip + "</table>";
}

}  // namespace

void MainWindow::showTip(const viewport::Pick& pick, const QPoint& global) {
  QString tip;
  if (pick.kind == viewport::Pick::Kind::Move && state_.path()) {
    tip = moveTip(*state_.path(), static_cast<std::size_t>(pick.index));
  } else if (const GeneratedPart* part = pickedPart(pick)) {
    const auto& brep = part->part->surface->brep;
    if (pick.kind == viewport::Pick::Kind::Face && brep && pick.index >= 0) {
      tip = tr("<b>Face %1</b><br/>%2").arg(pick.index).arg(qt(brep->face(pick.index).surfaceType));
    } else if (pick.kind == viewport::Pick::Kind::Edge && brep && pick.index >= 0) {
      const geometry::BrepEdgeInfo& edge = brep->edge(pick.index);
      tip = tr("<b>Edge %1</b> %2<br/>length %3 mm")
                .arg(pick.index)
                .arg(qt(edge.name))
                .arg(figureText(edge.length, 2));
    }
  }
  if (tip.isEmpty()) {
    QToolTip::hideText();
  } else {
    QToolTip::showText(global + QPoint(12, 8), tip, view_);
  }
}

void MainWindow::pickMenu(const viewport::Pick& pick, const QPoint& global) {
  QMenu menu(this);
  const project::Project& project = session_->document().project();
  const GeneratedPart* picked = pickedPart(pick);
  const bool ofPart = picked != nullptr;
  const std::string part = ofPart ? picked->id : std::string();
  const std::string operation = shownOperation();
  if (ofPart && pick.kind == viewport::Pick::Kind::Edge && pick.index >= 0) {
    menu.addAction(
        tr("Use edge %1 as guide curve").arg(pick.index), this,
        [this, part, edge = pick.index, operation] {
          std::string id = "edge-" + std::to_string(edge);
          std::vector<project::Command> commands;
          if (session_->document().project().guide(id) == nullptr) {
            commands.push_back(
                {"guide.add",
                 Value::object({{"id", id}, {"type", "edge"}, {"part", part}, {"edge", edge}})});
          }
          if (!operation.empty()) {
            commands.push_back(
                {"operation.set", Value::object({{"id", operation}, {"guide", id}})});
          }
          runAll(tr("Guide curve from edge %1").arg(edge), commands);
        });
  }
  if (ofPart && pick.kind == viewport::Pick::Kind::Face && pick.index >= 0) {
    const auto faces =
        project.part(part) != nullptr ? project.part(part)->faces : std::vector<int>();
    const bool has = std::find(faces.begin(), faces.end(), pick.index) != faces.end();
    menu.addAction(
        has ? tr("Take face %1 from the working surface").arg(pick.index)
            : tr("Add face %1 to the working surface").arg(pick.index),
        this, [this, part, faces, has, face = pick.index] {
          Value list = Value::array();
          for (const int f : faces) {
            if (f != face) {
              list.push(f);
            }
          }
          if (!has) {
            list.push(face);
          }
          run({"part.set",
               Value::object({{"id", part}, {"faces", list.size() > 0 ? list : Value()}})});
        });
    menu.addAction(tr("Set part on face %1").arg(pick.index), this, [this, pick, part] {
      tree_->select({"parts", part});
      chosenFace_ = pick.index;
      dropPart();
    });
  }
  if (pick.kind == viewport::Pick::Kind::Move && state_.path()) {
    const auto move = static_cast<std::size_t>(pick.index);
    menu.addAction(tr("Show layer %1 alone").arg(state_.path()->layer(move) + 1), this,
                   [this, move] {
                     actions_->action("play.single")->setChecked(true);
                     state_.jumpTo(move);
                   });
    addPointEdits(menu, move);
    menu.addAction(tr("Seams towards this point"), this, [this, move, operation] {
      // The direction of aligned seams, seen from the middle of the path, in the part frame.
      const std::vector<float>& at = state_.path()->data()->positions;
      const viewport::Point p = state_.path()->position(move);
      double offset[2] = {0.0, 0.0};
      for (std::size_t axis = 0; axis < 2; ++axis) {
        float low = at[axis];
        float high = low;
        for (std::size_t i = axis; i < at.size(); i += 3) {
          low = std::min(low, at[i]);
          high = std::max(high, at[i]);
        }
        offset[axis] = p[axis] - 0.5 * (static_cast<double>(low) + high);
      }
      const double angle = radToDeg(std::atan2(offset[1], offset[0]));
      const auto set = [&](const char* key, Value value) {
        return project::Command{
            "operation.set_param",
            Value::object(
                {{"id", operation}, {"section", "path"}, {"key", key}, {"value", value}})};
      };
      runAll(tr("Seams towards a point"),
             {set("seam", "aligned"), set("seam_direction", std::round(angle * 10) / 10)});
    });
  }
  menu.addSeparator();
  for (const char* id : {"view.fit", "view.cell", "view.section", "view.measure"}) {
    menu.addAction(actions_->action(id));
  }
  menu.exec(global);
}

}  // namespace wcam::gui
