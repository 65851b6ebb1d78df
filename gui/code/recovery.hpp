#pragma once

#include <QList>
#include <QLockFile>
#include <QString>
#include <functional>
#include <memory>

#include "widgets/file_keeper.hpp"

namespace eyebridge::gui {

/// A text that was not saved.
struct Draft {
  int number = 0;  ///< From Recovery::new_number(): no other text of this process has it.
  QString name;    ///< Of the tab.
  QString path;    ///< Its file; "" when it never had one.
  QString text;
};

/// Keeps unsaved texts on disk, so that a crash, kill -9 or a power failure loses none. Each has a
/// folder of its own, locked as long as the process lives; a new one takes over what others left.
class Recovery {
 public:
  /// `folder` is where all of them are; it is made if need be. `on_trouble` is called, by this
  /// thread's event loop, when the disk refuses a text.
  Recovery(const QString& folder, const std::function<void()>& on_trouble);
  /// Removes the folder, unless something is kept in it. Returns when all is on the disk.
  ~Recovery();
  Recovery(const Recovery&) = delete;
  Recovery& operator=(const Recovery&) = delete;

  [[nodiscard]] int new_number() { return ++last_number_; }
  /// What processes left that are no more. It is kept here from now on, under new numbers.
  [[nodiscard]] QList<Draft> take_lost();
  /// Keeps a text in place of the one of the same number: soon, in another thread, which waits for
  /// the disk. False when there is no place for any.
  [[nodiscard]] bool keep(const Draft& draft);
  /// In their order with keep().
  void forget(int number);
  /// Returns when all of that is done.
  void finish() { files_.finish(); }
  /// Lost texts that could not be read, which stay where they are, in words; "" when there are
  /// none.
  [[nodiscard]] const QString& trouble() const { return trouble_; }

 private:
  [[nodiscard]] QString file_of(int number) const;
  void take_folder(const QString& folder, QList<Draft>& drafts);

  int last_number_ = 0;
  QString all_;
  QString own_;
  QString trouble_;
  std::unique_ptr<QLockFile> lock_;
  FileKeeper files_;
};

}  // namespace eyebridge::gui
