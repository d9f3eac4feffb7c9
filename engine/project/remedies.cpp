// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "remedies.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/file_io.hpp"
#include "wcam/base/json.hpp"
#include "wcam/base/quantity.hpp"
#include "wcam/base/remedy.hpp"
#include "wcam/base/text.hpp"
#include "wcam/cell/inverse.hpp"
#include "wcam/project/placing.hpp"
#include "wcam/project/project_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

namespace wcam::project::detail {

namespace {

/// In front of figures that stand for a change of the project.
constexpr std::string_view kTry = "try_";

std::optional<double> figure(const Diagnostic& finding, std::string_view name) {
  for (const auto& [key, value] : finding.data) {
    if (key == name) {
      return value;
    }
  }
  return std::nullopt;
}

bool isTry(const std::pair<std::string, double>& entry) {
  return entry.first.rfind(kTry, 0) == 0;
}

std::string withSign(double value, const char* unit) {
  return (value < 0.0 ? "-" : "+") + formatFixed(std::abs(value), 0) + " " + unit;
}

Command setMotion(const std::string& operation, const char* key, Value value) {
  return {
      "operation.set_param",
      Value::object(
          {{"id", operation}, {"section", "motion"}, {"key", key}, {"value", std::move(value)}})};
}

/// The configuration as its parameter names it.
Value branchValue(const cell::Cell& cell, double branch) {
  std::string name = cell.inverse->branchName(static_cast<int>(branch));
  for (char& c : name) {
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return Value(name);
}

/// Moves the part on its table; placements are in the part frame.
std::vector<Command> movePart(const Document& document,
                              const std::string& operation,
                              const cell::Cell& cell,
                              double turnDeg,
                              const geometry::Vec3& move) {
  geometry::Pose onTable = geometry::Pose::Identity();
  onTable.linear() =
      Eigen::AngleAxisd(degToRad(turnDeg), geometry::Vec3::UnitZ()).toRotationMatrix();
  onTable.translation() = move;
  return placementCommands(document, operation,
                           cell.T_table_part.inverse() * onTable * cell.T_table_part);
}

/// The cell file's other configuration, named as the project names its cell.
std::optional<Command> setOtherCell(const Document& document,
                                    const std::filesystem::path& project) {
  const FileRef& ref = document.project().cell;
  const std::filesystem::path file = resolvePath(project, ref);
  const auto other =
      cell::otherConfigurationFile(parseJson(readFile(file), pathText(file)), file.parent_path());
  if (!other) {
    return std::nullopt;
  }
  const std::size_t folder = ref.path.rfind('/');
  const std::string name = pathText(other->filename());
  const std::string path =
      folder == std::string::npos ? name : ref.path.substr(0, folder + 1) + name;
  // Only beside its own file has it a name like that.
  if (other->lexically_normal() != resolvePath(project, {path, {}}).lexically_normal()) {
    return std::nullopt;
  }
  return Command{"cell.set",
                 Value::object({{"file", Value::object({{"path", path}, {"sha256", ""}})}})};
}

std::map<std::string, std::size_t> violationsByCode(const std::vector<Diagnostic>& findings) {
  std::map<std::string, std::size_t> counts;
  for (const Diagnostic& finding : findings) {
    if (finding.severity == Severity::Violation) {
      ++counts[finding.code];
    }
  }
  return counts;
}

std::size_t sumOf(const std::map<std::string, std::size_t>& counts) {
  std::size_t sum = 0;
  for (const auto& [code, count] : counts) {
    sum += count;
  }
  return sum;
}

/// Fewer of some kind and more of none.
bool isBetter(const std::map<std::string, std::size_t>& after,
              const std::map<std::string, std::size_t>& before) {
  const bool more = std::any_of(after.begin(), after.end(), [&](const auto& entry) {
    const auto own = before.find(entry.first);
    return entry.second > (own != before.end() ? own->second : 0);
  });
  return !more && sumOf(after) < sumOf(before);
}

/// A proposal with how many violations make it.
struct Candidate {
  Proposal proposal;
  std::size_t count = 0;
  bool tried = false;
  std::size_t left = 0;  ///< violations, when it was tried
};

/// Of every finding its candidate; none for what is no violation or proposes nothing.
std::vector<std::optional<std::size_t>> collect(const std::vector<Diagnostic>& findings,
                                                const MakeProposal& makeProposal,
                                                std::vector<Candidate>& candidates) {
  std::vector<std::optional<std::size_t>> own(findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].severity != Severity::Violation) {
      continue;
    }
    const auto proposal = makeProposal(findings[i]);
    if (!proposal) {
      continue;
    }
    const auto same = std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& c) {
      return c.proposal.commands == proposal->commands;
    });
    own[i] = static_cast<std::size_t>(same - candidates.begin());
    if (same == candidates.end()) {
      candidates.push_back({*proposal, 1});
    } else {
      ++same->count;
    }
  }
  return own;
}

