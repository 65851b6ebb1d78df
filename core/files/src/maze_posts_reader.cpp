#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "eyebridge/base/units.hpp"
#include "maze_formats.hpp"
#include "maze_layout.hpp"
#include "text.hpp"

namespace eyebridge::files {
namespace {

using world::MazeCell;

bool is_post(char c) { return c == 'o' || c == '+'; }
bool is_space(char c) { return c == ' '; }

/// Where the posts of `line` stand, if it is the upper edge of a drawing: posts at equal distances,
/// and nothing but walls and blanks between them.
std::vector<std::size_t> posts_in(std::string_view line) {
  std::vector<std::size_t> posts;
  bool has_wall = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_post(line[i])) {
      posts.push_back(i);
    } else if (line[i] == '-' || (line[i] == '_' && !posts.empty())) {
      has_wall = true;
    } else if (!is_space(line[i])) {
      return {};
    }
  }
  const bool is_plain = has_wall || line.find('+') != std::string_view::npos || posts.size() > 2;
  if (posts.size() < 2 || posts.back() + 1 != line.size() || !is_plain) return {};
  const std::size_t pitch = posts[1] - posts[0];
  for (std::size_t i = 1; i < posts.size(); ++i) {
    if (posts[i] - posts[i - 1] != pitch) return {};
  }
  return pitch < 2 ? std::vector<std::size_t>{} : posts;
}

class PostsReader {
 public:
  explicit PostsReader(const MazeSource& source)
      : source_(source),
        file_(source.file),
        warnings_(source.file, source.warnings),
        rows_(maze_lines(source.bytes, source.file)) {}

  world::WorldModel read() {
    take_size();
    lay_out();
    for (std::size_t r = 0; r < rows_.size(); ++r) {
      if (r % tall_ == 0) {
        read_edge_line(r);
      } else {
        read_cell_line(r);
      }
      look_outside(r);
    }
    warn_of_gaps(grid_, warnings_, [this](MazeCell cell, Side side) { return place(cell, side); });
    take_starts();
    return contest_maze(std::move(grid_), std::move(starts_));
  }

 private:
  void take_size() {
    grid_cell_ = kContestCell;
    if (const auto size = cell_size_in(rows_.back(), file_)) {
      grid_cell_ = *size;
      rows_.pop_back();
      while (!rows_.empty() && rows_.back().text.empty()) rows_.pop_back();
    }
    if (source_.cell) grid_cell_ = *source_.cell;
  }

  void lay_out() {
    const std::vector<std::size_t> posts = posts_in(rows_.front().text);
    left_ = posts.front();
    wide_ = posts[1] - posts[0];
    tall_ = 1;
    while (tall_ < rows_.size() && !is_post(at(tall_, left_))) ++tall_;
    const std::size_t lines = rows_.size() - 1;
    if (tall_ == rows_.size() || tall_ < 2) {
      const std::size_t r = std::min(tall_, lines);
      throw ConfigError({file_, rows_[r].line, static_cast<int>(left_) + 1},
                        "no second line of posts below the first: expected a line of cells, then "
                        "one of posts");
    }
    if (lines % tall_ != 0) {
      throw ConfigError({file_, rows_.back().line, 1},
                        "the drawing ends within a row of cells: expected a line of posts");
    }
    grid_ = empty_maze(posts.size() - 1, lines / tall_, {file_, rows_.front().line, 1});
    grid_.cell = grid_cell_;
  }

  /// The character at a line and a column, a blank where the line is shorter.
  [[nodiscard]] char at(std::size_t r, std::size_t i) const {
    return i < rows_[r].text.size() ? rows_[r].text[i] : ' ';
  }

  /// A line of posts, and the walls that lie between them.
  void read_edge_line(std::size_t r) {
    const int boundary = grid_.rows - static_cast<int>(r / tall_);  // rows of cells below it
    for (int column = 0; column <= grid_.columns; ++column) {
      const std::size_t post = left_ + static_cast<std::size_t>(column) * wide_;
      if (!is_post(at(r, post))) {
        odd(r, post,
            is_space(at(r, post)) ? std::string("no post here: expected 'o' or '+'")
                                  : told(r, post) + " where a post belongs");
      }
      if (column == grid_.columns) continue;
      int drawn = 0;
      std::optional<std::size_t> other;
      for (std::size_t i = post + 1; i < post + wide_; ++i) {
        if (is_space(at(r, i))) continue;
        ++drawn;
        if (at(r, i) != '-' && at(r, i) != '_' && !other) other = i;
      }
      if (drawn == 0) continue;
      if (other) odd(r, *other, told(r, *other) + " is taken for a wall: expected '-'");
      if (drawn < static_cast<int>(wide_) - 1) {
        odd(r, post + 1, "a wall that is drawn in part is taken for a whole one");
      }
      const bool top = boundary == grid_.rows;
      edge(grid_, {column, top ? boundary - 1 : boundary}, top ? Side::North : Side::South) = 1;
    }
  }

