// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "wcam/base/text.hpp"
#include "wcam/base/value.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace wcam {

/// Information is worth knowing, a warning may harm the part, a violation makes `camcli --check`
/// fail.
enum class Severity { Information, Warning, Violation };
const char* toString(Severity severity) noexcept;

/// Where a finding is; -1 means "not about one layer / bead / point". Counted from 0.
struct Place {
  std::string operation;
  int layer = -1;
  int bead = -1;
  int point = -1;
  friend bool operator==(const Place&, const Place&) = default;
};

/// A finding: something the user should know about a result that exists. Errors that leave no
/// result are exceptions (Error). `code` is stable ("motion.joint_limit"), `data` carries the
/// figures by unit-bearing names ("excess_deg"), `remedy` says how to fix it.
struct Diagnostic {
  Severity severity = Severity::Information;
  std::string code;
  Text message;
  Text remedy;
  Place place;
  std::vector<std::pair<std::string, double>> data;
};

/// {"severity","code","message","remedy","place","data"}; empty parts are left out.
Value toValue(const Diagnostic& diagnostic);
/// One line: "warning process.speed_clamped [elbow layer 3 bead 0 point 12]: message (remedy)".
std::string toLine(const Diagnostic& diagnostic);

/// Findings of one code and severity that a stage keeps; what is beyond is counted in one more
/// finding, "findings.more". A million of them help nobody, and take a gigabyte.
inline constexpr std::size_t kMostOfOneKind = 1000;

/// Thread-safe collection. Stages that add from several threads must add in a fixed order
/// afterwards (collect per index, then append), since order is part of the result.
class Diagnostics {
public:
  Diagnostics() = default;

  Diagnostics(const Diagnostics& other);

  Diagnostics& operator=(const Diagnostics& other);

  void add(Diagnostic diagnostic);
  void append(const std::vector<Diagnostic>& items);
  [[nodiscard]] std::vector<Diagnostic> items() const;
  [[nodiscard]] std::size_t count(Severity severity) const;
  [[nodiscard]] std::size_t count(std::string_view code) const;

private:
  struct Kind {
    std::size_t count = 0;
    std::size_t more = 0;  ///< index of the finding that counts those beyond the limit
  };

  void addLocked(Diagnostic diagnostic);

  mutable std::mutex mutex_;
  std::vector<Diagnostic> items_;
  std::map<std::pair<std::string, Severity>, Kind> kinds_;
};

}  // namespace wcam
