#include "read/child.h"

#include "base/input_files.h"
#include "read/formats.h"
#include "read/manifest.h"
#include "read/protocol.h"
#include "read/reader_process.h"
#include "read/ready_reader.h"
#include "read/sandbox.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <vector>

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
// Memory that the reader's libraries take before they look at a file.
constexpr std::uint64_t kMinMemory = std::uint64_t(64) << 20;
// An index may name many pieces, and each is open for a while.
constexpr rlim_t kMaxOpenFiles = 1 << 16;

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

// The file that the child told of last, of those that the input names.
std::string fileTold(std::string_view errors)
{
	const std::size_t at = errors.rfind(kReadingMark);
	if (at == errors.npos)
		return {};
	const std::string_view rest = errors.substr(at + kReadingMark.size());
	return std::string(rest.substr(0, std::min(rest.find('\n'), kMaxReasonLength)));
}

// Returns true if the limits on memory are the machine's or the caller's. Else they follow from the size of the file,
// and only a damaged one needs more.
// given: to the child in the end.
bool isShortOfMemory(const InputLimits& limits, rlim_t given)
{
	return !limits.follows_size || given < limits.memory;
}

Error outOfMemory(const std::string& file, const std::string& reason, bool is_short)
{
	if (!is_short)
		return {ErrorKind::input,
		        fmt::format("{}: truncated or damaged: it describes more than a file of its size can hold", file)};
	return {ErrorKind::out_of_memory,
	        fmt::format("{}: {}; make room, or raise the limits of this process (ulimit -v, -f)", file, reason)};
}

bool isFromOutside(int signal)
{
	constexpr std::array signals = {SIGKILL, SIGXCPU, SIGTERM, SIGINT, SIGHUP, SIGQUIT};
	return std::ranges::find(signals, signal) != signals.end();
}

Error killed(const std::string& file, int signal, const std::string& where)
{
	const char* remedy = signal == SIGKILL   ? "as the system does when memory runs out; free some and try again"
	                     : signal == SIGXCPU ? "since it used up its processor time; raise that limit (ulimit -t)"
	                                         : "from outside; try again";
	return {ErrorKind::internal,
	        fmt::format("{}: the reader was killed (signal {}){}, {}", file, signal, where, remedy)};
}

// Returns the error that tells the user why the child ended. memory: its address space. target: of convert().
Error explain(const std::string& file, const Reader& reader, bool is_short, rlim_t memory, const std::string& target)
{
	const auto input = [&](const std::string& reason) {
		return Error{ErrorKind::input, fmt::format("{}: {}", file, reason)};
	};
	const std::string line = lastLine(reader.errors);
	const std::string told = fileTold(reader.errors);
	const std::string where = told.empty() ? told : fmt::format(" while it read {}", told);
	const std::string no_memory = fmt::format("there was not enough memory{}", where);
	const auto speaksOfMemory = [&](std::string_view words) { return reader.errors.find(words) != std::string::npos; };
	// Too little even for its libraries, which then fail in ways of their own.
	const bool cannot_start = memory < kMinMemory && told.empty();
	if (WIFSIGNALED(reader.status))
	{
		const int signal = WTERMSIG(reader.status);
		if (cannot_start || speaksOfMemory("std::bad_alloc"))
			return outOfMemory(file, no_memory, is_short);
		if (isFromOutside(signal))
			return killed(file, signal, where);
		return input(fmt::format("the reader crashed (signal {}){}; the file is damaged or not what its ending says",
		                         signal, where));
	}
	const int code = WEXITSTATUS(reader.status);
	if (line.starts_with(kReasonMark) && line.size() > kReasonMark.size())
	{
		const std::string reason = line.substr(kReasonMark.size());
		if (code == kRefusedExitCode)
			return input(reason);
		if (code == kNoMemoryExitCode)
			return outOfMemory(file, reason, is_short);
		if (code == kNoSandboxExitCode)
			return {ErrorKind::internal, fmt::format("{}: {}", file, reason)};
		if (code == kNoRoomExitCode)
			return {ErrorKind::output, fmt::format("{}: {}", target, reason)};
	}
	if (code == 127 &&
	    (cannot_start || speaksOfMemory("Cannot allocate memory") || speaksOfMemory("failed to map segment")))
		return outOfMemory(file, no_memory, true);
	if (code == 127)
		return notStarted(line);
	return input(fmt::format("the reader gave up (exit code {}){}; the file is damaged or not what its ending says",
	                         code, where));
}

