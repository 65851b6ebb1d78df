// The editor's files: saving, changes by others, what an editor left that ended without a word.
#include <QComboBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QImage>
#include <QLabel>
#include <QMessageBox>
#include <algorithm>
#include <utility>

#include "editor/editor_window.hpp"
#include "editor/import_dialog.hpp"
#include "eyebridge/files/load.hpp"
#include "widgets/ask_for_file.hpp"

namespace eyebridge::gui {

bool EditorWindow::save() {
  if (files_.path.empty()) {
    ask_for_path();
    return false;
  }
  if (watch_.has_changed()) {
    notices_->tell("disk", tr("%1 was changed by another program. What shall count?").arg(path()),
                   {{tr("My plan: write over it"), [this] { write(path()); }},
                    {tr("The file: load it"), [this] { reload(); }}});
    return false;
  }
  return write(path());
}

bool EditorWindow::save_as(const QString& path) { return write(path); }

bool EditorWindow::write(const QString& path) {
  try {
    Saving saving = plan_saving(document_.settled(), files_, path.toStdString());
    write_all_files(saving.texts);
    QStringList names;
    for (const FileText& text : saving.texts) {
      names << QFileInfo(QString::fromStdString(text.path.string())).fileName();
    }
    // What this kind of file cannot say is no longer in the plan, either.
    document_.edit(tr("Save as %1").arg(names.last()),
                   [&](Plan& plan) { plan = saving.files.plan; });
    const bool is_new_name = files_.path != saving.files.path;
    files_ = std::move(saving.files);
    files_.other_comments = 0;
    drop_own();
    for (const char* topic : {"disk", "save", "open", "warnings"}) notices_->end(topic);
    if (is_new_name) {
      // What was left of the old name is offered where that is opened again.
      notices_->end("recovery");
      autosave_.reset();
      take_autosave();
    }
    document_.history().setClean();
    show_files();
    refresh();
    message_->setText(tr("Saved %1").arg(names.join(tr(" and "))));
    check_run();
    return true;
  } catch (const ConfigError& error) {
    notices_->tell("save", QString::fromStdString(error.what()));
    return false;
  }
}

void EditorWindow::check_run() {
  notices_->end("run");
  try {
    files::load_scenario(files_.path, {.places = search_places()});
  } catch (const ConfigError& error) {
    notices_->tell(
        "run",
        tr("Saved; but a run would refuse it: %1").arg(QString::fromStdString(error.what())));
  }
}

void EditorWindow::tell_warnings() {
  QStringList lines;
  constexpr std::size_t kMost = 5;
  for (std::size_t i = 0; i < files_.warnings.size() && i < kMost; ++i) {
    lines << QString::fromStdString(files_.warnings[i].str());
  }
  if (files_.warnings.size() > kMost) {
    lines << tr("and %1 more warnings").arg(files_.warnings.size() - kMost);
  }
  if (files_.other_comments > 0) {
    lines << tr("%1 lines have comments: saving keeps those at the top of a file only")
                 .arg(files_.other_comments);
  }
  std::size_t unplaced = 0;
  for (std::size_t i = 0; i < files_.plan.robots.size(); ++i) {
    if (!pose_of_robot(files_.plan, i)) ++unplaced;
  }
  if (unplaced > 0) {
    lines << tr("%1 robots have no place of their own: they are kept, but not shown").arg(unplaced);
  }
  for (const std::string& problem : catalogue_.problems()) lines << QString::fromStdString(problem);
  if (lines.isEmpty()) {
    notices_->end("warnings");
  } else {
    notices_->tell("warnings", lines.join('\n'));
  }
}

void EditorWindow::show_catalogue() {
  described_ = document_.settled().rest;
  catalogue_ = Catalogue(described_, files_.path.parent_path());
  canvas_->set_catalogue(catalogue_);
  properties_->set_catalogue(catalogue_);
  make_choices();
}

void EditorWindow::show_texture() {
  textured_ = document_.settled().texture;
  const auto file = texture_file(document_.settled(), files_);
  const QImage picture = file.empty() ? QImage() : QImage(QString::fromStdString(file.string()));
  canvas_->set_texture(picture);
  if (textured_ && picture.isNull()) {
    notices_->tell("texture", tr("The floor's texture %1 is not found, or is no picture")
                                  .arg(QString::fromStdString(*textured_)));
  } else {
    notices_->end("texture");
  }
}

bool EditorWindow::add_description(const QString& path) {
  const bool is_robot = path.endsWith(".robi", Qt::CaseInsensitive);
  files::SimFile sim;
  (is_robot ? sim.robot_files : sim.object_files)
      .push_back({QFileInfo(path).absoluteFilePath().toStdString(), {}});
  const Catalogue found(sim, files_.path.parent_path());
  if (!found.problems().empty()) {
    notices_->tell("describe", QString::fromStdString(found.problems().front()));
    return false;
  }
  notices_->end("describe");
  // Beside the file that will name it, its name alone does.
  const QFileInfo info(path);
  const bool beside =
      !files_.path.empty() && info.absolutePath() == QFileInfo(this->path()).absolutePath();
  const QString name = beside ? info.fileName() : info.absoluteFilePath();
  document_.edit(tr("Add %1").arg(info.fileName()), [&](Plan& plan) {
    auto& list = is_robot ? plan.rest.robot_files : plan.rest.object_files;
    list.push_back({name.toStdString(), {}});
  });
  robots_->setCurrentText(QString::fromStdString(found.names().back()));
  return true;
}

void EditorWindow::ask_for_description() {
  ask_for_file(*this, tr("Add robot or object"), QFileInfo(path()).absolutePath(),
               tr("Robots and objects (*.robi *.esObj)"),
               [this](const QString& file) { add_description(file); });
}

void EditorWindow::when_free(std::function<void()> act) {
  if (document_.history().isClean()) return act();
  waiting_ = std::move(act);
  if (auto* const asked = findChild<QMessageBox*>("unsaved")) return asked->raise();
  auto* const box = new QMessageBox(
      QMessageBox::Question, tr("Unsaved edits"),
      tr("%1 has edits that are not saved.").arg(path().isEmpty() ? tr("The new world") : path()),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
  box->setAttribute(Qt::WA_DeleteOnClose);
  box->setObjectName("unsaved");
  connect(box, &QMessageBox::finished, this, [this](int button) {
    answer(button == QMessageBox::Save      ? Answer::Save
           : button == QMessageBox::Discard ? Answer::Discard
                                            : Answer::Cancel);
  });
  box->open();
}

void EditorWindow::answer(Answer answer) {
  const auto act = std::exchange(waiting_, {});
  if (auto* const box = findChild<QMessageBox*>("unsaved")) {
    box->setObjectName({});  // it is answered
    box->disconnect(this);
    box->close();
  }
  if (!act || answer == Answer::Cancel) return;
  if (answer == Answer::Save && !save()) return;
  if (answer == Answer::Discard) {
    drop_own();
    document_.history().setClean();
  }
  act();
}

void EditorWindow::ask_for_path() {
  auto* const dialog = new QFileDialog(this, tr("Save as"), QFileInfo(path()).absolutePath());
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setAcceptMode(QFileDialog::AcceptSave);
  const QStringList filters = {tr("Simulation: world, robots, objects (*.sim)"),
                               tr("World: walls and starts (*.wld)"),
                               tr("Maze: walls on a grid (*.maz)")};
  dialog->setNameFilters(filters);
  const auto take_suffix = [dialog, filters](const QString& filter) {
    const QStringList endings = {"sim", "wld", "maz"};
    dialog->setDefaultSuffix(endings.value(filters.indexOf(filter)));
  };
  connect(dialog, &QFileDialog::filterSelected, dialog, take_suffix);
  const QString ending = QFileInfo(path()).suffix().toLower();
  const Plan& plan = document_.settled();
  const bool is_bare = plan.robots.empty() && plan.things.empty() && plan.markers.empty();
  const int kind = ending == "maz" ? 2 : ending == "wld" || (ending.isEmpty() && is_bare) ? 1 : 0;
  dialog->selectNameFilter(filters[kind]);
  take_suffix(filters[kind]);
  connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) { save_as(file); });
  dialog->open();
}

