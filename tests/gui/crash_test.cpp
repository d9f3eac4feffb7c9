// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that end badly, and the ones that are started after them: whole processes with a real
// window.

#include "wcam/base/file_io.hpp"

#include "gui_fixture.hpp"
#include "widgets/text.hpp"
#include <signal.h>

#include <QProcess>

namespace wcam::gui {
namespace {

class Program : public ::testing::Test {
protected:
  std::unique_ptr<QProcess> start(const QString& role, const std::filesystem::path& file = {}) {
    auto process = std::make_unique<QProcess>();
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    // A user of its own: nothing of another test is recovered.
    for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
      environment.insert(name, qt(pathText(folder / "home")));
    }
    process->setProcessEnvironment(environment);
    process->setProcessChannelMode(QProcess::ForwardedErrorChannel);
    QStringList arguments = {"--role", role};
    if (!file.empty()) {
      arguments.append(qt(pathText(file)));
    }
    process->start(QCoreApplication::applicationFilePath(), arguments);
    EXPECT_TRUE(process->waitForStarted());
    return process;
  }

  /// Reads what the process says until it says a line, or ends.
  static bool says(QProcess& process, const QByteArray& line, QByteArray& all) {
    while (!all.contains(line + "\n")) {
      if (!process.waitForReadyRead(test::kPatienceMs)) {
        return false;
      }
      all += process.readAllStandardOutput();
    }
    return true;
  }

  /// A change that is not saved, an end by a signal, and a start after it.
  void endAndRecover(const QString& role, int number, const std::filesystem::path& file) {
    endAndRecover(role, number, file, file);
  }

  void endAndRecover(const QString& role,
                     int number,
                     const std::filesystem::path& file,
                     const std::filesystem::path& fileAfter) {
    auto victim = start(role, file);
    QByteArray said;
    ASSERT_TRUE(says(*victim, "ready", said)) << said.toStdString();
    ::kill(static_cast<pid_t>(victim->processId()), number);
    ASSERT_TRUE(victim->waitForFinished(test::kPatienceMs));
    if (number == SIGKILL) {
      EXPECT_EQ(victim->exitStatus(), QProcess::CrashExit);
    } else {
      EXPECT_EQ(victim->exitStatus(), QProcess::NormalExit);
      EXPECT_EQ(victim->exitCode(), 128 + number);
    }
    auto next = start("recover", fileAfter);
    ASSERT_TRUE(next->waitForFinished(test::kPatienceMs));
    const QByteArray answer = next->readAllStandardOutput();
    EXPECT_EQ(next->exitStatus(), QProcess::NormalExit) << "the program crashed at its start";
    EXPECT_EQ(answer.toStdString(), "asked\nname rescued\nmodified\n");
    EXPECT_EQ(next->exitCode(), 0);
  }

  testing::TestFolder folder;
};

TEST_F(Program, ASavedProjectIsRecoveredAfterKill9) {
  endAndRecover("change", SIGKILL, test::copyOf("elbow", folder.path()));
}

TEST_F(Program, AnUnsavedProjectIsRecoveredAfterKill9) {
  endAndRecover("change", SIGKILL, {});
}

TEST_F(Program, ASavedProjectIsRecoveredAfterSigterm) {
  // At once: the last autosave is older than the change.
  endAndRecover("change-at-once", SIGTERM, test::copyOf("elbow", folder.path()));
}

TEST_F(Program, AnUnsavedProjectIsRecoveredAfterSigterm) {
  endAndRecover("change-at-once", SIGTERM, {});
}

TEST_F(Program, AnUnsavedProjectIsRecoveredBeforeAPartIsImported) {
  const std::filesystem::path part = folder / "elbow.step";
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step", part);
  endAndRecover("change", SIGKILL, {}, part);
}

TEST_F(Program, APartOnTheCommandLineIsImportedAtTheStart) {
  const std::filesystem::path part = folder / "elbow.step";
  std::filesystem::copy(test::example("elbow").parent_path() / "elbow.step", part);
  auto program = start("import", part);
  ASSERT_TRUE(program->waitForFinished(test::kPatienceMs));
  EXPECT_EQ(program->exitStatus(), QProcess::NormalExit) << "the program crashed at its start";
  EXPECT_EQ(program->readAllStandardOutput().toStdString(), "asked\nparts 1\n");
}

}  // namespace
}  // namespace wcam::gui
