// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wcam/project/history.hpp"

#include "wcam/base/text.hpp"

#include "sample_project.hpp"

namespace wcam::project {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

Command rename(const std::string& name) {
  return {"project.rename", Value::object({{"name", Value(name)}})};
}

Command step(double value) {
  return {"operation.set_param",
          Value::object({{"id", "planar"}, {"key", "step"}, {"value", value}})};
}

TEST(History, UndoAndRedoGoThroughTheSnapshots) {
  History history(sampleDocument());
  EXPECT_FALSE(history.canUndo());
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  EXPECT_TRUE(history.apply(rename("a")));
  EXPECT_TRUE(history.apply(step(2.0)));
  EXPECT_EQ(history.undoLabel(), "Set step of planar");
  EXPECT_THAT(history.labels(), ElementsAre("Rename project", "Set step of planar"));
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.current().project().name, "a");
  EXPECT_EQ(history.redoLabel(), "Set step of planar");
  EXPECT_EQ(history.undoLabel(), "Rename project");
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.current().text(), sampleDocument().text());
  EXPECT_EQ(history.undoLabel(), "");
  EXPECT_TRUE(history.redo());
  EXPECT_TRUE(history.redo());
  EXPECT_EQ(history.current().project().operation("planar")->params.at("step").asReal(), 2.0);
  EXPECT_EQ(history.redoLabel(), "");
}

TEST(History, NewStepDropsWhatWasUndone) {
  History history(sampleDocument());
  history.apply(rename("a"));
  history.apply(rename("b"));
  history.undo();
  history.apply(rename("c"));
  EXPECT_FALSE(history.canRedo());
  history.undo();
  EXPECT_EQ(history.current().project().name, "a");
}

TEST(History, CommandWithoutEffectIsNoStep) {
  History history(sampleDocument());
  history.apply(rename("a"));
  history.undo();
  EXPECT_FALSE(history.apply(rename("élbow")));
  EXPECT_TRUE(history.canRedo());
  EXPECT_FALSE(history.canUndo());
}

TEST(History, FailingCommandChangesNothing) {
  History history(sampleDocument());
  history.apply(rename("a"));
  history.undo();
  EXPECT_THROW(history.apply({"part.remove", Value::object({{"id", "elbow"}})}), Error);
  EXPECT_TRUE(history.canRedo());
  EXPECT_EQ(history.current(), sampleDocument());
}

TEST(History, CleanMarkerFollowsUndo) {
  History history(sampleDocument());
  EXPECT_TRUE(history.isClean());
  history.apply(rename("a"));
  EXPECT_FALSE(history.isClean());
  history.markClean();
  EXPECT_TRUE(history.isClean());
  history.undo();
  EXPECT_FALSE(history.isClean());
  history.redo();
  EXPECT_TRUE(history.isClean());
  history.undo();
  history.apply(rename("b"));
  history.undo();
  EXPECT_FALSE(history.isClean()) << "the saved state is gone for good";
}

TEST(History, DragsAreOneStep) {
  History history(sampleDocument());
  for (int i = 1; i <= 10; ++i) {
    history.apply(step(i + 0.5), "drag 1");
  }
  EXPECT_EQ(history.labels().size(), 1U);
  history.apply(step(3.0), "drag 2");
  EXPECT_EQ(history.labels().size(), 2U);
  history.undo();
  EXPECT_EQ(history.current().project().operation("planar")->params.at("step").asReal(), 10.5);
  history.apply(step(4.0), "drag 1");
  EXPECT_EQ(history.labels().size(), 2U) << "after an undo a drag begins anew";
}

TEST(History, DragDoesNotChangeTheSavedState) {
  History history(sampleDocument());
  history.apply(step(1.0), "drag");
  history.markClean();
  history.apply(step(2.0), "drag");
  EXPECT_FALSE(history.isClean());
  history.undo();
  EXPECT_TRUE(history.isClean());
}

TEST(History, TransactionIsOneStep) {
  History history(sampleDocument());
  {
    History::Transaction transaction(history, "Prepare");
    history.apply(rename("a"));
    history.apply(step(1.0));
    EXPECT_EQ(history.current().project().name, "a");
    EXPECT_FALSE(history.undo());
    EXPECT_TRUE(transaction.commit());
  }
  EXPECT_THAT(history.labels(), ElementsAre("Prepare"));
  history.undo();
  EXPECT_EQ(history.current(), sampleDocument());
}

TEST(History, TransactionWithoutCommitIsDropped) {
  History history(sampleDocument());
  std::vector<std::string> log;
  history.setLog([&](const std::string& line) { log.push_back(line); });
  try {
    History::Transaction transaction(history, "Prepare");
    history.apply(rename("a"));
    history.apply({"part.remove", Value::object({{"id", "elbow"}})});
    FAIL();
  } catch (const Error&) {
  }
  EXPECT_EQ(history.current(), sampleDocument());
  EXPECT_FALSE(history.canUndo());
  EXPECT_TRUE(log.empty());
  {
    History::Transaction transaction(history, "Nothing");
    EXPECT_THROW(History::Transaction(history, "Second"), Error);
    EXPECT_FALSE(transaction.commit());
  }
  EXPECT_FALSE(history.canUndo());
}

