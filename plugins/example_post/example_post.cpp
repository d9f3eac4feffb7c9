// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

// The smallest useful post-processor: one line per move, comma separated.
#include "wcam/plugin/plugin.hpp"
#include "wcam/program/text_writer.hpp"
#include "wcam/program/validate.hpp"

namespace {

using wcam::plugin::OutputFile;
using wcam::plugin::PostProcessor;
namespace ir = wcam::program;

/// The parameters of this post. Everything the user sees of them comes from schema().
struct Params {
  bool header = true;
  int decimals = 3;
};

wcam::Schema<Params> schema() {
  return wcam::Schema<Params>{}
      .add(&Params::header, {.key = "header", .label = "Header line"})
      .add(&Params::decimals, {.key = "decimals",
                               .label = "Decimals",
                               .help = "Of positions in mm and speeds in mm/s.",
                               .min = 0,
                               .max = 6});
}

class CsvPost final : public PostProcessor {
public:
  [[nodiscard]] std::vector<OutputFile> post(const ir::Program& program,
                                             const wcam::Value& values,
                                             const wcam::JobContext& context) const override {
    const Params params = schema().read(values, "post-processor example.post.csv");
    ir::requireValid(program);
    ir::TextWriter out;
    if (params.header) {
      out.text("layer,bead,point,x_mm,y_mm,z_mm,speed_mm_s,arc\n");
    }
    bool arc = false;
    for (const ir::Instruction& instruction : program.instructions) {
      context.check();
      if (std::holds_alternative<ir::ArcOn>(instruction.action)) {
        arc = true;
      } else if (std::holds_alternative<ir::ArcOff>(instruction.action)) {
        arc = false;
      }
      double speed = 0.0;  // a joint move has no path speed
      if (const auto* move = std::get_if<ir::MoveLinear>(&instruction.action)) {
        speed = move->speed;
      } else if (const auto* circle = std::get_if<ir::MoveCircular>(&instruction.action)) {
        speed = circle->speed;
      }
      ir::forEachTarget(instruction.action, [&](const ir::Target& target) {
        const auto p = target.T_table_tcp.translation();
        const ir::Origin& origin = instruction.origin;
        out.integer(origin.layer).text(",").integer(origin.bead).text(",").integer(origin.point);
        for (const double number : {p.x(), p.y(), p.z(), speed}) {
          out.text(",").fixed(number, params.decimals);
        }
        out.text(arc ? ",1\n" : ",0\n");
      });
    }
    return {{program.name + ".csv", out.take()}};
  }
};

void registerComponents(wcam::plugin::Registrar& registrar) {
  registrar.addPost(
      {.id = "example.post.csv",
       .name = "Comma separated values",
       .summary = "One line per move, for spreadsheets and for learning to write a post",
       .params = schema().params()},
      [] { return std::make_unique<CsvPost>(); });
}

}  // namespace

WCAM_PLUGIN(registerComponents);
