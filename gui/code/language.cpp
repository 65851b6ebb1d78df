#include "code/language.hpp"

#include <QFileInfo>
#include <QFont>
#include <initializer_list>

#include <Qsci/qscilexercpp.h>
#include <Qsci/qscilexerpython.h>

namespace eyebridge::gui {
namespace {

/// What is told apart by colour. Ratios of contrast to both grounds are above 4.5 to 1.
struct Inks {
  QColor comment;
  QColor keyword;
  QColor string;
  QColor number;
  QColor directive;
  QColor name;
};

const Inks kOnLight{{0x3a, 0x6e, 0x3a}, {0x1f, 0x3f, 0xa8}, {0x9a, 0x3b, 0x12},
                    {0x7a, 0x1f, 0x86}, {0x6b, 0x55, 0x00}, {0x00, 0x60, 0x70}};
const Inks kOnDark{{0x8b, 0xc2, 0x8b}, {0x8f, 0xb4, 0xff}, {0xf0, 0xa8, 0x80},
                   {0xdc, 0xa0, 0xe6}, {0xd8, 0xc0, 0x60}, {0x70, 0xd0, 0xdc}};

void ink(QsciLexer& lexer, std::initializer_list<int> styles, const QColor& colour) {
  for (const int style : styles) lexer.setColor(colour, style);
}

void ink_cpp(QsciLexer& lexer, const Inks& inks) {
  using L = QsciLexerCPP;
  ink(lexer,
      {L::Comment, L::CommentLine, L::CommentDoc, L::CommentLineDoc, L::PreProcessorComment,
       L::PreProcessorCommentLineDoc},
      inks.comment);
  ink(lexer, {L::Keyword}, inks.keyword);
  ink(lexer,
      {L::SingleQuotedString, L::DoubleQuotedString, L::RawString, L::UnclosedString,
       L::VerbatimString, L::EscapeSequence},
      inks.string);
  ink(lexer, {L::Number, L::UserLiteral}, inks.number);
  ink(lexer, {L::PreProcessor}, inks.directive);
  ink(lexer, {L::KeywordSet2, L::GlobalClass}, inks.name);
}

void ink_python(QsciLexer& lexer, const Inks& inks) {
  using L = QsciLexerPython;
  ink(lexer, {L::Comment, L::CommentBlock}, inks.comment);
  ink(lexer, {L::Keyword}, inks.keyword);
  ink(lexer,
      {L::SingleQuotedString, L::DoubleQuotedString, L::TripleSingleQuotedString,
       L::TripleDoubleQuotedString, L::UnclosedString, L::SingleQuotedFString,
       L::DoubleQuotedFString, L::TripleSingleQuotedFString, L::TripleDoubleQuotedFString},
      inks.string);
  ink(lexer, {L::Number}, inks.number);
  ink(lexer, {L::Decorator}, inks.directive);
  ink(lexer, {L::ClassName, L::FunctionMethodName, L::HighlightedIdentifier}, inks.name);
}

}  // namespace

Language language_of(const QString& path) {
  const QString extension = QFileInfo(path).suffix();
  if (extension == "c" || extension == "h") return Language::C;
  for (const char* const cpp : {"cpp", "cc", "cxx", "c++", "C", "hpp", "hh", "hxx"}) {
    if (extension == QLatin1String(cpp)) return Language::Cpp;
  }
  return extension == "py" ? Language::Python : Language::Text;
}

QString comment_of(Language language) {
  switch (language) {
    case Language::C:
    case Language::Cpp:
      return "//";
    case Language::Python:
      return "#";
    case Language::Text:
      break;
  }
  return "";
}

QsciLexer* make_lexer(Language language, QObject* parent) {
  switch (language) {
    case Language::C:
    case Language::Cpp: {
      auto* const lexer = new QsciLexerCPP(parent);
      lexer->setFoldComments(true);
      lexer->setFoldCompact(false);
      return lexer;
    }
    case Language::Python: {
      auto* const lexer = new QsciLexerPython(parent);
      lexer->setFoldCompact(false);
      return lexer;
    }
    case Language::Text:
      break;
  }
  return nullptr;
}

bool is_dark(const QPalette& palette) {
  return palette.color(QPalette::Base).lightness() < palette.color(QPalette::Text).lightness();
}

void paint_lexer(QsciLexer& lexer, const QPalette& palette, const QFont& font) {
  lexer.setFont(font, -1);
  lexer.setDefaultFont(font);
  lexer.setDefaultColor(palette.color(QPalette::Text));
  lexer.setColor(palette.color(QPalette::Text), -1);
  lexer.setDefaultPaper(palette.color(QPalette::Base));
  lexer.setPaper(palette.color(QPalette::Base), -1);
  const Inks& inks = is_dark(palette) ? kOnDark : kOnLight;
  if (qobject_cast<QsciLexerPython*>(&lexer) != nullptr) {
    ink_python(lexer, inks);
  } else {
    ink_cpp(lexer, inks);
  }
}

}  // namespace eyebridge::gui
