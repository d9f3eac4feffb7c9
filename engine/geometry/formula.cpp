// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#include "formula.hpp"

#include "wcam/base/error.hpp"
#include "wcam/base/quantity.hpp"

#include <muParser.h>

#include <array>

namespace wcam::geometry {

struct Formula::Impl {
  std::array<double, 2> values{};
  mu::Parser parser;
};

Formula::Formula(const std::string& text,
                 const std::vector<std::string>& variables,
                 const std::string& context)
    : impl_(std::make_unique<Impl>()) {
  WCAM_ASSERT(variables.size() <= impl_->values.size());
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
