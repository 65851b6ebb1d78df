#pragma once

#include <QUndoCommand>
#include <memory>
#include <vector>

#include "editor/document.hpp"

namespace eyebridge::gui {

/// The part of a list that a step changes: all else of it is not kept.
template <class T>
struct Splice {
  std::size_t at = 0;
  std::vector<T> before;
  std::vector<T> after;
};

/// A step of a document's history: the difference of two plans, either way.
class PlanStep final : public QUndoCommand {
 public:
  /// `document` is lent and is as `before` says; pushing the step makes it as `after` says.
  PlanStep(Document& document, const QString& what, const Plan& before, const Plan& after);

  void undo() override { apply(false); }
  void redo() override { apply(true); }

 private:
  struct Frame {  ///< What is no list.
    double width, height;
    std::optional<std::string> texture;
    std::optional<double> cell;
  };
  static Frame frame_of(const Plan& plan);
  void apply(bool forward);

  Document& document_;
  Frame before_;
  Frame after_;
  Splice<world::Wall> walls_;
  Splice<world::StartPose> starts_;
  Splice<Thing> things_;
  Splice<world::Marker> markers_;
  Splice<files::SimRobot> robots_;
  std::shared_ptr<const files::SimFile> rest_before_;  ///< Null: it stays.
  std::shared_ptr<const files::SimFile> rest_after_;
};

}  // namespace eyebridge::gui
