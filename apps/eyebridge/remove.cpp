#include <memory>
#include <string>

#include <CLI/CLI.hpp>

#include "ask_run.hpp"
#include "command.hpp"

namespace eyebridge::apps {

void add_remove(CLI::App& root, int& code) {
  CLI::App* command =
      root.add_subcommand("remove", "Takes a robot out of a run: eyebridge remove NUMBER");
  command->footer(
      "Ends the program of a robot in a run on this computer, as Ctrl-C would (motors stop,\n"
      "results are written), and takes the robot out of the world; prints its number.\n"
      "The others keep their numbers and go on. In virtual time it goes at whichever step is "
      "next:\n"
      "such a run cannot be repeated.");
  auto run = std::make_shared<int>(0);
  auto number = std::make_shared<std::string>();
  command->add_option("NUMBER", *number, "The robot's, from 1")->required();
  command->add_option("--run", *run, "The run's process, where there are several")
      ->check(CLI::PositiveNumber);
  command->callback([run, number, &code] {
    code = ask_run("remove", *run, {robios::kRemove, *number});
  });
}

}  // namespace eyebridge::apps
