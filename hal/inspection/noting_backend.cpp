#include <algorithm>
#include <array>
#include <memory>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "calls/exchange.hpp"
#include "eyebridge/base/units.hpp"
#include "eyebridge/hal/device_notes.hpp"
#include "eyebridge/hal/passing_backend.hpp"

namespace eyebridge::hal {
namespace {

/// Numbers of a fixed count, without a list on the heap.
template <class... Types>
NoteCell::Values note_of(const Types&... values) {
  NoteCell::Values note{};
  [[maybe_unused]] auto end = note.begin();
  ((end = std::ranges::copy(AsValues<Types>::pack(values), end).out), ...);
  return note;
}

/// Range and bearing of a scan's nearest point.
NoteCell::Values nearest_of(std::span<const double> ranges, double field_of_view) {
  if (ranges.empty()) return {};
  const auto nearest = std::ranges::min_element(ranges);
  const bool is_circle = field_of_view > 2 * kPi - 1e-9;  // without a ray at both ends
  const auto gaps = static_cast<double>(ranges.size()) - (is_circle ? 0.0 : 1.0);
  if (gaps < 0.5) return {*nearest, 0.0};
  return {*nearest, (0.5 - static_cast<double>(nearest - ranges.begin()) / gaps) * field_of_view};
}

/// The nearest zone, and the bearing of its column.
NoteCell::Values note_of(const RangeMatrix::Ranges& ranges) {
  const auto nearest = std::ranges::min_element(ranges);
  const auto column = static_cast<std::size_t>(nearest - ranges.begin()) % RangeMatrix::kSize;
  const double share = (static_cast<double>(column) + 0.5) / RangeMatrix::kSize;
  return {*nearest, (0.5 - share) * RangeMatrix::kFieldOfView};
}

/// A device whose calls are noted; `inner` and what is noted in are lent.
template <class Interface>
class Noting : public Interface {
 public:
  Noting(Interface& inner, DeviceNotes& notes, std::string_view kind, int id,
         const std::string& name)
      : inner_(inner), notes_(notes) {
    const auto add = [&](const auto& row) {
      if (!row.note || rows_[index_of(*row.note)] != kNone) return;
      if (row.is_of_line) return add_lines(kind);
      rows_[index_of(*row.note)] = cells_.size();
      const int own = row.id.value_or(kHasLines ? 0 : id);  // 0: of all lines
      cells_.push_back(&notes.add(std::string(kind), own, name, *row.note));
    };
    std::apply([&](const auto&... rows) { (add(rows), ...); }, Calls<Interface>::kAll);
  }

 protected:
  template <class Answer, class... Args>
  Result<Answer> carry(const DeviceCall<Interface, Answer, Args...>& row,
                       std::type_identity_t<Args>... args) {
    Result<Answer> answer = (inner_.*row.method)(args...);
    NoteCell* const cell = row.note ? cell_of(row, args...) : nullptr;
    if (cell != nullptr) put(*cell, row, answer, args...);
    return answer;
  }
  template <class Fact>
  Fact fact(Fact (Interface::*method)() const) const {
    return (inner_.*method)();
  }

  Interface& inner_;
  DeviceNotes& notes_;

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  static constexpr std::size_t index_of(Quantity quantity) {
    return static_cast<std::size_t>(quantity);
  }

  static constexpr bool kHasLines = requires { Calls<Interface>::kFirstLine; };

  /// A row for each line and what is done to it.
  void add_lines(std::string_view kind) {
    if constexpr (kHasLines) {
      for (int line = Calls<Interface>::kFirstLine; line <= Calls<Interface>::kLastLine; ++line) {
        stride_ = 0;
        const auto add = [&](const auto& row) {
          if (!row.note || !row.is_of_line) return;
          ++stride_;
          if (line == Calls<Interface>::kFirstLine) rows_[index_of(*row.note)] = cells_.size();
          cells_.push_back(&notes_.add(std::string(kind), line, "", *row.note));
        };
        std::apply([&](const auto&... rows) { (add(rows), ...); }, Calls<Interface>::kAll);
      }
    }
  }

  /// Null: of a line that there is not.
  template <class Row, class... Args>
  NoteCell* cell_of(const Row& row, const Args&... args) const {
    const std::size_t first = rows_[index_of(*row.note)];
    if constexpr (kHasLines && sizeof...(Args) > 0) {
      const int line = std::get<0>(std::tie(args...)) - Calls<Interface>::kFirstLine;
      const int last = Calls<Interface>::kLastLine - Calls<Interface>::kFirstLine;
      if (line < 0 || line > last) return nullptr;
      return cells_[first + static_cast<std::size_t>(line) * stride_];
    }
    return cells_[first];
  }

