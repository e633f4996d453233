#pragma once

#include "base/result.h"
#include "render/picture.h"
#include "write/atomic_file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::write
{

// Returns true if a name has the ending of a film: .mp4, .mkv, .webm or .gif.
bool isFilm(std::string_view path);

// A film. The program ffmpeg makes it from pictures that it gets through a pipe. The file appears whole or not at all.
// If ffmpeg is not installed, there is an error at once.
class Film
{
public:
	// All pictures must have this size. per_second > 0.
	static Result<Film> create(const std::string& path, std::uint32_t width, std::uint32_t height, double per_second);
	Film(Film&& other) noexcept;
	Film& operator=(Film&&) = delete;
	~Film();

	Status add(const render::Picture& picture);
	Status commit();

private:
	explicit Film(AtomicFile file) : file_(std::move(file)) {}

	Error failure() const; // the message of ffmpeg
	bool wait();           // returns true if ffmpeg succeeded

	std::string path_;
	AtomicFile file_;
	int frames_ = -1;
	int said_ = -1; // its standard error
	int process_ = -1;
};

} // namespace vp::write
