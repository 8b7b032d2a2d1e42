#include "manual/man_page.h"

#include <set>
#include <sstream>
#include <vector>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"
#include "absl/strings/str_split.h"
#include "absl/strings/string_view.h"
#include "absl/strings/strip.h"

namespace geodesic::manual {
namespace {

// `text` as troff shows it, word for word.
std::string Escaped(const std::string& text) {
  std::string escaped =
      absl::StrReplaceAll(text, {{"\\", "\\e"}, {"-", "\\-"}, {"'", "\\(aq"}});
  // A line that begins so would be a request.
  escaped = absl::StrReplaceAll(escaped, {{"\n.", "\n\\&."}});
  return escaped.starts_with('.') ? "\\&" + escaped : escaped;
}

std::string Bold(const std::string& text) {
  return absl::StrCat("\\fB", Escaped(text), "\\fR");
}

std::string Italic(const std::string& text) {
  return absl::StrCat("\\fI", Escaped(text), "\\fR");
}

class Writer {
 public:
  void Section(const std::string& title) { out_ << ".SH " << title << '\n'; }
  void Subsection(const std::string& title) { out_ << ".SS " << title << '\n'; }
  // Line by line, as it stands.
  void Verbatim(const std::string& text) {
    out_ << ".PP\n.nf\n" << Escaped(text) << "\n.fi\n";
  }
  // `term` is troff.
  void Entry(const std::string& term, const std::string& text) {
    out_ << ".TP\n" << term << '\n' << Escaped(text) << '\n';
  }
  void Raw(const std::string& text) { out_ << text; }
  std::string Text() const { return out_.str(); }

 private:
  std::ostringstream out_;
};

void WriteOption(const Option& option, Writer* out) {
  std::string term;
  for (const std::string& name : option.names) {
    absl::StrAppend(&term, term.empty() ? "" : ", ", Bold(name));
  }
  if (!option.value.empty()) {
    absl::StrAppend(&term, " ", Italic(option.value));
  } else if (option.may_have_value) {
    absl::StrAppend(&term, "[=", Italic("N"), "]");
  }
  std::string text = option.help;
  if (!option.default_value.empty()) {
    absl::StrAppend(&text, " (default ", option.default_value, ")");
  }
  out->Entry(term, text);
}

// Options under their groups, in the order of their first options.
void WriteOptions(const std::vector<Option>& options, Writer* out) {
  std::vector<std::string> groups;
  std::set<std::string> seen;
  for (const Option& option : options) {
    if (seen.insert(option.group).second) groups.push_back(option.group);
  }
  for (const std::string& group : groups) {
    if (groups.size() > 1 && group != "Options") out->Subsection(group);
    for (const Option& option : options) {
      if (option.group == group) WriteOption(option, out);
    }
  }
}

void WriteEnvironment(const std::vector<Option>& options, Writer* out) {
  bool has_title = false;
  for (const Option& option : options) {
    if (option.variable.empty()) continue;
    if (!has_title) out->Section("ENVIRONMENT");
    has_title = true;
    out->Entry(Bold(option.variable),
               "Stands for " + option.names.back() + ".");
  }
}

// "Examples:" and "Exit codes:" begin sections of their own.
void WriteFooter(const std::string& footer, Writer* out) {
  for (absl::string_view text :
       absl::StrSplit(footer, "\n\n", absl::SkipWhitespace())) {
    text = absl::StripTrailingAsciiWhitespace(text);
    if (absl::ConsumePrefix(&text, "Examples:\n")) {
      out->Section("EXAMPLES");
    } else if (absl::ConsumePrefix(&text, "Exit codes:")) {
      out->Section("EXIT STATUS");
    } else {
      out->Section("NOTES");
    }
    out->Verbatim(std::string(absl::StripPrefix(text, "\n")));
  }
}

// `typed` is how the program is called, e.g. "geodesic field".
std::string Written(const Page& page, const std::string& typed,
                    const ManPageOptions& options,
                    const std::string& see_also) {
  const std::string name = absl::StrReplaceAll(typed, {{" ", "-"}});
  Writer out;
  out.Raw(absl::StrCat(".TH ", absl::AsciiStrToUpper(Escaped(name)), " ",
                       options.section, " \"\" \"geodesic ", options.version,
                       "\"\n"));
  out.Section("NAME");
  out.Raw(absl::StrCat(Escaped(name), " \\- ", Escaped(page.help), "\n"));
  out.Section("SYNOPSIS");
  std::string synopsis = Bold(typed) + " [" + Italic("OPTION") + "]...";
  for (const Option& argument : page.arguments) {
    absl::StrAppend(&synopsis, " ", Italic(argument.names[0]));
  }
  if (!page.commands.empty()) {
    absl::StrAppend(&synopsis, " ", Italic("COMMAND"), " ...");
  }
  out.Raw(synopsis + "\n");
  if (!page.commands.empty()) {
    out.Section("COMMANDS");
    for (const Page& command : page.commands) {
      out.Entry(Bold(command.name),
                absl::StrCat(command.help, "; see ", name, "-", command.name,
                             "(", options.section, ")"));
    }
  }
  if (!page.arguments.empty()) {
    out.Section("ARGUMENTS");
    WriteOptions(page.arguments, &out);
  }
  out.Section("OPTIONS");
  WriteOptions(page.options, &out);
  WriteEnvironment(page.options, &out);
  WriteFooter(page.footer, &out);
  if (!see_also.empty()) {
    out.Section("SEE ALSO");
    out.Raw(Escaped(see_also) + "\n");
  }
  return out.Text();
}

}  // namespace

std::string ManPage(const Page& program, const ManPageOptions& options) {
  return Written(program, program.name, options, "");
}

std::string ManPage(const Page& program, const Page& command,
                    const ManPageOptions& options) {
  return Written(command, absl::StrCat(program.name, " ", command.name),
                 options,
                 absl::StrCat(program.name, "(", options.section, ")"));
}

}  // namespace geodesic::manual
