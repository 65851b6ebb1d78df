#include <cctype>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "command.hpp"
#include "command_tree.hpp"
#include "eyebridge/base/config_error.hpp"
#include "eyebridge/base/write_file.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// `text` as troff shows it; lines become one paragraph.
std::string troff(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '\\') {
      out += "\\e";
    } else if (c == '-') {
      out += "\\-";
    } else if (c == '\n') {
      out += ' ';
    } else {
      out += c;
    }
  }
  return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

/// "eyebridge camera show", with another separator for the page's name.
std::string path_of(const CLI::App& command, char separator = ' ') {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? command.get_name()
                           : path_of(*parent, separator) + separator + command.get_name();
}

struct Summary {
  std::string what;
  std::string use;  ///< What comes behind the command's name; "" if the description has none.
};

/// Takes "Adds a robot to a run: eyebridge add MODEL" apart.
Summary summary_of(const CLI::App& command) {
  const std::string text = command.get_description();
  const std::string& name = command.get_name();
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos) return {text, ""};
  std::string_view use = std::string_view(text).substr(colon + 2);
  const auto skip = [&use](const std::string& word) {
    const bool is_there = use.starts_with(word + " ");
    if (is_there) use.remove_prefix(word.size() + 1);
    return is_there;
  };
  skip("eyebridge");
  if (!skip(name)) return {text, ""};
  return {text.substr(0, colon), std::string(use.substr(0, use.find("; ")))};
}

std::string use_of(const CLI::App& command) {
  if (std::string use = summary_of(command).use; !use.empty()) return use;
  std::string use = subcommands_of(command).empty() ? "[OPTIONS]" : "COMMAND [OPTIONS]";
  for (const CLI::Option* option : command.get_options()) {
    if (!option->get_positional()) continue;
    const std::string name = option->get_single_name();
    const std::string word = option->get_items_expected_max() > 1 ? name + "..." : name;
    use += option->get_required() ? " " + word : " [" + word + "]";
  }
  return use;
}

std::string description_line(const CLI::App& command) {
  std::string what = summary_of(command).what;
  if (!what.empty()) what[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(what[0])));
  if (what.ends_with('.')) what.pop_back();
  return what;
}

std::string options_text(const CLI::App& command, bool positional) {
  std::string text;
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_positional() != positional) continue;
    const std::string all = positional ? option->get_single_name()
                                       : fmt::format("{}", fmt::join(names_of(*option), ", "));
    std::string names = "\\fB" + troff(all) + "\\fR";
    const std::string type = option->get_type_name();
    if (option->get_items_expected_max() > 0 && !type.empty() && !positional) {
      names += " \\fI" + troff(type) + "\\fR";
    }
    text += ".TP\n" + names + "\n" + troff(option->get_description()) + "\n";
  }
  return text;
}

std::string commands_text(const CLI::App& command) {
  std::string text;
  for (const CLI::App* one : subcommands_of(command)) {
    text +=
        ".TP\n\\fB" + troff(path_of(*one, '-')) + "\\fR(1)\n" + troff(summary_of(*one).what) + "\n";
  }
  return text;
}

std::string see_also(const CLI::App& command) {
  const CLI::App* parent = command.get_parent();
  return parent == nullptr ? ".BR eyebridge\\-cc (1)\n"
                           : ".BR " + troff(path_of(*parent, '-')) + " (1)\n";
}

std::string page_of(const CLI::App& command) {
  std::string title = path_of(command, '-');
  for (char& c : title) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  std::string text =
      fmt::format(".TH {} 1 \"\" \"EyeBridge " EYEBRIDGE_VERSION
                  "\" \"User Commands\"\n"
                  ".SH NAME\n{} \\- {}\n.SH SYNOPSIS\n.B {}\n{}\n",
                  troff(title), troff(path_of(command, '-')), troff(description_line(command)),
                  troff(path_of(command)), troff(use_of(command)));
  const auto section = [&text](const char* name, const std::string& content) {
    if (!content.empty()) text += fmt::format(".SH {}\n{}", name, content);
  };
  const std::string footer = command.get_footer();
  section("DESCRIPTION", troff(summary_of(command).what) + "\n" +
                             (footer.empty() ? "" : ".PP\n" + troff(footer) + "\n"));
  section("COMMANDS", commands_text(command));
  section("ARGUMENTS", options_text(command, true));
  section("OPTIONS", options_text(command, false));
  section("SEE ALSO", see_also(command));
  return text;
}

void write_pages(const CLI::App& command, const fs::path& folder) {
  const fs::path file = folder / (path_of(command, '-') + ".1");
  if (const auto done = write_file(file, page_of(command)); !done) {
    throw ConfigError({file.string()}, done.error().what + "; expected a folder to write to");
  }
  std::printf("%s\n", file.c_str());
  for (const CLI::App* one : subcommands_of(command)) write_pages(*one, folder);
}

}  // namespace

void add_manual(CLI::App& root, int& code) {
  CLI::App* command =
      root.add_subcommand("manual", "Writes the manual pages of all commands: manual FOLDER");
  const auto folder = std::make_shared<std::string>();
  command->add_option("FOLDER", *folder, "Where they are written; man -l FILE shows one")
      ->required()
      ->type_name("");
  command->callback([&root, folder, &code] {
    write_pages(root, *folder);
    code = kFine;
  });
}

}  // namespace eyebridge::apps
