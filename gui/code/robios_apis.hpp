#pragma once

#include <functional>

#include <Qsci/qsciabstractapis.h>

#include "code/completions.hpp"

namespace eyebridge::gui {

/// What the editor offers while a person types: the names of RoBIOS and the keywords of the
/// language, and behind an opening parenthesis how the function is called.
class RobiosApis final : public QsciAbstractAPIs {
 public:
  /// Belongs to `lexer`. `api` says at each moment which interface the program is written against.
  RobiosApis(QsciLexer* lexer, std::function<Api()> api);

  void updateAutoCompletionList(const QStringList& context, QStringList& list) override;
  QStringList callTips(const QStringList& context, int commas, QsciScintilla::CallTipsStyle style,
                       QList<int>& shifts) override;

 private:
  std::function<Api()> api_;
};

}  // namespace eyebridge::gui
