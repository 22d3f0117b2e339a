#include "app/command_line.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <set>

#include "app/commands.h"
#include "app/described_commands.h"
#include "app/exit_code.h"
#include "app/option_checks.h"
#include "app/option_errors.h"
#include "app/study_command.h"
#include "base/enum_names.h"
#include "base/interruption.h"
#include "base/shown_unit.h"
#include "base/simd.h"
#include "base/text.h"
#include "base/version.h"
#include "results/comparison_results.h"
#include "runstore/append_file.h"

namespace overbend {
namespace {

constexpr const char* kStrictHelp = "Exit code 4 if a code check is exceeded; the results are still written";
/// Commands that print no results.
const std::set<std::string> kWithoutResults = {"new",      "import",     "export",       "schema",
                                               "licences", "completion", "check-results"};
constexpr const char* kStageHelp = "A single stage of the model's operation, by number or name";

void add_check(CLI::App& program, int& code) {
  CLI::App* command =
      program.add_subcommand("check", "Read and validate a model; print how it was understood. Writes no files.");
  auto model = std::make_shared<std::string>();
  command->add_option("MODEL", *model, "Model file (YAML)")->required();
  command->callback([model, &code] { code = run_check(*model); });
}

void add_static(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "static", "Static equilibrium of a model, or of every stage of its operation; writes a folder of results.");
  auto arguments = std::make_shared<StaticArguments>();
  command->add_option("MODEL", arguments->model_file, "Model file (YAML)")->required();
  command->add_option("-o,--output", arguments->output,
                      "Folder for the results; default: MODEL's name with .results, here");
  command->add_option("--stage", arguments->stage, kStageHelp);
  command->add_flag(
      "--sensitivities", arguments->sensitivities,
      "Derivatives of the results with respect to every number of the model, and the effect of its tolerance");
  command->add_flag("--strict", arguments->strict, kStrictHelp);
  command->callback([arguments, &code] { code = run_static(*arguments); });
}

void add_seek(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "seek", "Find the values of keys for which results meet targets (key `seek`); writes a folder of results.");
  auto model = std::make_shared<std::string>();
  auto output = std::make_shared<std::string>();
  command->add_option("MODEL", *model, "Model file (YAML)")->required();
  command->add_option("-o,--output", *output, "Folder for the results; default: MODEL's name with .results, here");
  command->callback([model, output, &code] { code = run_seek_command(*model, *output); });
}

/// Adds the options common to dynamic runs; `what` names the cases that run in parallel.
template <class Arguments>
void add_run_options(CLI::App* command, Arguments& arguments, const std::string& what,
                     const char* model = "Model file (YAML)") {
  command->add_option("MODEL", arguments.model_file, model)->required();
  command->add_option("--duration", arguments.duration, "Simulated time instead of the model's: '600 s'");
  CLI::Option* resume =
      command->add_flag("--resume", arguments.resume_option.resume, "Continue from the last checkpoint");
  command->add_flag("--restart", arguments.resume_option.restart, "Discard an unfinished run and start again")
      ->excludes(resume);
  command->add_option("--checkpoint", arguments.checkpoint_every, "Seconds between checkpoints")
      ->check(seconds())
      ->capture_default_str();
  command->add_option("--threads", arguments.threads, what + " run in parallel; default: one per core")
      ->check(whole_number(1, 4096));
}

void add_dynamic(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "dynamic",
      "Static, then dynamic analysis in the time domain; writes a folder of results. Ctrl-C leaves a checkpoint.");
  auto arguments = std::make_shared<DynamicArguments>();
  command->add_option("-o,--output", arguments->output,
                      "Folder for the results; default: MODEL's name with .results, here");
  command->add_option("--stage", arguments->stage, kStageHelp);
  add_run_options(command, *arguments, "Seeds");
  command->add_flag("--strict", arguments->strict, kStrictHelp);
  command->callback([arguments, &code] { code = run_dynamic(*arguments); });
}

void add_compare(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "compare",
      "Compare variants of a model in dynamic analysis, or the results in two or more folders; writes a folder with a "
      "page. Ctrl-C leaves checkpoints.");
  auto arguments = std::make_shared<CompareArguments>();
  command
      ->add_option("--of", arguments->of,
                   "tensioner: off, controlled, constant; contact: rollers, gap springs; impacts: resolved, captured")
      ->check(one_of_choices(enum_names<ComparisonType>()));
  command->add_option("-o,--output", arguments->output,
                      "Folder for the variants and the page; default: MODEL's name with .comparison, here");
  add_run_options(command, *arguments, "Variants", "Model file (YAML), with --of; or a folder of results");
  command->add_option("RESULTS", arguments->others, "Further folders of results, compared with the first");
  command->callback([arguments, &code] { code = run_compare(*arguments); });
}

