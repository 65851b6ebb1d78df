// The editor's menus, tools and status bar.
#include <QAction>
#include <QActionGroup>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolBar>
#include <algorithm>
#include <string>
#include <vector>

#include "editor/editor_window.hpp"
#include "editor/edits.hpp"
#include "eyebridge/base/units.hpp"
#include "widgets/recent_files.hpp"

namespace eyebridge::gui {

QAction* EditorWindow::add_action(QMenu& menu, const QString& text, const QKeySequence& key,
                                  const std::function<void()>& act) {
  QAction* const action = menu.addAction(text);
  action->setShortcut(key);
  connect(action, &QAction::triggered, this, [act] { act(); });
  return action;
}

void EditorWindow::make_file_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&File"));
  add_action(menu, tr("&New"), QKeySequence::New, [this] { when_free([this] { make_new(); }); });
  add_action(menu, tr("&Open..."), QKeySequence::Open,
             [this] { when_free([this] { ask_to_open(); }); });
  offer_recent_files(*menu.addMenu(tr("Open &recent")), {kRecentWorlds},
                     [this](const QString& path) { when_free([this, path] { open(path); }); });
  add_action(menu, tr("&Save"), QKeySequence::Save, [this] { save(); });
  add_action(menu, tr("Save &as..."), Qt::CTRL | Qt::SHIFT | Qt::Key_S, [this] { ask_for_path(); });
  add_action(menu, tr("&Load again from disk"), Qt::Key_F5, [this] { reload(); });
  menu.addSeparator();
  add_action(menu, tr("&Import floor plan..."), Qt::CTRL | Qt::Key_I,
             [this] { ask_for_picture(); });
  add_action(menu, tr("Add &robot or object..."), Qt::CTRL | Qt::Key_R,
             [this] { ask_for_description(); });
  menu.addSeparator();
  add_action(menu, tr("&Close"), QKeySequence::Close, [this] { close(); });
}

void EditorWindow::make_edit_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Edit"));
  QAction* const undo = document_.history().createUndoAction(this, tr("&Undo"));
  undo->setShortcut(QKeySequence::Undo);
  undo->setIconText(tr("Undo"));  // of the tool bar, which must not jump
  QAction* const redo = document_.history().createRedoAction(this, tr("&Redo"));
  redo->setShortcuts({QKeySequence(QKeySequence::Redo), Qt::CTRL | Qt::Key_Y});
  redo->setIconText(tr("Redo"));
  menu.addActions({undo, redo});
  menu.addSeparator();
  add_action(menu, tr("Cu&t"), QKeySequence::Cut, [this] {
    copy();
    canvas_->remove();
  });
  add_action(menu, tr("&Copy"), QKeySequence::Copy, [this] { copy(); });
  // Beside what it was copied from, by a step of the grid.
  const auto step = [this] { return canvas_->grid() > 0 ? canvas_->grid() : 0.1; };
  add_action(menu, tr("&Paste"), QKeySequence::Paste, [this, step] { paste({step(), -step()}); });
  add_action(menu, tr("Du&plicate"), Qt::CTRL | Qt::Key_D, [this, step] {
    copy();
    paste({step(), -step()});
  });
  add_action(menu, tr("&Delete"), QKeySequence::Delete, [this] { canvas_->remove(); });
  menu.addSeparator();
  add_action(menu, tr("Select &all"), QKeySequence::SelectAll,
             [this] { document_.select(all_items(document_.plan())); });
  add_action(menu, tr("Select &next"), Qt::Key_N, [this] { select_next(1); });
  add_action(menu, tr("Select pre&vious"), Qt::SHIFT | Qt::Key_N, [this] { select_next(-1); });
  add_action(menu, tr("&Let go"), Qt::Key_Escape, [this] { canvas_->cancel(); });
  menu.addSeparator();
  constexpr double kTurn = 15.0;  // degrees
  add_action(menu, tr("&Split wall"), Qt::CTRL | Qt::Key_K, [this] { canvas_->split(); });
  add_action(menu, tr("Turn le&ft"), Qt::Key_BracketLeft,
             [this] { canvas_->turn(deg_to_rad(kTurn)); });
  add_action(menu, tr("Turn r&ight"), Qt::Key_BracketRight,
             [this] { canvas_->turn(deg_to_rad(-kTurn)); });
  QToolBar& bar = *addToolBar(tr("Edit"));
  bar.setObjectName("edit_bar");
  bar.addActions({undo, redo});
}

