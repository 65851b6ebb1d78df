#include "code/runner.hpp"

#include <QDir>
#include <QFileInfo>
#include <QProcessEnvironment>
#include <csignal>
#include <cstring>
#include <utility>

#include <sys/prctl.h>
#include <unistd.h>

namespace eyebridge::gui {
namespace {

/// No colours in what is read, and a compiler whose words are those that messages.cpp knows.
QProcessEnvironment environment_of(Step::Kind kind) {
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert("NO_COLOR", "1");
  environment.insert("PYTHON_COLORS", "0");
  if (kind == Step::Kind::Build) environment.insert("LC_ALL", "C.UTF-8");
  return environment;
}

}  // namespace

Runner::Runner(QObject* parent) : QObject(parent) {
  patience_.setSingleShot(true);
  patience_.setInterval(kPatience_ms);
  connect(&patience_, &QTimer::timeout, this, [this] { send(SIGKILL); });
}

Runner::~Runner() {
  if (!process_) return;
  process_->disconnect(this);
  send(SIGKILL);
}

void Runner::start(const QList<Step>& plan) {
  if (state_ != State::Idle || plan.isEmpty()) return;
  plan_ = plan;
  start_step();
}

void Runner::start_step() {
  const Step step = plan_.takeFirst();
  if (step.kind == Step::Kind::Build) {
    const QString out = step.arguments.value(step.arguments.indexOf("-o") + 1);
    QDir().mkpath(QFileInfo(out).absolutePath());
  }
  process_ = std::make_unique<QProcess>();
  process_->setProcessEnvironment(environment_of(step.kind));
  process_->setWorkingDirectory(step.folder);
  process_->setStandardInputFile(QProcess::nullDevice());
  process_->setProcessChannelMode(QProcess::ForwardedChannels);
  if (!terminal_.open([this](const QByteArray& bytes) {
        if (on_output) on_output(bytes);
      })) {
    end(false, tr("No terminal can be opened for the program's output"));
    return;
  }
  process_->setChildProcessModifier([this, windows = getpid()] {
    // Without us nobody could stop it. Told when the thread that forks ends: the windows' thread,
    // which lives as long as the process.
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != windows) _exit(1);
    // A group of its own: what it starts is stopped with it. The windows' thread takes no signals,
    // which a child would inherit.
    setpgid(0, 0);
    sigset_t none;
    sigemptyset(&none);
    sigprocmask(SIG_SETMASK, &none, nullptr);
    terminal_.take_outputs();
  });
  connect(process_.get(), &QProcess::finished, this, &Runner::step_ended);
  connect(process_.get(), &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;  // finished() follows
    end(false, tr("%1 cannot be started: %2").arg(process_->program(), process_->errorString()));
  });
  const bool builds = step.kind == Step::Kind::Build;
  since_.start();
  set_state(builds ? State::Building : State::Running, builds ? tr("Building") : tr("Running"));
  process_->start(step.program, step.arguments);
  terminal_.close_writer();
  if (process_ && state_ != State::Idle) group_ = process_->processId();
}

void Runner::step_ended(int code, QProcess::ExitStatus status) {
  const bool was_stopped = state_ == State::Stopping;
  const bool built = state_ == State::Building;
  const bool well = status == QProcess::NormalExit && code == 0;
  terminal_.finish();
  if (well && !was_stopped && !plan_.isEmpty()) {
    group_ = 0;
    process_.release()->deleteLater();
    start_step();
    return;
  }
  const double seconds = static_cast<double>(since_.elapsed()) / 1000;
  QString how;
  if (was_stopped) {
    how = tr("Stopped");
  } else if (status != QProcess::NormalExit) {
    how = tr("Crashed: %1").arg(QString::fromUtf8(strsignal(code)));
  } else if (built) {
    how = well ? tr("Built") : tr("Not built: see the messages below");
  } else {
    how = tr("Ended with exit code %1 after %2 s").arg(code).arg(seconds, 0, 'f', 1);
  }
  end(well && !was_stopped, how);
}

void Runner::end(bool well, const QString& how) {
  patience_.stop();
  terminal_.finish();
  plan_.clear();
  group_ = 0;
  // Its own signal may have brought us here.
  if (process_) process_.release()->deleteLater();
  set_state(State::Idle, how);
  if (on_end) on_end(well);
}

void Runner::stop() {
  if (state_ != State::Building && state_ != State::Running) return;
  set_state(State::Stopping, tr("Stopping"));
  send(SIGTERM);
  patience_.start();
}

void Runner::send(int signal) const {
  // Both: the child may not have its group yet.
  if (group_ <= 0) return;
  const auto pid = static_cast<pid_t>(group_);
  if (kill(-pid, signal) != 0) kill(pid, signal);
}

void Runner::set_state(State state, const QString& how) {
  state_ = state;
  if (on_state) on_state(how);
}

}  // namespace eyebridge::gui
