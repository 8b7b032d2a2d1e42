#include "server/options/setting_sources.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <istream>
#include <memory>

#include "absl/strings/ascii.h"
#include "absl/strings/str_cat.h"
#include "absl/strings/str_replace.h"

namespace geodesic::server {
namespace {

// "GEODESICD_MAX_FACES" for "max-faces".
std::string EnvironmentName(const std::string& flag) {
  return absl::StrCat("GEODESICD_", absl::AsciiStrToUpper(absl::StrReplaceAll(
                                        flag, {{"-", "_"}})));
}

// CLI11 lets a file win over the environment. In a container the file is in the
// image and operators set the environment, so here the environment wins.
class FileBelowEnvironment final : public CLI::ConfigBase {
 public:
  // The app outlives it.
  explicit FileBelowEnvironment(const CLI::App& app) : app_(app) {}

  std::vector<CLI::ConfigItem> from_config(std::istream& input) const override {
    std::vector<CLI::ConfigItem> settings = ConfigBase::from_config(input);
    for (const CLI::ConfigItem& setting : settings) CheckName(setting);
    std::erase_if(settings, [](const CLI::ConfigItem& item) {
      return std::getenv(EnvironmentName(item.name).c_str()) != nullptr;
    });
    return settings;
  }

 private:
  // CLI11 names neither the file nor the way out.
  void CheckName(const CLI::ConfigItem& setting) const {
    if (setting.parents.empty() &&
        app_.get_option_no_throw("--" + setting.name) != nullptr) {
      return;
    }
    std::string name = setting.fullname();
    absl::StrReplaceAll({{".++", ""}}, &name);  // the begin of a section
    throw CLI::ConfigError(absl::StrCat(
        app_.get_config_ptr()->as<std::string>(), ": \"", name,
        "\" is not a setting. A line is NAME = VALUE, with a name that --help "
        "lists after --; there are no sections"));
  }

  const CLI::App& app_;
};

// CLI11 would wait for a pipe, and read a device, for ever. Of what is not
// there it says so itself.
std::string CheckPlainFile(const std::string& path) {
  // Far more than all settings take.
  constexpr uintmax_t kMostBytes = 4 << 20;
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found ||
      kind == std::filesystem::file_type::none) {
    return "";
  }
  if (kind != std::filesystem::file_type::regular) {
    return absl::StrCat(path, " is no plain file: write the settings to one");
  }
  return std::filesystem::file_size(path, error) <= kMostBytes
             ? ""
             : absl::StrCat(path, " is larger than 4 MiB: it has no settings");
}

}  // namespace

void AddFile(CLI::App& app) {
  app.set_config("--config", "", "Read settings from this TOML or INI file")
      ->check(&CheckPlainFile)
      ->type_name("FILE");
  app.config_formatter(std::make_shared<FileBelowEnvironment>(app));
}

void AddVariables(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const std::string name = option->get_single_name();
    if (name == "help" || name == "version") continue;
    option->envname(EnvironmentName(name));
  }
}

void TakeVariables(CLI::App& app) {
  for (CLI::Option* option : app.get_options()) {
    const std::string name = option->get_envname();
    const char* value = name.empty() ? nullptr : std::getenv(name.c_str());
    if (value == nullptr || *value == 0 || option->count() > 0) continue;
    option->add_result(value);
    option->run_callback();
  }
}

std::vector<std::string> ArgumentsInReverse(int argc, const char* const* argv) {
  std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool has_flag = std::any_of(
      arguments.begin(), arguments.end(),
      [](const auto& argument) { return argument.starts_with("--config"); });
  const char* file = std::getenv("GEODESICD_CONFIG");
  if (file != nullptr && !has_flag) {
    arguments.insert(arguments.begin(), absl::StrCat("--config=", file));
  }
  std::reverse(arguments.begin(), arguments.end());
  return arguments;
}

}  // namespace geodesic::server