TEST(History, ForgetsTheOldestBeyondItsBudget) {
  History history(sampleDocument(), 1);
  for (int i = 0; i < 5; ++i) {
    history.apply(rename("n" + std::to_string(i)));
  }
  EXPECT_EQ(history.labels().size(), 1U);
  EXPECT_TRUE(history.undo());
  EXPECT_EQ(history.current().project().name, "n3");
  EXPECT_FALSE(history.undo());
}

TEST(History, SnapshotsShareTheirNodes) {
  History history(sampleDocument());
  const std::size_t first = history.bytes();
  history.apply(rename("a"));
  const std::size_t perStep = history.bytes() - first;
  for (int i = 0; i < 100; ++i) {
    history.apply(rename("n" + std::to_string(i)));
  }
  EXPECT_LE(history.bytes(), first + 102 * perStep);
  // The nodes themselves are the same objects.
  const Value::Array& now = history.current().tree().at("operations").asArray();
  history.undo();
  EXPECT_EQ(&history.current().tree().at("operations").asArray(), &now);
}

TEST(SessionLog, ReplayGivesTheSameBytes) {
  std::string log;
  History history(sampleDocument());
  history.setLog([&](const std::string& line) { log += line + "\n"; });
  history.apply(rename("ä \"quoted\"\nname"));
  history.apply(step(1.0), "drag");
  history.apply(step(2.0), "drag");
  history.undo();
  history.redo();
  {
    History::Transaction transaction(history, "Both");
    history.apply(rename("b"));
    history.apply(step(1e-300));
    transaction.commit();
  }
  history.undo();
  History replayed(sampleDocument());
  std::string secondLog;
  replayed.setLog([&](const std::string& line) { secondLog += line + "\n"; });
  EXPECT_EQ(replayed.replay(log, "session"), 7U);
  EXPECT_EQ(replayed.current().text(), history.current().text());
  EXPECT_EQ(replayed.labels(), history.labels());
  EXPECT_EQ(replayed.position(), history.position());
  EXPECT_EQ(secondLog, log);
}

TEST(SessionLog, SkipsBlankLinesAndComments) {
  History history(sampleDocument());
  EXPECT_EQ(
      history.replay(
          "\n# a comment\r\n  {\"command\": \"project.rename\", \"args\": {\"name\": \"z\"}}\r\n\n",
          "log"),
      1U);
  EXPECT_EQ(history.current().project().name, "z");
  EXPECT_EQ(history.replay("", "log"), 0U);
}

TEST(SessionLog, ErrorsNameTheLine) {
  const std::string good = R"({"command": "project.rename", "args": {"name": "z"}})";
  const auto failure = [&](ErrorCode code, const std::string& bad) {
    History history(sampleDocument());
    const std::string message = errorOf(
        code, [&] { (void)history.replay(good + "\n\n" + bad + "\n" + good, "log.jsonl"); });
    EXPECT_EQ(history.current().project().name, "z") << "what was applied before stays";
    EXPECT_THAT(message, HasSubstr("log.jsonl, line 3"));
    return message;
  };
  failure(ErrorCode::InputInvalid, "{");
  failure(ErrorCode::InputInvalid, "plain text");
  failure(ErrorCode::InputInvalid, "[]");
  failure(ErrorCode::InputInvalid, R"({"command": "part.fly"})");
  failure(ErrorCode::InputInvalid, R"({"command": "redo"})");
  failure(ErrorCode::InputInvalid, R"({"transaction": 3, "commands": []})");
  failure(ErrorCode::InputInvalid, R"({"transaction": "t"})");
  failure(ErrorCode::InputInvalid, R"({"command": "cell.remove", "merged": 1})");
  EXPECT_THAT(
      failure(ErrorCode::InputInvalid, R"({"command": "part.remove", "args": {"id": "elbow"}})"),
      AllOf(HasSubstr("part.remove"), HasSubstr("is used by")));
  failure(
      ErrorCode::InputInvalid,
      R"({"transaction": "t", "commands": [{"command": "cell.remove"}, {"command": "part.fly"}]})");
}

TEST(SessionLog, FailedGroupLeavesNothingBehind) {
  History history(sampleDocument());
  EXPECT_THROW(
      (void)history.replay(
          R"({"transaction": "t", "commands": [{"command": "cell.remove"}, {"command": "part.fly"}]})",
          "log"),
      Error);
  EXPECT_EQ(history.current(), sampleDocument());
}

}  // namespace
}  // namespace wcam::project