void add_slurm(CLI::App& command, StudyArguments& arguments) {
  command.add_option("--on", arguments.on, "Where the cases run: slurm submits a job array; default: here")
      ->check(one_of_choices({"slurm"}));
  command.add_option("--partition", arguments.slurm.partition, "Slurm: partition; default: the cluster's");
  command.add_option("--time", arguments.slurm.time, "Slurm: time limit of a task; default: the partition's");
  command
      .add_option("--cases-per-task", arguments.slurm.cases_per_task,
                  "Slurm: number of cases per task, run one after the other; default: chosen to give 200 tasks")
      ->check(whole_number(1, 1000000));
  command
      .add_option("--array-limit", arguments.slurm.array_limit,
                  "Slurm: maximum number of tasks that run at the same time")
      ->check(whole_number(1, 1000000));
  command.add_flag("--watch", arguments.watch, "Slurm: show the progress of the study until its tasks have ended");
  command.add_flag("--resubmit", arguments.resubmit, "Slurm: submit cases that failed or did not finish again");
}

void add_study(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "study",
      "Run many cases of a model with different values of keys; writes a table. A study that was interrupted or killed "
      "continues when it is started again.");
  auto arguments = std::make_shared<StudyArguments>();
  command->add_option("STUDY", arguments->study_file, "Study file (YAML); with --gather also the folder of a study")
      ->required();
  command->add_option("-o,--output", arguments->output,
                      "Folder for the study; default: STUDY's name with .study, here");
  command->add_option("--threads", arguments->threads, "Cases run in parallel; default: one per core")
      ->check(whole_number(1, 4096));
  command->add_option("--checkpoint", arguments->checkpoint_every, "Seconds between checkpoints of a dynamic analysis")
      ->check(seconds())
      ->capture_default_str();
  CLI::Option* dry = command->add_flag("--dry-run", arguments->dry_run,
                                       "List the cases and estimate the run time from a few of them; writes nothing");
  CLI::Option* only = command->add_option("--case", arguments->only, "Run only this case, with all its files")
                          ->check(whole_number(0, 100000000))
                          ->excludes(dry);
  command->add_flag("--retry-failed", arguments->retry_failed, "Run cases that failed before again");
  CLI::Option* tasks = command
                           ->add_option("--tasks", arguments->tasks,
                                        "I/N: only cases I, I + N, I + 2 N, ... of the study; I from 0 to N - 1. "
                                        "Processes may share the folder; --gather then makes the table")
                           ->excludes(dry)
                           ->excludes(only);
  command->add_flag("--gather", arguments->gather, "Make the tables from the finished cases; runs no case")
      ->excludes(dry)
      ->excludes(only)
      ->excludes(tasks);
  command->add_flag("--strict", arguments->strict, "Exit code 4 if a case exceeds a code check or has no solution");
  add_slurm(*command, *arguments);
  command->callback([arguments, &code] { code = run_study_command(*arguments); });
}

void add_lay_table(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "lay-table", "Table of lay equilibria over tension, lay-back, depth or a route; writes CSV, XLSX and a page.");
  auto arguments = std::make_shared<LayTableArguments>();
  command->add_option("MODEL", arguments->model_file, "Model file (YAML)")->required();
  command->add_option("-o,--output", arguments->output,
                      "Folder for the table; default: MODEL's name with .lay-table, here");
  std::vector<CLI::Option*> varied;
  const auto vary = [&](const char* name, std::string& value, const char* text) {
    varied.push_back(command->add_option(name, value, text));
    for (std::size_t i = 0; i + 1 < varied.size(); ++i) varied.back()->excludes(varied[i]);
    return varied.back();
  };
  vary("--tension", arguments->tension,
       "Tension, from..to/steps: '200 kN..400 kN/20'; default: lay_table of the model");
  vary("--lay-back", arguments->lay_back, "Lay-back, from which the tension follows: '120 m..180 m/12'");
  vary("--depth", arguments->depth, "Water depth, at the model's tension: '60 m..120 m/12'");
  vary("--depths", arguments->depths_file, "Depths along a route: CSV of distance_m or kp_km, and depth_m");
  command->add_flag("--least", arguments->min_tension,
                    "Along a route: use the minimum tension that passes every check");
  command->callback([arguments, &code] { code = run_lay_table(*arguments); });
}

void add_report(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("report", "Write report.html again from results.h5.");
  auto place = std::make_shared<std::string>();
  command->add_option("RESULTS", *place, "Folder of results, or its results.h5")->required();
  auto pdf = std::make_shared<bool>(false);
  command->add_flag("--pdf", *pdf, "Print it as report.pdf as well, with Chromium (or the browser OVERBEND_BROWSER)");
  command->callback([place, pdf, &code] { code = run_report(*place, *pdf); });
}