void EditorWindow::ask_to_open() {
  ask_for_file(*this, tr("Open"), QFileInfo(path()).absolutePath(),
               tr("Worlds, mazes, simulations (*.wld *.maz *.sim)"),
               [this](const QString& file) { open(file); });
}

void EditorWindow::ask_for_picture() {
  auto* const dialog = new ImportDialog(this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->on_choice = [this](const QString& picture, const files::FloorPlanOptions& options,
                             bool replaces) { import_floor_plan(picture, options, replaces); };
  dialog->open();
}

bool EditorWindow::import_floor_plan(const QString& picture, const files::FloorPlanOptions& options,
                                     bool replaces) {
  try {
    const files::FloorPlan read = read_floor_plan(QImage(picture), options);
    document_.edit(tr("Import floor plan"), [&](Plan& plan) {
      if (replaces) {
        plan.walls.clear();
        plan.width = read.width;
        plan.height = read.height;
      }
      plan.width = std::max(plan.width, read.width);
      plan.height = std::max(plan.height, read.height);
      plan.walls.insert(plan.walls.end(), read.walls.begin(), read.walls.end());
    });
    canvas_->fit();
    message_->setText(tr("%1 walls from %2").arg(read.walls.size()).arg(picture));
    return true;
  } catch (const ConfigError& error) {
    notices_->tell("import", tr("%1: %2").arg(picture, QString::fromStdString(error.text())));
    return false;
  }
}

void EditorWindow::disk_changed() {
  if (document_.history().isClean()) return reload();
  notices_->tell(
      "disk",
      tr("%1 was changed by another program. Your edits are still here; after loading, Undo brings "
         "them back.")
          .arg(path()),
      {{tr("Load it"), [this] { reload(); }}, {tr("Keep mine"), [this] { watch_.accept(); }}});
}

void EditorWindow::reload() {
  if (files_.path.empty()) return;
  try {
    PlanFiles files = open_plan(files_.path);
    const Plan plan = files.plan;
    files_ = std::move(files);
    notices_->end("disk");
    document_.edit(tr("Load from disk"), [&](Plan& changed) { changed = plan; });
    document_.history().setClean();
    show_files();
    tell_warnings();
    refresh();
    message_->setText(tr("Loaded %1 again").arg(path()));
  } catch (const ConfigError& error) {
    notices_->tell("disk",
                   tr("The file has changed, but cannot be read: %1. Your plan is still "
                      "here; saving writes it again.")
                       .arg(QString::fromStdString(error.what())),
                   {{tr("Keep mine"), [this] { watch_.accept(); }}});
    document_.history().resetClean();
    refresh();
  }
}

void EditorWindow::offer_left() {
  notices_->tell("recovery", tr("An editor ended here with unsaved edits."),
                 {{tr("Recover them"),
                   [this] {
                     try {
                       const Plan left = autosave_->left();
                       document_.edit(tr("Recover"), [&](Plan& plan) { plan = left; });
                       show_catalogue();
                     } catch (const ConfigError& error) {
                       const QString kept = autosave_->set_aside();
                       notices_->tell(
                           "unreadable",
                           tr("The edits cannot be recovered: %1. %2")
                               .arg(QString::fromStdString(error.what()),
                                    kept.isEmpty() ? tr("Nor can they be put aside: the next edit "
                                                        "takes their place")
                                                   : tr("They are kept as %1").arg(kept)));
                     }
                     refresh();  // from now on our own edits are kept
                   }},
                  {tr("Discard them"), [this] {
                     autosave_->drop();
                     refresh();
                   }}});
}

void EditorWindow::take_autosave() {
  autosave_ = std::make_unique<Autosave>(
      files_.path, [this](const QString& why_not) { edits_were_kept(why_not); });
  if (autosave_->has_left()) offer_left();
}

void EditorWindow::drop_own() {
  if (autosave_ && notices_->text("recovery").isEmpty()) autosave_->drop();
}

void EditorWindow::keep_now() {
  keep_edits();
  if (autosave_) autosave_->finish();
}

void EditorWindow::keep_edits() {
  if (!autosave_ || document_.history().isClean()) return;
  // Until somebody has said what becomes of them, the older edits stay.
  if (!notices_->text("recovery").isEmpty()) return;
  if (!autosave_->is_ours()) {
    notices_->tell("autosave",
                   tr("Another editor has this file open: unsaved edits are not kept here"));
    return;
  }
  try {
    autosave_->write(document_.settled());
  } catch (const ConfigError& error) {
    edits_were_kept(QString::fromStdString(error.what()));
  }
}

void EditorWindow::edits_were_kept(const QString& why_not) {
  if (why_not.isEmpty()) {
    notices_->end("autosave");
  } else {
    notices_->tell("autosave", tr("Unsaved edits are not kept: %1").arg(why_not));
  }
}

}  // namespace eyebridge::gui
