#pragma once

#include "render/picture.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

namespace vp::app
{

// Keeps the pictures of a sweep, to play them again at full rate and to save them. Thread safe.
class FilmLoop
{
public:
	// Limit for all pictures together: some 280 pictures of 1280 x 720 pixels.
	static constexpr std::size_t kMaxBytes = std::size_t(1) << 30;
	static std::size_t bytesOf(int frames, std::uint32_t width, std::uint32_t height)
	{
		return std::size_t(4) * width * height * static_cast<std::size_t>(frames);
	}

	explicit FilmLoop(int frames) : pictures_(static_cast<std::size_t>(frames)) {}

	int frames() const { return static_cast<int>(pictures_.size()); }
	void put(int frame, render::Picture picture);
	int recorded() const;
	bool isWhole() const { return recorded() == frames(); }
	std::shared_ptr<const render::Picture> picture(int frame) const; // null before it is recorded

private:
	mutable std::mutex mutex_;
	std::vector<std::shared_ptr<const render::Picture>> pictures_;
	int recorded_ = 0;
};

} // namespace vp::app
