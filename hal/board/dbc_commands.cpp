#include "board/dbc_commands.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "board/dbc_names.hpp"
#include "config/toml_ascii.hpp"
#include "eyebridge/base/text.hpp"
#include "eyebridge/bridges/dbc/signal.hpp"

namespace eyebridge::hal {
namespace {

namespace dbc = bridges::dbc;
using Kind = bridges::DbcChecksum::Kind;

template <class Value>
struct Word {
  std::string_view name;
  Value value;
};

constexpr std::array<Word<Kind>, 3> kChecksums{
    {{"xor", Kind::Xor}, {"sae-j1850", Kind::SaeJ1850}, {"autosar-1", Kind::AutosarProfile1}}};
constexpr std::array<Word<dbc::DataIdMode>, 4> kModes{
    {{"both", dbc::DataIdMode::Both},
     {"alternating", dbc::DataIdMode::Alternating},
     {"low", dbc::DataIdMode::Low},
     {"nibble", dbc::DataIdMode::Nibble}}};

template <class Words>
auto word_of(DbcFields& fields, std::string_view key, const Words& words, std::string_view found) {
  const auto match = std::ranges::find(words, found, [](const auto& word) { return word.name; });
  if (match != words.end()) return match->value;
  std::string list;
  for (const auto& word : words) list += (list.empty() ? "" : ", ") + std::string(word.name);
  fields.refuse(key,
                fmt::format("found {} for '{}', expected one of {}", in_quotes(found), key, list));
}

void set_constants(const toml::table& table, const TomlDocument& document,
                   bridges::DbcCommand& command) {
  DbcFields fields(table, document, "'constants'");
  for (const auto& [key, node] : table) {
    const std::string name = from_ascii(key.str());
    const DbcSignalRef ref = find_signal(command.message, name, fields, key.str());
    const auto value = fields.number(key.str(), -1e18, 1e18);
    const auto bits = dbc::bits_for(ref.signal(), *value);
    if (!bits) fields.refuse(key.str(), "found a constant that cannot be: " + bits.error().what);
    dbc::put_bits(ref.signal(), *bits, command.resting);
  }
}

bool is_whole(const dbc::Signal& signal) {
  return signal.kind == dbc::NumberKind::Signed || signal.kind == dbc::NumberKind::Unsigned;
}

bridges::DbcCounter read_counter(const toml::table& table, const TomlDocument& document,
                                 const dbc::Message& message) {
  DbcFields fields(table, document, "'counter'");
  const DbcSignalRef ref =
      find_signal(message, fields.need_text("signal", "the name of a signal"), fields, "signal");
  constexpr int kLongest = 32;
  if (ref.signal().length > kLongest || !is_whole(ref.signal())) {
    fields.refuse("signal", fmt::format("found {}, expected a whole number of at most {} bits",
                                        ref.signal().name, kLongest));
  }
  const long most = static_cast<long>((std::uint64_t{1} << ref.signal().length) - 1);
  const long last = fields.whole("last", 1, most).value_or(most);
  fields.finish();
  return {ref.index, static_cast<std::uint64_t>(last)};
}

void check_profile_1(const DbcFields& fields, bridges::DbcCommand& command) {
  if (!command.counter) {
    fields.refuse("kind", "found autosar-1 without a 'counter' in [[command]], expected one");
  }
  const dbc::Signal& signal = command.message.signals[command.counter->signal];
  if (signal.length != 4) {
    fields.refuse("kind", fmt::format("found a counter of {} bits ({}), expected the 4 bits of "
                                      "autosar-1",
                                      signal.length, signal.name));
  }
  command.counter->last = std::min<std::uint64_t>(command.counter->last, dbc::kProfile1LastCounter);
}

bridges::DbcChecksum read_checksum(const toml::table& table, const TomlDocument& document,
                                   bridges::DbcCommand& command) {
  DbcFields fields(table, document, "'checksum'");
  const DbcSignalRef ref = find_signal(
      command.message, fields.need_text("signal", "the name of a signal"), fields, "signal");
  const dbc::Signal& signal = ref.signal();
  const int lowest = signal.order == dbc::ByteOrder::Intel ? signal.start : signal.start - 7;
  if (signal.length != 8 || lowest % 8 != 0) {
    fields.refuse("signal", fmt::format("found {}, expected 8 bits that are a byte of their own",
                                        signal.name));
  }
  bridges::DbcChecksum checksum;
  checksum.signal = ref.index;
  checksum.kind =
      word_of(fields, "kind", kChecksums, fields.need_text("kind", "xor, sae-j1850 or autosar-1"));
  if (checksum.kind == Kind::AutosarProfile1) {
    check_profile_1(fields, command);
    const auto id = fields.whole("data_id", 0, 0xFFFF);
    if (!id) fields.refuse("data_id", "found no 'data_id' in 'checksum', expected 0 … 65535");
    checksum.data_id = static_cast<std::uint16_t>(*id);
    checksum.mode = word_of(fields, "mode", kModes, fields.text("mode").value_or("both"));
  }
  fields.finish();
  return checksum;
}

}  // namespace

bridges::DbcCommand read_dbc_command(DbcFields& fields, const dbc::Database& database,
                                     const std::vector<bridges::DbcCommand>& others) {
  bridges::DbcCommand command;
  const std::string name = fields.need_text("message", "the name of a message");
  command.message = find_message(database, name, fields, "message");
  for (const bridges::DbcCommand& other : others) {
    if (other.message.name != name) continue;
    fields.refuse("message", fmt::format("found the message {} a second time, expected one "
                                         "[[command]] for it",
                                         in_quotes(name)));
  }
  const auto period = fields.duration("period");
  if (!period && !command.message.period_ms) {
    fields.refuse("period", fmt::format("found no 'period' in [[command]], and no cycle time of {} "
                                        "in the DBC file, expected one of them",
                                        name));
  }
  command.period =
      period.value_or(Time{std::chrono::milliseconds(command.message.period_ms.value_or(1))});
  command.resting.assign(static_cast<std::size_t>(command.message.length), 0);
  if (const toml::table* table = fields.table("constants")) {
    set_constants(*table, fields.document(), command);
  }
  if (const toml::table* table = fields.table("counter")) {
    command.counter = read_counter(*table, fields.document(), command.message);
  }
  if (const toml::table* table = fields.table("checksum")) {
    command.checksum = read_checksum(*table, fields.document(), command);
  }
  return command;
}

}  // namespace eyebridge::hal
