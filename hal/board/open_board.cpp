#include "board/open_board.hpp"

#include <charconv>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "board/board_backend.hpp"
#include "board/can_link.hpp"
#include "board/dbc_link.hpp"
#include "board/io7_link.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/monotonic_clock.hpp"

namespace eyebridge::hal {
namespace {

using namespace std::chrono_literals;

// A robot tells its version every 5 s, everything else within 100 ms; it is listened to for 400 ms.
constexpr Time kCanPatience = 3s;

/// Takes the option `key` out of `url`; `otherwise` when it is not there.
std::string take(BackendUrl& url, std::string_view key, const std::string& otherwise) {
  const auto found = url.options.find(key);
  if (found == url.options.end()) return otherwise;
  std::string value = std::move(found->second);
  url.options.erase(found);
  return value;
}

int take_node(BackendUrl& url, const SourceLocation& where) {
  const std::string text = take(url, "node", "1");
  int node = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), node);
  if (error != std::errc{} || end != text.data() + text.size() || node < EYECAN_NODE_FIRST ||
      node > EYECAN_NODE_LAST) {
    throw ConfigError(where,
                      fmt::format("found {} for 'node', expected the number of a robot, {} … {}",
                                  in_quotes(text), EYECAN_NODE_FIRST, EYECAN_NODE_LAST));
  }
  return node;
}

/// One of two words.
std::optional<bool> take_choice(BackendUrl& url, const SourceLocation& where, std::string_view key,
                                std::string_view yes, std::string_view no) {
  if (!url.options.contains(key)) return std::nullopt;
  const std::string text = take(url, key, "");
  if (text != yes && text != no) {
    throw ConfigError(
        where, fmt::format("found {} for '{}', expected {} or {}", in_quotes(text), key, yes, no));
  }
  return text == yes;
}

std::optional<Time> take_timeout(BackendUrl& url, const SourceLocation& where) {
  constexpr int kShortest = 5;
  constexpr int kLongest = 5000;
  if (!url.options.contains("timeout")) return std::nullopt;
  const std::string text = take(url, "timeout", "");
  int ms = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ms);
  if (error != std::errc{} || end != text.data() + text.size() || ms < kShortest || ms > kLongest) {
    throw ConfigError(where, fmt::format("found {} for 'timeout', expected milliseconds, {} … {}",
                                         in_quotes(text), kShortest, kLongest));
  }
  return std::chrono::milliseconds(ms);
}

/// What the URL says of a board on a line.
bridges::Io7Settings take_io7_settings(BackendUrl& url, const SourceLocation& where) {
  using bridges::io7::ByteOrder;
  using bridges::io7::RequestForm;
  bridges::Io7Settings settings;
  settings.vw_letters = take_choice(url, where, "profile", "io7vw", "io7").value_or(false);
  settings.said_timeout = take_timeout(url, where);
  if (const auto text = take_choice(url, where, "requests", "text", "bytes")) {
    settings.said_requests = *text ? RequestForm::Ascii : RequestForm::Binary;
  }
  if (const auto msb = take_choice(url, where, "order", "msb", "lsb")) {
    settings.said_byte_order = *msb ? ByteOrder::MsbFirst : ByteOrder::LsbFirst;
  }
  return settings;
}

BoardTables take_tables(BackendUrl& url, const BackendContext& context) {
  const Config& config = context.config;
  std::string path = take(url, "hdt", "");
  if (path.empty() && config.is_set("hdt")) path = config.path("hdt").string();
  if (path.empty()) {
    context.log.write(Severity::Info,
                      "no --hdt: the board counts as an S4 with Sharp GP2Y0A21 sensors");
    return default_board_tables();
  }
  std::vector<Warning> warnings;
  BoardTables tables = read_board_tables(path, warnings);
  for (const Warning& warning : warnings)
    context.log.write(Severity::Warning, warning.where.str() + ": " + warning.text);
  return tables;
}

