// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.hpp"

#include "wcam/base/file_io.hpp"
#include "wcam/base/version.h"
#include "wcam/plugin/crash_notice.hpp"

#include "end_signals.hpp"
#include "main_window.hpp"
#include "widgets/text.hpp"
#include "widgets/vtk_widget.hpp"

#include <QApplication>
#include <QCommandLineParser>
#include <QLibraryInfo>
#include <QLocale>
#include <QSettings>
#include <QTimer>
#include <QTranslator>

#include <clocale>
#include <cstdio>

namespace wcam::gui {

namespace {

constexpr int kUsage = 1;

/// A window that starts minimised is never painted.
constexpr int kUnpaintedMs = 3000;

/// Runs once the window is there and its view is drawn, from the event loop: a dialog that opened
/// inside a paint event would paint the window a second time.
void afterStartup(MainWindow& window, const std::function<void()>& then) {
  auto* once = new QTimer(&window);
  once->setSingleShot(true);
  VtkWidget* view = window.view();
  QObject::connect(once, &QTimer::timeout, &window, [once, view, then] {
    if (view != nullptr) {
      QObject::disconnect(view, nullptr, once, nullptr);
    }
    once->deleteLater();
    then();
  });
  if (view != nullptr) {
    QObject::connect(
        view, &VtkWidget::painted, once, [once] { once->start(0); },
        static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
  }
  once->start(view != nullptr ? kUnpaintedMs : 0);
}

}  // namespace

void prepareApplication() {
  plugin::nameCrashes("wcam");
  QCoreApplication::setOrganizationName("wcam");
  QCoreApplication::setApplicationName("wcam");
  QCoreApplication::setApplicationVersion(WCAM_VERSION);
  // VTK draws through GLX; under Wayland that is XWayland. The user may say otherwise.
  if (qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM") && !qEnvironmentVariableIsEmpty("DISPLAY")) {
    qputenv("QT_QPA_PLATFORM", "xcb");
  }
  VtkWidget::prepareFormat();
}

bool loadTranslations(QApplication& application, const QString& language) {
  // The plural forms of English.
  auto* english = new QTranslator(&application);
  if (english->load(":/i18n/wcam_en.qm")) {
    QCoreApplication::installTranslator(english);
  }
  const QLocale locale = language.isEmpty() ? QLocale() : QLocale(language);
  if (locale.language() == QLocale::English || locale.language() == QLocale::C) {
    if (!language.isEmpty()) {
      QLocale::setDefault(locale);
    }
    return true;
  }
  auto* own = new QTranslator(&application);
  if (!own->load(locale, "wcam", "_", ":/i18n")) {
    delete own;
    return false;
  }
  QCoreApplication::installTranslator(own);
  // What is typed may have the decimal comma of the language.
  QLocale::setDefault(locale);
  auto* base = new QTranslator(&application);
  if (base->load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(base);
  }
  return true;
}

int runApplication(int argc, char** argv, const std::function<void(MainWindow&)>& started) {
  prepareApplication();
  QApplication application(argc, argv);
  // Numbers in files and fields have a dot in every language.
  std::setlocale(LC_NUMERIC, "C");
  QCommandLineParser parser;
  parser.setApplicationDescription("CAM for robotic wire-arc additive manufacturing");
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument("file", "project (.wcam) to open, or a part to import", "[FILE]");
  const QCommandLineOption exitOption("exit-after-startup",
                                      "Opens the window and the file, then ends with 0.");
  const QCommandLineOption languageOption("language", "Language of the program, for example fr.",
                                          "CODE");
  const QCommandLineOption pluginOption("plugin", "Plugin to load, before all others.", "FILE");
  const QCommandLineOption noUserOption("no-user-plugins",
                                        "Leaves out WCAM_PLUGIN_PATH and the user's plugins.");
  parser.addOptions({exitOption, languageOption, pluginOption, noUserOption});
  parser.process(application);
  if (parser.positionalArguments().size() > 1) {
    std::fputs("wcam: one file at most; see wcam --help\n", stderr);
    return kUsage;
  }
  const QString language = parser.isSet(languageOption) ? parser.value(languageOption)
                                                        : QSettings().value("language").toString();
  if (!loadTranslations(application, language) && parser.isSet(languageOption)) {
    std::fprintf(stderr, "wcam: there is no translation '%s'; English is shown\n",
                 qPrintable(language));
  }
  std::vector<std::filesystem::path> plugins;
  for (const QString& file : parser.values(pluginOption)) {
    plugins.push_back(pathFromText(utf8(file)));
  }
  const auto host = std::make_shared<const plugin::PluginHost>(
      plugin::defaultPluginSearch(plugins, !parser.isSet(noUserOption)));
  int code = 0;
  {
    MainWindow window(host, QGuiApplication::platformName() != "offscreen");
    const EndSignals endSignals(window.session());
    window.show();
    const QStringList files = parser.positionalArguments();
    const bool leave = parser.isSet(exitOption);
    afterStartup(window, [&window, files, leave] {
      // A part goes into a project without a name, which would take the place of the lost one.
      const bool untitled =
          files.isEmpty() || !files.front().endsWith(".wcam", Qt::CaseInsensitive);
      if (untitled && !leave) {
        window.offerUntitledWork();
      }
      const bool opened = files.isEmpty() || window.openFile(pathFromText(utf8(files.front())));
      if (leave) {
        std::fputs(utf8(window.noticeText() + (window.noticeText().isEmpty() ? "" : "\n")).c_str(),
                   stderr);
        QCoreApplication::exit(opened ? 0 : exitCodeOf(ErrorCode::InputInvalid));
      }
    });
    if (started) {
      started(window);
    }
    code = QApplication::exec();
  }
  return code;
}

}  // namespace wcam::gui
