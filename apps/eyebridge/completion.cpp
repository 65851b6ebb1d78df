#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "command.hpp"
#include "completion_words.hpp"
#include "eyebridge/base/config_error.hpp"
#include "own_files.hpp"

namespace eyebridge::apps {
namespace {

void print_script(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  if (text.str().empty()) {
    throw ConfigError({file.string()}, "this file is missing: the installation is not complete");
  }
  std::fputs(text.str().c_str(), stdout);
}

/// Help of several lines would look like several words.
std::string on_one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\t') c = ' ';
  }
  return text;
}

void print_words(const CLI::App& root, std::vector<std::string> words) {
  const std::string current = words.empty() ? "" : words.back();
  if (!words.empty()) words.pop_back();
  const Completions found = complete(root, words, current);
  for (const Completions::Word& word : found.words) {
    std::printf("%s\t%s\n", word.text.c_str(), on_one_line(word.help).c_str());
  }
  if (found.goes_on) std::puts("more");
  if (found.files == Completions::Files::Any) std::puts("files");
  if (found.files == Completions::Files::Folders) std::puts("folders");
}

}  // namespace

void add_completion(CLI::App& root, int& code) {
  CLI::App* command =
      root.add_subcommand("completion", "Prints what makes a shell complete command lines");
  command->require_subcommand(1);
  const auto add_shell = [&](const char* shell, const char* use,
                             std::filesystem::path CompletionFiles::*file) {
    CLI::App* one = command->add_subcommand(shell, std::string("For ") + shell + ": " + use);
    one->callback([file, &code] {
      print_script(own_files().completion.*file);
      code = kFine;
    });
  };
  add_shell("bash", "eval \"$(eyebridge completion bash)\" in ~/.bashrc", &CompletionFiles::bash);
  add_shell("zsh", "eval \"$(eyebridge completion zsh)\" in ~/.zshrc, after compinit",
            &CompletionFiles::zsh);
  add_shell("fish", "eyebridge completion fish | source, in config.fish", &CompletionFiles::fish);
  command->footer("Debian's packages have installed it already.");

  CLI::App* asked = command->add_subcommand(
      "words", "What can come next: words [-- WORD...], the last of which is being typed");
  const auto words = std::make_shared<std::vector<std::string>>();
  asked->add_option("WORD", *words, "Words of the command line, without eyebridge")->type_name("");
  asked->footer(
      "Prints a word and its description, with a tab between, per line; then \"more\" where a word "
      "is\n"
      "only the beginning of one, and \"files\" or \"folders\" where their names can come next as "
      "well.");
  asked->callback([&root, words, &code] {
    print_words(root, *words);
    code = kFine;
  });
}

}  // namespace eyebridge::apps
