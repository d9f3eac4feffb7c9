// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <muParser.h>

#include <array>
#include <string_view>
#include <vector>

namespace wcam::geometry {

namespace {

/// Where the first comma stands that separates no arguments of a function.
std::size_t looseComma(const std::string& text) {
  std::size_t depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    depth += text[i] == '(' ? 1 : 0;
    depth -= text[i] == ')' && depth > 0 ? 1 : 0;
    if (text[i] == ',' && depth == 0) {
      return i;
    }
  }
  return std::string::npos;
}

/// Where a comma stands between two digits in a function that takes any number of values:
/// "min(60, 30+0,5*z)" would have three of them.
std::size_t decimalComma(const std::string& text) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  const auto isName = [&](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || isDigit(c);
  };
  std::vector<bool> open;  // per parenthesis: of such a function
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(') {
      std::size_t begin = i;
      while (begin > 0 && isName(text[begin - 1])) {
        --begin;
      }
      const std::string_view name(text.data() + begin, i - begin);
      open.push_back(name == "min" || name == "max" || name == "sum" || name == "avg");
    } else if (text[i] == ')' && !open.empty()) {
      open.pop_back();
    } else if (text[i] == ',' && !open.empty() && open.back() && i > 0 && isDigit(text[i - 1]) &&
               i + 1 < text.size() && isDigit(text[i + 1])) {
      return i;
    }
  }
  return std::string::npos;
}

/// Where an equals sign stands that compares nothing.
std::size_t assignment(const std::string& text) {
  for (std::size_t i = text.find('='); i != std::string::npos; i = text.find('=', i + 1)) {
    const bool compares =
        i > 0 && std::string_view("=<>!").find(text[i - 1]) != std::string_view::npos;
    const bool doubled = i + 1 < text.size() && text[i + 1] == '=';
    if (!compares && !doubled) {
      return i;
    }
    i += doubled ? 1 : 0;
  }
  return std::string::npos;
}

/// The parser would take the last item of a list, and let a formula change its variable.
void requireOneValue(const std::string& formula, const std::string& context) {
  if (const std::size_t comma = looseComma(formula); comma != std::string::npos) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    const bool decimal = comma > 0 && isDigit(formula[comma - 1]) && comma + 1 < formula.size() &&
                         isDigit(formula[comma + 1]);
    std::string better = formula;
    better[comma] = '.';
    throw Error(
        ErrorCode::InvalidArgument,
        wcam::text("a comma outside of a function (position %1)", {std::to_string(comma + 1)}),
        wcam::text("%1 = %2", {context, formula}),
        decimal ? wcam::text("write %1, with a decimal point", {better})
                : wcam::text("write one formula, not a list"));
  }
  if (const std::size_t comma = decimalComma(formula); comma != std::string::npos) {
    std::string point = formula;
    point[comma] = '.';
    std::string list = formula;
    list.insert(comma + 1, " ");
    throw Error(
        ErrorCode::InvalidArgument,
        wcam::text("a comma between two digits (position %1) may be a decimal comma or separate "
                   "two values",
                   {std::to_string(comma + 1)}),
        wcam::text("%1 = %2", {context, formula}),
        wcam::text("write %1, with a decimal point, or %2, with a blank after the comma",
                   {point, list}));
  }
  if (const std::size_t equals = assignment(formula); equals != std::string::npos) {
    throw Error(ErrorCode::InvalidArgument,
                wcam::text("an assignment (position %1)", {std::to_string(equals + 1)}),
                wcam::text("%1 = %2", {context, formula}),
                "write the formula alone, without a name and '='; '==' compares");
  }
}

}  // namespace

struct Formula::Impl {
  std::array<double, 2> values{};
  mu::Parser parser;
};

Formula::Formula(const std::string& text,
                 const std::vector<std::string>& variables,
                 const std::string& context)
    : impl_(std::make_unique<Impl>()) {
  WCAM_ASSERT(variables.size() <= impl_->values.size());
  requireOneValue(text, context);
  try {
    for (std::size_t i = 0; i < variables.size(); ++i) {
      impl_->parser.DefineVar(variables[i], &impl_->values[i]);
    }
    impl_->parser.DefineConst("pi", kPi);
    impl_->parser.SetExpr(text);
    impl_->parser.Eval();
  } catch (const mu::Parser::exception_type& error) {
    const std::string names = joinText(variables, ", ");
    const std::string where = std::to_string(error.GetPos() + 1);
    throw Error(ErrorCode::InvalidArgument,
                error.GetPos() >= 0 ? wcam::text("%1 (position %2)", {error.GetMsg(), where})
                                    : Text(error.GetMsg()),
                wcam::text("%1 = %2", {context, text}),
                names.empty()
                    ? wcam::text("use numbers, pi, + - * / ^ and functions like sin, sqrt, exp")
                    : wcam::text("use %1, numbers, pi, + - * / ^ and functions like sin, sqrt, exp",
                                 {names}));
  }
}

Formula::~Formula() = default;
Formula::Formula(Formula&&) noexcept = default;
Formula& Formula::operator=(Formula&&) noexcept = default;

double Formula::operator()(double first, double second) const {
  impl_->values = {first, second};
  return impl_->parser.Eval();
}

}  // namespace wcam::geometry
