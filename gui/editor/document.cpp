#include "editor/document.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "editor/edits.hpp"
#include "editor/plan_step.hpp"

namespace eyebridge::gui {
namespace {

template <class T>
bool same_element(const T& a, const T& b) {
  return a == b;
}
bool same_element(const files::SimRobot& a, const files::SimRobot& b) {
  return files::same_meaning(a, b);
}

template <class T>
Splice<T> difference(const std::vector<T>& before, const std::vector<T>& after) {
  const auto same = [](const T& a, const T& b) { return same_element(a, b); };
  const auto [b, a] = std::ranges::mismatch(before, after, same);
  auto before_end = before.end();
  auto after_end = after.end();
  while (before_end != b && after_end != a && same(*std::prev(before_end), *std::prev(after_end))) {
    --before_end;
    --after_end;
  }
  return {static_cast<std::size_t>(b - before.begin()), {b, before_end}, {a, after_end}};
}

/// Selected elements behind one that came or went are other ones now: they are let go.
template <class T>
void replace(std::vector<T>& list, const Splice<T>& splice, bool forward, Kind kind,
             Selection& selection) {
  const std::vector<T>& from = forward ? splice.before : splice.after;
  const std::vector<T>& to = forward ? splice.after : splice.before;
  const auto begin = list.begin() + static_cast<std::ptrdiff_t>(splice.at);
  const auto next = list.erase(begin, begin + static_cast<std::ptrdiff_t>(from.size()));
  list.insert(next, to.begin(), to.end());
  if (from.size() == to.size()) return;
  std::erase_if(selection,
                [&](const Item& item) { return item.kind == kind && item.index >= splice.at; });
}

}  // namespace

PlanStep::Frame PlanStep::frame_of(const Plan& plan) {
  return {plan.width, plan.height, plan.texture, plan.cell};
}

PlanStep::PlanStep(Document& document, const QString& what, const Plan& before, const Plan& after)
    : QUndoCommand(what),
      document_(document),
      before_(frame_of(before)),
      after_(frame_of(after)),
      walls_(difference(before.walls, after.walls)),
      starts_(difference(before.starts, after.starts)),
      things_(difference(before.things, after.things)),
      markers_(difference(before.markers, after.markers)),
      robots_(difference(before.robots, after.robots)) {
  if (files::same_meaning(before.rest, after.rest)) return;
  rest_before_ = std::make_shared<const files::SimFile>(before.rest);
  rest_after_ = std::make_shared<const files::SimFile>(after.rest);
}

void PlanStep::apply(bool forward) {
  Plan plan = std::move(document_.plan_);
  Selection& selection = document_.selection_;
  const Frame& frame = forward ? after_ : before_;
  plan.width = frame.width;
  plan.height = frame.height;
  plan.texture = frame.texture;
  plan.cell = frame.cell;
  replace(plan.walls, walls_, forward, Kind::Wall, selection);
  replace(plan.starts, starts_, forward, Kind::Start, selection);
  replace(plan.things, things_, forward, Kind::Thing, selection);
  replace(plan.markers, markers_, forward, Kind::Marker, selection);
  replace(plan.robots, robots_, forward, Kind::Robot, selection);
  if (rest_before_) plan.rest = forward ? *rest_after_ : *rest_before_;
  document_.take(std::move(plan));
}

Document::Document(Plan plan) : plan_(std::move(plan)) {}

void Document::tell() const {
  if (on_change) on_change();
}

void Document::take(Plan plan) {
  plan_ = std::move(plan);
  ++version_;
  preview_.reset();
  tell();
}

void Document::edit(const QString& what, const std::function<void(Plan&)>& change) {
  Plan after = plan_;
  change(after);
  drop_points(after);
  if (same_plan(plan_, after)) {
    cancel();
  } else {
    history_.push(new PlanStep(*this, what, plan_, after));
  }
}

void Document::preview(const std::function<void(Plan&)>& change) {
  preview_ = plan_;
  change(*preview_);
  tell();
}

void Document::commit(const QString& what) {
  if (!preview_) return;
  const Plan after = *preview_;
  edit(what, [&](Plan& plan) { plan = after; });
}

void Document::cancel() {
  if (!preview_) return;
  preview_.reset();
  tell();
}

void Document::select(Selection items) {
  std::erase_if(items, [this](const Item& item) { return !has(plan_, item); });
  if (items == selection_) return;
  selection_ = std::move(items);
  tell();
}

}  // namespace eyebridge::gui
