// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later

#include "main_window.hpp"

#include "wcam/base/file_io.hpp"

#include "node_form.hpp"
#include "widgets/layer_slider.hpp"
#include "widgets/legend.hpp"
#include "widgets/log_view.hpp"
#include "widgets/move_bar.hpp"
#include "widgets/plot.hpp"
#include "widgets/program_view.hpp"
#include "widgets/text.hpp"
#include "widgets/theme.hpp"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QCloseEvent>
#include <QDockWidget>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QProgressBar>
#include <QSettings>
#include <QSlider>
#include <QStatusBar>
#include <QTabWidget>
#include <QTextEdit>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include <cmath>

namespace wcam::gui {

namespace {

constexpr int kLayoutVersion = 1;
constexpr int kProgramDelayMs = 150;
constexpr int kStaleDelayMs = 400;

QDockWidget* dock(QMainWindow* window,
                  const char* name,
                  const QString& title,
                  QWidget* content,
                  Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(title, window);
  made->setObjectName(name);
  made->setWidget(content);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                    QDockWidget::DockWidgetFloatable);
  window->addDockWidget(area, made);
  return made;
}

}  // namespace

MainWindow::MainWindow(std::shared_ptr<const plugin::PluginHost> plugins, bool viewport) {
  setObjectName("mainWindow");
  setWindowIcon(applicationIcon());
  setAcceptDrops(true);
  setDockNestingEnabled(true);
  session_ = new Session(std::move(plugins), this);
  actions_ = new ActionCatalog(this);
  buildCentre(viewport);
  scene_ = new SceneController(state_, view_, this);
  buildDocks();
  buildStatus();
  buildFileActions();
  buildEditActions();
  buildProjectActions();
  buildViewActions();
  buildPlayActions();
  buildHelpActions();
  actions_->fill(*menuBar());
  buildToolBar();
  connectAll();
  resize(1280, 860);
  resizeDocks({treeDock_, formDock_}, {240, 380}, Qt::Horizontal);
  resizeDocks({bottomDock_}, {210}, Qt::Vertical);
  const QSettings settings;
  if (settings.contains("window/geometry")) {
    restoreGeometry(settings.value("window/geometry").toByteArray());
    restoreState(settings.value("window/state").toByteArray(), kLayoutVersion);
  }
  dark_ = settings.value("window/dark", systemIsDark()).toBool();
  actions_->action("view.dark")->setChecked(dark_);
  applyTheme(dark_);
  setPartStyle(viewport::PartStyle::Translucent);
  showDocument();
  showState();
}

MainWindow::~MainWindow() {
  // The jobs end while their listeners still live.
  delete session_;
  session_ = nullptr;
  // Views of the view state go before it.
  for (QWidget* view :
       std::initializer_list<QWidget*>{layers_, moves_, joints_, process_, program_}) {
    delete view;
  }
  delete scene_;
}

