#include "write/atomic_file.h"

#include "base/input_files.h"
#include "write/flush.h"
#include "write/held_name.h"
#include "write/unfinished.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vp::write
{

namespace
{

bool isStandardOutput(const std::string& path)
{
	return path == "-" || path == "/dev/stdout" || path == "/dev/fd/1" || path == "/proc/self/fd/1";
}

const char* remedy(int error)
{
	switch (error)
	{
	case ENOENT:
	case ENOTDIR:
		return "remove what stands in the place of its folder, or choose another path";
	case EACCES:
	case EPERM:
	case EROFS:
		return "change its permissions or choose another path";
	case EISDIR:
		return "give the name of a file in it";
	case ENOSPC:
	case EDQUOT:
	case EFBIG:
		return "make room or choose another path";
	case ENAMETOOLONG:
		return "choose a shorter name";
	case EPIPE:
		return "its reader has gone";
	default:
		return "choose another path";
	}
}

Error cannotWrite(const std::string& path, int error)
{
	return {ErrorKind::output, fmt::format("{}: cannot be written: {}; {}", path == "-" ? "standard output" : path,
	                                       std::strerror(error), remedy(error))};
}

Error isAnInput(const std::string& path)
{
	return {ErrorKind::output,
	        fmt::format("{}: is one of the input files, and would be lost; choose another path", path)};
}

// Creates a file of a name no one has. Short, so that a long target name leaves room for it.
int createBeside(const std::string& target, mode_t mode, std::string& name)
{
	const std::string folder = nearestFolder(target);
	removeLeftovers(folder);
	const TouchingFiles files;
	for (;;)
	{
		name = newHeldName(folder);
		rememberUnfinished(name); // first: a signal may come as soon as the file is there
		const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
		if (descriptor >= 0 && holdName(descriptor))
			return descriptor;
		const int error = descriptor >= 0 ? EEXIST : errno;
		if (descriptor >= 0)
			::close(descriptor);
		forgetUnfinished(name);
		if (error != EEXIST)
		{
			errno = error;
			return -1;
		}
	}
}

// Makes the folder of a file, for output that is complete. Gives those that were not there, the deepest first.
std::vector<std::filesystem::path> makeFolders(const std::string& path)
{
	std::vector<std::filesystem::path> made;
	std::error_code unknown;
	for (std::filesystem::path folder = std::filesystem::path(path).parent_path();
	     !folder.empty() && folder != folder.root_path() && !std::filesystem::exists(folder, unknown);
	     folder = folder.parent_path())
		made.push_back(folder);
	if (!made.empty())
		std::filesystem::create_directories(made.front(), unknown);
	return made;
}

} // namespace

std::string nearestFolder(const std::string& path)
{
	std::filesystem::path folder = std::filesystem::path(path).parent_path();
	std::error_code unknown;
	while (!folder.empty() && folder != folder.root_path() && !std::filesystem::exists(folder, unknown))
		folder = folder.parent_path();
	return folder.empty() ? "." : folder.string();
}

Status refuseInput(const std::string& path, bool may_be_state)
{
	const std::optional<InputKind> kind = inputAt(path);
	if (!kind || (may_be_state && *kind == InputKind::state))
		return Nothing{};
	return isAnInput(path);
}

Result<AtomicFile> AtomicFile::create(const std::string& path, bool may_be_state)
{
	AtomicFile file;
	file.path_ = path;
	file.may_be_state_ = may_be_state;
	if (isStandardOutput(path))
	{
		std::fflush(stdout);
		file.descriptor_ = STDOUT_FILENO;
		file.owns_descriptor_ = false;
		return file;
	}

	struct stat old;
	const bool exists = stat(path.c_str(), &old) == 0;
	if (!exists && errno != ENOENT)
		return cannotWrite(path, errno);
	if (exists && S_ISDIR(old.st_mode))
		return cannotWrite(path, EISDIR);
	if (Status free = refuseInput(path, may_be_state); !free)
		return free.error();
	if (exists && !S_ISREG(old.st_mode))
	{
		file.descriptor_ = open(path.c_str(), O_WRONLY | O_CLOEXEC);
		return file.descriptor_ < 0 ? Result<AtomicFile>(cannotWrite(path, errno)) : std::move(file);
	}
	// Renaming needs no right to write the old file, but a file that was protected must stay as it is.
	if (exists && faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
		return cannotWrite(path, errno);

	std::error_code failed;
	const std::filesystem::path target = std::filesystem::weakly_canonical(path, failed);
	file.target_ = failed ? path : target.string();
	// Names are tried now: better than after the work.
	if (std::filesystem::path(path).filename().empty())
		return cannotWrite(path, EISDIR);
	for (const std::filesystem::path& name : std::filesystem::path(file.target_))
		if (name.string().size() > 255)
			return cannotWrite(path, ENAMETOOLONG);
	file.descriptor_ = createBeside(file.target_, exists ? old.st_mode & 0777 : 0666, file.beside_);
	if (file.descriptor_ < 0)
	{
		const int error = errno;
		file.beside_.clear();
		return cannotWrite(path, error);
	}
	if (exists)
		(void)fchmod(file.descriptor_,
		             old.st_mode & 0777); // the umask may have taken rights away that the old file gave
	return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : path_(std::move(other.path_)), target_(std::move(other.target_)), beside_(std::exchange(other.beside_, {})),
      descriptor_(std::exchange(other.descriptor_, -1)), owns_descriptor_(other.owns_descriptor_),
      may_be_state_(other.may_be_state_), error_(other.error_)
{
}

AtomicFile::~AtomicFile()
{
	discard();
}

void AtomicFile::discard()
{
	if (descriptor_ >= 0 && owns_descriptor_)
		::close(descriptor_);
	descriptor_ = -1;
	if (!beside_.empty())
	{
		unlink(beside_.c_str());
		forgetUnfinished(beside_);
	}
	beside_.clear();
}

void AtomicFile::write(std::string_view bytes)
{
	while (!error_ && !bytes.empty())
	{
		const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
		if (written >= 0)
			bytes.remove_prefix(static_cast<std::size_t>(written));
		else if (errno != EINTR)
			error_ = errno;
	}
}

Status AtomicFile::close()
{
	// Some file systems tell of a full disk only here. A file keeps its lock until it has its name.
	const bool is_held = !beside_.empty();
	const int closed = !owns_descriptor_ || descriptor_ < 0 ? -1 : is_held ? dup(descriptor_) : descriptor_;
	if (!is_held && owns_descriptor_)
		descriptor_ = -1;
	if (closed >= 0 && ::close(closed) != 0 && !error_)
		error_ = errno;
	return error_ ? Status(cannotWrite(path_, error_)) : Nothing{};
}

Status AtomicFile::take(const std::string& file)
{
	const TouchingFiles files;
	struct stat own = {};
	const int taken = open(file.c_str(), O_RDONLY | O_CLOEXEC);
	if (taken < 0 || !holdName(taken) || stat(beside_.c_str(), &own) != 0 ||
	    std::rename(file.c_str(), beside_.c_str()) != 0)
	{
		const int error = errno;
		if (taken >= 0)
			::close(taken);
		return cannotWrite(path_, error);
	}
	::close(std::exchange(descriptor_, taken));
	(void)chmod(beside_.c_str(), own.st_mode & 0777);
	return Nothing{};
}

Status AtomicFile::commit()
{
	(void)close(); // error_ holds what it says
	if (!error_ && !beside_.empty())
	{
		// Once more: by now it is known which files the input names.
		if (Status free = refuseInput(path_, may_be_state_); !free)
		{
			discard();
			return free;
		}
		const bool replaces = access(target_.c_str(), F_OK) == 0;
		// Else a machine that stops might have lost the old file, and the new one might be empty.
		if (replaces)
			error_ = flushFile(descriptor_);
		const TouchingFiles files;
		const std::vector<std::filesystem::path> made = makeFolders(target_);
		if (!error_ && std::rename(beside_.c_str(), target_.c_str()) == 0)
		{
			forgetUnfinished(std::exchange(beside_, {}));
			if (replaces)
				(void)flushFileOrFolder(nearestFolder(target_)); // the old name or the new one is there in any case
		}
		else
		{
			error_ = error_ ? error_ : errno;
			std::error_code ignored;
			for (const std::filesystem::path& folder : made)
				std::filesystem::remove(folder, ignored);
		}
	}
	discard();
	if (error_)
		return cannotWrite(path_, error_);
	return Nothing{};
}

Status checkWritable(const std::string& path)
{
	std::error_code failed;
	if (std::filesystem::is_other(path, failed)) // opening a pipe to try it would end its reader
		return Nothing{};
	const Result<AtomicFile> file = AtomicFile::create(path);
	return file ? Status(Nothing{}) : file.error();
}

} // namespace vp::write
