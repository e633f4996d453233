#include "viewer/script.h"

#include "base/input_files.h"
#include "report/console.h"
#include "view/state_file.h"
#include "write/png.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <iomanip>
#include <sstream>

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::app
{

namespace
{

// A window manager may take its time, and may refuse.
constexpr std::chrono::seconds kPatience{5};

// Splits a line at spaces. Quotation marks hold a word with spaces together.
std::vector<std::string> wordsOf(const std::string& line)
{
	std::istringstream text(line);
	std::vector<std::string> words;
	for (std::string word; text >> std::quoted(word);)
		words.push_back(std::move(word));
	return words;
}

Error unfit(const std::string& reason)
{
	return {ErrorKind::usage, reason + "; see docs/VIEWER.md, Scripting"};
}

std::optional<int> numberOf(const std::string& word)
{
	std::istringstream text(word);
	int number = 0;
	return text >> number && text.eof() ? std::optional(number) : std::nullopt;
}

} // namespace

Result<std::shared_ptr<std::FILE>> Script::open(const std::string& file)
{
	noteInput(file);
	struct stat kind = {};
	// A FIFO that is opened for writing too never ends, so several writers may come and go.
	const bool pipe = file != "-" && stat(file.c_str(), &kind) == 0 && S_ISFIFO(kind.st_mode);
	std::FILE* opened = file == "-" ? fdopen(dup(STDIN_FILENO), "r") : std::fopen(file.c_str(), pipe ? "r+e" : "re");
	if (!opened)
		return Error{ErrorKind::input, fmt::format("--commands {}: cannot be read ({}); name a file, a FIFO, or - for "
		                                           "standard input",
		                                           file, std::strerror(errno))};
	return std::shared_ptr<std::FILE>(opened, std::fclose);
}

Script::Script(std::shared_ptr<std::FILE> file, std::function<void()> wake)
    : file_(std::move(file)), ends_(eventfd(0, EFD_CLOEXEC)), wake_(std::move(wake)),
      told_(std::chrono::steady_clock::now()), thread_([this] { read(); })
{
}

Script::~Script()
{
	eventfd_write(ends_, 1);
	thread_.join();
	close(ends_);
}

void Script::read()
{
	nameThreadRow("commands");
	const int descriptor = fileno(file_.get());
	std::array<pollfd, 2> sources{pollfd{descriptor, POLLIN, 0}, pollfd{ends_, POLLIN, 0}};
	std::array<char, 4096> bytes;
	std::string line;
	while (poll(sources.data(), sources.size(), -1) >= 0 || errno == EINTR)
	{
		if (sources[1].revents)
			return;
		const ssize_t count = ::read(descriptor, bytes.data(), bytes.size());
		if (count < 0 && errno == EINTR)
			continue;
		if (count <= 0)
			break;
		take({bytes.data(), static_cast<std::size_t>(count)}, line);
	}
	if (!line.empty())
		take("\n", line); // the last line of a file need not end with a line break
}

void Script::take(std::string_view bytes, std::string& line)
{
	{
		const std::lock_guard lock(mutex_);
		for (const char byte : bytes)
			if (byte == '\n')
				lines_.push_back(std::exchange(line, {}));
			else
				line += byte;
	}
	wake_();
}

std::optional<std::string> Script::next()
{
	const std::lock_guard lock(mutex_);
	if (lines_.empty())
		return std::nullopt;
	std::string line = std::move(lines_.front());
	lines_.pop_front();
	return line;
}

bool Script::run(const Stage& stage)
{
	tellErrors(stage.document);
	if (isWaiting(stage))
		return true;
	bool busy = false;
	// The condition to wait for is checked in a later round, so that input from before the command counts too.
	while (!waiting_ && !stage.document.wantsToQuit())
	{
		const std::optional<std::string> line = next();
		if (!line)
			break;
		busy = true;
		if (Status done = carryOut(*line, stage); !done)
			printLine(fmt::format("--commands: {}: {}", *line, done.error().message));
		tellErrors(stage.document);
	}
	return busy;
}

bool Script::isWaiting(const Stage& stage)
{
	if (!waiting_)
		return false;
	if (waiting_->done(stage))
		waiting_.reset();
	else if (waiting_->until && std::chrono::steady_clock::now() > *waiting_->until)
	{
		printLine(fmt::format("--commands: {}", waiting_->failure));
		waiting_.reset();
	}
	return waiting_.has_value();
}

// A command may fail later, as loading does. The window shows that in a notice, which a script cannot read.
void Script::tellErrors(const Document& document)
{
	Moment newest = told_;
	for (const Notice& notice : document.notices())
		if (notice.is_error && notice.since > told_)
		{
			printLine(notice.words);
			newest = std::max(newest, notice.since);
		}
	told_ = newest;
}

Status Script::carryOut(const std::string& line, const Stage& stage)
{
	const Words words = wordsOf(line);
	return words.empty() || words[0].starts_with('#') ? Nothing{} : act(words, stage);
}

Status Script::act(const Words& words, const Stage& stage)
{
	const std::string& name = words[0];
	const Words rest(words.begin() + 1, words.end());
	const auto has = [&](const char* wanted, std::size_t count) { return name == wanted && rest.size() == count; };
	if (name == "open" && !rest.empty())
		return stage.document.open(rest), Nothing{};
	if (name == "drop" && !rest.empty())
		return stage.window.drop(rest), Nothing{};
	if (has("do", 1))
	{
		const auto action = interact::actionNamed(rest[0]);
		if (!action)
			return Error{ErrorKind::usage, "no such action; vprobe view --list-bindings names them"};
		return stage.document.perform(*action), Nothing{};
	}
	if (has("set", 2))
		return stage.document.set(rest[0], rest[1]);
	if (has("save-state", 1))
		return saveState(rest[0], stage);
	if (has("save-picture", 3))
		return savePicture(rest, stage);
	if (has("save-film", 1))
		return stage.document.playback().saveFilm(rest[0]), Nothing{};
	if (has("save-slice", 1))
		return stage.document.saveSlice(rest[0]), Nothing{};
	if (has("save-color-map", 1))
		return stage.document.saveColorMap(rest[0]), Nothing{};
	if (has("save-trace", 1))
		return stage.document.saveTrace(rest[0]), Nothing{};
	if (has("screenshot", 1))
		return capture(rest[0], stage);
	if (has("size", 2))
		return resize(rest, stage);
	if (has("wait", 0))
		waitForPicture(stage);
	else if (has("minimise", 0))
	{
		stage.window.minimize();
		waitFor([](const Stage& now) { return now.window.minimized(); }, "minimise: the window stayed as it was");
	}
	else if (has("restore", 0))
	{
		stage.window.restore();
		waitFor([](const Stage& now) { return !now.window.minimized(); }, "restore: the window stayed as it was");
	}
	else if (has("quit", 0))
		stage.document.quit();
	else
		return unfit("no such command, or not with so many words");
	return Nothing{};
}

// If a frame of the window changes something, such as the size of the scene, only the next frame requests a picture of
// it.
void Script::waitForPicture(const Stage& stage)
{
	constexpr std::uint64_t kFrames = 2;
	const auto done = [enough = stage.frames + kFrames](const Stage& now)
	{ return now.document.isIdle() && (now.window.minimized() || (now.shows_newest && now.frames >= enough)); };
	waiting_ = Waiting{done, {}, {}};
}

Status Script::saveState(const std::string& file, const Stage& stage) const
{
	return view::saveState(stage.document.state(), file);
}

Status Script::capture(const std::string& file, const Stage& stage)
{
	if (stage.window.minimized())
		return Error{ErrorKind::usage, "nothing is seen of a minimised window; restore comes first"};
	captures_ = true;
	stage.screen.capture(
	    [this, file](const render::Picture& picture)
	    {
		    captures_ = false;
		    if (Status written = write::writePng(picture, file); !written)
			    printLine(fmt::format("--commands: screenshot: {}", written.error().message));
	    });
	waiting_ = Waiting{[this](const Stage&) { return !captures_; }, {}, {}};
	return Nothing{};
}

Status Script::savePicture(const Words& words, const Stage& stage)
{
	const auto width = numberOf(words[0]);
	const auto height = numberOf(words[1]);
	constexpr int kMax = static_cast<int>(render::kMaxPictureSize);
	if (!width || !height || *width < 1 || *height < 1 || *width > kMax || *height > kMax)
		return unfit("needs a width and a height in pixels, and a file's name");
	stage.document.savePicture(words[2], static_cast<std::uint32_t>(*width), static_cast<std::uint32_t>(*height));
	return Nothing{};
}

Status Script::resize(const Words& words, const Stage& stage)
{
	const auto width = numberOf(words[0]);
	const auto height = numberOf(words[1]);
	if (!width || !height || *width < 1 || *height < 1)
		return unfit("needs a width and a height in pixels");
	stage.window.resize(*width, *height);
	waitFor([width = static_cast<std::uint32_t>(*width), height = static_cast<std::uint32_t>(*height)](const Stage& now)
	        { return now.window.pixels().width == width && now.window.pixels().height == height; },
	        fmt::format("size {} {}: the desktop gave the window another size", *width, *height));
	return Nothing{};
}

void Script::waitFor(std::function<bool(const Stage&)> done, std::string failure)
{
	waiting_ = Waiting{std::move(done), std::chrono::steady_clock::now() + kPatience, std::move(failure)};
}

} // namespace vp::app
