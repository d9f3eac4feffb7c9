// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "application.hpp"

#include "wcam/base/file_io.hpp"

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

/// Runs once the window is there and its view is drawn.
void afterStartup(MainWindow& window, const std::function<void()>& then) {
  if (window.view() == nullptr) {
    QTimer::singleShot(0, &window, then);
    return;
  }
  QObject::connect(window.view(), &VtkWidget::painted, &window, then, Qt::SingleShotConnection);
}

}  // namespace

void prepareApplication() {
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
    return true;
  }
  auto* own = new QTranslator(&application);
  if (!own->load(locale, "wcam", "_", ":/i18n")) {
    delete own;
    return false;
  }
  QCoreApplication::installTranslator(own);
  auto* base = new QTranslator(&application);
  if (base->load(locale, "qtbase", "_", QLibraryInfo::path(QLibraryInfo::TranslationsPath))) {
    QCoreApplication::installTranslator(base);
  }
  return true;
}

int runApplication(int argc, char** argv) {
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
    window.show();
    const QStringList files = parser.positionalArguments();
    const bool leave = parser.isSet(exitOption);
    afterStartup(window, [&window, files, leave] {
      if (files.isEmpty() && !leave) {
        window.offerUntitledWork();
      }
      const bool opened = files.isEmpty() || window.openFile(pathFromText(utf8(files.front())));
      if (leave) {
        std::fputs(utf8(window.noticeText() + (window.noticeText().isEmpty() ? "" : "\n")).c_str(),
                   stderr);
        QCoreApplication::exit(opened ? 0 : exitCodeOf(ErrorCode::InputInvalid));
      }
    });
    code = QApplication::exec();
  }
  return code;
}

}  // namespace wcam::gui
