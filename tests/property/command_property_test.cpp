// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/base/error.hpp"
#include "wcam/base/json.hpp"
#include "wcam/project/history.hpp"
#include "wcam/project/project_file.hpp"

#include "random_source.hpp"
#include <gtest/gtest.h>

#include <algorithm>

namespace wcam::project {
namespace {

using wcam::testing::RandomSource;

const char* const kNouns[] = {"part",      "substrate", "guide", "process",
                              "operation", "output",    "plugin"};

/// Mostly sensible, sometimes wrong commands: the laws below must hold for both.
class CommandSource {
public:
  explicit CommandSource(RandomSource& random) : random_(random) {}

  Command next() {
    const std::string noun = kNouns[random_.below(std::size(kNouns))];
    switch (random_.below(12)) {
      case 0:
      case 1:
      case 2:
        return {noun + ".add", withNoise(nodeArgs(noun, true))};
      case 3:
      case 4:
        return {noun + ".set", withNoise(nodeArgs(noun, false))};
      case 5:
        return {noun + ".remove", Value::object({{"id", id()}})};
      case 6:
        return {noun + ".rename", Value::object({{"id", id()}, {"to", id()}})};
      case 7:
        return {noun + ".move", Value::object({{"id", id()}, {"index", random_.below(4)}})};
      case 8:
        return {noun + ".set_param",
                Value::object({{"id", id()}, {"key", text()}, {"value", value(2)}})};
      case 9:
      case 10:
        return edit();
      default:
        return global();
    }
  }

private:
  Command edit() {
    static const std::vector<std::string> kTypes = {"reverse", "pause", "move_seam", "revers"};
    Value args = Value::object({{"operation", id()}, {"id", id()}});
    switch (random_.below(6)) {
      case 0:
      case 1:
        args.set("type", random_.pick(kTypes));
        if (random_.chance(0.3)) {
          args.set("params", params());
        }
        if (random_.chance(0.3)) {
          args.set("index", random_.below(3));
        }
        return {"edit.add", withNoise(args)};
      case 2:
        return {"edit.set", withNoise(args.set("enabled", random_.chance(0.5)))};
      case 3:
        return {"edit.remove", args};
      case 4:
        return {"edit.move", args.set("index", random_.below(3))};
      default:
        return {"edit.set_param", args.set("key", text()).set("value", value(2))};
    }
  }

  Command global() {
    switch (random_.below(4)) {
      case 0:
        return {"cell.set", Value::object({{"file", file()}})};
      case 1:
        return {"cell.remove", Value::object()};
      case 2:
        return {"file.pin", Value::object({{"files", Value::object({{"a.step", hash()}})}})};
      default:
        return {"project.rename", Value::object({{"name", text()}})};
    }
  }

  Value id() {
    static const std::vector<std::string> kIds = {"a", "b", "c.d", "e-1", "f_2"};
    return Value(random_.chance(0.02) ? "Not an id" : random_.pick(kIds));
  }

  Value text() {
    static const std::vector<std::string> kTexts = {
        "", "step", "a b", "ä€😀", "\"quoted\"\\", "line\nfeed\ttab", std::string("\0", 1), "\x7f"};
    return Value(random_.pick(kTexts));
  }

  Value hash() {
    return Value(random_.chance(0.5) ? std::string()
                                     : std::string(64, '0' + static_cast<char>(random_.below(10))));
  }

  Value file() {
    static const std::vector<std::string> kPaths = {"a.step", "dir/b.stl", "é f.csv"};
    Value ref = Value::object({{"path", random_.pick(kPaths)}});
    if (random_.chance(0.5)) {
      ref.set("sha256", hash());
    }
    return ref;
  }

  Value number() {
    switch (random_.below(5)) {
      case 0:
        return Value(static_cast<std::int64_t>(random_.bits()));
      case 1:
        return Value(random_.real(-1e-300, 1e-300));
      case 2:
        return Value(random_.real(-1e300, 1e300));
      case 3:
        return Value(-0.0);
      default:
        return Value(random_.real(-1000.0, 1000.0));
    }
  }