/// Tries the candidates. @return the one to offer
std::optional<std::size_t> bestOf(std::vector<Candidate>& candidates,
                                  const std::map<std::string, std::size_t>& before,
                                  const TryRemedy& tryRemedy,
                                  std::size_t most) {
  std::vector<std::size_t> order(candidates.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    order[i] = i;
  }
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return candidates[a].count > candidates[b].count;
  });
  order.resize(std::min(order.size(), most));
  std::optional<std::size_t> best;
  for (const std::size_t i : order) {
    Candidate& candidate = candidates[i];
    const auto found = tryRemedy(candidate.proposal.commands);
    const auto after = found ? violationsByCode(*found) : before;
    candidate.tried = true;
    candidate.left = sumOf(after);
    if (isBetter(after, before) && (!best || candidate.left < candidates[*best].left)) {
      best = i;
    }
    if (best && candidates[*best].left == 0) {
      break;
    }
  }
  return best;
}

}  // namespace

Command setParam(const std::string& operation, const ParamSetting& setting) {
  return {"operation.set_param", Value::object({{"id", operation},
                                                {"section", setting.section},
                                                {"key", setting.key},
                                                {"value", setting.value}})};
}

std::optional<Proposal> proposalOf(const Diagnostic& finding,
                                   const Document& document,
                                   const std::string& operation,
                                   const cell::Cell& cell,
                                   const std::filesystem::path& project) {
  const auto get = [&](std::string_view name) {
    return figure(finding, std::string(kTry) + std::string(name));
  };
  try {
    if (const auto turn = get("turn_deg")) {
      return Proposal{text("turn the part on the table by %1", {withSign(*turn, "deg")}),
                      movePart(document, operation, cell, *turn, geometry::Vec3::Zero())};
    }
    for (int axis = 0; axis < 3; ++axis) {
      const char name = static_cast<char>('x' + axis);
      if (const auto step = get(std::string("table_") + name + "_mm")) {
        geometry::Vec3 move = geometry::Vec3::Zero();
        move(axis) = *step;
        const std::string direction =
            std::string(*step < 0.0 ? "-" : "+") + static_cast<char>('X' + axis);
        return Proposal{text("move the part by %1 mm in %2 of the table",
                             {formatFixed(std::abs(*step), 0), direction}),
                        movePart(document, operation, cell, 0.0, move)};
      }
    }
    if (const auto branch = get("other_branch"); branch && cell.other != nullptr) {
      const auto other = setOtherCell(document, project);
      if (!other) {
        return std::nullopt;
      }
      Proposal proposal{text("take the cell \"%1\"", {cell.other->name}), {*other}};
      if (cell.other->arm) {
        proposal.commands.push_back(
            setMotion(operation, "branch", branchValue(*cell.other, *branch)));
      }
      return proposal;
    }
    if (get("exit_rotations")) {
      return Proposal{text("set exit_rotations, which tilts the torch out of collisions"),
                      {setMotion(operation, "exit_rotations", Value(true))}};
    }
    const auto rotation = get("rotation_deg");
    const auto branch = get("branch");
    Proposal proposal;
    if (branch) {
      proposal.commands.push_back(setMotion(operation, "branch", branchValue(cell, *branch)));
    }
    if (rotation) {
      proposal.commands.push_back(setMotion(operation, "torch_rotation", Value(*rotation)));
    }
    if (branch && rotation) {
      proposal.what =
          text("use the configuration %1 and a rotation of %2 deg about the torch",
               {cell.inverse->branchName(static_cast<int>(*branch)), formatFixed(*rotation, 1)});
    } else if (branch) {
      proposal.what =
          text("use the configuration %1", {cell.inverse->branchName(static_cast<int>(*branch))});
    } else if (rotation) {
      proposal.what =
          text("set the rotation about the torch to %1 deg", {formatFixed(*rotation, 1)});
    } else {
      return std::nullopt;
    }
    return proposal;
  } catch (const Error&) {
    return std::nullopt;  // what does not move with the part: it stays a hint
  }
}

std::vector<std::vector<Command>> triedSettings(const std::vector<Diagnostic>& findings,
                                                const std::string& operation) {
  std::vector<std::vector<Command>> commands(findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    for (const ParamSetting& setting : settingsOf(findings[i])) {
      commands[i].push_back(setParam(operation, setting));
    }
  }
  return commands;
}

RemediedFindings triedRemedies(std::vector<Diagnostic> findings,
                               const MakeProposal& makeProposal,
                               const TryRemedy& tryRemedy,
                               std::size_t most) {
  const auto before = violationsByCode(findings);
  std::vector<Candidate> candidates;
  const auto own = collect(findings, makeProposal, candidates);
  const std::optional<std::size_t> best = bestOf(candidates, before, tryRemedy, most);
  RemediedFindings result;
  result.commands.resize(findings.size());
  for (std::size_t i = 0; i < findings.size(); ++i) {
    Diagnostic& finding = findings[i];
    std::erase_if(finding.data, isTry);
    if (!own[i]) {
      continue;
    }
    if (best) {
      const Candidate& chosen = candidates[*best];
      result.commands[i] = chosen.proposal.commands;
      finding.remedy = chosen.left == 0
                           ? text("%1; tried on the whole operation: no violation is left",
                                  {chosen.proposal.what})
                           : text("%1; tried on the whole operation: %2 of %3 violations are left",
                                  {chosen.proposal.what, std::to_string(chosen.left),
                                   std::to_string(sumOf(before))});
    } else if (candidates[*own[i]].tried) {
      finding.remedy =
          text("%1; tried on the whole operation, it does not help by itself", {finding.remedy});
    }
  }
  result.findings = std::move(findings);
  return result;
}

}  // namespace wcam::project::detail
