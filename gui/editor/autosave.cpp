#include "editor/autosave.hpp"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QStandardPaths>
#include <algorithm>
#include <utility>
#include <vector>

#include "widgets/process_lock.hpp"

namespace eyebridge::gui {
namespace {

class AutosaveText {
  Q_DECLARE_TR_FUNCTIONS(Autosave)
};

constexpr int kMostUnnamed = 100;

QString autosave_folder() {
  return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/editor";
}

QString key_of(const std::filesystem::path& path) {
  const QFileInfo info(QString::fromStdString(path.string()));
  const QString canonical = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
  const QByteArray hash =
      QCryptographicHash::hash(canonical.toUtf8(), QCryptographicHash::Sha256).toHex();
  return info.completeBaseName() + '-' + QString::fromLatin1(hash.left(16));
}

std::string text_at(const QJsonObject& kept, const char* key) {
  return kept[key].toString().toStdString();
}

}  // namespace

bool Autosave::take(const QString& name) {
  const QString file = autosave_folder() + '/' + name + ".autosave";
  auto lock = take_lock(file + ".editor");
  if (lock == nullptr) return false;
  file_ = file;
  lock_ = std::move(lock);
  is_there_ = QFile::exists(file_);
  return true;
}

Autosave::Autosave(const std::filesystem::path& path,
                   const std::function<void(const QString& why)>& on_written)
    : files_([on_written](const QString& /*path*/, const QString& why) { on_written(why); }) {
  QDir().mkpath(autosave_folder());
  if (!path.empty()) {
    take(key_of(path));
    return;
  }
  // One that was left by its editor first.
  for (const bool only_left : {true, false}) {
    for (int i = 1; i <= kMostUnnamed; ++i) {
      const QString name = QString("unnamed-%1").arg(i);
      if (only_left && !QFile::exists(autosave_folder() + '/' + name + ".autosave")) continue;
      if (take(name)) return;
    }
  }
}

Plan Autosave::left() const {
  const std::string name = file_.toStdString();
  QFile disk(file_);
  QByteArray bytes;
  if (disk.open(QIODevice::ReadOnly)) bytes = disk.readAll();
  const QJsonObject kept = QJsonDocument::fromJson(bytes).object();
  if (!kept["ground"].isString() || !kept["simulation"].isString()) {
    throw ConfigError({name, 0, 0},
                      AutosaveText::tr("these are no edits that an editor kept").toStdString());
  }
  std::vector<Warning> warnings;
  const auto ground = files::read_world(text_at(kept, "ground"), name, warnings);
  Plan plan;
  plan.rest = files::read_sim(text_at(kept, "simulation"), name, warnings);
  plan.width = ground.width;
  plan.height = ground.height;
  plan.texture = ground.floor_texture;
  plan.water = ground.water;
  plan.walls = ground.walls;
  plan.starts = ground.starts;
  const QString letters = kept["letters"].toString();
  const QString drawn = kept["drawn"].toString();
  for (std::size_t i = 0; i < plan.starts.size(); ++i) {
    const char letter = letters.mid(static_cast<qsizetype>(i), 1).toStdString().c_str()[0];
    plan.starts[i].letter = letter == '-' ? '\0' : letter;
  }
  if (kept.contains("cell")) plan.cell = kept["cell"].toDouble();
  for (const QJsonValue& goal : kept["goals"].toArray()) {
    plan.goals.push_back({goal.toArray().at(0).toInt(), goal.toArray().at(1).toInt()});
  }
  for (const world::ObjectSpec& object : plan.rest.objects) plan.things.push_back({object, false});
  for (std::size_t i = 0; i < plan.things.size(); ++i) {
    const auto at = static_cast<qsizetype>(i);
    plan.things[i].is_drawn = at < drawn.size() && drawn[at] == '1';
    if (!plan.things[i].is_drawn || !plan.cell) continue;
    // A small maze makes what it draws smaller, which no .sim file can say.
    plan.things[i].spec.radius = std::min(plan.things[i].spec.radius, 0.4 * *plan.cell);
    if (plan.things[i].spec.kind == world::ObjectKind::Ball) {
      plan.things[i].spec.height = 2 * plan.things[i].spec.radius;
    }
  }
  plan.markers = std::exchange(plan.rest.markers, {});
  plan.robots = std::exchange(plan.rest.robots, {});
  plan.rest.objects.clear();
  plan.rest.path_places.clear();
  return plan;
}

void Autosave::write(const Plan& plan) {
  if (!is_ours()) return;
  Plan whole = plan;
  QString letters;
  QString drawn;
  for (const world::StartPose& start : plan.starts) {
    letters += start.letter == 0 ? QChar('-') : QChar(start.letter);
  }
  for (Thing& thing : whole.things) {
    drawn += thing.is_drawn ? '1' : '0';
    if (!thing.is_drawn) continue;
    thing.is_drawn = false;
    files::SimFile usual;
    std::vector<Warning> warnings;
    usual = files::read_sim(thing.spec.name + " 0 0 0", "autosave", warnings);
    thing.spec.radius = usual.objects.at(0).radius;
    thing.spec.height = usual.objects.at(0).height;
  }
  QJsonObject kept{{"ground", QString::fromStdString(files::write_world(ground_of(whole, false)))},
                   {"simulation", QString::fromStdString(files::write_sim(sim_of(whole)))},
                   {"letters", letters},
                   {"drawn", drawn}};
  if (plan.cell) kept["cell"] = *plan.cell;
  QJsonArray goals;
  for (const world::MazeCell goal : plan.goals) goals.append(QJsonArray{goal.column, goal.row});
  if (!goals.isEmpty()) kept["goals"] = goals;
  is_there_ = true;
  files_.write(file_, [kept] { return QJsonDocument(kept).toJson(); });
}

QString Autosave::set_aside() {
  QString name;
  for (int i = 1; name.isEmpty() || QFile::exists(name); ++i) {
    name = QString("%1.unreadable-%2").arg(file_).arg(i);
  }
  if (!QFile::rename(file_, name)) return {};
  is_there_ = false;
  return name;
}

void Autosave::drop() {
  if (!is_there_) return;
  is_there_ = false;
  files_.remove(file_);
  // A process whose last window is closed may end without destroying it.
  files_.finish();
}

}  // namespace eyebridge::gui
