#include "verify/expect.h"

#include "base/input_files.h"
#include "picture/compare.h"
#include "picture/read_png.h"
#include "report/console.h"
#include "team.h"
#include "verify/figures.h"
#include "write/atomic_file.h"
#include "write/png.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <filesystem>

namespace vp::app
{

Result<ExpectedPicture> readExpected(const std::string& file, const std::string& difference)
{
	if (file.empty() && !difference.empty())
		return Error{ErrorKind::usage,
		             "--difference: shows how the picture differs from --expect FILE.png; give both, or leave it out"};
	if (file.empty())
		return ExpectedPicture{};
	noteInput(file);
	if (!difference.empty() && std::filesystem::path(difference).extension() != ".png")
		return Error{
		    ErrorKind::usage,
		    fmt::format("--difference {}: pictures are written as .png; give a name that ends so", difference)};
	if (Status place = difference.empty() || !isFirst() ? Nothing{} : write::checkWritable(difference); !place)
		return place.error();
	Result<render::Picture> picture = picture::readPng(file);
	if (!picture)
		return picture.error();
	return ExpectedPicture{file, std::move(*picture), difference};
}

Result<ExitCode> compareWith(const ExpectedPicture& expected, const render::Picture& drawn, int samples)
{
	if (expected.file.empty() || !isFirst())
		return ExitCode::done;
	const Result<picture::PictureDifference> found = picture::comparePictures(expected.picture, drawn);
	if (found && found->isWithin(picture::toleranceOf(samples)))
		return ExitCode::done;
	printLine(fmt::format("{}: is not as drawn: {}", expected.file, found ? found->text() : found.error().message));
	if (found && !expected.difference.empty())
		if (Status written =
		        write::writePng(picture::pictureOfDifference(expected.picture, drawn), expected.difference);
		    !written)
			return written.error();
	return ExitCode::differs;
}

Status checkExpected(const std::string& file)
{
	if (file.empty())
		return Nothing{};
	const Result<nlohmann::json> figures = readFigures(file);
	if (!figures)
		return figures.error();
	const Result<Tolerances> tolerances = tolerancesOf(*figures, file);
	return tolerances ? Status(Nothing{}) : tolerances.error();
}

Result<ExitCode> compareWith(const std::string& file, const std::string& stats)
{
	if (file.empty() || !isFirst())
		return ExitCode::done;
	const Result<std::vector<MovedFigure>> moved = compareFigures(file, stats);
	if (!moved)
		return moved.error();
	if (moved->empty())
		return ExitCode::done;
	printLine(fmt::format("{}: {}", file, text(*moved)));
	return ExitCode::differs;
}

} // namespace vp::app