void add_check_results(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "check-results", "Repeat the code checks of stored results, optionally with other settings; no new analysis.");
  auto arguments = std::make_shared<CheckResultsArguments>();
  command->add_option("RESULTS", arguments->place, "Folder of results, or its results.h5")->required();
  command->add_option("--set", arguments->changes,
                      "A key below 'checks' and its value: checks.safety_class=high; may be repeated");
  command->add_option("-o,--output", arguments->output,
                      "New folder for the results with these checks; default: the checks are only printed");
  command->add_flag("--strict", arguments->strict, kStrictHelp);
  command->callback([arguments, &code] { code = run_check_results(*arguments); });
}

void add_serve(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("serve", "Graphical interface, for a browser on this machine.");
  auto arguments = std::make_shared<ServeArguments>();
  command->add_option("MODEL", arguments->model_file, "Model file (YAML) to open");
  command->add_option("--port", arguments->port, "Port on 127.0.0.1; default: any free port")
      ->check(whole_number(1, 65535));
  command->add_option("--folder", arguments->folder,
                      "Folder of models and runs; default: that of MODEL, or the current one");
  command->add_flag("!--no-browser", arguments->browser, "Only print the address");
  command->callback([arguments, &code] { code = run_serve(*arguments); });
}

void add_schema(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("schema", "Print the JSON Schema of the model file.");
  auto form = std::make_shared<SchemaForm>(SchemaForm::json);
  command->add_flag_callback(
      "--reference", [form] { *form = SchemaForm::reference; }, "Print the reference page (Markdown) instead");
  command->add_flag_callback(
      "--findings", [form] { *form = SchemaForm::findings; }, "Print the page of findings (Markdown) instead");
  command->add_flag_callback(
      "--types", [form] { *form = SchemaForm::types; }, "Print the TypeScript types of results instead");
  command->callback([form, &code] { code = run_schema(*form); });
}

void add_licences(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "licences", "Print the licences of the program and of the packages bundled with page and report.");
  command->callback([&code] { code = run_licences(); });
}

void add_new(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand("new", "Write a ready-to-run model from a few flags (or questions).");
  auto options = std::make_shared<NewOptions>();
  command->add_option("--pipe", options->pipe, "Nominal size in inches (4 to 48) or outside diameter: 16, '406.4 mm'");
  command->add_option("--depth", options->depth, "Water depth: '89 m'");
  command->add_option("--wall", options->wall,
                      "Wall thickness; default: the thinnest of API 5L that passes the checks");
  command->add_option("--yield", options->yield, "Yield stress")->capture_default_str();
  command->add_option("--coating", options->coating, "Thickness of the corrosion coating")->capture_default_str();
  command->add_option("--concrete", options->concrete, "Thickness of the concrete coating; default: none");
  command->add_option("--lay", options->lay, "s: over a stinger; j: directly from a tower")
      ->check(one_of_choices({"s", "j"}))
      ->capture_default_str();
  command->add_option("--vessel", options->vessel, "barge, BGL-1 or ship; default: chosen by depth")
      ->check(one_of_choices({"barge", "BGL-1", "ship"}));
  command->add_option("--stinger-radius", options->stinger_radius,
                      "Stinger radius; default: chosen so that the overbend passes its checks");
  command->add_option("--boxes", options->boxes, "Roller boxes on the stinger; default: one every 5 m")
      ->check(whole_number(1, 100));
  command->add_option("--tension", options->tension,
                      "Top tension; default: chosen so that the sagbend passes its checks");
  command->add_option("--title", options->title, "Title of the report");
  command->add_option("-o,--output", options->output, "File to write; default: standard output");
  command->add_flag("--force", options->force, "Overwrite an existing file");
  command->callback([options, &code] { code = run_new(*options); });
}

void add_import(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "import",
      "Translate an OrcaFlex text data file into a model; prints and writes an account of what was left out.");
  auto arguments = std::make_shared<ImportArguments>();
  command->add_option("FILE", arguments->file, "Text data file of OrcaFlex (.yml)")->required();
  command->add_option("-o,--output", arguments->output, "Model to write; default: the name of the file, with .yaml");
  command->add_option("--yield", arguments->yield_stress,
                      "Yield stress of the steel, which such files seldom have: '450 MPa'");
  command->add_flag("--force", arguments->force, "Overwrite existing files");
  command->add_flag("--strict", arguments->strict,
                    "Exit with code 4 if something was left out that results may depend on");
  command->callback([arguments, &code] { code = run_import(*arguments); });
}

