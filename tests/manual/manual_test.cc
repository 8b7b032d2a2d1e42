#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <string>

#include "manual/completions.h"
#include "manual/man_page.h"
#include "manual/pages.h"
#include "manual/settings_file.h"

namespace geodesic::manual {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::Not;

class ManualTest : public ::testing::Test {
 protected:
  ManualTest() {
    app_.set_config("--config");
    app_.add_option("-s,--size", size_, "How big; in metres")
        ->type_name("N")
        ->capture_default_str()
        ->envname("TOOL_SIZE")
        ->group("Shape");
    app_.add_option("--colour", colour_, "It's -- by default -- red")
        ->type_name("red|dark-blue");
    CLI::App* cut = app_.add_subcommand("cut", "Cut a file: in two");
    cut->add_option("FILE", colour_, "What to cut")->required();
    cut->add_flag("--all{7}", size_, "Cut all [of it]");
    cut->add_option("--out", colour_, "Where to")->type_name("FILE");
    cut->footer("Examples:\n  tool cut .a\n\nRead more.");
  }

  CLI::App app_{"A tool", "tool"};
  int size_ = 3;
  std::string colour_;
};

TEST_F(ManualTest, DescribesOptionsAndCommands) {
  const Page page = Describe(app_);
  EXPECT_EQ(page.name, "tool");
  ASSERT_EQ(page.options.size(), 4);  // and --help, --config
  EXPECT_THAT(
      page.options[2],
      AllOf(Field(&Option::names, ElementsAre("-s", "--size")),
            Field(&Option::value, "N"), Field(&Option::default_value, "3"),
            Field(&Option::variable, "TOOL_SIZE"),
            Field(&Option::is_setting, true), Field(&Option::group, "Shape")));
  EXPECT_THAT(page.options[3].choices, ElementsAre("red", "dark-blue"));
  ASSERT_EQ(page.commands.size(), 1);
  const Page& cut = page.commands[0];
  ASSERT_EQ(cut.arguments.size(), 1);
  EXPECT_THAT(cut.arguments[0].names, ElementsAre("FILE"));
  ASSERT_EQ(cut.options.size(), 3);
  EXPECT_TRUE(cut.options[1].may_have_value);
  EXPECT_THAT(cut.options[1].value, "");
}

TEST_F(ManualTest, ManPagesHoldEverySection) {
  const Page page = Describe(app_);
  const ManPageOptions options = {.section = 1, .version = "1.2"};
  const std::string tool = ManPage(page, options);
  EXPECT_THAT(tool, HasSubstr(".TH TOOL 1 \"\" \"geodesic 1.2\""));
  EXPECT_THAT(tool, HasSubstr("\\fB\\-s\\fR, \\fB\\-\\-size\\fR \\fIN\\fR\n"
                              "How big; in metres (default 3)"));
  EXPECT_THAT(tool, HasSubstr("It\\(aqs \\-\\- by default"));
  EXPECT_THAT(tool, HasSubstr(".SH ENVIRONMENT\n.TP\n\\fBTOOL_SIZE\\fR\n"));
  EXPECT_THAT(tool, Not(HasSubstr("NOTES")));  // no footer
  EXPECT_THAT(tool, HasSubstr("see tool\\-cut(1)"));

  const std::string cut = ManPage(page, page.commands[0], options);
  EXPECT_THAT(cut, HasSubstr("tool\\-cut \\- Cut a file: in two"));
  EXPECT_THAT(cut, HasSubstr("\\fB\\-\\-all\\fR[=\\fIN\\fR]"));
  EXPECT_THAT(cut, HasSubstr(".SH EXAMPLES\n.PP\n.nf\n  tool cut .a\n"));
  EXPECT_THAT(cut, HasSubstr(".SH NOTES\n.PP\n.nf\nRead more."));
}

TEST_F(ManualTest, LinesThatBeginWithADotAreText) {
  app_.footer("Examples:\n.hidden\n.nf");
  EXPECT_THAT(ManPage(Describe(app_), {}),
              HasSubstr("\n\\&.hidden\n\\&.nf\n.fi\n"));
}

TEST_F(ManualTest, CompletionsEscapeWhatShellsRead) {
  const Page page = Describe(app_);
  EXPECT_THAT(BashCompletion(page),
              HasSubstr("--colour) COMPREPLY=($(compgen -W 'red dark-blue'"));
  EXPECT_THAT(
      ZshCompletion(page),
      AllOf(HasSubstr("'*--all[Cut all \\[of it\\]]'"),
            HasSubstr("'cut:Cut a file\\: in two'"), HasSubstr("It'\\''s")));
  EXPECT_THAT(FishCompletion(page),
              AllOf(HasSubstr("-l out -r -F"), HasSubstr("It\\'s")));
}

TEST_F(ManualTest, SettingsAreCommentsUnlessTheyAreSet) {
  const std::string file =
      SettingsFile(Describe(app_), {{"colour", "dark-blue"}});
  EXPECT_THAT(file, HasSubstr("\n## Shape\n\n# How big; in metres. "
                              "(TOOL_SIZE)\n#size = 3\n"));
  EXPECT_THAT(file, HasSubstr("\ncolour = \"dark-blue\"\n"));
  EXPECT_THAT(file, Not(HasSubstr("config")));
}

}  // namespace
}  // namespace geodesic::manual
