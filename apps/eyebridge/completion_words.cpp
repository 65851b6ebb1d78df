#include "completion_words.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <CLI/CLI.hpp>

#include "command_tree.hpp"
#include "eyebridge/camera/source.hpp"
#include "eyebridge/files/load.hpp"
#include "eyebridge/hal/registry.hpp"

namespace eyebridge::apps {
namespace {

namespace fs = std::filesystem;

/// Where the parser is after the words that are there already.
struct Place {
  const CLI::App* command;
  const CLI::Option* pending = nullptr;  ///< Takes the next word as its value.
  std::size_t positionals = 0;
  bool options_ended = false;  ///< After "--".
  bool in_program = false;     ///< What follows belongs to a robot program.
};

bool takes_next_word(const CLI::Option& option) { return option.get_items_expected_min() > 0; }

const CLI::Option* find_option(const CLI::App& command, std::string_view name) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& known : names_of(*option)) {
      if (known == name) return option;
    }
  }
  return nullptr;
}

const CLI::App* find_subcommand(const CLI::App& command, const std::string& name) {
  for (const CLI::App* one : subcommands_of(command)) {
    if (one->get_name() == name) return one;
  }
  return nullptr;
}

void pass_positional(Place& place, const std::string& word) {
  const CLI::App* subcommand = place.positionals == 0 && !place.options_ended
                                   ? find_subcommand(*place.command, word)
                                   : nullptr;
  if (subcommand != nullptr) {
    place = {subcommand};
    return;
  }
  const auto own = place.command->get_options(
      [](const CLI::Option* option) { return option->get_positional(); });
  place.in_program = place.command->get_prefix_command() && place.positionals >= own.size();
  ++place.positionals;
}

Place place_after(const CLI::App& root, std::span<const std::string> before) {
  Place place{&root};
  for (const std::string& word : before) {
    if (place.in_program) break;
    if (place.pending != nullptr) {
      place.pending = nullptr;
    } else if (word == "--" && !place.options_ended) {
      place.options_ended = true;
    } else if (word.starts_with("-") && !place.options_ended) {
      const CLI::Option* option = find_option(*place.command, word);
      if (option != nullptr && takes_next_word(*option)) place.pending = option;
    } else {
      pass_positional(place, word);
    }
  }
  return place;
}

/// Words with one separator between, "a|b".
std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> out(1);
  for (const char c : text) {
    if (c == separator) {
      out.emplace_back();
    } else {
      out.back() += c;
    }
  }
  return out;
}

/// "auto|on|off" of a type that names its values, "{lossless,mjpeg}" of CLI::IsMember.
std::vector<std::string> choices_of(const std::string& type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}');
  if (open != std::string::npos && close != std::string::npos && open < close) {
    return split(std::string_view(type).substr(open + 1, close - open - 1), ',');
  }
  const bool named =
      type.find('|') != std::string::npos &&
      std::ranges::none_of(type, [](unsigned char c) { return std::isupper(c) != 0; });
  return named ? split(type, '|') : std::vector<std::string>{};
}

std::vector<std::string> world_names() {
  std::vector<std::string> names;
  for (const fs::path& folder : files::SearchPlaces::of_process().folders()) {
    std::error_code error;
    for (fs::directory_iterator file(folder, error), end; !error && file != end;
         file.increment(error)) {
      const std::string ending = file->path().extension().string();
      if (ending == ".wld" || ending == ".maz" || ending == ".sim") {
        names.push_back(file->path().filename().string());
      }
    }
  }
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

/// What options and arguments of this type can be. `type` is the word that --help shows.
Completions values_of(const std::string& type) {
  Completions out;
  const auto is = [&](std::string_view word) { return type.starts_with(word); };
  if (is("WORLD")) {
    for (std::string& name : world_names()) out.words.push_back({std::move(name), "world"});
    out.files = Completions::Files::Any;
  } else if (is("BACKEND")) {
    for (const hal::BackendFactory& row : hal::backend_table()) {
      out.words.push_back({std::string(row.scheme), std::string(row.summary)});
    }
    out.goes_on = true;
  } else if (is("CAMERA")) {
    for (const camera::SourceFactory& row : camera::source_table()) {
      out.words.push_back({std::string(row.scheme), std::string(row.summary)});
    }
    out.goes_on = true;
  } else if (is("FILE") || is("PATH") || is("DEVICE") || is("COMMAND")) {
    out.files = Completions::Files::Any;
  } else if (is("FOLDER")) {
    out.files = Completions::Files::Folders;
  } else {
    for (std::string& choice : choices_of(type)) out.words.push_back({std::move(choice), ""});
  }
  return out;
}

std::string type_of(const CLI::Option& option) {
  std::string type = option.get_type_name();
  if (option.get_positional() && (type.empty() || type == "TEXT")) return option.get_single_name();
  return type;
}

/// Worlds of a list with commas follow those that are there already.
Completions values_of(const CLI::Option& option, const std::string& written) {
  const std::string type = type_of(option);
  Completions out = values_of(type);
  const std::size_t comma = written.rfind(',');
  if (type.ends_with(",...") && comma != std::string::npos) {
    for (Completions::Word& word : out.words) word.text.insert(0, written, 0, comma + 1);
  }
  return out;
}

/// "--gui=o": the values behind the option's name.
Completions values_in_one_word(const CLI::App& command, const std::string& current,
                               std::size_t equals) {
  const CLI::Option* option = find_option(command, current.substr(0, equals));
  if (option == nullptr) return {};
  Completions out = values_of(*option, current.substr(equals + 1));
  for (Completions::Word& word : out.words) word.text.insert(0, current, 0, equals + 1);
  return out;
}

Completions options_of(const CLI::App& command) {
  Completions out;
  for (const CLI::Option* option : command.get_options()) {
    for (std::string& name : names_of(*option)) {
      out.words.push_back({std::move(name), option->get_description()});
    }
  }
  return out;
}

Completions arguments_at(const Place& place, const std::string& current) {
  Completions out;
  if (place.positionals == 0 && !place.options_ended) {
    for (const CLI::App* one : subcommands_of(*place.command)) {
      out.words.push_back({one->get_name(), one->get_description()});
    }
    if (!out.words.empty()) return out;
  }
  const auto own = place.command->get_options(
      [](const CLI::Option* option) { return option->get_positional(); });
  // The last one may take several words.
  const std::size_t index =
      own.empty() ? 0 : std::min<std::size_t>(place.positionals, own.size() - 1);
  const bool takes_one =
      !own.empty() && (place.positionals < own.size() || own[index]->get_items_expected_max() > 1);
  if (takes_one) return values_of(*own[index], current);
  if (place.command->get_prefix_command()) out.files = Completions::Files::Any;
  return out;
}

}  // namespace

Completions complete(const CLI::App& root, std::span<const std::string> before,
                     const std::string& current) {
  const Place place = place_after(root, before);
  const std::size_t equals = current.find('=');
  const bool is_option = current.starts_with("-") && !place.options_ended && !place.in_program;
  Completions out;
  if (place.in_program) {
    out.files = Completions::Files::Any;
  } else if (place.pending != nullptr) {
    out = values_of(*place.pending, current);
  } else if (is_option && equals != std::string::npos) {
    out = values_in_one_word(*place.command, current, equals);
  } else if (is_option) {
    out = options_of(*place.command);
  } else {
    out = arguments_at(place, current);
  }
  std::erase_if(out.words,
                [&](const Completions::Word& word) { return !word.text.starts_with(current); });
  return out;
}

}  // namespace eyebridge::apps
