// Reads one file with VTK and hands its arrays over in shared memory; see read/protocol.h. If a damaged file makes a
// reader crash, hang or use up memory, only this process is lost.
#include "read/protocol.h"
#include "read/ready_reader.h"
#include "vprobe-read/base/bytes_read.h"
#include "vprobe-read/base/is_one_of.h"
#include "vprobe-read/base/read_files.h"
#include "vprobe-read/base/refusal.h"
#include "vprobe-read/checks/complaints.h"
#include "vprobe-read/convert/convert.h"
#include "vprobe-read/door/opening.h"
#include "vprobe-read/formats/formats.h"
#include "vprobe-read/manifest/manifest_writer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace vp::reader
{

namespace fs = std::filesystem;

namespace
{

// Its own name and those of protocol.h, without slices.
constexpr int kArgumentCount = 20;

// Adds to a reason which of the files that an index names is meant.
std::string withPiece(const std::string& input, std::string reason)
{
	const std::string piece = pieceBeingRead();
	const bool is_index = isOneOf(fs::path(input).extension().string(),
	                              {".pvti", ".pvtr", ".pvts", ".pvtu", ".vtm", ".vth", ".vthb", ".pvd", ".series"});
	const bool names_a_piece = reason.starts_with("its ");
	if (is_index && !names_a_piece && !piece.empty() &&
	    reason.find(fs::path(piece).filename().string()) == std::string::npos)
		reason = fmt::format("in its file {}: {}", piece, reason);
	return reason;
}

[[noreturn]] void giveUp(std::string reason, int code)
{
	// A file that may not be opened is no sign of damage, whatever its library says.
	if (const std::vector<std::string> refused = refusedFiles(); !refused.empty() && code == read::kRefusedExitCode)
		reason = refused.front();
	for (char& c : reason)
		if (c == '\n' || c == '\r')
			c = ' ';
	std::fprintf(stderr, "\n%s%s\n", read::kReasonMark.data(), reason.c_str());
	std::fflush(stderr);
	_exit(code);
}

std::vector<std::string> linesOf(std::string_view text)
{
	std::vector<std::string> lines;
	while (!text.empty())
	{
		const std::size_t end = std::min(text.find('\n'), text.size());
		if (end > 0)
			lines.emplace_back(text.substr(0, end));
		text.remove_prefix(std::min(end + 1, text.size()));
	}
	return lines;
}

ArrayWish parseWish(std::string_view text)
{
	ArrayWish wish;
	wish.all = false;
	for (const std::string& line : linesOf(text))
	{
		if (line == "*")
			wish.all = true;
		else if (line == "^")
			wish.first = true;
		else if (line.starts_with('='))
			wish.names.push_back(line.substr(1));
	}
	return wish;
}

Request parseRequest(int count, char** arguments)
{
	Request request;
	const std::string time = arguments[1];
	if (time == "first")
		request.time = Request::Time::first;
	else if (time.starts_with('#'))
	{
		request.time = Request::Time::index;
		request.time_index = std::strtoull(time.c_str() + 1, nullptr, 10);
	}
	else if (time == "all")
		request.packs_all_times = true;
	else if (time != "last")
	{
		request.time = Request::Time::nearest;
		request.time_value = std::strtod(time.c_str(), nullptr);
	}
	request.solution = arguments[2];
	request.refine = std::strtod(arguments[3], nullptr);
	request.displace = arguments[4];
	request.patches = std::string(arguments[5]) == "1";
	request.threads = static_cast<int>(std::strtol(arguments[6], nullptr, 10));
	request.arrays = parseWish(arguments[7]);
	request.format = arguments[8];
	request.raw = arguments[9];
	request.convert_to = arguments[10];
	request.convert_folder = arguments[11];
	request.cells_of_part = std::strtoull(arguments[12], nullptr, 10);
	constexpr std::string_view places = "places";
	request.parts = arguments[13];
	request.wants_places = request.parts.starts_with(places);
	if (request.wants_places)
		request.parts.erase(0, places.size());
	request.sandbox = arguments[14];
	request.follow = linesOf(arguments[15]);
	if (*arguments[16])
		request.stays_above = std::strtoull(arguments[16], nullptr, 10);
	request.unpack = arguments[17];
	request.level = std::strtoull(arguments[18], nullptr, 10);
	request.file = arguments[19];
	request.slices.assign(arguments + kArgumentCount, arguments + count);
	request.arguments = arguments;
	return request;
}

convert::TimesToPack timesToPack(const Request& request, manifest::Writer& manifest)
{
	if (manifest.times().size() == 1)
		return {manifest.times()};
	if (!request.packs_all_times || manifest.times().empty())
		return {};
	if (manifest.displacement().isOn())
		throw Refusal(fmt::format("has {} times, and its points move with them; choose one time with --time",
		                          manifest.times().size()));
	const auto read = [&request, &manifest](std::size_t time)
	{
		Request at = request;
		at.time = Request::Time::index;
		at.time_index = time;
		return manifest.collect([&] { formats::readAnyFormat(at, manifest); });
	};
	return {manifest.times(), manifest.times().size() - 1, read};
}

read::SourceStamp stampOf(const std::string& file)
{
	const int descriptor = open(file.c_str(), O_RDONLY | O_CLOEXEC);
	const read::SourceStamp stamp = read::stampOf(descriptor);
	if (descriptor >= 0)
		close(descriptor);
	return stamp;
}

// Ends the process if the parent is gone.
void sendToParent(std::string_view bytes)
{
	std::size_t sent = 0;
	while (sent < bytes.size())
	{
		const ssize_t n = write(read::kManifestFd, bytes.data() + sent, bytes.size() - sent);
		if (n < 0 && errno != EINTR)
			_exit(1);
		if (n > 0)
			sent += static_cast<std::size_t>(n);
	}
}

int run(int argc, char** argv)
{
	const auto is_open = [](int fd) { return fcntl(fd, F_GETFD) >= 0; };
	if (argc < kArgumentCount || !is_open(read::kArraysFd) || !is_open(read::kManifestFd) || !is_open(read::kCellsFd))
	{
		std::fprintf(stderr, "vprobe-read is started by vprobe to read files; run vprobe info FILE instead\n");
		return 1;
	}
	std::signal(SIGXFSZ, SIG_IGN); // a full arrays file shows as an error of the write
	startCounting();
	Request request = parseRequest(argc, argv);
	const ArrayWish wished = request.arrays;
	if (!request.displace.empty())
		request.stays_above = ~std::uint64_t(0);
	if (!request.displace.empty())
		request.arrays = {}; // any of them may say how points move
	const door::Hold hold = request.sandbox == "off" ? door::Hold{} : door::closeDoor(door::openingFor(request));
	if (request.sandbox == "require" && (hold.landlock == 0 || !hold.seccomp))
		giveUp(
		    fmt::format("the system has no full sandbox for its reader ({}); take Linux 5.13 or newer with Landlock, "
		                "or set the sandbox to auto",
		                door::holdText(hold)),
		    read::kNoSandboxExitCode);
	try
	{
		checks::installComplaints();
		tellFiles(request.file);
		if (!request.unpack.empty())
		{
			formats::needHdf5(request);
			volumes::unpackParts(request, sendToParent);
			_exit(0);
		}
		manifest::Writer manifest(request.refine, wished, !request.convert_to.empty(), PartFilter(request.parts));
		manifest.setDisplacement({request.displace, request.patches});
		if (request.convert_to.ends_with(".vtkhdf") || request.writesIndex())
			formats::needHdf5(request);
		if (request.writesIndex())
			request.stamp = stampOf(request.file);
		formats::readAnyFormat(request, manifest);
		manifest.refuseOtherLevel(request.level);
		request.said = manifest.warnings();
		manifest.setSandbox(door::holdText(hold));
		for (std::string& refused : refusedFiles())
			manifest.warn(std::move(refused));
		if (!request.convert_to.empty() && !manifest.isEmpty())
			for (std::string& line : convert::writeConverted(manifest.kept(), timesToPack(request, manifest), request))
				manifest.warn(std::move(line));
		sendToParent(manifest.finish());
	}
	catch (const Refusal& refusal)
	{
		giveUp(withPiece(request.file, refusal.what()), read::kRefusedExitCode);
	}
	catch (const NoRoom& full)
	{
		giveUp(full.what(), read::kNoRoomExitCode);
	}
	catch (const NoSharedMemory& full)
	{
		giveUp(full.what(), read::kNoMemoryExitCode);
	}
	catch (const std::bad_alloc&)
	{
		giveUp(withPiece(request.file, "there is not enough memory to read it"), read::kNoMemoryExitCode);
	}
	catch (const fs::filesystem_error& error)
	{
		giveUp(fmt::format("{} cannot be read ({}); check its permissions", error.path1().string(),
		                   error.code().message()),
		       read::kRefusedExitCode);
	}
	catch (const std::length_error&)
	{
		giveUp(withPiece(request.file, "truncated or damaged: it names a size that no file has"),
		       read::kRefusedExitCode);
	}
	catch (const std::exception&)
	{
		giveUp(withPiece(request.file, "truncated or damaged: its contents do not follow its format"),
		       read::kRefusedExitCode);
	}
	_exit(0); // VTK's own clearing up takes time and can only crash
}

} // namespace

} // namespace vp::reader

int main(int argc, char** argv)
{
	if (!vp::read::isAskedForCopies(argc, argv))
		return vp::reader::run(argc, argv);
	std::vector<std::string> arguments = vp::read::makeCopies();
	return vp::reader::run(static_cast<int>(arguments.size()), vp::read::pointersTo(arguments).data());
}
