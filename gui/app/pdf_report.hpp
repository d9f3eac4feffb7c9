// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

#include <string>

namespace wcam::gui {

/// The page of project::htmlReport as a PDF of A4 pages: figures become a table, plots pictures of
/// 300 dpi. Needs an application object, no display; may run in the background.
/// @throws Error(Internal) when Qt cannot make it
QByteArray pdfReport(const std::string& html);

}  // namespace wcam::gui
