// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Carries the precompiled headers of the engine (packaging/cmake/WcamModule.cmake); does nothing.