  Value vector(double from) {
    Value result = Value::array();
    for (int i = 0; i < 3; ++i) {
      result.push(random_.real(from, 500.0));
    }
    return result;
  }

  Value value(int depth) {
    switch (random_.below(depth > 0 ? 6 : 4)) {
      case 0:
        return Value(random_.chance(0.5));
      case 1:
        return text();
      case 2:
        return number();
      case 3:
        return Value();
      case 4: {
        Value list = Value::array();
        for (std::size_t i = random_.below(3); i > 0; --i) {
          list.push(value(depth - 1));
        }
        return list;
      }
      default: {
        Value object = Value::object();
        for (std::size_t i = random_.below(3); i > 0; --i) {
          object.set(text().asString(), value(depth - 1));
        }
        return object;
      }
    }
  }

  Value params() {
    Value object = Value::object();
    for (std::size_t i = random_.below(3); i > 0; --i) {
      object.set(text().asString(), value(1));
    }
    return object;
  }

  Value ids() { return Value(Value::Array{id()}); }

  /// All keys of a node for "add", some of them for "set".
  Value nodeArgs(const std::string& noun, bool all) {
    Value args = Value::object({{"id", id()}});
    const auto put = [&](const char* key, Value v, bool required) {
      if (random_.chance(all && required ? 0.98 : 0.3)) {
        args.set(key, !all && random_.chance(0.2) ? Value() : std::move(v));
      }
    };
    if (noun == "part") {
      put("file", file(), true);
      put("import", params(), false);
      put("faces", Value(Value::Array{Value(random_.below(9))}), false);
      put("placement", Value::object({{"position_mm", vector(-500.0)}}), false);
    } else if (noun == "substrate") {
      const bool plate = random_.chance(0.7);
      put("type", plate ? "plate" : "part", true);
      put("size_mm", vector(1.0), plate);
      put("part", id(), !plate);
      put("position_mm", vector(-500.0), false);
    } else if (noun == "guide") {
      const bool formula = random_.chance(0.5);
      put("type", formula ? "formula" : "polyline", true);
      put("file", file(), !formula);
      for (const char* key : {"x", "y", "z"}) {
        put(key, text(), formula);
      }
      put("begin", random_.real(-1.0, 0.5), formula);
      put("end", random_.real(0.4, 2.0), formula);
    } else if (noun == "process") {
      put("file", file(), false);
      put("params", params(), false);
    } else if (noun == "operation") {
      put("strategy", id(), true);
      put("parts", ids(), true);
      put("substrate", id(), true);
      put("process", id(), true);
      put("guide", id(), false);
      put("params", params(), false);
      put("path", params(), false);
      put("enabled", random_.chance(0.5), false);
    } else if (noun == "output") {
      put("post", id(), true);
      put("operations", ids(), false);
      put("folder", text(), false);
    } else {
      put("version", text(), false);
    }
    return args;
  }

  Value withNoise(Value args) {
    if (random_.chance(0.05)) {
      args.set("unknown", value(1));
    }
    if (random_.chance(0.05)) {
      args.set("id", value(1));
    }
    if (random_.chance(0.1)) {
      args.set("index", random_.below(3));
    }
    return args;
  }

