// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/output_set.hpp"
#include "wcam/base/text.hpp"
#include "wcam/project/pipeline.hpp"
#include "wcam/project/placing.hpp"
#include "wcam/project/project_file.hpp"

#include "changed_project.hpp"
#include "verbs.hpp"

#include <cmath>
#include <cstdio>

namespace wcam::cli {

namespace {

std::string describe(const motion::PartPlace& place) {
  return "move (" + formatFixed(place.move.x(), 2) + ", " + formatFixed(place.move.y(), 2) + ", " +
         formatFixed(place.move.z(), 2) + ") mm, turn " + formatFixed(radToDeg(place.turn), 2) +
         " deg: " +
         (place.failing == 0 ? std::string("feasible")
                             : std::to_string(place.failing) + " points fail") +
         ", score " + formatFixed(place.score, 3) + ", limits " +
         formatFixed(radToDeg(place.limitMargin), 1) + " deg, wrist " +
         formatFixed(radToDeg(place.wristBend), 1) + " deg, elbow " +
         formatFixed(radToDeg(place.elbowBend), 1) + " deg, " +
         (std::isfinite(place.axisDistance)
              ? "axis 1 " + formatFixed(place.axisDistance, 0) + " mm, "
              : std::string()) +
         "dexterity " + formatFixed(place.dexterity, 3) + ", clearance " +
         formatFixed(place.clearance, 1) + " mm, " + place.branch + ", torch rotation " +
         formatFixed(radToDeg(place.torchRotation), 0) + " deg";
}

}  // namespace

int placeVerb(const Session& session) {
  const Options& options = session.options;
  const std::filesystem::path file = pathFromText(options.file);
  const project::LoadedProject loaded = project::loadProject(file);
  OutputPlan plan;
  plan.keep(file, "the project");
  for (const project::UsedFile& used : project::usedFiles(loaded.document)) {
    plan.keep(project::resolvePath(file, used.ref), text("the file of the %1", {used.owner}));
  }
  plan.write(pathFromText(options.map), "the map");
  const project::Pipeline pipeline(loaded.document, file, session.plugins);
  motion::PlacementSearch search;
  search.rangeX = search.rangeY = options.placeRange;
  search.rangeZ = options.placeHeight;
  search.step = options.placeStep;
  search.turnStep = degToRad(options.placeTurn);
  const motion::PlacementMap map =
      pipeline.searchPlacement(options.placedOperation, search, session.context);
  session.console.endProgress();
  const motion::PartPlace& best = map.places[map.best];
  session.console.say("now:  " + describe(map.places.front()));
  session.console.say("best: " + describe(best));
  if (!options.map.empty()) {
    writeResult(pathFromText(options.map), project::toCsv(map));
  }
  bool applied = false;
  if (options.applyPlace && map.best != 0 && best.failing == 0) {
    const ChangedProject changed(file);
    if (changed.loaded.sha256 != loaded.sha256) {
      throw Error(ErrorCode::OutputConflict,
                  "another program has changed the project while the place was searched",
                  pathText(file), "search again");
    }
    project::Document document = changed.loaded.document;
    for (const project::Command& command :
         project::placementCommands(document, options.placedOperation, best.pose())) {
      document = project::apply(document, command);
    }
    changed.save(session, document);
    applied = true;
    session.console.say("moved and saved " + pathText(file));
  } else if (options.applyPlace) {
    session.console.say(map.best == 0 ? "the part stands best where it is: nothing moved"
                                      : "no place is feasible: nothing moved");
  }
  if (options.json) {
    std::fputs(toCanonicalJson(project::toValue(map).set("applied", applied)).c_str(), stdout);
  }
  // A search that found nothing feasible ends like a check that fails.
  return best.failing == 0 ? 0 : exitCodeOf(ErrorCode::CheckFailed);
}

}  // namespace wcam::cli