// With cell_to_point, an array of points may be one of cells in the file.
std::string wishArgument(const ArrayWish& wish, bool cell_to_point)
{
	constexpr std::string_view kOfPoints = "point:";
	if (wish.all)
		return "*";
	std::string lines = wish.first ? "^" : "";
	for (const std::string& name : wish.names)
		lines += "\n=" + (cell_to_point && name.starts_with(kOfPoints) ? name.substr(kOfPoints.size()) : name);
	return lines;
}

std::string displaceArgument(const ReadOptions& options)
{
	if (options.displace == 0.0)
		return {};
	return fmt::format("{:.17g}{}{}", options.displace, options.displace_by.empty() ? "" : " ", options.displace_by);
}

// As protocol.h has them.
std::vector<std::string> argumentsFor(const std::string& file, const ReadOptions& options, const std::string& sandbox)
{
	std::vector<std::string> arguments = {
	    "vprobe-read",
	    options.all_times ? "all" : timeText(options.time),
	    options.solution,
	    fmt::format("{}", options.refine),
	    displaceArgument(options),
	    options.patches ? "1" : "0",
	    std::to_string(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)),
	    wishArgument(options.arrays, options.cell_to_point),
	    options.format,
	    rawText(options.raw),
	    options.convert_to,
	    options.convert_folder,
	    options.cells_of_part > 0 ? std::to_string(options.cells_of_part) : "",
	    (options.keeps_in_runs ? "places" : "") + options.parts,
	    sandbox,
	    followArgument(options.follow),
	    options.stays_above ? std::to_string(*options.stays_above) : "",
	    options.unpack,
	    std::to_string(options.level),
	    file};
	arguments.insert(arguments.end(), options.slices.begin(), options.slices.end());
	return arguments;
}

rlimit limitOf(std::uint64_t value, int resource)
{
	rlimit limit = {};
	getrlimit(static_cast<__rlimit_resource>(resource), &limit);
	limit.rlim_cur = limit.rlim_max = std::min<rlim_t>(value, limit.rlim_cur);
	return limit;
}

// The child may raise the limit as far as this process may, up to kMaxOpenFiles.
rlimit limitOfFiles()
{
	rlimit limit = {};
	getrlimit(RLIMIT_NOFILE, &limit);
	limit.rlim_max = std::min(limit.rlim_max, kMaxOpenFiles);
	limit.rlim_cur = std::min(limit.rlim_cur, limit.rlim_max);
	return limit;
}

// vprobe-read becomes vprobe-read-more where a file asks for it, and to unpack parts. To start that at once spares the
// time to load the first, a fifth of what a small file takes; it reads all other formats, too.
std::string programFor(const std::string& program, const std::string& file, const ReadOptions& options)
{
	const Format* format = options.format.empty() ? formatOfEnding(file) : findFormat(options.format);
	const bool needs_more = (format && format->in_more) || !options.unpack.empty();
	const std::string more = program + "-more";
	return needs_more && access(more.c_str(), X_OK) == 0 ? more : program;
}

} // namespace

Error stopped(const std::string& input)
{
	return {ErrorKind::cancelled, fmt::format("{}: reading was cancelled", input)};
}

ReaderAtWork::ReaderAtWork(const std::string& file, const ReadOptions& options, const InputLimits& limits)
    : file_(file), options_(options), limits_(limits)
{
}

Result<ReaderAtWork> ReaderAtWork::start(const std::string& file, const ReadOptions& options, const InputLimits& limits,
                                         const Descriptor& requests)
{
	ReaderAtWork reader(file, options, limits);
	if (const Status started = reader.started(requests); !started)
		return started.error();
	return reader;
}