  RandomSource& random_;
};

/// A project with unknown keys, which every sequence must carry along.
Document startDocument() {
  return Document::parse(parseJson(R"({
    "x_first": [1, {"b": 2.50}], "format": "wcam-project", "format_version": 1, "name": "start",
    "parts": [{"x": 1, "id": "a", "file": {"path": "a.step", "y": {}}}],
    "x_between": null,
    "substrates": [{"id": "a", "type": "plate", "size_mm": [1, 2, 3]}],
    "processes": [{"id": "a"}],
    "operations": [{"id": "a", "strategy": "s", "parts": ["a"], "substrate": "a", "process": "a", "z": "z"}]
  })"));
}

class CommandLaws : public ::testing::TestWithParam<std::uint64_t> {};

/// After every step: a failing command leaves the document as it was, saving and loading is the
/// identity, and the typed model has every node of the tree.
TEST_P(CommandLaws, HoldForEveryStep) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  CommandSource commands(random);
  Document document = startDocument();
  int accepted = 0;
  for (int i = 0; i < 300; ++i) {
    const Command command = commands.next();
    const std::string before = document.text();
    Document next;
    try {
      next = apply(document, command);
    } catch (const Error& error) {
      ASSERT_EQ(error.code(), ErrorCode::InvalidArgument) << error.what();
      ASSERT_EQ(document.text(), before);
      continue;
    }
    ++accepted;
    ASSERT_EQ(document.text(), before) << "a command must not touch the old document";
    const std::string text = next.text();
    const LoadedProject loaded = parseProject(text, "x.wcam");
    ASSERT_EQ(loaded.document.text(), text);
    ASSERT_EQ(next.project().operations.size(),
              next.tree().contains("operations") ? next.tree().at("operations").size() : 0U);
    ASSERT_EQ(next.tree().at("x_first"), startDocument().tree().at("x_first"));
    ASSERT_EQ(apply(document, command), next) << "a command is a pure function";
    ASSERT_TRUE(!(document == next) || diff(document, next).empty());
    document = next;
  }
  EXPECT_GT(accepted, 30) << "the generator must reach valid documents";
}

/// Undo after any sequence gives back the bytes of every earlier document, redo those of every
/// later one, and the log of the session reproduces the document, the steps and itself.
TEST_P(CommandLaws, UndoRedoAndReplay) {
  RandomSource random(GetParam());
  SCOPED_TRACE("WCAM_TEST_SEED=" + std::to_string(random.seed()));
  CommandSource commands(random);
  History history(startDocument());
  std::string log;
  history.setLog([&log](const std::string& line) { log += line + "\n"; });
  const auto tryApply = [&](const std::string& key) {
    try {
      history.apply(commands.next(), key);
    } catch (const Error&) {
    }
  };
  for (int i = 0; i < 200; ++i) {
    switch (random.below(12)) {
      case 0:
        history.undo();
        break;
      case 1:
        history.redo();
        break;
      case 2:
        history.markClean();
        break;
      case 3: {
        History::Transaction transaction(history, "group");
        for (std::size_t k = random.below(4); k > 0; --k) {
          tryApply({});
        }
        if (random.chance(0.7)) {
          transaction.commit();
        }
        break;
      }
      case 4:
      case 5:
        tryApply("drag " + std::to_string(random.below(2)));
        break;
      default:
        tryApply({});
    }
  }
  History replayed(startDocument());
  std::string secondLog;
  replayed.setLog([&secondLog](const std::string& line) { secondLog += line + "\n"; });
  replayed.replay(log, "session");
  ASSERT_EQ(replayed.current().text(), history.current().text());
  ASSERT_EQ(replayed.labels(), history.labels());
  ASSERT_EQ(replayed.position(), history.position());
  ASSERT_EQ(secondLog, log);

  while (history.redo()) {
  }
  std::vector<std::string> texts = {history.current().text()};
  while (history.undo()) {
    texts.push_back(history.current().text());
  }
  ASSERT_EQ(texts.back(), startDocument().text()) << "undo of everything restores the file";
  for (auto text = texts.rbegin() + 1; text != texts.rend(); ++text) {
    ASSERT_TRUE(history.redo());
    ASSERT_EQ(history.current().text(), *text);
  }
  ASSERT_FALSE(history.redo());
}

INSTANTIATE_TEST_SUITE_P(Seeds, CommandLaws, ::testing::ValuesIn(wcam::testing::testSeeds(20)));

}  // namespace
}  // namespace wcam::project
