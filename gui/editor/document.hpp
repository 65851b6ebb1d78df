#pragma once

#include <QString>
#include <QUndoStack>
#include <cstdint>
#include <functional>
#include <optional>

#include "editor/plan.hpp"

namespace eyebridge::gui {

/// A plan that is being edited: with its history, which has no limit, and what is selected. Needs
/// no screen.
class Document {
 public:
  explicit Document(Plan plan);

  /// As it is shown: with what the mouse is just doing to it.
  [[nodiscard]] const Plan& plan() const { return preview_ ? *preview_ : plan_; }
  /// As of the last step.
  [[nodiscard]] const Plan& settled() const { return plan_; }
  /// Another number after each change of the settled plan.
  [[nodiscard]] std::uint64_t version() const { return version_; }
  [[nodiscard]] QUndoStack& history() { return history_; }
  [[nodiscard]] const QUndoStack& history() const { return history_; }

  /// A step that can be undone, called `what`; none when `change` changes nothing.
  void edit(const QString& what, const std::function<void(Plan&)>& change);
  /// What `change` would do to the settled plan is shown, instead of any preview before it.
  void preview(const std::function<void(Plan&)>& change);
  /// The preview, if there is one, becomes a step.
  void commit(const QString& what);
  void cancel();

  [[nodiscard]] const Selection& selection() const { return selection_; }
  /// What the plan does not have is left out.
  void select(Selection items);

  /// Told after each change of the plan, its preview or the selection.
  std::function<void()> on_change;

 private:
  friend class PlanStep;
  void take(Plan plan);
  void tell() const;

  Plan plan_;
  std::uint64_t version_ = 0;
  std::optional<Plan> preview_;
  Selection selection_;
  QUndoStack history_;
};

}  // namespace eyebridge::gui