Status ReaderAtWork::started(const Descriptor& requests)
{
	const Result<std::string> found = readerProgram();
	if (!found)
		return found.error();
	const Result<std::string> sandbox = sandboxArgument();
	if (!sandbox)
		return sandbox.error();
	const std::string program = programFor(*found, file_, options_);
	noteInput(file_);
	noteInput(options_.solution);
	for (const std::string& slice : options_.slices)
		noteInput(slice);

	arrays_ = lifted(memfd_create("vprobe-arrays", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	cells_ = lifted(memfd_create("vprobe-cells", MFD_CLOEXEC | MFD_ALLOW_SEALING));
	const Descriptor null = lifted(open("/dev/null", O_RDWR | O_CLOEXEC));
	Pipe manifest = makePipe();
	Pipe errors = makePipe();
	Pipe life = makePipe();
	if (!arrays_ || !cells_ || !null || !manifest.write_end || !errors.write_end || !life.write_end)
		return notStarted(std::strerror(errno));

	std::vector<std::string> arguments = argumentsFor(file_, options_, *sandbox);
	const std::vector<char*> command = pointersTo(arguments);
	std::vector<std::string> variables = readerEnvironment();
	const std::vector<char*> environment = pointersTo(variables);
	ChildSetup setup = {};
	setup.program = program.c_str();
	setup.environment = environment.data();
	setup.arguments = command.data();
	setup.null = null.get();
	setup.requests = requests ? requests.get() : null.get();
	setup.errors = errors.write_end.get();
	setup.arrays = arrays_.get();
	setup.manifest = manifest.write_end.get();
	setup.cells = cells_.get();
	setup.life = life.read_end.get();
	setup.parent = getpid();
	setup.memory = limitOf(limits_.memory, RLIMIT_AS);
	setup.file_size = limitOf(limits_.memory, RLIMIT_FSIZE);
	// A stalled disk shows on the wall clock only; this one ends a child whose parent was stopped.
	setup.time = limitOf(2 * static_cast<std::uint64_t>(limits_.time.count()), RLIMIT_CPU);
	setup.files = limitOfFiles();
	memory_ = setup.memory.rlim_cur;
	file_size_ = setup.file_size.rlim_cur;

	const std::optional<pid_t> copy = options_.ready ? options_.ready->copy(setup) : std::nullopt;
	const pid_t pid = copy ? *copy : fork();
	if (pid < 0)
		return notStarted(std::strerror(errno));
	if (pid == 0)
		becomeReader(setup);
	life_ = std::move(life.write_end);
	reader_ = std::make_unique<Reader>(pid, std::move(manifest.read_end), std::move(errors.read_end), limits_.time);
	return Nothing{};
}

Error ReaderAtWork::notInTime() const
{
	if (options_.stop.stop_requested())
		return stopped(file_);
	const char* reason =
	    reader_->wroteTooMuch() ? "describes more arrays than can be" : "the reader ran over its time limit of {} s";
	return {ErrorKind::input, fmt::format("{}: {}", file_, fmt::format(fmt::runtime(reason), limits_.time.count()))};
}

Status ReaderAtWork::answer(std::span<std::byte> to)
{
	reader_->startAnew(limits_.time);
	const Reader::Answer answer = reader_->answer(to, options_.stop);
	if (answer == Reader::Answer::late)
		return notInTime();
	if (answer == Reader::Answer::ended)
		return explain(file_, *reader_, isShortOfMemory(limits_, std::min(memory_, file_size_)), memory_, {});
	return Nothing{};
}

Result<HandedOver> ReaderAtWork::finish()
{
	reader_->startAnew(limits_.time); // it may have waited for us before
	if (!reader_->finish(options_.stop))
		return notInTime();
	if (!WIFEXITED(reader_->status) || WEXITSTATUS(reader_->status) != 0)
		return explain(file_, *reader_, isShortOfMemory(limits_, std::min(memory_, file_size_)), memory_,
		               options_.convert_to);
	HandedOver handed{std::move(reader_->manifest), mapSealed(arrays_), mapSealed(cells_)};
	if (!handed.arrays.owner || !handed.cells.owner)
		return outOfMemory(file_, fmt::format("its arrays cannot be mapped ({})", std::strerror(errno)), true);
	return handed;
}

Result<HandedOver> runReader(const std::string& file, const ReadOptions& options, const InputLimits& limits)
{
	Result<ReaderAtWork> reader = ReaderAtWork::start(file, options, limits);
	if (!reader)
		return reader.error();
	return reader->finish();
}

} // namespace vp::read
