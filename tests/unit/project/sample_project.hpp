// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/json.hpp"
#include "wcam/project/document.hpp"

#include "error_matchers.hpp"
#include "test_folder.hpp"

#include <string>

namespace wcam::project {

/// A project that uses every kind of node, with unknown keys at several levels.
inline std::string sampleText() {
  return R"json({
  "format": "wcam-project",
  "format_version": 1,
  "name": "élbow",
  "x_note": {"by": "another tool", "list": [1, 2.50, {"deep": null}]},
  "cell": {"path": "cells/arcmate.json", "sha256": ""},
  "parts": [
    {"id": "elbow", "file": {"path": "elbow.step", "x_size": 12}, "import": {"chord_mm": 0.01},
     "placement": {"position_mm": [0, 0, 12.5], "rotation_deg": [90, 0, 0]}, "faces": [1, 2], "x_tag": "k"},
    {"id": "base.part", "file": {"path": "base.stl"}}
  ],
  "substrates": [
    {"id": "plate", "type": "plate", "size_mm": [300, 300, 20]},
    {"id": "on_part", "type": "part", "part": "base.part", "position_mm": [1, 2, 3]}
  ],
  "guides": [
    {"id": "axis", "type": "formula", "x": "50*cos(t)-50", "y": "0", "z": "50*sin(t)", "begin": 0, "end": 1.5},
    {"id": "rim", "type": "edge", "part": "elbow", "edge": 3, "reversed": true},
    {"id": "named", "type": "edge", "part": "elbow", "edge": "E12"},
    {"id": "line", "type": "polyline", "file": {"path": "guide.csv"}}
  ],
  "processes": [
    {"id": "steel", "params": {"wire_speed": 3.5}},
    {"id": "shop", "file": {"path": "processes/shop.json"}}
  ],
  "operations": [
    {"id": "planar", "strategy": "wcam.slicing.planar", "parts": ["elbow"], "substrate": "plate",
     "process": "steel", "params": {"step": 5.0}},
    {"id": "guided", "strategy": "wcam.slicing.guide", "parts": ["elbow", "base.part"], "substrate": "on_part",
     "guide": "axis", "process": "shop", "path": {"seam": "nearest"}, "motion": {}, "enabled": false}
  ],
  "outputs": [
    {"id": "fanuc", "post": "wcam.post.fanuc", "operations": ["planar"], "params": {"mode": "joint"}, "folder": "ls"},
    {"id": "all", "post": "wcam.post.kuka"}
  ],
  "plugins": [{"id": "wcam.post.fanuc", "version": "0.1.0"}],
  "x_last": [[]]
})json";
}

inline Value sampleTree() {
  return parseJson(sampleText());
}

inline Document sampleDocument() {
  return Document::parse(sampleTree());
}

using wcam::testing::errorOf;
using wcam::testing::TestFolder;

}  // namespace wcam::project
