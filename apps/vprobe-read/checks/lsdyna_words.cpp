#include "lsdyna_words.h"

#include "vprobe-read/base/refusal.h"

#include <fmt/format.h>

#include <cmath>

namespace vp::reader::checks
{

namespace
{

constexpr std::size_t kControlWords = 64;
constexpr std::size_t kFileTypeAt = 11;
constexpr std::size_t kVersionAt = 14;
constexpr std::size_t kDimensionsAt = 15;

} // namespace

template <class Number>
Number LsdynaWords::number(std::size_t word) const
{
	static_assert(sizeof(Number) <= 8);
	if (word >= count())
		throw damaged("it ends within its words");
	return numberAt<Number>(bytes_.data() + word * width_, order_);
}

std::int64_t LsdynaWords::integer(std::size_t word) const
{
	return width_ == 4 ? number<std::int32_t>(word) : number<std::int64_t>(word);
}

double LsdynaWords::real(std::size_t word) const
{
	return width_ == 4 ? number<float>(word) : number<double>(word);
}

// Checks the file's type, its dimensions, and the version of the program.
bool LsdynaWords::hasHead() const
{
	if (count() < kControlWords)
		return false;
	const std::int64_t type = integer(kFileTypeAt);
	const std::int64_t dimensions = integer(kDimensionsAt);
	const double version = real(kVersionAt);
	return (type == 1 || type == 5 || type == 11) && dimensions >= 2 && dimensions <= 7 && version > 0.0 &&
	       version < 1e6;
}

LsdynaWords::LsdynaWords(std::string_view bytes) : bytes_(bytes)
{
	for (const std::size_t width : {4, 8})
		for (const ByteOrder order : {ByteOrder::little, ByteOrder::big})
		{
			width_ = width;
			order_ = order;
			if (hasHead())
				return;
		}
	throw damaged("its control words are not those of d3plot");
}

LsdynaWords::LsdynaWords(std::string_view bytes, const LsdynaWords& first)
    : bytes_(bytes), width_(first.width_), order_(first.order_)
{
}

bool LsdynaWords::isHead(std::string_view bytes)
{
	try
	{
		const LsdynaWords words(bytes);
		return words.real(kVersionAt) >= 1.0;
	}
	catch (const Refusal&)
	{
		return false;
	}
}

LsdynaControl::LsdynaControl(const LsdynaWords& words)
{
	const auto countAt = [&](std::size_t word)
	{
		const std::int64_t count = words.integer(word);
		if (count < 0 || count > std::int64_t(1) << 40)
			throw damaged(fmt::format("its control word {} is {}", word, count));
		return count;
	};
	dimensions = countAt(kDimensionsAt);
	nodes = countAt(16);
	globals = countAt(18);
	has_temperature = countAt(19);
	has_places = countAt(20);
	has_velocities = countAt(21);
	has_accelerations = countAt(22);
	solids = words.integer(23);
	has_ten_nodes = solids < 0;
	solids = std::abs(solids);
	solid_values = countAt(27);
	beams = countAt(28);
	beam_values = countAt(30);
	shells = countAt(31);
	shell_values = countAt(33);
	integration = words.integer(36);
	thick_shells = countAt(40);
	thick_values = countAt(42);
	user_ids = countAt(39);
	ale_materials = countAt(47);
	solid_thermal = 0;
	if (countAt(57) > 0)
	{
		head_words_ += kControlWords;
		solid_thermal = countAt(65);
	}
	for (const auto& [word, what] : {std::pair{std::size_t(37), "particles (SPH)"},
	                                 {48, "fluid variables"},
	                                 {49, "fluid variables"},
	                                 {54, "particles in airbags"},
	                                 {55, "shells of 8 nodes"}})
		if (words.integer(word) != 0)
			throw Refusal(fmt::format("{}, which are not read; write the results of solids alone", what));
	// The last two digits say that nodes have more values: rates of temperature, residual forces.
	if (countAt(56) % 100 != 0)
		throw Refusal("rates of temperature or residual forces at nodes, which are not read");
	if (dimensions < 4 || dimensions > 5 || has_ten_nodes)
		throw Refusal(fmt::format("{}, which is not read", has_ten_nodes    ? "solids of 10 nodes"
		                                                   : dimensions > 5 ? "a road surface"
		                                                                    : "packed connectivity"));
	if (dimensions == 5) // types of materials: some have rigid shells, which have no values
	{
		rigid_shells = countAt(head_words_);
		material_words_ = 2 + static_cast<std::size_t>(countAt(head_words_ + 1));
		if (rigid_shells > shells)
			throw damaged("it has more rigid shells than shells");
	}
	if (solids > std::int64_t(1) << 40)
		throw damaged("it has more solids than can be");
	deletion = integration >= 0 ? Deletion::none : integration > -10000 ? Deletion::nodes : Deletion::elements;
}

std::size_t LsdynaControl::geometryWords() const
{
	return thickShellsAt() + static_cast<std::size_t>(9 * thick_shells + 6 * beams + 5 * shells + user_ids);
}

std::size_t LsdynaControl::temperatureWords() const
{
	constexpr std::array<std::size_t, 4> words = {0, 1, 4, 6};
	const std::int64_t kind = has_temperature % 10;
	if (kind > 3)
		throw damaged("temperatures of an unknown kind");
	return words[static_cast<std::size_t>(kind)];
}

std::size_t LsdynaControl::nodeWords() const
{
	return temperatureWords() + massWords() +
	       3 * static_cast<std::size_t>((has_places != 0) + (has_velocities != 0) + (has_accelerations != 0));
}

std::size_t LsdynaControl::solidValuesAt() const
{
	return nodesAt() + nodeWords() * static_cast<std::size_t>(nodes) + static_cast<std::size_t>(solid_thermal * solids);
}

std::size_t LsdynaControl::thickValuesAt() const
{
	return solidValuesAt() + static_cast<std::size_t>(solid_values * solids);
}

std::size_t LsdynaControl::deletionAt() const
{
	return thickValuesAt() + static_cast<std::size_t>(thick_values * thick_shells + beam_values * beams +
	                                                  shell_values * (shells - rigid_shells));
}

std::size_t LsdynaControl::stateWords() const
{
	return deletionAt() + (deletion == Deletion::nodes      ? static_cast<std::size_t>(nodes)
	                       : deletion == Deletion::elements ? elementCount()
	                                                        : 0);
}

} // namespace vp::reader::checks