void MainWindow::buildCentre(bool viewport) {
  auto* centre = new QWidget(this);
  auto* rows = new QVBoxLayout(centre);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(0);

  notice_ = new QFrame(centre);
  notice_->setObjectName("notice");
  notice_->setFrameShape(QFrame::StyledPanel);
  auto* line = new QHBoxLayout(notice_);
  line->setContentsMargins(10, 6, 6, 6);
  noticeIcon_ = new QLabel(notice_);
  noticeText_ = new QLabel(notice_);
  noticeText_->setObjectName("noticeText");
  noticeText_->setWordWrap(true);
  noticeText_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  auto* close = new QToolButton(notice_);
  close->setObjectName("noticeClose");
  close->setAutoRaise(true);
  close->setText("✕");
  close->setAccessibleName(tr("Close the message"));
  line->addWidget(noticeIcon_);
  line->addWidget(noticeText_, 1);
  line->addWidget(close, 0, Qt::AlignTop);
  connect(close, &QToolButton::clicked, this, &MainWindow::hideNotice);
  notice_->hide();
  rows->addWidget(notice_);

  auto* middle = new QHBoxLayout;
  middle->setSpacing(0);
  if (viewport) {
    view_ = new VtkWidget(centre);
    stage_ = view_;
  } else {
    auto* placeholder = new QLabel(tr("The 3D view needs a display."), centre);
    placeholder->setObjectName("viewport");
    placeholder->setAlignment(Qt::AlignCenter);
    stage_ = placeholder;
  }
  stage_->installEventFilter(this);
  legend_ = new Legend(state_, stage_);
  legend_->hide();
  staleNote_ = new QLabel(stage_);
  staleNote_->setObjectName("staleNote");
  staleNote_->setAutoFillBackground(true);
  staleNote_->setMargin(5);
  staleNote_->hide();
  layers_ = new LayerSlider(state_, centre);
  middle->addWidget(stage_, 1);
  middle->addWidget(layers_);
  rows->addLayout(middle, 1);

  sectionBar_ = new QFrame(centre);
  sectionBar_->setObjectName("sectionBar");
  auto* cut = new QHBoxLayout(sectionBar_);
  cut->setContentsMargins(8, 3, 8, 3);
  cut->addWidget(new QLabel(tr("Section"), sectionBar_));
  sectionAxis_ = new QToolButton(sectionBar_);
  sectionAxis_->setText("Y");
  sectionAxis_->setToolTip(tr("Axis of the section: click for the next one"));
  cut->addWidget(sectionAxis_);
  sectionSlider_ = new QSlider(Qt::Horizontal, sectionBar_);
  sectionSlider_->setObjectName("sectionSlider");
  sectionSlider_->setAccessibleName(tr("Place of the section"));
  sectionSlider_->setRange(0, 1000);
  sectionSlider_->setValue(500);
  cut->addWidget(sectionSlider_, 1);
  sectionBar_->hide();
  rows->addWidget(sectionBar_);
  connect(sectionSlider_, &QSlider::valueChanged, this, &MainWindow::updateSection);
  connect(sectionAxis_, &QToolButton::clicked, this, [this] {
    sectionAxisIndex_ = (sectionAxisIndex_ + 1) % 3;
    sectionAxis_->setText(QString("XYZ").mid(sectionAxisIndex_, 1));
    updateSection();
  });

  moves_ = new MoveBar(state_, centre);
  rows->addWidget(moves_);
  setCentralWidget(centre);
}

void MainWindow::buildDocks() {
  tree_ = new ProjectTree(this);
  form_ = new ParamForm(this);
  treeDock_ = dock(this, "treeDock", tr("Project"), tree_, Qt::LeftDockWidgetArea);
  formDock_ = dock(this, "formDock", tr("Parameters"), form_, Qt::RightDockWidgetArea);
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName("bottomTabs");
  tabs_->setDocumentMode(true);
  diagnostics_ = new DiagnosticsTable(this);
  joints_ = new JointPlot(state_, this);
  process_ = new ProcessPlot(state_, this);
  program_ = new ProgramView(state_, this);
  log_ = new LogView(this);
  history_ = new QListWidget(this);
  history_->setObjectName("historyList");
  history_->setAccessibleName(tr("History"));
  history_->setFrameShape(QFrame::NoFrame);
  tabs_->addTab(diagnostics_, tr("Findings"));
  tabs_->addTab(joints_, tr("Joints"));
  tabs_->addTab(process_, tr("Process"));
  tabs_->addTab(program_, tr("Program"));
  tabs_->addTab(history_, tr("History"));
  tabs_->addTab(log_, tr("Log"));
  bottomDock_ = dock(this, "bottomDock", tr("Results"), tabs_, Qt::BottomDockWidgetArea);
  // The tabs say what it is.
  bottomDock_->setTitleBarWidget(new QWidget(bottomDock_));
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
}

void MainWindow::buildStatus() {
  status_ = new QLabel(this);
  status_->setObjectName("statusText");
  progress_ = new QProgressBar(this);
  progress_->setObjectName("progress");
  progress_->setRange(0, 1000);
  progress_->setFixedWidth(220);
  progress_->setTextVisible(true);
  cancel_ = new QToolButton(this);
  cancel_->setObjectName("cancel");
  cancel_->setIcon(icon("cancel"));
  cancel_->setAutoRaise(true);
  cancel_->setToolTip(tr("Cancel (Esc)"));
  cancel_->setAccessibleName(cancel_->toolTip());
  statusBar()->addWidget(status_, 1);
  statusBar()->addPermanentWidget(progress_);
  statusBar()->addPermanentWidget(cancel_);
  progress_->hide();
  cancel_->hide();
}

