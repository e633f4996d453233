#include "process.h"

#include "patience.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace view
{

namespace
{

constexpr double kSecondsToEnd = 5.0;

void redirect(int descriptor, const std::string& file, int flags)
{
	const int opened = open(file.c_str(), flags | O_CLOEXEC, 0666);
	if (opened < 0 || dup2(opened, descriptor) < 0)
		_exit(99);
}

[[noreturn]] void become(const std::vector<std::string>& command, const Process::Setting& setting)
{
	prctl(PR_SET_PDEATHSIG, SIGKILL);
	redirect(STDIN_FILENO, setting.in, O_RDONLY);
	redirect(STDOUT_FILENO, setting.out, O_WRONLY | O_CREAT | O_TRUNC);
	redirect(STDERR_FILENO, setting.err, O_WRONLY | O_CREAT | O_TRUNC);
	for (const auto& [name, value] : setting.environment)
		setenv(name.c_str(), value.c_str(), 1);
	if (setting.kept >= 0)
		fcntl(setting.kept, F_SETFD, 0);
	std::vector<char*> argv;
	for (const std::string& word : command)
		argv.push_back(const_cast<char*>(word.c_str()));
	argv.push_back(nullptr);
	execvp(argv[0], argv.data());
	_exit(98);
}

} // namespace

Process::Process(const std::vector<std::string>& command, const Setting& setting)
{
	process_ = fork();
	if (process_ < 0)
		throw std::runtime_error("no fork");
	if (process_ == 0)
		become(command, setting);
}

Process::~Process()
{
	if (!runs())
		return;
	interrupt(SIGTERM);
	if (waitFor(kSecondsToEnd))
		return;
	interrupt(SIGKILL);
	waitFor(kSecondsToEnd);
}

bool Process::runs()
{
	int status = 0;
	if (!status_ && waitpid(process_, &status, WNOHANG) == process_)
		status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
	return !status_;
}

std::optional<int> Process::waitFor(double seconds)
{
	eventually([this] { return !runs(); }, seconds);
	return status_;
}

void Process::interrupt(int signal) const
{
	if (!status_)
		kill(process_, signal);
}

std::size_t Process::residentBytes() const
{
	std::ifstream file("/proc/" + std::to_string(process_) + "/statm");
	std::size_t all = 0;
	std::size_t resident = 0;
	file >> all >> resident;
	return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

bool isInstalled(const std::string& program)
{
	const char* path = std::getenv("PATH");
	std::istringstream folders(path ? path : "");
	for (std::string folder; std::getline(folders, folder, ':');)
		if (access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0)
			return true;
	return false;
}

} // namespace view
