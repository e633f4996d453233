#pragma once

#include "base/result.h"
#include "picture/compare.h"

#include <nlohmann/json_fwd.hpp>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace vp::app
{

// A number is as expected if it is within one of both.
struct FigureTolerance
{
	double relative = 1e-6; // times the expected number
	double absolute = 1e-9; // sums of positive and negative values are noise around 0
};

// The key "tolerance" of a file of figures.
struct Tolerances
{
	FigureTolerance all{};
	std::map<std::string, FigureTolerance> keys{}; // by the last key of a figure, as "area"
	std::optional<picture::PictureTolerance> picture{};
};

// A figure that is not as expected.
struct MovedFigure
{
	std::string place; // as "sheets/0/area"
	std::string expected;
	std::string drawn; // "none" if there is no such figure
	std::string why;   // "" or how far a number may be
};

// Reads the key "tolerance" of a document, if it is there. Returns an input error for what is not a tolerance.
Result<Tolerances> tolerancesOf(const nlohmann::json& document, const std::string& file);

// Compares what the expected document holds, except "tolerance"; other figures do not matter. Whole numbers are equal,
// unless the file has a tolerance for their key.
std::vector<MovedFigure> movedFigures(const nlohmann::json& expected, const nlohmann::json& figures,
                                      const Tolerances& tolerances);

// Returns one line about all of them: "sheets/0/area is 1.2, expected 1.3, and 2 more differ".
std::string text(const std::vector<MovedFigure>& moved);

// Reads a file of figures, which --update may write again.
Result<nlohmann::json> readFigures(const std::string& file);

// Compares a --stats document with a file of figures.
Result<std::vector<MovedFigure>> compareFigures(const std::string& file, const std::string& stats);

// Returns a file of figures: those of a --stats document that do not depend on machine, time and search.
std::string newFigures(const nlohmann::json& figures);
// Returns the file again with the figures of today. Keys and tolerance stay.
std::string updatedFigures(nlohmann::json expected, const nlohmann::json& figures);

} // namespace vp::app
