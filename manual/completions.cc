#include "manual/completions.h"

#include <algorithm>
#include <string>
#include <vector>

#include "absl/strings/str_cat.h"
#include "absl/strings/str_join.h"
#include "absl/strings/str_replace.h"

namespace geodesic::manual {
namespace {

// In quotes that bash, zsh and fish read alike, but for what each escapes.
std::string QuotedForShell(const std::string& text) {
  return absl::StrCat("'", absl::StrReplaceAll(text, {{"'", "'\\''"}}), "'");
}

std::string QuotedForFish(const std::string& text) {
  return absl::StrCat(
      "'", absl::StrReplaceAll(text, {{"\\", "\\\\"}, {"'", "\\'"}}), "'");
}

std::vector<std::string> NamesOf(const std::vector<Option>& options) {
  std::vector<std::string> names;
  for (const Option& option : options) {
    names.insert(names.end(), option.names.begin(), option.names.end());
  }
  return names;
}

std::vector<std::string> CommandsOf(const Page& program) {
  std::vector<std::string> names;
  names.reserve(program.commands.size());
  for (const Page& command : program.commands) names.push_back(command.name);
  return names;
}

// The first sentence or clause, for lists with a line an option.
std::string Short(const std::string& help) {
  return help.substr(0, std::min(help.find(';'), help.find(": ")));
}

// Whether files are what to offer as the option's value.
bool TakesFile(const Option& option) { return option.value == "FILE"; }

// Lines of `case "$previous"` that offer what an option of `options` takes.
std::string BashValues(const std::vector<Option>& options,
                       const std::string& indent) {
  std::string cases;
  for (const Option& option : options) {
    if (option.value.empty()) continue;
    absl::StrAppend(&cases, indent, absl::StrJoin(option.names, "|"), ") ");
    if (!option.choices.empty()) {
      absl::StrAppend(&cases, "COMPREPLY=($(compgen -W '",
                      absl::StrJoin(option.choices, " "), "' -- \"$word\")); ");
    } else if (TakesFile(option)) {
      absl::StrAppend(&cases, "COMPREPLY=($(compgen -f -- \"$word\")); ");
    }
    absl::StrAppend(&cases, "return ;;\n");
  }
  return cases;
}

// The arguments of zsh's _arguments for an option.
std::vector<std::string> ZshSpecs(const Option& option) {
  const std::string help = absl::StrReplaceAll(
      Short(option.help), {{"[", "\\["}, {"]", "\\]"}, {":", "\\:"}});
  std::string value;
  if (!option.value.empty()) {
    const std::string action =
        !option.choices.empty()
            ? absl::StrCat("(", absl::StrJoin(option.choices, " "), ")")
        : TakesFile(option) ? "_files"
                            : " ";
    value = absl::StrCat(":", absl::StrReplaceAll(option.value, {{":", "\\:"}}),
                         ":", action);
  }
  std::vector<std::string> specs;
  for (const std::string& name : option.names) {
    // An asterisk: it may be repeated.
    specs.push_back(
        QuotedForShell(absl::StrCat("*", name, "[", help, "]", value)));
  }
  return specs;
}

std::string ZshArguments(const std::vector<Option>& options,
                         const std::vector<Option>& more,
                         const std::string& indent) {
  std::string text;
  for (const std::vector<Option>* list : {&options, &more}) {
    for (const Option& option : *list) {
      for (const std::string& spec : ZshSpecs(option)) {
        absl::StrAppend(&text, " \\\n", indent, spec);
      }
    }
  }
  return text;
}

// Lines of fish for these options, under a condition.
std::string FishOptions(const std::string& program, const std::string& when,
                        const std::vector<Option>& options) {
  std::string lines;
  for (const Option& option : options) {
    absl::StrAppend(&lines, "complete -c ", program);
    if (!when.empty()) absl::StrAppend(&lines, " -n ", QuotedForFish(when));
    for (const std::string& name : option.names) {
      absl::StrAppend(&lines, name.starts_with("--") ? " -l " : " -s ",
                      name.substr(name.starts_with("--") ? 2 : 1));
    }
    if (!option.choices.empty()) {
      absl::StrAppend(&lines, " -x -a ",
                      QuotedForFish(absl::StrJoin(option.choices, " ")));
    } else if (TakesFile(option)) {
      absl::StrAppend(&lines, " -r -F");
    } else if (!option.value.empty()) {
      absl::StrAppend(&lines, " -x");
    }
    absl::StrAppend(&lines, " -d ", QuotedForFish(Short(option.help)), "\n");
  }
  return lines;
}

}  // namespace

std::string BashCompletion(const Page& program) {
  std::string cases;
  for (const Page& command : program.commands) {
    absl::StrAppend(
        &cases, "    ", command.name, ")\n", "      case \"$previous\" in\n",
        BashValues(command.options, "        "), "      esac\n",
        "      options='", absl::StrJoin(NamesOf(command.options), " "), "'\n",
        "      ;;\n");
  }
  return absl::StrCat(
      "# Completion of ", program.name, " for bash, made from its options.\n\n",
      "_", program.name,
      "() {\n"
      "  local word=${COMP_WORDS[COMP_CWORD]} "
      "previous=${COMP_WORDS[COMP_CWORD - 1]}\n"
      "  local commands='",
      absl::StrJoin(CommandsOf(program), " "),
      "'\n"
      "  local command='' options='' i\n"
      "  COMPREPLY=()\n"
      "  for ((i = 1; i < COMP_CWORD; ++i)); do\n"
      "    if [[ \" $commands \" == *\" ${COMP_WORDS[i]} \"* ]]; then\n"
      "      command=${COMP_WORDS[i]}\n"
      "      break\n"
      "    fi\n"
      "  done\n"
      "  case \"$previous\" in\n",
      BashValues(program.options, "    "),
      "  esac\n"
      "  case \"$command\" in\n",
      cases,
      "  esac\n"
      "  if [[ $word == -* ]]; then\n"
      "    COMPREPLY=($(compgen -W \"$options ",
      absl::StrJoin(NamesOf(program.options), " "),
      "\" -- \"$word\"))\n"
      "  elif [[ -z $command ]]; then\n"
      "    COMPREPLY=($(compgen -W \"$commands\" -- \"$word\"))\n"
      "  else\n"
      "    COMPREPLY=($(compgen -f -- \"$word\"))\n"
      "  fi\n"
      "}\n"
      "complete -o filenames -F _",
      program.name, " ", program.name, "\n");
}

std::string ZshCompletion(const Page& program) {
  std::string commands;
  std::string cases;
  for (const Page& command : program.commands) {
    absl::StrAppend(&commands, "    ",
                    QuotedForShell(absl::StrCat(
                        command.name, ":",
                        absl::StrReplaceAll(command.help, {{":", "\\:"}}))),
                    "\n");
    absl::StrAppend(
        &cases, "        ", command.name, ")\n          _arguments -s",
        ZshArguments(command.options, program.options, "            "),
        " \\\n            '*:FILE:_files'\n          ;;\n");
  }
  return absl::StrCat(
      "#compdef ", program.name, "\n# Completion of ", program.name,
      " for zsh, made from its options.\n\n", "_", program.name,
      "() {\n"
      "  local context state state_descr line\n"
      "  typeset -A opt_args\n"
      "  local -a commands=(\n",
      commands,
      "  )\n"
      "  _arguments -s -C",
      ZshArguments(program.options, {}, "    "),
      " \\\n    '1:command:->command' \\\n    '*::argument:->arguments'\n"
      "  case $state in\n"
      "    command) _describe command commands ;;\n"
      "    arguments)\n"
      "      case $words[1] in\n",
      cases,
      "      esac\n"
      "      ;;\n"
      "  esac\n"
      "}\n\n_",
      program.name, " \"$@\"\n");
}

std::string FishCompletion(const Page& program) {
  const std::string none =
      absl::StrCat("not __fish_seen_subcommand_from ",
                   absl::StrJoin(CommandsOf(program), " "));
  std::string lines = absl::StrCat(
      "# Completion of ", program.name, " for fish, made from its options.\n",
      FishOptions(program.name, "", program.options));
  for (const Page& command : program.commands) {
    absl::StrAppend(
        &lines, "complete -c ", program.name, " -n ", QuotedForFish(none),
        " -f -a ", command.name, " -d ", QuotedForFish(command.help), "\n",
        FishOptions(program.name, "__fish_seen_subcommand_from " + command.name,
                    command.options));
  }
  return lines;
}

}  // namespace geodesic::manual
