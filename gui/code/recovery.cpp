#include "code/recovery.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QUuid>

#include "widgets/process_lock.hpp"

namespace eyebridge::gui {
namespace {

const QString kLock = "lock";
const QString kDrafts = "*.json";

bool read_draft(const QString& path, Draft& draft) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) return false;
  const QJsonObject object = QJsonDocument::fromJson(file.readAll()).object();
  if (!object["text"].isString() || !object["name"].isString()) return false;
  draft = {0, object["name"].toString(), object["path"].toString(), object["text"].toString()};
  return true;
}

std::unique_ptr<QLockFile> locked(const QString& folder) {
  return take_lock(QDir(folder).filePath(kLock));
}

}  // namespace

Recovery::Recovery(const QString& folder, const std::function<void()>& on_trouble)
    : all_(folder), files_([on_trouble](const QString& /*path*/, const QString& why) {
        if (!why.isEmpty()) on_trouble();
      }) {
  own_ = QDir(all_).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces));
  if (QDir().mkpath(own_)) lock_ = locked(own_);
}

Recovery::~Recovery() {
  finish();
  if (!QDir(own_).entryList({kDrafts}, QDir::Files).isEmpty()) return;
  lock_.reset();
  QDir().rmdir(own_);
}

QString Recovery::file_of(int number) const {
  return QDir(own_).filePath(QString("%1.json").arg(number));
}

bool Recovery::keep(const Draft& draft) {
  if (!lock_) return false;
  files_.write(file_of(draft.number), [draft] {
    const QJsonObject object{{"name", draft.name}, {"path", draft.path}, {"text", draft.text}};
    return QJsonDocument(object).toJson();
  });
  return true;
}

void Recovery::forget(int number) { files_.remove(file_of(number)); }

QList<Draft> Recovery::take_lost() {
  QList<Draft> drafts;
  const QDir all(all_);
  for (const QString& name : all.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
    const QString folder = all.filePath(name);
    if (folder != own_) take_folder(folder, drafts);
  }
  return drafts;
}

void Recovery::take_folder(const QString& folder, QList<Draft>& drafts) {
  std::unique_ptr<QLockFile> lock = locked(folder);
  if (!lock) return;
  const QDir lost(folder);
  for (const QString& name : lost.entryList({kDrafts}, QDir::Files, QDir::Name)) {
    Draft draft;
    if (!read_draft(lost.filePath(name), draft)) {
      trouble_ = QCoreApplication::translate("Recovery", "%1 cannot be recovered: it is no draft")
                     .arg(lost.filePath(name));
      continue;
    }
    draft.number = new_number();
    // A second crash loses nothing, either: at each moment it is in one of the two folders.
    if (QFile::rename(lost.filePath(name), file_of(draft.number))) drafts << draft;
  }
  lock.reset();
  QDir().rmdir(folder);
}

}  // namespace eyebridge::gui
