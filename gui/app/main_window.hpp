// SPDX-FileCopyrightText: 2026 The WCAM developers
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene_controller.hpp"
#include "session.hpp"
#include "widgets/action_catalog.hpp"
#include "widgets/diagnostics_table.hpp"
#include "widgets/param_form.hpp"
#include "widgets/project_tree.hpp"

#include <QMainWindow>

#include <filesystem>
#include <memory>

class QDockWidget;
class QFrame;
class QKeyEvent;
class QLabel;
class QListWidget;
class QMenu;
class QProgressBar;
class QSlider;
class QTabWidget;
class QToolButton;

namespace wcam::gui {

class JointPlot;
class LayerSlider;
class Legend;
class LogView;
class MoveBar;
class ProcessPlot;
class ProgramView;

/// The window: it puts the views of session and view state together and turns actions into
/// commands.
class MainWindow : public QMainWindow {
  Q_OBJECT

public:
  /// @param viewport false puts a placeholder for the 3D view (tests without a display)
  explicit MainWindow(std::shared_ptr<const plugin::PluginHost> plugins, bool viewport = true);
  ~MainWindow() override;

  /// Opens a project, or imports a part. Asks about unsaved changes, recovery and locks. @return
  /// false when nothing was opened
  bool openFile(const std::filesystem::path& file);
  /// Offers the work of a program that ended before its project was saved.
  void offerUntitledWork();
  /// @return false when the file could not be written; the reason is shown
  bool saveTo(const std::filesystem::path& file);

  // Stable handles for tests.
  [[nodiscard]] Session& session() { return *session_; }

  [[nodiscard]] ViewState& viewState() { return state_; }

  [[nodiscard]] ActionCatalog& actions() { return *actions_; }

  [[nodiscard]] ProjectTree& tree() { return *tree_; }

  [[nodiscard]] ParamForm& form() { return *form_; }

  [[nodiscard]] DiagnosticsTable& diagnostics() { return *diagnostics_; }

  [[nodiscard]] ProgramView& program() { return *program_; }

  /// Null with a placeholder.
  [[nodiscard]] VtkWidget* view() { return view_; }

  [[nodiscard]] SceneController& scene() { return *scene_; }

  /// The message that is shown above the view; empty when there is none.
  [[nodiscard]] QString noticeText() const;
  void applyTheme(bool dark);
  /// Writes the HTML report in the background.
  void writeReport(const std::filesystem::path& file);

protected:
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;
  bool event(QEvent* event) override;
  bool eventFilter(QObject* object, QEvent* event) override;

private:
  // main_window.cpp: the parts of the window
  void buildCentre(bool viewport);
  void buildDocks();
  void buildStatus();
  void connectAll();
  void placeOverlay();
  [[nodiscard]] bool isMenuKey(QObject* object, const QKeyEvent& event) const;

  // main_window_actions.cpp: the catalogue
  void buildFileActions();
  void buildEditActions();
  void buildProjectActions();
  void buildViewActions();
  void buildPlayActions();
  void buildHelpActions();
  QAction* addToggle(const QString& id,
                     const QString& menu,
                     const QString& text,
                     const QString& help,
                     const QString& keys,
                     const QString& icon,
                     bool on,
                     const std::function<void(bool)>& run);
  void updateActions();
  void buildToolBar();
  void fillRecent();

  // main_window_project.cpp: what the actions do
  void newProject();
  void openDialog();
  bool save();
  bool saveAsDialog();
  bool mayDiscard();
  /// Another program has changed the file: read it again, or keep what is here.
  void offerReload();
  bool offerRecovery(const std::filesystem::path& file);
  void remember(const std::filesystem::path& file);
  void importFiles(const QStringList& files);
  void importDialog();
  void addOperation();
  void addNode(const std::string& list);
  void removeNode();
  void renameNode();
  void duplicateNode();
  void moveNode(int by);
  void copyNode();
  void pasteNode();
  /// Adds a copy beside the node, under a free id.
  void addCopy(const NodeRef& node, Value value);
  void chooseCell();
  void dropPart();
  void showExport();
  void saveReport();
  void locateFile(const std::string& list, const std::string& id);
  bool run(const project::Command& command, const std::string& mergeKey = {});
  bool runAll(const QString& label, const std::vector<project::Command>& commands);

