#include "stop_signals.hpp"

#include <csignal>
#include <initializer_list>

namespace eyebridge::apps {
namespace {

volatile std::sig_atomic_t stop_signal = 0;

void note_stop(int signal) { stop_signal = signal; }

}  // namespace

void stop_on_signals() {
  struct sigaction action {};
  action.sa_handler = note_stop;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

bool stop_asked() { return stop_signal != 0; }

}  // namespace eyebridge::apps
