#pragma once

#include <QPalette>
#include <QString>

class QsciLexer;

namespace eyebridge::gui {

/// What a file is written in.
enum class Language { Text, C, Cpp, Python };

/// By the file's extension: .c and .h are C, .cpp, .cc, .cxx, .c++, .hpp, .hh C++, .py Python, all
/// else text. (gcc's .C is C++.)
Language language_of(const QString& path);

/// What begins a comment up to the line's end; "" for text.
QString comment_of(Language language);

/// Colours the language; null for text. Belongs to `parent`.
QsciLexer* make_lexer(Language language, QObject* parent);

/// Colours for a dark or a light palette, in the font that is given.
void paint_lexer(QsciLexer& lexer, const QPalette& palette, const QFont& font);

/// Whether light letters stand on dark ground.
bool is_dark(const QPalette& palette);

}  // namespace eyebridge::gui
