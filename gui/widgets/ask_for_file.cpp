#include "widgets/ask_for_file.hpp"

#include <QFileDialog>
#include <QFileInfo>
#include <utility>

namespace eyebridge::gui {
namespace {

QFileDialog& make_dialog(QWidget& window, const QString& title, const QString& folder,
                         const QString& filter, std::function<void(const QString&)> chosen) {
  auto* const dialog = new QFileDialog(&window, title, folder, filter);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  QObject::connect(dialog, &QFileDialog::fileSelected, &window,
                   [chosen = std::move(chosen)](const QString& path) { chosen(path); });
  return *dialog;
}

}  // namespace

QFileDialog& ask_for_file(QWidget& window, const QString& title, const QString& folder,
                          const QString& filter, std::function<void(const QString&)> chosen) {
  QFileDialog& dialog = make_dialog(window, title, folder, filter, std::move(chosen));
  dialog.setFileMode(QFileDialog::ExistingFile);
  dialog.open();
  return dialog;
}

QFileDialog& ask_where_to_save(QWidget& window, const QString& title, const QString& proposal,
                               const QString& filter, std::function<void(const QString&)> chosen) {
  const QFileInfo file(proposal);
  const QString folder = file.path() == "." ? QString() : file.path();
  QFileDialog& dialog = make_dialog(window, title, folder, filter, std::move(chosen));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.selectFile(file.fileName());
  dialog.open();
  return dialog;
}

}  // namespace eyebridge::gui
