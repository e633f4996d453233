#pragma once

#include "base/result.h"
#include "base/vec.h"
#include "grid/block.h"
#include "grid/field_choice.h"
#include "grid/number_types.h"

#include <cstddef>
#include <string>

namespace vp::vectors
{

constexpr int kVectorComponents = 3;

// The array of three components that is followed: `array` is "[point:|cell:]NAME"; empty takes the first such point
// array, else the first such cell array. Input errors: no such array, or one of other components; they list those that
// would do.
Result<grid::FieldChoice> chooseVectors(const grid::BlockSet& blocks, const std::string& array);

// Vectors of one block at one time.
class BlockVectors
{
public:
	BlockVectors() = default;
	// field: may be null, as of a block that lacks the array.
	explicit BlockVectors(const grid::Field* field)
	    : field_(field && field->components == kVectorComponents ? field : nullptr)
	{
	}

	bool known() const { return field_; }
	bool onCells() const { return field_->association == grid::Association::cell; }
	// tuple: the number of a point or a cell in its source.
	Vec3 at(std::size_t tuple) const
	{
		if (field_->type == grid::NumberType::float32)
			return numbersAt<float>(tuple);
		if (field_->type == grid::NumberType::float64)
			return numbersAt<double>(tuple);
		return {field_->value(tuple, 0), field_->value(tuple, 1), field_->value(tuple, 2)};
	}

private:
	template <class Number>
	Vec3 numbersAt(std::size_t tuple) const
	{
		const std::byte* numbers = field_->tuple(tuple);
		return {grid::numberAt<Number>(numbers, 0), grid::numberAt<Number>(numbers, 1),
		        grid::numberAt<Number>(numbers, 2)};
	}

	const grid::Field* field_ = nullptr;
};

} // namespace vp::vectors
