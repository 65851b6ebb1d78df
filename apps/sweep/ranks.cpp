#include "sweep/ranks.hpp"

#include <charconv>
#include <stdexcept>

#include <fmt/format.h>
#include <poll.h>

#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/hash.hpp"

namespace eyebridge::apps {
namespace {

constexpr int kPause_ms = 2;  // between two looks for messages; runs take tens of these
constexpr std::string_view kReady = "ready ";      // and the hash of the cells
constexpr std::string_view kProblem = "problem ";  // and what it is
constexpr std::string_view kDone = "done ";        // index, blank, outcome
constexpr std::string_view kRun = "run ";          // index
constexpr std::string_view kHome = "home";

std::string hash_of(const std::vector<Cell>& cells) {
  StateHash hash;
  for (const Cell& cell : cells) {
    for (const char c : cell.key()) hash.add_byte(static_cast<std::uint8_t>(c));
  }
  return fmt::format("{:016x}", hash.value());
}

std::pair<int, std::string> wait_for_message(RankLink& link) {
  for (;;) {
    if (auto message = link.receive()) return std::move(*message);
    poll(nullptr, 0, kPause_ms);
  }
}

void send_home(RankLink& link) {
  for (int rank = 1; rank < link.size(); ++rank) link.send(rank, std::string(kHome));
}

std::size_t index_in(std::string_view text) {
  std::size_t index = 0;
  const auto [stopped, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{}) throw std::runtime_error("found a message without a number");
  return index;
}

}  // namespace

void greet_ranks(RankLink& link, const std::vector<Cell>& cells, const std::string& problem) {
  const std::string expected = std::string(kReady) + hash_of(cells);
  std::string elsewhere;
  for (int rank = 1; rank < link.size(); ++rank) {
    const auto [from, text] = wait_for_message(link);
    if (text == expected || !elsewhere.empty()) continue;
    elsewhere = fmt::format("rank {} {}", from,
                            text.starts_with(kProblem)
                                ? "says: " + text.substr(kProblem.size())
                                : "found other runs; expected the same files on every computer");
  }
  if (problem.empty() && elsewhere.empty()) return;
  send_home(link);
  throw ConfigError({}, problem.empty() ? elsewhere : problem);
}

bool run_on_ranks(RankLink& link, std::span<const std::size_t> todo,
                  const std::function<void(std::size_t, const Outcome&)>& ended,
                  const std::function<bool()>& stop) {
  int busy = 0;
  const auto give_work = [&](int rank) {
    if (todo.empty()) return;
    link.send(rank, fmt::format("{}{}", kRun, todo.front()));
    todo = todo.subspan(1);
    ++busy;
  };
  for (int rank = 1; rank < link.size(); ++rank) give_work(rank);
  while (busy > 0 && !stop()) {
    const auto message = link.receive();
    if (!message) {
      poll(nullptr, 0, kPause_ms);
      continue;
    }
    const std::string& text = message->second;
    if (!text.starts_with(kDone)) throw std::runtime_error("found a message that is no outcome");
    --busy;
    const std::size_t index = index_in(std::string_view(text).substr(kDone.size()));
    ended(index, outcome_from_text(text.substr(text.find(' ', kDone.size()) + 1)));
    give_work(message->first);
  }
  send_home(link);
  return busy == 0;
}

void serve_rank(RankLink& link, const std::vector<Cell>& cells, const RunSettings& settings,
                const std::string& problem) {
  link.send(
      0, problem.empty() ? std::string(kReady) + hash_of(cells) : std::string(kProblem) + problem);
  for (;;) {
    const std::string text = wait_for_message(link).second;
    if (!text.starts_with(kRun)) return;  // home
    const std::size_t cell = index_in(std::string_view(text).substr(kRun.size()));
    std::string done;
    const bool ended = run_cells(
        cells, std::span(&cell, 1), settings,
        [&](std::size_t index, const Outcome& outcome) {
          done = fmt::format("{}{} {}", kDone, index, to_text(outcome));
        },
        // While it runs nothing else can come than that it is over.
        [&] { return link.receive().has_value(); });
    if (!ended) return;
    link.send(0, done);
  }
}

}  // namespace eyebridge::apps