/// The value, or what stood in the way as a mistake in the URL.
template <class T>
T opened(Result<T> result, const SourceLocation& where) {
  if (!result) throw ConfigError(where, result.error().what);
  return std::move(*result);
}

const SourceLocation& place(const BackendContext& context) {
  return context.config.value("hal").where;
}

std::unique_ptr<Backend> io7_board(const BackendContext& context, const BoardTables& tables,
                                   const bridges::Io7Settings& settings, bridges::StreamOpener open,
                                   std::unique_ptr<Clock> clock) {
  auto client =
      std::make_unique<bridges::Io7Client>(std::move(open), *clock, context.log, settings);
  if (const auto found = client->connect(); !found) {
    throw ConfigError(place(context), found.error().what);
  }
  auto link = std::make_unique<Io7Link>(std::move(client), *clock, tables);
  auto backend = std::make_unique<BoardBackend>(std::move(clock), std::move(link), tables);
  backend->start();
  return backend;
}

std::unique_ptr<Backend> can_board(const BackendContext& context, const BoardTables& tables,
                                   int node, std::unique_ptr<bridges::CanBus> bus,
                                   std::unique_ptr<Clock> clock, bool guarded) {
  auto client = std::make_unique<bridges::CanClient>(std::move(bus), node, *clock, context.log);
  if (!clock->is_virtual()) client->start();  // else who moves the clock pumps
  if (const auto ready = client->wait_ready(kCanPatience); !ready) {
    throw ConfigError(place(context), ready.error().what +
                                          "; expected that it is switched on, and the same bit "
                                          "rate and terminations at all nodes");
  }
  if (guarded) {
    if (const auto guard = client->guard(); !guard) {
      throw ConfigError(place(context), guard.error().what);
    }
  }
  auto link = std::make_unique<CanLink>(std::move(client));
  auto backend = std::make_unique<BoardBackend>(std::move(clock), std::move(link), tables);
  backend->start();
  return backend;
}

/// A robot with messages of its own: dbc=FILE and map=FILE.
std::optional<DbcRobot> take_dbc_robot(BackendUrl& url, const BackendContext& context) {
  const SourceLocation& where = place(context);
  const bool has_dbc = url.options.contains("dbc");
  const bool has_map = url.options.contains("map");
  if (!has_dbc && !has_map) return std::nullopt;
  if (has_dbc != has_map) {
    throw ConfigError(where, fmt::format("found '{}' without '{}', expected both: the messages of "
                                         "a robot, and what they mean",
                                         has_dbc ? "dbc" : "map", has_dbc ? "map" : "dbc"));
  }
  for (const char* const other : {"node", "hdt", "ids", "offset"}) {
    if (!url.options.contains(other)) continue;
    throw ConfigError(where, fmt::format("found '{}' beside 'dbc', expected it not: the mapping "
                                         "file says what the robot is",
                                         other));
  }
  if (context.config.is_set("hdt")) {
    context.log.write(Severity::Warning,
                      "--hdt is ignored: the mapping file says what the robot is");
  }
  const std::string dbc = take(url, "dbc", "");
  return load_dbc_robot(dbc, take(url, "map", ""));
}

/// A bus without CAN FD would drop the messages that need it, and nobody would know why.
void check_fd(const BackendUrl& url, const DbcRobot& robot, const SourceLocation& where) {
  const auto given = url.options.find("fd");
  if (given != url.options.end() && given->second == "1") return;
  const auto refuse = [&](const bridges::dbc::Message& message) {
    if (!message.fd) return;
    throw ConfigError(where, fmt::format("found {}, a message of CAN FD, expected the option fd=1",
                                         message.name));
  };
  for (const bridges::DbcCommand& command : robot.plan.commands) refuse(command.message);
  for (const bridges::dbc::Message& status : robot.plan.statuses) refuse(status);
}