  template <class Answer, class... Args>
  void put(NoteCell& cell, const DeviceCall<Interface, Answer, Args...>&,
           const Result<Answer>& answer, const std::remove_cvref_t<Args>&... args) const {
    if (!answer) return cell.put_failure(notes_.stamp());
    if constexpr ((is_room<Args> || ...)) {
      cell.put(notes_.stamp(), nearest_of(args..., inner_.shape().field_of_view));
    } else if constexpr (!std::is_void_v<Answer>) {
      if constexpr (std::is_same_v<Interface, Remote>) {
        if (*answer == 0) return;  // no code came
      }
      cell.put(notes_.stamp(), note_of(*answer));
    } else if constexpr (kHasLines) {
      cell.put(notes_.stamp(), note_of(std::get<1>(std::tie(args...))));
    } else {
      cell.put(notes_.stamp(), note_of(args...));
    }
  }

  std::vector<NoteCell*> cells_;
  std::array<std::size_t, kQuantityCount> rows_ = [] {
    std::array<std::size_t, kQuantityCount> none{};
    none.fill(kNone);
    return none;
  }();
  std::size_t stride_ = 0;  ///< From a line's cell to that of the next one.
};

/// Notes the sounds that could be played.
class NotingSound final : public Relay<Sound, Noting<Sound>> {
 public:
  using Relay::Relay;
  Result<void> tone(double frequency, double duration) override {
    return Relay::tone(frequency, duration).map([&] {
      SoundNote note;
      note.frequency = frequency;
      note.length = duration;
      notes_.put_sound(std::move(note));
    });
  }
  Result<void> play(const std::string& path) override {
    return Relay::play(path).map([&] {
      SoundNote note;
      note.file = path;
      notes_.put_sound(std::move(note));
    });
  }
};

template <class Interface>
constexpr bool is_noted() {
  return std::apply([](const auto&... rows) { return (rows.note.has_value() || ...); },
                    Calls<Interface>::kAll);
}

class NotingBackend final : public PassingBackend {
 public:
  NotingBackend(std::unique_ptr<Backend> inner, std::shared_ptr<DeviceNotes> notes)
      : PassingBackend(std::move(inner)), notes_(std::move(notes)) {
    for_each_kind([&]<DeviceKind kind>() {
      const std::vector<DeviceFacts> facts = inner_->facts_of(name_of(kind));
      for (int id = kKind<kind>.first_id; id <= kKind<kind>.last_id; ++id) {
        const auto fact = std::ranges::find(facts, id, &DeviceFacts::id);
        add<kind>(id, fact != facts.end() ? fact->name : std::string());
      }
    });
  }

  Device* find(DeviceKind kind, int id) override {
    const auto& shelf = shelves_[static_cast<std::size_t>(kind)];
    const auto index = static_cast<std::size_t>(id);  // huge for less than 0
    return index < shelf.size() ? shelf[index] : nullptr;
  }

 private:
  template <DeviceKind kind>
  void add(int id, const std::string& name) {
    using Interface = InterfaceOf<kind>;
    Interface* const inner = inner_->device<kind>(id);
    if (inner == nullptr) return;
    Device* device = inner;
    if constexpr (kind == DeviceKind::Sound) {
      device = keep<NotingSound>(*inner, *notes_, name_of(kind), id, name);
    } else if constexpr (is_noted<Interface>()) {
      device = keep<Relay<Interface, Noting<Interface>>>(*inner, *notes_, name_of(kind), id, name);
    }
    auto& shelf = shelves_[static_cast<std::size_t>(kind)];
    shelf.resize(static_cast<std::size_t>(id) + 1);
    shelf.back() = device;
  }
  template <class Type, class... Args>
  Device* keep(Args&&... args) {
    return devices_.emplace_back(std::make_unique<Type>(std::forward<Args>(args)...)).get();
  }

  const std::shared_ptr<DeviceNotes> notes_;
  std::vector<std::unique_ptr<Device>> devices_;
  /// By kind and id. Made at once, so that finding one costs no lock.
  std::array<std::vector<Device*>, kKindCount> shelves_;
};

}  // namespace

NotedBackend with_notes(std::unique_ptr<Backend> inner) {
  auto notes = std::make_shared<DeviceNotes>(inner->clock());
  return {std::make_unique<NotingBackend>(std::move(inner), notes), notes};
}

}  // namespace eyebridge::hal
