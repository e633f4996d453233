#pragma once

#include "base/result.h"
#include "render/picture.h"
#include "write/atomic_file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace vp::write
{

// Whether a name ends like a film's: .mp4, .mkv, .webm or .gif.
bool isFilm(std::string_view path);

// A film, put together by the program ffmpeg, which gets the pictures through a pipe. The file appears whole or not at
// all. Where ffmpeg is not installed that is told at once.
class Film
{
public:
	// All pictures are of this size; per_second > 0.
	static Result<Film> create(const std::string& path, std::uint32_t width, std::uint32_t height, double per_second);
	Film(Film&& other) noexcept;
	Film& operator=(Film&&) = delete;
	~Film();

	Status add(const render::Picture& picture);
	Status commit();

private:
	explicit Film(AtomicFile file) : file_(std::move(file)) {}

	Error failure() const; // what ffmpeg said
	bool wait();           // true where ffmpeg ended well

	std::string path_;
	AtomicFile file_;
	int frames_ = -1;
	int said_ = -1; // its standard error
	int process_ = -1;
};

} // namespace vp::write