  // main_window_edits.cpp: edits of toolpaths
  void addEdit();
  /// Adds an edit and shows its form. @return false when it was refused
  bool makeEdit(const std::string& operation,
                const std::string& id,
                const std::string& type,
                const Value& params);
  /// An entry for each type of edit, with these parameters.
  void addEditTypes(QMenu& menu, const Value& params);
  void addPointEdits(QMenu& menu, std::size_t move);
  void layerMenu(const QPoint& global);

  // main_window_views.cpp: views of the document
  void showDocument();
  void showNode(const NodeRef& node);
  void showTitle();
  void showHistory();
  void editNode(const std::string& section, const std::string& key, const Value& value);
  void nodeMenu(const NodeRef& node, const QPoint& global);
  void screenshot();
  [[nodiscard]] std::string shownOperation() const;
  void setPartStyle(viewport::PartStyle style);
  void updateSection();

  // main_window_results.cpp: views of the results
  void showResults();
  void showState();
  void showProgram();
  void jump(const FindingRow& row);
  void applyRemedy(const FindingRow& row);
  [[nodiscard]] std::map<NodeRef, Badge> badges() const;
  [[nodiscard]] std::vector<FindingRow> findingRows() const;

  // main_window_picking.cpp: what the mouse finds in the 3D view
  void showPick(const viewport::Pick& pick);
  void showTip(const viewport::Pick& pick, const QPoint& global);
  void measure(const viewport::Pick& pick);
  void pickMenu(const viewport::Pick& pick, const QPoint& global);
  /// The part that a pick names, or null.
  [[nodiscard]] const GeneratedPart* pickedPart(const viewport::Pick& pick) const;

  void notify(Status status, const QString& text);
  void hideNotice();

  ViewState state_;
  Session* session_ = nullptr;
  ActionCatalog* actions_ = nullptr;
  SceneController* scene_ = nullptr;
  VtkWidget* view_ = nullptr;
  QWidget* stage_ = nullptr;
  Legend* legend_ = nullptr;
  QLabel* staleNote_ = nullptr;
  LayerSlider* layers_ = nullptr;
  MoveBar* moves_ = nullptr;
  QFrame* notice_ = nullptr;
  QLabel* noticeIcon_ = nullptr;
  QLabel* noticeText_ = nullptr;
  QFrame* sectionBar_ = nullptr;
  QSlider* sectionSlider_ = nullptr;
  QToolButton* sectionAxis_ = nullptr;
  int sectionAxisIndex_ = 1;
  ProjectTree* tree_ = nullptr;
  ParamForm* form_ = nullptr;
  QTabWidget* tabs_ = nullptr;
  DiagnosticsTable* diagnostics_ = nullptr;
  JointPlot* joints_ = nullptr;
  ProcessPlot* process_ = nullptr;
  ProgramView* program_ = nullptr;
  LogView* log_ = nullptr;
  QListWidget* history_ = nullptr;
  QDockWidget* treeDock_ = nullptr;
  QDockWidget* formDock_ = nullptr;
  QDockWidget* bottomDock_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QToolButton* cancel_ = nullptr;
  QLabel* status_ = nullptr;
  QMenu* recent_ = nullptr;
  QMenu* colours_ = nullptr;
  QTimer programDelay_;
  QTimer staleDelay_;
  NodeRef shownNode_;
  NodeRef edited_;
  std::string chosenOperation_;
  int chosenFace_ = -1;  ///< face that the part is to be set on
  std::optional<viewport::Point> measureFrom_;
  bool measuring_ = false;
  bool dark_ = false;
};

}  // namespace wcam::gui