void EditorWindow::make_tool_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&Tools"));
  QToolBar& bar = *addToolBar(tr("Tools"));
  bar.setObjectName("tool_bar");
  tools_ = new QActionGroup(this);
  struct Row {
    PlanTool tool;
    QString text;
    Qt::Key key;
    QString help;
  };
  const Row rows[] = {
      {PlanTool::Select, tr("Se&lect"), Qt::Key_V,
       tr("Drag things, ends of walls, way-points; drag a rim to turn; double-click a wall to "
          "split "
          "it")},
      {PlanTool::Wall, tr("&Wall"), Qt::Key_W,
       tr("Drag a wall, or click from corner to corner; Shift: straight; Ctrl: off the grid")},
      {PlanTool::Thing, tr("&Object"), Qt::Key_O, tr("Click to place it; drag on to turn it")},
      {PlanTool::Robot, tr("&Robot"), Qt::Key_R, tr("Click to place it; drag on to turn it")},
      {PlanTool::Start, tr("&Start"), Qt::Key_S,
       tr("Click where robots may start; drag on to turn")},
      {PlanTool::Marker, tr("&Marker"), Qt::Key_M, tr("Click to paint a disc on the floor")},
      {PlanTool::Way, tr("Wa&y"), Qt::Key_P,
       tr("Click on an object, then where it shall go, point by point")},
      {PlanTool::Measure, tr("M&easure"), Qt::Key_L, tr("Drag from one place to another")},
  };
  for (const Row& row : rows) {
    const PlanTool tool = row.tool;
    const QString help = row.help;
    QAction* const action = add_action(menu, row.text, row.key, [this, tool, help] {
      canvas_->set_tool(tool);
      message_->setText(help);
    });
    action->setCheckable(true);
    action->setChecked(tool == PlanTool::Select);
    action->setToolTip(help + QString(" (%1)").arg(QKeySequence(row.key).toString()));
    tools_->addAction(action);
    bar.addAction(action);
  }
  const auto use = [this](PlanTool tool) {
    tools_->actions().at(tool == PlanTool::Thing ? 2 : 3)->trigger();
  };
  things_ = new QComboBox(this);
  things_->setObjectName("things");
  things_->setAccessibleName(tr("Object to place"));
  things_->setToolTip(tr("Object to place"));
  connect(things_, &QComboBox::currentTextChanged, this,
          [this](const QString& name) { canvas_->set_thing(name.toStdString()); });
  // Who chooses what to place wants to place it.
  connect(things_, &QComboBox::textActivated, this, [use] { use(PlanTool::Thing); });
  robots_ = new QComboBox(this);
  connect(robots_, &QComboBox::textActivated, this, [use] { use(PlanTool::Robot); });
  robots_->setObjectName("robots");
  robots_->setAccessibleName(tr("Robot to place"));
  robots_->setToolTip(tr("Robot, or object that a file describes, to place"));
  connect(robots_, &QComboBox::currentTextChanged, this,
          [this](const QString& name) { canvas_->set_robot(name.toStdString()); });
  for (const std::string& name : builtin_things()) things_->addItem(QString::fromStdString(name));
  bar.addSeparator();
  bar.addWidget(things_);
  bar.addWidget(robots_);
}

void EditorWindow::make_choices() {
  const QString before = robots_->currentText();
  robots_->clear();
  for (const std::string& name : catalogue_.names()) robots_->addItem(QString::fromStdString(name));
  if (robots_->findText(before) >= 0) robots_->setCurrentText(before);
}

