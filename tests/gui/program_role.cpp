// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "program_role.hpp"

#include "app/application.hpp"
#include "app/main_window.hpp"

#include <QAbstractButton>
#include <QApplication>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QPushButton>
#include <QTimer>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace wcam::gui::test {

namespace {

constexpr int kLookMs = 20;
constexpr int kWaitFor = 1000;  // looks: a program that hangs must not hold up the tests

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

/// Looks again and again until something is done.
void eachMoment(MainWindow& window, const std::function<bool()>& look) {
  auto* timer = new QTimer(&window);
  timer->setInterval(kLookMs);
  auto looks = std::make_shared<int>(0);
  QObject::connect(timer, &QTimer::timeout, &window, [timer, looks, look] {
    if (look()) {
      timer->stop();
      timer->deleteLater();
    } else if (++*looks > kWaitFor) {
      say("gave up");
      timer->stop();
      QCoreApplication::exit(3);
    }
  });
  timer->start();
}

/// A dialog that was opened inside a paint event would be there while the view is being painted.
bool mayOpen(const MainWindow& window) {
  return !const_cast<MainWindow&>(window).view()->paintingActive();
}

void change(MainWindow& window, bool hasFile, bool waits) {
  eachMoment(window, [&window, hasFile, waits, done = false]() mutable {
    Session& session = window.session();
    if (hasFile && session.file().empty()) {
      return false;
    }
    if (!done) {
      done = true;
      static_cast<void>(session.apply({"project.rename", Value::object({{"name", "rescued"}})}));
    }
    const auto saved = project::autosavePath(hasFile ? session.file() : Session::untitledFile());
    if (waits && !std::filesystem::exists(saved)) {
      return false;
    }
    say("ready");
    return true;
  });
}

void recover(MainWindow& window) {
  eachMoment(window, [&window, clicked = false]() mutable {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!clicked && box != nullptr && box->isVisible() && box->objectName() == "recoverBox") {
      clicked = true;
      say(mayOpen(window) ? "asked" : "asked while painting");
      box->buttons().front()->click();
      return false;
    }
    if (clicked && window.session().document().project().name == "rescued") {
      say("name " + window.session().document().project().name);
      say(window.session().modified() ? "modified" : "saved");
      QCoreApplication::exit(0);
      return true;
    }
    return false;
  });
}

void import(MainWindow& window) {
  eachMoment(window, [&window, clicked = false]() mutable {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!clicked && dialog != nullptr && dialog->objectName() == "importDialog") {
      auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
      if (ok->isEnabled()) {
        clicked = true;
        say(mayOpen(window) ? "asked" : "asked while painting");
        ok->click();
      }
      return false;
    }
    if (clicked && !window.session().document().project().parts.empty()) {
      say("parts " + std::to_string(window.session().document().project().parts.size()));
      QCoreApplication::exit(0);
      return true;
    }
    return false;
  });
}

}  // namespace

bool playRole(int argc, char** argv, int& code) {
  if (argc < 3 || std::string(argv[1]) != "--role") {
    return false;
  }
  const std::string role = argv[2];
  const bool hasFile = argc > 3;
  std::vector<char*> own = {argv[0]};
  std::string noUser = "--no-user-plugins";
  own.push_back(noUser.data());
  if (hasFile) {
    own.push_back(argv[3]);
  }
  code = runApplication(static_cast<int>(own.size()), own.data(), [&](MainWindow& window) {
    if (role == "recover") {
      recover(window);
    } else if (role == "import") {
      import(window);
    } else {
      change(window, hasFile, role == "change");
    }
  });
  return true;
}

}  // namespace wcam::gui::test