void MainWindow::connectAll() {
  qApp->installEventFilter(this);
  // A command means the project with what is being typed.
  actions_->setBefore([this](const QString& id) {
    if (id != "project.cancel" && !id.startsWith("view.") && !id.startsWith("play.")) {
      form_->commit();
    }
  });
  connect(session_, &Session::documentChanged, this, &MainWindow::showDocument);
  connect(session_, &Session::fileChanged, this, &MainWindow::showTitle);
  connect(session_, &Session::resultsChanged, this, &MainWindow::showResults);
  connect(session_, &Session::stateChanged, this, &MainWindow::showState);
  connect(session_, &Session::changedOnDisk, this, &MainWindow::offerReload);
  connect(session_, &Session::failed, this,
          [this](const QString& message) { notify(Status::Error, message); });
  session_->generation().setProgress([this](double fraction, const std::string& label) {
    // A progress bar repaints itself at once, and with it the 3D view is composed anew: later will
    // do.
    progress_->setUpdatesEnabled(false);
    progress_->setValue(static_cast<int>(1000 * fraction));
    progress_->setFormat(engineText(label) + " %p%");
    progress_->setUpdatesEnabled(true);
  });
  connect(cancel_, &QToolButton::clicked, this,
          [this] { actions_->action("project.cancel")->trigger(); });
  connect(tree_, &ProjectTree::nodeSelected, this, &MainWindow::showNode);
  connect(tree_, &ProjectTree::nodeMenu, this, &MainWindow::nodeMenu);
  connect(tree_, &ProjectTree::enabledChanged, this, [this](const NodeRef& node, bool on) {
    run(commandOf(session_->document(), node, "node", "enabled", on ? Value() : Value(false)));
  });
  layers_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(layers_, &QWidget::customContextMenuRequested, this,
          [this](const QPoint& at) { layerMenu(layers_->mapToGlobal(at)); });
  connect(form_, &ParamForm::edited, this, &MainWindow::editNode);
  connect(diagnostics_, &DiagnosticsTable::activated, this, &MainWindow::jump);
  connect(diagnostics_, &DiagnosticsTable::applied, this, &MainWindow::applyRemedy);
  connect(scene_, &SceneController::coloursChanged, this, [this] {
    legend_->setColours(scene_->colours());
    legend_->setVisible(state_.path() != nullptr && actions_->action("view.legend")->isChecked());
    placeOverlay();
  });
  connect(legend_, &Legend::chooseQuantity, this,
          [this] { colours_->popup(legend_->mapToGlobal(QPoint(0, 24))); });
  connect(history_, &QListWidget::itemActivated, this,
          [this] { session_->goTo(static_cast<std::size_t>(history_->currentRow())); });
  connect(history_, &QListWidget::itemClicked, this,
          [this] { session_->goTo(static_cast<std::size_t>(history_->currentRow())); });
  programDelay_.setSingleShot(true);
  programDelay_.setInterval(kProgramDelayMs);
  connect(&programDelay_, &QTimer::timeout, this, &MainWindow::showProgram);
  // What is computed at once need not turn grey in between.
  staleDelay_.setSingleShot(true);
  staleDelay_.setInterval(kStaleDelayMs);
  connect(&staleDelay_, &QTimer::timeout, this, [this] {
    if (session_->stale()) {
      scene_->setStale(true);
    }
  });
  connect(program_, &ProgramView::wanted, &programDelay_, qOverload<>(&QTimer::start));
  if (view_ != nullptr) {
    connect(view_, &VtkWidget::clicked, this,
            [this](const viewport::Pick& pick) { showPick(pick); });
    connect(view_, &VtkWidget::hovered, this, &MainWindow::showTip);
    connect(view_, &VtkWidget::contextMenuAt, this, &MainWindow::pickMenu);
  }
  state_.listen([this](unsigned changes) {
    if ((changes & (ViewState::PathChanged | ViewState::ColourChanged)) != 0) {
      updateActions();
    }
  });
}

