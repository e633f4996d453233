#include "report/frame_figures.h"

#include "ranks/write/joined_stats.h"
#include "report/stats_json.h"
#include "team.h"
#include "write/atomic_file.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <string_view>

#include <fcntl.h>
#include <unistd.h>

namespace vp::app
{

namespace
{

// As statsDocument() writes a list of frames: the list, and a frame in it.
constexpr std::string_view kNoFrames = "\n\t\"frames\": []";
constexpr std::string_view kBeforeFrame = "\n\t\t";

Error cannotKeep(int error)
{
	return {ErrorKind::output, fmt::format("--stats: the figures of the frames cannot be kept in the folder for "
	                                       "temporary files ({}); free space there, or set TMPDIR to another folder",
	                                       std::strerror(error))};
}

// A file that is gone when it is closed, and that no other program finds.
std::FILE* fileWithoutName()
{
	std::error_code none;
	std::string path = (std::filesystem::temp_directory_path(none) / "vprobe-frames-XXXXXX").string();
	if (none)
	{
		errno = none.value();
		return nullptr;
	}
	const int descriptor = mkostemp(path.data(), O_CLOEXEC);
	if (descriptor < 0)
		return nullptr;
	unlink(path.c_str());
	return fdopen(descriptor, "w+");
}

std::string textOf(const nlohmann::json& frame)
{
	const std::string plain = frame.dump(1, '\t', false, nlohmann::json::error_handler_t::replace);
	std::string text(kBeforeFrame);
	for (const char letter : plain) // a text in it has no line breaks
		if (letter == '\n')
			text += kBeforeFrame;
		else
			text += letter;
	return text;
}

} // namespace

Result<FrameFigures> FrameFigures::create(std::string stats)
{
	FrameFigures figures(std::move(stats));
	figures.file_.reset(fileWithoutName());
	if (!figures.file_)
		return cannotKeep(errno);
	return figures;
}

void FrameFigures::add(const session::Session& session, nlohmann::json frame)
{
	const std::string text = textOf(ranks::figuresOfAll(session.ranks(), std::move(frame)));
	if (!isFirst() || error_)
		return;
	if ((!is_empty_ && std::fputc(',', file_.get()) == EOF) || std::fputs(text.c_str(), file_.get()) == EOF)
		error_ = errno;
	is_empty_ = false;
}

Status FrameFigures::copyTo(write::AtomicFile& file)
{
	if (error_ || std::fflush(file_.get()) != 0 || std::fseek(file_.get(), 0, SEEK_SET) != 0)
		return cannotKeep(error_ ? error_ : errno);
	std::array<char, 1 << 16> part;
	while (const std::size_t got = std::fread(part.data(), 1, part.size(), file_.get()))
		file.write({part.data(), got});
	return std::ferror(file_.get()) ? Status(cannotKeep(errno)) : Nothing{};
}

Result<ExitCode> FrameFigures::write(const session::Session& session)
{
	const std::string document = statsDocument(session, {{"frames", nlohmann::json::array()}});
	if (!isFirst())
		return ExitCode::done;
	Result<write::AtomicFile> file = write::AtomicFile::create(stats_);
	if (!file)
		return file.error();
	const std::size_t list = document.find(kNoFrames) + kNoFrames.size() - 1; // its closing bracket
	file->write(std::string_view(document).substr(0, list));
	if (Status copied = copyTo(*file); !copied)
		return copied.error();
	if (!is_empty_)
		file->write("\n\t");
	file->write(std::string_view(document).substr(list));
	if (Status written = file->commit(); !written)
		return written.error();
	return ExitCode::done;
}

} // namespace vp::app
