#include "program.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace cli
{

namespace
{

// A run that takes longer hangs.
constexpr unsigned kSecondsToLive = 120;

std::filesystem::path makeFolder()
{
	std::string name = testing::TempDir() + "vprobe-cli-XXXXXX";
	if (!mkdtemp(name.data()))
		throw std::runtime_error("no temporary folder: " + name);
	return name;
}

void redirect(int descriptor, const std::string& file)
{
	const int opened = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
	if (opened < 0 || dup2(opened, descriptor) < 0)
		_exit(99);
	close(opened);
}

[[noreturn]] void becomeProgram(const Arguments& arguments, const Surroundings& surroundings, const std::string& out,
                                const std::string& err)
{
	const int input = open(surroundings.standard_input.c_str(), O_RDONLY);
	dup2(input, STDIN_FILENO);
	redirect(STDOUT_FILENO, out);
	redirect(STDERR_FILENO, surroundings.standard_error.empty() ? err : surroundings.standard_error);
	for (const int stream : surroundings.closed)
		close(stream);
	for (const auto& [name, value] : surroundings.environment)
		setenv(name.c_str(), value.c_str(), 1);
	if (surroundings.file_size_limit)
	{
		std::signal(SIGXFSZ, SIG_IGN); // writes fail instead
		const rlim_t limit = static_cast<rlim_t>(surroundings.file_size_limit);
		const rlimit limits{limit, limit};
		setrlimit(RLIMIT_FSIZE, &limits);
	}
	if (surroundings.memory_limit)
	{
		const rlim_t limit = static_cast<rlim_t>(surroundings.memory_limit);
		const rlimit limits{limit, limit};
		setrlimit(RLIMIT_AS, &limits);
	}
	if (!surroundings.folder.empty() && chdir(surroundings.folder.c_str()) != 0)
		_exit(97);
	alarm(kSecondsToLive);
	std::vector<char*> argv{const_cast<char*>("vprobe")};
	for (const std::string& argument : arguments)
		argv.push_back(const_cast<char*>(argument.c_str()));
	argv.push_back(nullptr);
	const char* other = std::getenv("VPROBE_PROGRAM"); // tests/same has a program of its own run
	execv(other ? other : VPROBE_PROGRAM, argv.data());
	_exit(98);
}

bool isOneLine(const std::string& text)
{
	return text.size() > 1 && text.back() == '\n' && std::count(text.begin(), text.end(), '\n') == 1;
}

testing::AssertionResult judge(const Outcome& outcome, const std::string& wanted, bool good)
{
	if (good)
		return testing::AssertionSuccess();
	return testing::AssertionFailure() << "wanted " << wanted << "; got status " << outcome.status
	                                   << "\nstandard error:\n"
	                                   << outcome.err << "\nstandard output, " << outcome.out.size() << " bytes:\n"
	                                   << outcome.out.substr(0, 400);
}

std::string describe(const std::string& wanted, const std::vector<std::string>& words)
{
	std::string text = wanted;
	for (const std::string& word : words)
		text += " \"" + word + "\"";
	return text;
}

bool holdsAll(const std::string& text, const std::vector<std::string>& words)
{
	return std::all_of(words.begin(), words.end(), [&](const std::string& word) { return contains(text, word); });
}

} // namespace

Program::Program() : folder_(makeFolder()), caught_(makeFolder()) {}

Program::~Program()
{
	std::error_code ignored;
	std::filesystem::remove_all(folder_, ignored);
	std::filesystem::remove_all(caught_, ignored);
}

int Program::start(const Arguments& arguments, const Surroundings& surroundings) const
{
	const std::string out =
	    surroundings.standard_output.empty() ? (caught_ / "out").string() : surroundings.standard_output;
	const std::string err = caught_ / "err";
	const pid_t child = fork();
	if (child < 0)
		throw std::runtime_error("no fork");
	if (child == 0)
		becomeProgram(arguments, surroundings, out, err);
	return child;
}

Outcome Program::outcomeOf(int process, const Surroundings& surroundings) const
{
	int status = 0;
	waitpid(process, &status, 0);
	Outcome outcome;
	outcome.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
	if (surroundings.standard_output.empty())
		outcome.out = contents(caught_ / "out");
	if (surroundings.standard_error.empty())
		outcome.err = contents(caught_ / "err");
	return outcome;
}

Outcome Program::run(const Arguments& arguments, const Surroundings& surroundings) const
{
	return outcomeOf(start(arguments, surroundings), surroundings);
}

Outcome Program::interrupted(const Arguments& arguments, const std::function<bool()>& ripe) const
{
	const int process = start(arguments, {});
	siginfo_t ended{};
	while (!ripe() && waitid(P_PID, static_cast<id_t>(process), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
	       ended.si_pid == 0)
		usleep(1000);
	kill(process, SIGINT);
	return outcomeOf(process, {});
}

nlohmann::json Program::stats(const Arguments& inputs_and_probe) const
{
	const Outcome outcome = run(Arguments{"slice"} + inputs_and_probe + Arguments{"--classify", "cpu", "--stats", "-"});
	EXPECT_EQ(outcome.status, 0) << outcome.err;
	nlohmann::json json = outcome.json();
	EXPECT_TRUE(json.is_object()) << outcome.out;
	return json;
}

std::string Program::write(const std::string& name, const std::string& contents) const
{
	std::ofstream(path(name), std::ios::binary) << contents;
	return path(name);
}

std::vector<std::string> Program::files() const
{
	std::vector<std::string> names;
	for (const auto& entry : std::filesystem::directory_iterator(folder_))
		names.push_back(entry.path().filename());
	std::sort(names.begin(), names.end());
	return names;
}

void Drawing::SetUp()
{
	const Outcome outcome = run({"slice", "demo:shell:4", "--classify", "gpu", "--stats", "-"});
	if (outcome.status == 3)
		GTEST_SKIP() << outcome.err;
}

PictureSize sizeOf(const std::string& png)
{
	const std::string end("IEND\xAE\x42\x60\x82", 8);
	if (png.size() < 24 || png.compare(0, 8, "\x89PNG\r\n\x1a\n") != 0 || !png.ends_with(end))
		return {};
	const auto number = [&](std::size_t at)
	{
		std::uint32_t value = 0;
		for (std::size_t i = at; i < at + 4; ++i)
			value = value << 8 | static_cast<unsigned char>(png[i]);
		return value;
	};
	return {number(16), number(20)};
}

std::string contents(const std::string& path)
{
	std::ostringstream text;
	text << std::ifstream(path, std::ios::binary).rdbuf();
	return text.str();
}

bool contains(const std::string& text, const std::string& part)
{
	return text.find(part) != std::string::npos;
}

testing::AssertionResult isError(const Outcome& outcome, int status, const std::vector<std::string>& words)
{
	const bool good =
	    outcome.status == status && outcome.out.empty() && isOneLine(outcome.err) && holdsAll(outcome.err, words);
	return judge(outcome, describe("status " + std::to_string(status) + " and one line with", words), good);
}

testing::AssertionResult isQuiet(const Outcome& outcome)
{
	return judge(outcome, "status 0 and silence on standard error", outcome.status == 0 && outcome.err.empty());
}

testing::AssertionResult isDoneWithAWord(const Outcome& outcome, const std::vector<std::string>& words)
{
	const bool good = outcome.status == 0 && isOneLine(outcome.err) && holdsAll(outcome.err, words);
	return judge(outcome, describe("status 0 and one line with", words), good);
}

Arguments operator+(Arguments a, const Arguments& b)
{
	a.insert(a.end(), b.begin(), b.end());
	return a;
}

Surroundings noDevice()
{
	return {.environment = {{"VK_DRIVER_FILES", "/nonexistent"}, {"VK_ICD_FILENAMES", "/nonexistent"}}};
}

} // namespace cli