std::unique_ptr<Backend> dbc_board(const BackendContext& context, DbcRobot robot,
                                   std::unique_ptr<bridges::CanBus> bus,
                                   std::unique_ptr<Clock> clock, bool guarded) {
  auto client =
      std::make_unique<bridges::DbcClient>(std::move(bus), robot.plan, *clock, context.log);
  if (!clock->is_virtual()) client->start();  // else who moves the clock pumps
  if (const auto ready = client->wait_ready(kCanPatience); !ready) {
    throw ConfigError(place(context), ready.error().what +
                                          "; expected that it is switched on, the same bit rate "
                                          "at all nodes, and that these files are its own");
  }
  if (guarded) {
    if (const auto guard = client->guard(); !guard) {
      throw ConfigError(place(context), guard.error().what);
    }
  }
  const BoardTables tables = robot.tables;
  auto link = std::make_unique<DbcLink>(std::move(client), std::move(robot), *clock);
  auto backend = std::make_unique<BoardBackend>(std::move(clock), std::move(link), tables);
  backend->start();
  return backend;
}

/// On CAN the robot itself turns readings into ranges, unless an HDT file says how.
BoardTables can_tables(BackendUrl& url, const BackendContext& context) {
  const bool said = url.options.contains("hdt") || context.config.is_set("hdt");
  BoardTables tables = take_tables(url, context);
  if (said) return tables;
  for (BoardPsdTable& psd : tables.psds) psd.metres.clear();
  return tables;
}

}  // namespace

std::unique_ptr<Backend> open_io7_board(
    const BackendUrl& url, const BackendContext& context,
    std::function<Result<std::unique_ptr<bridges::ByteStream>>()> open,
    std::unique_ptr<Clock> clock) {
  BackendUrl rest = url;
  const bridges::Io7Settings settings = take_io7_settings(rest, place(context));
  const BoardTables tables = take_tables(rest, context);
  return io7_board(context, tables, settings, std::move(open), std::move(clock));
}

std::unique_ptr<Backend> open_io7_board(const BackendUrl& url, const BackendContext& context) {
  BackendUrl line = url;
  const SourceLocation& where = place(context);
  bridges::Io7Settings settings = take_io7_settings(line, where);
  settings.guarded = true;
  const BoardTables tables = take_tables(line, context);
  auto clock = std::make_unique<bridges::MonotonicClock>();
  Clock& time = *clock;
  // What is wrong with the URL is thrown by the first call.
  auto open = [line, where, &time] { return bridges::open_stream(line, where, time); };
  return io7_board(context, tables, settings, std::move(open), std::move(clock));
}

std::unique_ptr<Backend> open_can_board(const BackendUrl& url, const BackendContext& context,
                                        std::unique_ptr<bridges::CanBus> bus,
                                        std::unique_ptr<Clock> clock) {
  BackendUrl rest = url;
  if (auto robot = take_dbc_robot(rest, context)) {
    return dbc_board(context, *std::move(robot), std::move(bus), std::move(clock), false);
  }
  const int node = take_node(rest, place(context));
  return can_board(context, can_tables(rest, context), node, std::move(bus), std::move(clock),
                   false);
}

std::unique_ptr<Backend> open_can_board(const BackendUrl& url, const BackendContext& context) {
  BackendUrl line = url;
  const SourceLocation& where = place(context);
  if (auto robot = take_dbc_robot(line, context)) {
    check_fd(line, *robot, where);
    auto clock = std::make_unique<bridges::MonotonicClock>();
    auto bus = opened(bridges::open_bus(line, where, *clock), where);
    return dbc_board(context, *std::move(robot), std::move(bus), std::move(clock), true);
  }
  const int node = take_node(line, where);
  const BoardTables tables = can_tables(line, context);
  auto clock = std::make_unique<bridges::MonotonicClock>();
  auto bus = opened(bridges::open_bus(line, where, *clock), where);
  return can_board(context, tables, node, std::move(bus), std::move(clock), true);
}

}  // namespace eyebridge::hal
