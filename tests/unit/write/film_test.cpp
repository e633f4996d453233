#include "sample_slice.h"

#include "write/film.h"

#include <gtest/gtest.h>

#include <fstream>

#include <cstdlib>
#include <filesystem>

namespace vp::test
{

namespace
{

class FilmFile : public testing::Test
{
protected:
	void SetUp() override
	{
		if (std::system("ffmpeg -version >/dev/null 2>&1") != 0)
			GTEST_SKIP() << "ffmpeg is not installed";
	}

	render::Picture picture(std::uint8_t shade) const
	{
		return {kSide, kSide, std::vector<std::uint8_t>(std::size_t(4) * kSide * kSide, shade)};
	}

	static constexpr std::uint32_t kSide = 64;
	TemporaryFolder folder_;
};

} // namespace

TEST(FilmName, ByItsEnding)
{
	for (const char* film : {"a.mp4", "b/c.mkv", "a.webm", "a.gif"})
		EXPECT_TRUE(write::isFilm(film)) << film;
	for (const char* other : {"a.png", "mp4", "", "a.mp4.png", "{frame}.png"})
		EXPECT_FALSE(write::isFilm(other)) << other;
}

TEST_F(FilmFile, AppearsOnCommit)
{
	Result<write::Film> film = write::Film::create(folder_ / "a.gif", kSide, kSide, 10.0);
	ASSERT_TRUE(film);
	for (int shade = 0; shade < 250; shade += 50)
		ASSERT_TRUE(film->add(picture(static_cast<std::uint8_t>(shade))));
	EXPECT_FALSE(std::filesystem::exists(folder_ / "a.gif"));
	ASSERT_TRUE(film->commit());
	EXPECT_EQ(readText(folder_ / "a.gif").substr(0, 6), "GIF89a");
	EXPECT_EQ(folder_.files(), 1u);
}

TEST_F(FilmFile, WithoutCommitNothingIsLeft)
{
	{
		Result<write::Film> film = write::Film::create(folder_ / "a.mp4", kSide, kSide, 10.0);
		ASSERT_TRUE(film);
		ASSERT_TRUE(film->add(picture(7)));
	}
	EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(FilmFile, WhatFfmpegSaysIsTold)
{
	// 65535 is GIF's widest picture.
	const Status status = [&]() -> Status
	{
		Result<write::Film> film = write::Film::create(folder_ / "a.gif", 70000, 1, 10.0);
		if (!film)
			return film.error();
		const Status added = film->add({70000, 1, std::vector<std::uint8_t>(4 * 70000)});
		return added ? film->commit() : added;
	}();
	ASSERT_FALSE(status);
	EXPECT_EQ(status.error().kind, ErrorKind::output);
	EXPECT_NE(status.error().message.find("ffmpeg failed: "), std::string::npos) << status.error().message;
	EXPECT_EQ(status.error().message.find('\n'), std::string::npos);
	EXPECT_EQ(status.error().message.find("it gave no reason"), std::string::npos);
	EXPECT_EQ(folder_.files(), 0u);
}

TEST_F(FilmFile, NowhereToWriteIsToldBeforeTheWork)
{
	std::ofstream(folder_ / "none") << "a file where the folder would be";
	const Result<write::Film> film = write::Film::create(folder_ / "none/a.gif", kSide, kSide, 10.0);
	ASSERT_FALSE(film);
	EXPECT_EQ(film.error().kind, ErrorKind::output);
	EXPECT_NE(film.error().message.find("none/a.gif"), std::string::npos);
}

TEST(FilmWithoutFfmpeg, IsRefused)
{
	const TemporaryFolder folder;
	const std::string search = std::getenv("PATH");
	setenv("PATH", "/nonexistent", 1);
	const Result<write::Film> film = write::Film::create(folder / "a.gif", 2, 2, 10.0);
	setenv("PATH", search.c_str(), 1);
	ASSERT_FALSE(film);
	EXPECT_EQ(film.error().kind, ErrorKind::output);
	EXPECT_NE(film.error().message.find("not installed"), std::string::npos);
	EXPECT_EQ(folder.files(), 0u);
}

} // namespace vp::test