  /// A line through a row of cells: the walls beside them, and what stands in them.
  void read_cell_line(std::size_t r) {
    const int row = grid_.rows - 1 - static_cast<int>(r / tall_);
    for (int column = 0; column <= grid_.columns; ++column) {
      const std::size_t wall = left_ + static_cast<std::size_t>(column) * wide_;
      if (!is_space(at(r, wall))) {
        if (at(r, wall) != '|') {
          odd(r, wall, told(r, wall) + " is taken for a wall: expected '|'");
        }
        char& flag = column == grid_.columns ? edge(grid_, {column - 1, row}, Side::East)
                                             : edge(grid_, {column, row}, Side::West);
        if (r % tall_ > 1 && flag == 0) odd_part(r, wall);
        flag = 1;
      } else if (r % tall_ > 1 && was_wall(column, row)) {
        odd_part(r, wall);
      }
      if (column == grid_.columns) continue;
      for (std::size_t i = wall + 1; i < wall + wide_; ++i) read_mark(r, i, {column, row});
    }
  }
  [[nodiscard]] bool was_wall(int column, int row) const {
    return column == grid_.columns ? has_wall(grid_, {column - 1, row}, Side::East)
                                   : has_wall(grid_, {column, row}, Side::West);
  }
  void odd_part(std::size_t r, std::size_t i) {
    odd(r, i, "a wall that is drawn in part is taken for a whole one");
  }

  void read_mark(std::size_t r, std::size_t i, MazeCell cell) {
    const char mark = at(r, i);
    if (is_space(mark)) return;
    const bool is_start = mark == 'S' || mark == 's' || facing_of(mark);
    if (is_start) {
      marks_.push_back({mark, cell, {file_, rows_[r].line, static_cast<int>(i) + 1}});
    } else if (mark == 'G' || mark == 'g') {
      grid_.goals.push_back(cell);
    } else {
      odd(r, i, told(r, i) + " means nothing in a maze and is ignored: expected S or G");
    }
  }

  void look_outside(std::size_t r) {
    const std::string_view text = rows_[r].text;
    const std::size_t right = left_ + static_cast<std::size_t>(grid_.columns) * wide_;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (i == left_) i = right + 1;
      if (i < text.size() && !is_space(text[i])) {
        return odd(r, i, told(r, i) + " outside of the drawing is ignored");
      }
    }
  }

  void take_starts() {
    for (const Mark& mark : marks_) {
      Pose pose = start_in(grid_, mark.cell);
      if (const auto facing = facing_of(mark.letter)) pose.theta = *facing;
      starts_.push_back({mark.letter, pose});
      if (source_.start_places != nullptr) source_.start_places->push_back(mark.where);
    }
    if (marks_.empty() && source_.start_places != nullptr) {
      source_.start_places->push_back({file_, 0, 0});
    }
  }

  [[nodiscard]] SourceLocation place(MazeCell cell, Side side) const {
    const auto down = static_cast<std::size_t>(grid_.rows - 1 - cell.row) * tall_;
    const auto across = static_cast<std::size_t>(cell.column) * wide_ + left_;
    const std::size_t r = down + (side == Side::North ? 0 : side == Side::South ? tall_ : 1);
    const std::size_t i = across + (side == Side::West ? 0 : side == Side::East ? wide_ : 1);
    return {file_, rows_[r].line, static_cast<int>(i) + 1};
  }

  [[nodiscard]] std::string told(std::size_t r, std::size_t i) const {
    return in_quotes(std::string_view(&rows_[r].text[i], 1));
  }
  void odd(std::size_t r, std::size_t i, std::string text) {
    warnings_.add(rows_[r].line, static_cast<int>(i) + 1, std::move(text));
  }

  struct Mark {
    char letter;
    MazeCell cell;
    SourceLocation where;
  };

  const MazeSource& source_;
  const std::string& file_;
  Warnings warnings_;
  std::vector<MazeLine> rows_;
  std::size_t left_ = 0;  ///< Column of the left posts.
  std::size_t wide_ = 0;  ///< Columns from post to post.
  std::size_t tall_ = 0;  ///< Lines from post to post.
  double grid_cell_ = kContestCell;
  world::MazeGrid grid_;
  std::vector<Mark> marks_;
  std::vector<world::StartPose> starts_;
};

}  // namespace

bool starts_with_posts(std::string_view text) {
  text = without_bom(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  text = text.substr(0, text.find('\n', first));
  text.remove_prefix(text.rfind('\n') + 1);  // npos + 1 is 0
  return !posts_in(text.substr(0, text.find_last_not_of(" \r\x1A") + 1)).empty();
}

world::WorldModel read_posts_maze(const MazeSource& source) { return PostsReader(source).read(); }

}  // namespace eyebridge::files
