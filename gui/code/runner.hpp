#pragma once

#include <QCoreApplication>
#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>
#include <functional>
#include <memory>

#include "code/run_plan.hpp"
#include "code/terminal.hpp"

namespace eyebridge::gui {

/// Runs the steps of a plan, each when the one before has succeeded. Never blocks: all that happens
/// is told by the two functions. For one thread with an event loop.
class Runner final : public QObject {
  Q_DECLARE_TR_FUNCTIONS(Runner)
 public:
  enum class State { Idle, Building, Running, Stopping };
  /// How long a program has to end by itself once it was asked to, milliseconds.
  static constexpr int kPatience_ms = 3000;

  explicit Runner(QObject* parent);
  ~Runner() override;

  /// Begins; nothing when something runs.
  void start(const QList<Step>& plan);
  /// SIGTERM, and SIGKILL when it has not helped after kPatience_ms. To all processes of the step.
  void stop();
  [[nodiscard]] State state() const { return state_; }

  /// Called with what the processes print, both outputs in their order.
  std::function<void(const QByteArray&)> on_output;
  /// Called when the state changes, with what happened, for people.
  std::function<void(const QString&)> on_state;
  /// Called at the end: whether all steps succeeded.
  std::function<void(bool)> on_end;

 private:
  void start_step();
  void step_ended(int code, QProcess::ExitStatus status);
  void end(bool well, const QString& how);
  void set_state(State state, const QString& how);
  void send(int signal) const;

  QList<Step> plan_;
  State state_ = State::Idle;
  std::unique_ptr<QProcess> process_;
  qint64 group_ = 0;  ///< Of the step's processes; 0 when there are none.
  Terminal terminal_;
  QTimer patience_;
  QElapsedTimer since_;
};

}  // namespace eyebridge::gui
