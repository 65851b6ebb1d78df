#include "code/robios_apis.hpp"

#include <utility>

#include <Qsci/qscilexer.h>

namespace eyebridge::gui {
namespace {

// QScintilla's lexers have this many sets of keywords at most.
constexpr int kKeywordSets = 8;

/// Members of variables are nobody's business here, but those of the module `eye`.
bool is_ours(const QStringList& context) {
  return context.size() <= 1 || context.at(context.size() - 2) == "eye";
}

}  // namespace

RobiosApis::RobiosApis(QsciLexer* lexer, std::function<Api()> api)
    : QsciAbstractAPIs(lexer), api_(std::move(api)) {}

void RobiosApis::updateAutoCompletionList(const QStringList& context, QStringList& list) {
  if (context.isEmpty() || !is_ours(context)) return;
  const QString& begun = context.back();
  const auto offer = [&](const QString& name) {
    if (name.startsWith(begun, Qt::CaseInsensitive) && !list.contains(name)) list << name;
  };
  for (const Completion& completion : completions(api_())) offer(completion.name);
  for (int set = 1; set <= kKeywordSets; ++set) {
    const QStringList words = QString(lexer()->keywords(set)).split(' ', Qt::SkipEmptyParts);
    for (const QString& word : words) {
      if (word.front().isLetter()) offer(word);
    }
  }
}

QStringList RobiosApis::callTips(const QStringList& context, int commas,
                                 QsciScintilla::CallTipsStyle /*style*/, QList<int>& shifts) {
  if (context.size() < 2 || !is_ours(context.mid(0, context.size() - 1))) return {};
  const QByteArray name = context.at(context.size() - 2).toUtf8();
  const Completion* const found = find_completion(api_(), name.constData());
  if (found == nullptr || found->kind != Completion::Kind::Function) return {};
  QString prototype = QString::fromUtf8(found->prototype);
  // QScintilla stresses the argument behind as many commas as were typed: "..." stands for many.
  const int end = static_cast<int>(prototype.lastIndexOf("...)"));
  for (int have = static_cast<int>(prototype.count(',')); end >= 0 && have < commas; ++have) {
    prototype.insert(end, "..., ");
  }
  if (prototype.count(',') < commas) return {};
  shifts << 0;
  const QString doc = QString::fromUtf8(found->doc);
  return {doc.isEmpty() ? prototype : prototype + "\n" + doc};
}

}  // namespace eyebridge::gui
