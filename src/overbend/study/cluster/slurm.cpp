#include "study/cluster/slurm.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "base/json.h"
#include "base/text.h"
#include "platform/process.h"
#include "runstore/replace_file.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kDefaultMaxArraySize = 1001;  ///< Default of MaxArraySize.
/// Number of tasks aimed at, because each takes a good part of a second to start.
constexpr std::size_t kTasks = 200;

fs::path jobs_file(const fs::path& folder) {
  return folder / "slurm" / "jobs.json";
}

std::optional<std::size_t> parse_task_number(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

/// Returns MaxArraySize of the cluster: the tasks of an array are numbered from 0 to MaxArraySize - 1.
std::size_t max_array_size() {
  const std::optional<ProgramOutput> config = run_program({"scontrol", "show", "config"});
  if (!config || config->code != 0) return kDefaultMaxArraySize;
  std::istringstream lines(config->out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || trim(std::string_view(line).substr(0, equals)) != "MaxArraySize") continue;
    return parse_task_number(trim(std::string_view(line).substr(equals + 1))).value_or(kDefaultMaxArraySize);
  }
  return kDefaultMaxArraySize;
}

void write_jobs(const std::vector<SlurmJob>& jobs, const fs::path& folder) {
  Json list = Json::array();
  for (const SlurmJob& job : jobs) list.push_back({{"id", job.id}, {"count", job.count}, {"tasks", job.tasks}});
  replace_file(jobs_file(folder), json_text({{"jobs", list}}, 1) + "\n");
}

void write_script(const SlurmStudy& study) {
  std::error_code error;
  fs::create_directories(study.folder / "slurm" / "log", error);
  if (error) {
    throw SlurmError("the folder '" + (study.folder / "slurm").string() + "' cannot be created: " + error.message());
  }
  replace_file(study.folder / "slurm" / "job.sh", slurm_script(study));
}

/// Reads the number from "1234" or "1234;cluster".
std::string parse_job_id(const std::string& out) {
  const std::string_view line = trim(std::string_view(out).substr(0, out.find('\n')));
  const std::string_view id = line.substr(0, line.find(';'));
  if (!parse_task_number(id)) throw SlurmError("sbatch returned no job number but '" + for_display(out) + "'");
  return std::string(id);
}

}  // namespace

std::vector<SlurmJob> slurm_jobs(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(jobs_file(folder), error)) return {};
  std::vector<SlurmJob> jobs;
  try {
    const Json read = read_json_file(jobs_file(folder));
    for (const Json& job : read.at("jobs")) {
      jobs.push_back({job.at("id").get<std::string>(), job.at("count").get<std::size_t>(),
                      job.at("tasks").get<std::vector<std::size_t>>()});
    }
  } catch (const Json::exception& damage) {
    throw std::runtime_error("the file '" + jobs_file(folder).string() + "' is damaged: " + damage.what());
  }
  return jobs;
}

SlurmJob submit_to_slurm(const SlurmStudy& study, const SlurmOptions& options, std::size_t cases,
                         const std::vector<std::size_t>& open, const std::vector<std::string>& more) {
  std::vector<SlurmJob> jobs = slurm_jobs(study.folder);
  const std::size_t max_tasks = max_array_size();
  const std::size_t per_task = options.cases_per_task > 0 ? options.cases_per_task : (cases + kTasks - 1) / kTasks;
  SlurmJob job;
  job.count = jobs.empty() ? task_count(cases, per_task, max_tasks) : jobs.back().count;
  job.tasks = find_tasks(open, job.count);
  if (const auto queue = slurm_queue(jobs)) {  // running or waiting tasks are not submitted twice
    std::erase_if(job.tasks, [&](std::size_t task) { return queue->contains(task); });
  }
  if (job.tasks.empty()) throw SlurmError("nothing to submit: every case is finished or in the queue");
  write_script(study);
  const std::optional<ProgramOutput> sent = run_program(sbatch_command(study, options, job.tasks, job.count, more));
  if (!sent || sent->code == 127) throw SlurmError("Slurm is not available: the command sbatch is not on the PATH");
  if (sent->code != 0) throw SlurmError("sbatch rejected the job: " + std::string(trim(sent->err)));
  job.id = parse_job_id(sent->out);
  jobs.push_back(job);
  write_jobs(jobs, study.folder);
  return job;
}

std::optional<std::map<std::size_t, std::string>> slurm_queue(const std::vector<SlurmJob>& jobs) {
  std::map<std::size_t, std::string> states;
  for (const SlurmJob& job : jobs) {
    const auto output = run_program({"squeue", "--noheader", "--array", "--jobs=" + job.id, "--format=%K %T"});
    if (!output) return std::nullopt;
    if (output->code != 0) {
      if (output->err.find("Invalid job id") != std::string::npos) continue;  // finished long ago
      return std::nullopt;
    }
    std::istringstream lines(output->out);
    for (std::string task, state; lines >> task >> state;) {
      if (const auto number = parse_task_number(task); number && state != "COMPLETING") states[*number] = state;
    }
  }
  return states;
}

}  // namespace overbend