void EditorWindow::make_view_menu() {
  QMenu& menu = *menuBar()->addMenu(tr("&View"));
  constexpr double kZoom = Viewport::kZoomStep;
  QAction* const fit = add_action(menu, tr("&Fit"), Qt::Key_F, [this] { canvas_->fit(); });
  add_action(menu, tr("Zoom &in"), QKeySequence::ZoomIn, [this] { canvas_->zoom(kZoom); });
  add_action(menu, tr("Zoom &out"), QKeySequence::ZoomOut, [this] { canvas_->zoom(1 / kZoom); });
  menu.addSeparator();
  QToolBar& bar = *addToolBar(tr("View"));
  bar.setObjectName("view_bar");
  grid_ = new QDoubleSpinBox(this);
  grid_->setDecimals(1);
  grid_->setRange(0, 10000);
  grid_->setSingleStep(10);
  grid_->setValue(m_to_mm(canvas_->grid()));
  grid_->setPrefix(tr("Grid "));
  grid_->setSuffix(tr(" mm"));
  grid_->setSpecialValueText(tr("No grid"));
  grid_->setKeyboardTracking(false);
  grid_->setAccessibleName(tr("Step of the grid"));
  grid_->setToolTip(tr("Step of the grid (hold Ctrl to leave it)"));
  connect(grid_, &QDoubleSpinBox::valueChanged, this,
          [this](double step) { canvas_->set_grid(mm_to_m(step)); });
  add_action(menu, tr("&Grid on or off"), Qt::Key_G, [this] {
    const double usual = document_.plan().cell ? m_to_mm(*document_.plan().cell) / 2 : 100.0;
    grid_->setValue(canvas_->grid() > 0 ? 0.0 : usual);
  });
  menu.addSeparator();
  for (QDockWidget* dock : findChildren<QDockWidget*>()) menu.addAction(dock->toggleViewAction());
  bar.addAction(fit);
  bar.addWidget(grid_);
}

void EditorWindow::make_status() {
  pointer_ = new QLabel(this);
  pointer_->setObjectName("pointer");
  pointer_->setMinimumWidth(pointer_->fontMetrics().horizontalAdvance("x 88888  y 88888 mm"));
  message_ = new QLabel(this);
  message_->setObjectName("message");
  statusBar()->addWidget(pointer_);
  statusBar()->addWidget(message_, 1);
  canvas_->on_pointer = [this](Vec2 place) {
    pointer_->setText(
        tr("x %1  y %2 mm").arg(m_to_mm(place.x), 0, 'f', 0).arg(m_to_mm(place.y), 0, 'f', 0));
  };
  canvas_->on_message = [this](const QString& text) { message_->setText(text); };
}

void EditorWindow::select_next(int by) {
  const Selection all = all_items(document_.settled());
  if (all.empty()) return;
  const std::vector<Item> items(all.begin(), all.end());
  const auto count = static_cast<std::ptrdiff_t>(items.size());
  std::ptrdiff_t index = by > 0 ? 0 : count - 1;
  if (!document_.selection().empty()) {
    const auto found = std::ranges::find(items, *document_.selection().begin());
    index = (found - items.begin() + by + count) % count;
  }
  document_.select({items[static_cast<std::size_t>(index)]});
}

void EditorWindow::copy() {
  if (document_.selection().empty()) return;
  clip_ = copy_of(document_.settled(), document_.selection());
}

void EditorWindow::paste(Vec2 by) {
  Selection added;
  document_.edit(tr("Paste"), [&](Plan& plan) {
    keep_numbers(
        plan, [this](const std::string& model) { return catalogue_.find(model).is_object; },
        [&] { added = gui::paste(plan, clip_, by); });
  });
  document_.select(added);
  // The next one beside this one.
  clip_ = copy_of(document_.settled(), document_.selection());
}

}  // namespace eyebridge::gui