void add_export(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "export", "Write the lay of a model for another program; prints and writes an account of what was left out.");
  auto arguments = std::make_shared<ExportArguments>();
  command->add_option("MODEL", arguments->model_file, "Model file (YAML)")->required();
  command->add_flag("--orcaflex", arguments->as_orcaflex, "As a text data file of OrcaFlex (.yml)")->required();
  command->add_option("-o,--output", arguments->output, "File to write; default: the name of the model, with .yml");
  command->add_flag("--force", arguments->force, "Overwrite existing files");
  command->add_flag("--strict", arguments->strict,
                    "Exit with code 4 if something was left out that results may depend on");
  command->callback([arguments, &code] { code = run_export(*arguments); });
}

int print_completion(const CLI::App& program, const std::string& target) {
  const std::vector<DescribedCommand> commands = described(program);
  std::cout << (target == "bash"  ? bash_completion(commands)
                : target == "zsh" ? zsh_completion(commands)
                                  : manual_page(commands, kVersion));
  return kDone;
}

void add_completion(CLI::App& program, int& code) {
  CLI::App* command = program.add_subcommand(
      "completion", "Print the completion script of a shell (bash, zsh) or the manual page (man).");
  auto target = std::make_shared<std::string>();
  command->add_option("FOR", *target, "Shell, or man for the manual page")
      ->required()
      ->check(one_of_choices({"bash", "zsh", "man"}));
  command->callback([&program, target, &code] { code = print_completion(program, *target); });
}

/// Returns a message for an unknown command, with a suggestion; empty if the first argument is a command or an option.
std::string unknown_command(const CLI::App& program, int count, const char* const* arguments) {
  if (count < 2 || arguments[1][0] == '-' || arguments[1][0] == '\0') return "";
  std::vector<std::string> names;
  for (const DescribedCommand& command : described(program)) names.push_back(command.name);
  if (std::find(names.begin(), names.end(), arguments[1]) != names.end()) return "";
  names.erase(names.begin());  // the program itself
  const std::string near = nearest_word(arguments[1], names);
  return fmt::format("there is no command '{}'; {}", for_display(arguments[1]),
                     near.empty() ? "the commands are " + join_items(names, "and") : "did you mean '" + near + "'?");
}

/// Adds --units to every command that prints results. CLI11 uses the environment variable if the option is not given.
void add_units(CLI::App& program) {
  for (CLI::App* command : program.get_subcommands([](const CLI::App*) { return true; })) {
    if (kWithoutResults.contains(command->get_name())) continue;
    command
        ->add_option_function<std::string>(
            "--units", [](const std::string& word) { use_units(word == "us" ? UnitSystem::us : UnitSystem::metric); },
            "Units of texts, tables and reports: metric, or us for kip, ft, ksi; default: the variable OVERBEND_UNITS")
        ->check(one_of_choices({"metric", "us"}))
        ->envname("OVERBEND_UNITS");
  }
}

}  // namespace

int run_command_line(int count, const char* const* arguments) {
  CLI::App program("Overbend: analysis of offshore pipeline installation.", "overbend");
  int code = kDone;
  program.set_version_flag("--version", std::string("overbend ") + kVersion);
  program.require_subcommand(1);
  add_check(program, code);
  add_static(program, code);
  add_seek(program, code);
  add_dynamic(program, code);
  add_compare(program, code);
  add_study(program, code);
  add_lay_table(program, code);
  add_report(program, code);
  add_check_results(program, code);
  add_new(program, code);
  add_import(program, code);
  add_export(program, code);
  add_serve(program, code);
  add_schema(program, code);
  add_licences(program, code);
  add_completion(program, code);
  add_units(program);
  try {
    best_isa();
  } catch (const std::invalid_argument& error) {  // before anything is computed
    std::cerr << "overbend: " << error.what() << "\n";
    return kWrongInput;
  }
  const std::string wrong = unknown_command(program, count, arguments);
  if (!wrong.empty()) {
    std::cerr << "overbend: " << wrong << "\n";
    return kWrongInput;
  }
  try {
    program.parse(count, arguments);
    if (!std::cout.flush()) throw FileError("the output cannot be written");
    return code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error, std::cout, std::cerr);  // help and version
    std::cerr << option_error_message(program, {arguments + 1, static_cast<std::size_t>(count - 1)}, error) << "\n";
    return kWrongInput;
  } catch (const Interrupted&) {
    std::cerr << "overbend: interrupted\n";
    return kInterrupted;
  } catch (const FileError& error) {
    std::cerr << "overbend: " << error.what() << "\n";
  } catch (const std::exception& error) {
    std::cerr << "overbend: internal error: " << error.what() << "\n";
  }
  return kInternalError;
}

}  // namespace overbend
