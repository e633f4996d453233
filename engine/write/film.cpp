#include "write/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace vp::write
{

namespace
{

constexpr int kFilmDescriptor = 3; // in ffmpeg: the first after the standard ones

struct Kind
{
	std::string_view ending;
	const char* format;               // ffmpeg's name for it
	std::vector<const char*> options; // options of the codec
};

const std::vector<Kind>& kinds()
{
	// Most players take 4:2:0 only, which needs even sides.
	static const char* const even = "pad=ceil(iw/2)*2:ceil(ih/2)*2";
	static const char* const palette = "split[a][b];[a]palettegen[p];[b][p]paletteuse";
	static const std::vector<Kind> all = {
	    {".mp4",
	     "mp4",
	     {"-vf", even, "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p", "-movflags", "+faststart"}},
	    {".mkv", "matroska", {"-vf", even, "-c:v", "libx264", "-crf", "18", "-pix_fmt", "yuv420p"}},
	    {".webm", "webm", {"-vf", even, "-c:v", "libvpx-vp9", "-crf", "24", "-b:v", "0", "-pix_fmt", "yuv420p"}},
	    {".gif", "gif", {"-vf", palette, "-loop", "0"}}};
	return all;
}

const Kind* kindOf(std::string_view path)
{
	const auto at = std::ranges::find_if(kinds(), [&](const Kind& kind) { return path.ends_with(kind.ending); });
	return at == kinds().end() ? nullptr : &*at;
}

Error noFfmpeg(const std::string& path)
{
	return {ErrorKind::output, fmt::format("{}: films need the program ffmpeg, which is not installed; install it, or "
	                                       "write pictures: -o frames/{{frame:04}}.png",
	                                       path)};
}

} // namespace

bool isFilm(std::string_view path)
{
	return kindOf(path) != nullptr;
}

Result<Film> Film::create(const std::string& path, std::uint32_t width, std::uint32_t height, double per_second)
{
	Result<AtomicFile> file = AtomicFile::create(path);
	if (!file)
		return file.error();
	Film film(std::move(*file));
	film.path_ = path;
	// ffmpeg gets the file opened: by its name it would make it anew after Ctrl-C has removed it.
	const std::string& beside = film.file_.beside();
	const int opened = beside.empty() ? -1 : open(beside.c_str(), O_RDWR | O_CLOEXEC);
	const std::string target = opened < 0 ? path : fmt::format("/proc/self/fd/{}", kFilmDescriptor);
	const std::string size = fmt::format("{}x{}", width, height);
	const std::string rate = fmt::format("{}", per_second);
	const Kind& kind = *kindOf(path);
	std::vector<const char*> words{"ffmpeg", "-y", "-loglevel",  "error",      "-f",         "rawvideo", "-pix_fmt",
	                               "rgba",   "-s", size.c_str(), "-framerate", rate.c_str(), "-i",       "-"};
	words.insert(words.end(), kind.options.begin(), kind.options.end());
	words.insert(words.end(), {"-f", kind.format, target.c_str(), nullptr});

	std::array<int, 2> ends;
	// A socket, not a pipe: send() can do without the signal of an end that ffmpeg closed, whatever the caller's
	// program does with signals.
	if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
		return Error{ErrorKind::output, fmt::format("{}: ffmpeg cannot be connected; close other programs", path)};
	film.frames_ = ends[1];
	film.said_ = memfd_create("ffmpeg", MFD_CLOEXEC);
	posix_spawn_file_actions_t actions;
	posix_spawn_file_actions_init(&actions);
	posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
	posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
	posix_spawn_file_actions_adddup2(&actions, film.said_, STDERR_FILENO);
	if (opened >= 0)
		posix_spawn_file_actions_adddup2(&actions, opened, kFilmDescriptor);
	const int failed =
	    posix_spawnp(&film.process_, "ffmpeg", &actions, nullptr, const_cast<char* const*>(words.data()), environ);
	posix_spawn_file_actions_destroy(&actions);
	close(ends[0]);
	if (opened >= 0)
		close(opened);
	if (failed != 0)
	{
		film.process_ = -1;
		return noFfmpeg(path);
	}
	return film;
}

Film::Film(Film&& other) noexcept
    : path_(std::move(other.path_)), file_(std::move(other.file_)), frames_(std::exchange(other.frames_, -1)),
      said_(std::exchange(other.said_, -1)), process_(std::exchange(other.process_, -1))
{
}

Film::~Film()
{
	if (process_ > 0)
		kill(process_, SIGKILL);
	wait();
	if (said_ >= 0)
		close(said_);
}

bool Film::wait()
{
	if (frames_ >= 0)
		close(std::exchange(frames_, -1));
	if (process_ <= 0)
		return false;
	int status = 0;
	while (waitpid(process_, &status, 0) < 0 && errno == EINTR)
		;
	process_ = -1;
	return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

Error Film::failure() const
{
	std::string said(512, '\0');
	const ssize_t bytes = pread(said_, said.data(), said.size(), 0);
	said.resize(bytes > 0 ? static_cast<std::size_t>(bytes) : 0);
	said = said.substr(0, said.find('\n'));
	return {ErrorKind::output, fmt::format("{}: ffmpeg failed: {}; write pictures instead: -o frames/{{frame:04}}.png",
	                                       path_, said.empty() ? "it gave no reason" : said)};
}

Status Film::add(const render::Picture& picture)
{
	for (std::size_t done = 0; done < picture.rgba.size();)
	{
		const ssize_t bytes = ::send(frames_, picture.rgba.data() + done, picture.rgba.size() - done, MSG_NOSIGNAL);
		if (bytes < 0 && errno == EINTR)
			continue;
		if (bytes < 0)
		{
			wait();
			return failure();
		}
		done += static_cast<std::size_t>(bytes);
	}
	return Nothing{};
}

Status Film::commit()
{
	if (!wait())
		return failure();
	return file_.commit();
}

} // namespace vp::write