void MainWindow::placeOverlay() {
  legend_->move(12, 12);
  if (view_ != nullptr) {
    const bool legend = actions_->action("view.legend")->isChecked();
    view_->view().setInset(
        legend ? static_cast<int>(std::lround(Legend::kReserved * devicePixelRatioF())) : 0);
  }
  staleNote_->adjustSize();
  staleNote_->move((stage_->width() - staleNote_->width()) / 2, 12);
}

/// A field for text takes some keys with Ctrl for itself, as Emacs does (Ctrl+E: to the end of the
/// line). Those of the menus win, but for what every field can do: undo, copy and the like.
bool MainWindow::isMenuKey(QObject* object, const QKeyEvent& event) const {
  const auto* widget = qobject_cast<QWidget*>(object);
  const bool isText = qobject_cast<const QLineEdit*>(widget) != nullptr ||
                      qobject_cast<const QPlainTextEdit*>(widget) != nullptr ||
                      qobject_cast<const QTextEdit*>(widget) != nullptr;
  if (!isText || widget->window() != this ||
      (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0) {
    return false;
  }
  for (const auto key : {QKeySequence::Undo, QKeySequence::Redo, QKeySequence::Cut,
                         QKeySequence::Copy, QKeySequence::Paste, QKeySequence::SelectAll}) {
    if (event.matches(key)) {
      return false;
    }
  }
  return actions_->actionOf(QKeySequence(event.keyCombination())) != nullptr;
}

bool MainWindow::eventFilter(QObject* object, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride &&
      isMenuKey(object, *static_cast<QKeyEvent*>(event))) {
    event->ignore();
    return true;
  }
  if (object == stage_ && event->type() == QEvent::Resize) {
    placeOverlay();
  }
  return QMainWindow::eventFilter(object, event);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  form_->commit();
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  // The user has decided: nothing is left to recover.
  if (session_->modified() && session_->lockedBy().isEmpty()) {
    project::dropAutosave(session_->file().empty() ? Session::untitledFile() : session_->file());
  }
  session_->cancel();
  session_->tasks().cancel();
  QSettings settings;
  settings.setValue("window/geometry", saveGeometry());
  settings.setValue("window/state", saveState(kLayoutVersion));
  event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) {
    event->acceptProposedAction();
  }
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList parts;
  for (const QUrl& url : event->mimeData()->urls()) {
    const QString file = url.toLocalFile();
    if (file.endsWith(".wcam", Qt::CaseInsensitive)) {
      event->acceptProposedAction();
      QTimer::singleShot(0, this, [this, file] { openFile(pathFromText(utf8(file))); });
      return;
    }
    if (!file.isEmpty()) {
      parts.append(file);
    }
  }
  event->acceptProposedAction();
  // The program that the files come from waits until the drop ends: dialogs come after it.
  QTimer::singleShot(0, this, [this, parts] { importFiles(parts); });
}

bool MainWindow::event(QEvent* event) {
  // The space bar presses buttons and checks items where the focus is on one; elsewhere it plays.
  if (event->type() == QEvent::ShortcutOverride &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Space) {
    QWidget* focus = QApplication::focusWidget();
    if (qobject_cast<QAbstractButton*>(focus) != nullptr ||
        qobject_cast<QAbstractItemView*>(focus) != nullptr) {
      event->accept();
      return true;
    }
  }
  return QMainWindow::event(event);
}

void MainWindow::applyTheme(bool dark) {
  dark_ = dark;
  gui::applyTheme(dark);
  actions_->updateIcons();
  moves_->updateIcons();
  tree_->updateIcons();
  // Its icons and fonts are made with its fields.
  form_->clear();
  showNode(tree_->selected());
  scene_->setDark(dark);
  QSettings().setValue("window/dark", dark);
}

QString MainWindow::noticeText() const {
  return notice_->isHidden() ? QString() : noticeText_->text();
}

void MainWindow::notify(Status status, const QString& text) {
  noticeIcon_->setPixmap(statusIcon(status).pixmap(20, 20));
  noticeText_->setText(text);
  notice_->show();
  log_->say(status == Status::Error     ? LogView::Kind::Error
            : status == Status::Warning ? LogView::Kind::Warning
                                        : LogView::Kind::Note,
            text);
}

void MainWindow::hideNotice() {
  notice_->hide();
}

}  // namespace wcam::gui
