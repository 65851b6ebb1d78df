#include "panel/inspector.hpp"

#include <QHeaderView>
#include <QStringList>

#include "panel/inspector_words.hpp"

namespace eyebridge::gui {
namespace {

// Groups of many rows of which most programs use none.
bool begins_closed(const std::string& kind) { return kind == "digital" || kind == "analog"; }

QString time_text(Time time) { return QString("%1 s").arg(to_seconds(time), 0, 'f', 2); }

}  // namespace

Inspector::Inspector(const hal::DeviceNotes& notes, const robios::Keys& keys, QWidget* parent)
    : QTreeWidget(parent), keys_(keys), times_(notes) {
  setAccessibleName(tr("Sensors and actuators"));
  setHeaderLabels({tr("Name"), tr("Value"), tr("Unit"), tr("Last time")});
  headerItem()->setToolTip(kTime, tr("When the program last read or wrote it, on its own clock"));
  setUniformRowHeights(true);
  setAlternatingRowColors(true);
  setSelectionMode(QAbstractItemView::NoSelection);
  for (const hal::NotedValue& value : notes.values()) add_row(value);
  QTreeWidgetItem* const keys_group = group(tr("Keys"));
  const auto row = [keys_group](const QString& name) {
    auto* item = new QTreeWidgetItem(keys_group, {name, "–"});
    item->setTextAlignment(kValue, Qt::AlignRight);
    return item;
  };
  key_ = row(tr("key"));
  touch_ = row(tr("touch"));
  code_ = row(tr("remote control"));
  // The widest that there is, so that nothing moves with the values.
  constexpr int kMargin = 12;
  const auto width = [this](const char* text) {
    return fontMetrics().horizontalAdvance(text) + kMargin;
  };
  header()->setStretchLastSection(false);
  header()->setSectionResizeMode(kName, QHeaderView::Stretch);
  setColumnWidth(kValue, width("1000 mm/s "));
  setColumnWidth(kUnit, width("ticks/s"));
  setColumnWidth(kTime, width("Last time "));
  setIndentation(kMargin);
  refresh();
}

QTreeWidgetItem* Inspector::group(const QString& title) {
  for (int i = 0; i < topLevelItemCount(); ++i) {
    if (topLevelItem(i)->text(kName) == title) return topLevelItem(i);
  }
  auto* item = new QTreeWidgetItem(this, {title});
  item->setFirstColumnSpanned(true);
  item->setExpanded(true);
  return item;
}

void Inspector::add_row(const hal::NotedValue& value) {
  QTreeWidgetItem* const above = group(title_of(value.kind));
  if (begins_closed(value.kind)) above->setExpanded(false);
  const QString device = name_of(value);
  Row row{&value, {}};
  for (const ShownPart& part : parts_of(value.quantity)) {
    // The device's name alone where it says all.
    const bool is_alone = is_main(value) && !device.isEmpty();
    const QString name = is_alone ? device : (device.isEmpty() ? "" : device + ' ') + part.name;
    auto* item = new QTreeWidgetItem(above, {name, "–", part.unit});
    item->setTextAlignment(kValue, Qt::AlignRight);
    item->setHidden(!is_main(value));
    row.parts.push_back(item);
  }
  rows_.push_back(std::move(row));
}

void Inspector::put(QTreeWidgetItem* item, const QString& text, Time time) {
  // Text that is set anew is painted anew.
  if (item->text(kValue) != text) item->setText(kValue, text);
  item->setText(kTime, time_text(time));
  item->setHidden(false);
}

void Inspector::show_note(Row& row) {
  const hal::Note& note = row.note;
  row.shown = note.count;
  for (std::size_t i = 0; i < row.parts.size(); ++i) {
    const QString text = part_text(row.value->quantity, i, note.values);
    put(row.parts[i], note.has_failed ? tr("no answer") : text, row.time);
    row.parts[i]->setToolTip(kValue, note.has_failed ? tr("The last call failed") : QString());
  }
}

void Inspector::look() {
  times_.look();
  for (Row& row : rows_) {
    const std::optional<hal::Note> note = row.value->cell.get();
    if (!note || note->count == row.note.count) continue;
    row.note = *note;
    row.time = times_.time_of(note->stamp);
  }
}

void Inspector::refresh() {
  look();
  for (Row& row : rows_) {
    if (row.note.count != row.shown) show_note(row);
  }
  refresh_keys();
}

void Inspector::refresh_keys() {
  const robios::GivenKeys given = keys_.given();
  for (int i = 0; i < 4; ++i) {
    if (given.key == 1 << i) put(key_, QString("KEY%1").arg(i + 1), given.key_at);
  }
  if (given.touch) {
    put(touch_, QString("%1, %2").arg(given.touch->x).arg(given.touch->y), given.touch_at);
  }
  if (given.remote == 0) return;
  const auto code = static_cast<char16_t>(given.remote);
  put(code_,
      given.remote > ' ' && given.remote < 127 ? QString("'%1'").arg(QChar(code))
                                               : QString::number(given.remote),
      given.remote_at);
}

const QTreeWidgetItem* Inspector::find(const QString& path) const {
  const QStringList names = path.split('/');
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const QTreeWidgetItem* const above = topLevelItem(i);
    if (above->text(kName) != names.value(0)) continue;
    for (int k = 0; k < above->childCount(); ++k) {
      if (above->child(k)->text(kName) == names.value(1)) return above->child(k);
    }
  }
  return nullptr;
}

}  // namespace eyebridge::gui
