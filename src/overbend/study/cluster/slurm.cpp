#include "study/cluster/slurm.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>

#include "base/json.h"
#include "base/text.h"
#include "runstore/replace_file.h"
#include "study/cluster/run_program.h"

namespace overbend {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestArray = 1001;  ///< MaxArraySize where the cluster does not say.
/// A task takes a good part of a second to begin, whatever it does.
constexpr std::size_t kTasks = 200;

fs::path jobs_file(const fs::path& folder) {
  return folder / "slurm" / "jobs.json";
}

std::optional<std::size_t> number_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || text.empty()) return std::nullopt;
  return value;
}

/// Numbers of an array's tasks run from 0 to MaxArraySize - 1.
std::size_t largest_array() {
  const std::optional<ProgramOutput> config = run_program({"scontrol", "show", "config"});
  if (!config || config->code != 0) return kLargestArray;
  std::istringstream lines(config->out);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos || trim(std::string_view(line).substr(0, equals)) != "MaxArraySize") continue;
    return number_of(trim(std::string_view(line).substr(equals + 1))).value_or(kLargestArray);
  }
  return kLargestArray;
}

void remember(const std::vector<SlurmJob>& jobs, const fs::path& folder) {
  Json list = Json::array();
  for (const SlurmJob& job : jobs) list.push_back({{"id", job.id}, {"count", job.count}, {"tasks", job.tasks}});
  replace_file(jobs_file(folder), json_text({{"jobs", list}}, 1) + "\n");
}

void write_script(const SlurmStudy& study) {
  std::error_code fault;
  fs::create_directories(study.folder / "slurm" / "log", fault);
  if (fault) throw SlurmFault("the folder '" + (study.folder / "slurm").string() + "' cannot be: " + fault.message());
  replace_file(study.folder / "slurm" / "job.sh", slurm_script(study));
}

/// "1234" or "1234;cluster".
std::string id_of(const std::string& out) {
  const std::string_view line = trim(std::string_view(out).substr(0, out.find('\n')));
  const std::string_view id = line.substr(0, line.find(';'));
  if (!number_of(id)) throw SlurmFault("sbatch gave no job number but '" + for_display(out) + "'");
  return std::string(id);
}

}  // namespace

std::vector<SlurmJob> slurm_jobs(const fs::path& folder) {
  std::error_code fault;
  if (!fs::exists(jobs_file(folder), fault)) return {};
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
  const std::size_t largest = largest_array();
  const std::size_t per_task = options.cases_per_task > 0 ? options.cases_per_task : (cases + kTasks - 1) / kTasks;
  SlurmJob job;
  job.count = jobs.empty() ? task_count(cases, per_task, largest) : jobs.back().count;
  job.tasks = tasks_of(open, job.count);
  if (const auto queue = slurm_queue(jobs)) {  // what is at work or waits is not submitted twice
    std::erase_if(job.tasks, [&](std::size_t task) { return queue->contains(task); });
  }
  if (job.tasks.empty()) throw SlurmFault("nothing to submit: every case is finished or in the queue");
  write_script(study);
  const std::optional<ProgramOutput> sent = run_program(sbatch_words(study, options, job.tasks, job.count, more));
  if (!sent || sent->code == 127) throw SlurmFault("there is no Slurm here: the command sbatch is not on the PATH");
  if (sent->code != 0) throw SlurmFault("sbatch refused the job: " + std::string(trim(sent->err)));
  job.id = id_of(sent->out);
  jobs.push_back(job);
  remember(jobs, study.folder);
  return job;
}

std::optional<std::map<std::size_t, std::string>> slurm_queue(const std::vector<SlurmJob>& jobs) {
  std::map<std::size_t, std::string> states;
  for (const SlurmJob& job : jobs) {
    const auto told = run_program({"squeue", "--noheader", "--array", "--jobs=" + job.id, "--format=%K %T"});
    if (!told) return std::nullopt;
    if (told->code != 0) {
      if (told->err.find("Invalid job id") != std::string::npos) continue;  // long over
      return std::nullopt;
    }
    std::istringstream lines(told->out);
    for (std::string task, state; lines >> task >> state;) {
      if (const auto number = number_of(task); number && state != "COMPLETING") states[*number] = state;
    }
  }
  return states;
}

}  // namespace overbend
