#include "read/child.h"

#include "read/protocol.h"
#include "read/reader_process.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace vp::read
{

namespace
{

constexpr std::size_t kMaxReasonLength = 300;

std::string lastLine(std::string_view text)
{
	while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())))
		text.remove_suffix(1);
	if (const auto line_end = text.rfind('\n'); line_end != text.npos)
		text.remove_prefix(line_end + 1);
	std::string line(text.substr(0, kMaxReasonLength + kReasonMark.size()));
	std::replace_if(
	    line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
	return line;
}

Error notStarted(const std::string& why)
{
	return {ErrorKind::internal, fmt::format("vprobe-read cannot be started: {}", why)};
}

// What the child's end means for the user.
Error explain(const std::string& file, const Reader& reader, const InputLimits& limits)
{
	const auto input = [&](const std::string& reason) {
		return Error{ErrorKind::input, fmt::format("{}: {}", file, reason)};
	};
	const std::string line = lastLine(reader.errors);
	if (WIFSIGNALED(reader.status))
	{
		const int signal = WTERMSIG(reader.status);
		if (signal == SIGXCPU)
			return input(fmt::format("the reader ran over its time limit of {} s", limits.time.count()));
		return input(
		    fmt::format("the reader crashed (signal {}); the file is damaged or not what its ending says", signal));
	}
	const int code = WEXITSTATUS(reader.status);
	if (code == kRefusedExitCode && line.starts_with(kReasonMark) && line.size() > kReasonMark.size())
		return input(line.substr(kReasonMark.size()));
	if (code == 127)
		return notStarted(line);
	return input(
	    fmt::format("the reader gave up (exit code {}); the file is damaged or not what its ending says", code));
}

std::string wishArgument(const ArrayWish& wish)
{
	if (wish.all)
		return "*";
	std::string lines = wish.first ? "^" : "";
	for (const std::string& name : wish.names)
		lines += "\n=" + name;
	return lines;
}

rlimit limitOf(std::uint64_t value, int resource)
{
	rlimit limit = {};
	getrlimit(static_cast<__rlimit_resource>(resource), &limit);
	limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(value, limit.rlim_max);
	return limit;
}

} // namespace

Error stopped(const std::string& input)
{
	return {ErrorKind::cancelled, fmt::format("{}: reading was cancelled", input)};
}

Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits)
{
	const Result<std::string> program = readerProgram();
	if (!program)
		return program.error();

	const Descriptor arrays = lifted(memfd_create("vprobe-arrays", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	const Descriptor cells = lifted(memfd_create("vprobe-cells", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	const Descriptor null = lifted(open("/dev/null", O_RDWR | O_CLOEXEC));
	Pipe manifest = makePipe();
	Pipe errors = makePipe();
	if (!arrays || !cells || !null || !manifest.write_end || !errors.write_end)
		return notStarted(std::strerror(errno));

	std::string name = "vprobe-read";
	std::string time = timeText(options.time);
	std::string solution = options.solution;
	std::string refine = fmt::format("{}", options.refine);
	std::string path = file;
	std::string format = options.format;
	std::string target = options.convert_to;
	std::string beside = options.convert_beside;
	std::string raw = rawText(options.raw);
	std::string displace = fmt::format("{:.17g}", options.displace);
	ChildSetup setup = {};
	setup.program = program->c_str();
	std::string patches = options.patches ? "1" : "0";
	std::string threads =
	    std::to_string(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
	std::string wish = wishArgument(options.arrays);
	std::string parts = options.parts;
	setup.arguments = {name.data(),    time.data(),    solution.data(), refine.data(), displace.data(),
	                   patches.data(), threads.data(), wish.data(),     format.data(), raw.data(),
	                   target.data(),  beside.data(),  parts.data(),    path.data(),   nullptr};
	setup.null = null.get();
	setup.errors = errors.write_end.get();
	setup.arrays = arrays.get();
	setup.manifest = manifest.write_end.get();
	setup.cells = cells.get();
	setup.parent = getpid();
	setup.memory = limitOf(limits.memory, RLIMIT_AS);
	// A stalled disk shows on the wall clock only; this one ends a child whose parent was stopped.
	setup.time = limitOf(2 * static_cast<std::uint64_t>(limits.time.count()), RLIMIT_CPU);

	const auto deadline = std::chrono::steady_clock::now() + limits.time;
	const pid_t pid = fork();
	if (pid < 0)
		return notStarted(std::strerror(errno));
	if (pid == 0)
		becomeReader(setup);

	Reader reader(pid, std::move(manifest.read_end), std::move(errors.read_end));
	manifest.write_end.reset();
	errors.write_end.reset();
	if (!reader.finish(deadline, options.stop))
	{
		if (options.stop.stop_requested())
			return stopped(file);
		const char* reason =
		    reader.wroteTooMuch() ? "describes more arrays than can be" : "the reader ran over its time limit of {} s";
		return Error{ErrorKind::input,
		             fmt::format("{}: {}", file, fmt::format(fmt::runtime(reason), limits.time.count()))};
	}
	if (!WIFEXITED(reader.status) || WEXITSTATUS(reader.status) != 0)
		return explain(file, reader, limits);

	HandedOver handed{std::move(reader.manifest), mapSealed(arrays), mapSealed(cells)};
	if (!handed.arrays.owner || !handed.cells.owner)
		return Error{ErrorKind::input,
		             fmt::format("{}: the reader's arrays cannot be mapped: {}", file, std::strerror(errno))};
	return handed;
}

} // namespace vp::read
