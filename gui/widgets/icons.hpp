// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QString>

namespace wcam::gui {

/// What a badge in the tree says.
enum class Status { None, Ok, Stale, Running, Information, Warning, Error };

/// A drawn icon in the colours of the present palette; an unknown name gives an empty icon.
QIcon icon(const QString& name);
QIcon statusIcon(Status status);
QIcon applicationIcon();
QColor statusColour(Status status);

}  // namespace wcam::gui
