/* SPDX-FileCopyrightText: 2026 The WCAM developers
   SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WCAM_VERSION_H
#define WCAM_VERSION_H

/* MAJOR.MINOR.PATCH; CMake reads it from here. */
#define WCAM_VERSION "0.1.0"

#endif
