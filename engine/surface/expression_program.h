#pragma once

#include "surface/expression_operations.h"
#include "surface/expression_parser.h"

#include <array>
#include <cstdint>
#include <vector>

namespace vp::surface
{

// An expression as instructions over slots: x, y and z, then registers. Of two operands the one that needs more
// registers is computed first (Sethi and Ullman 1970), so n leaves need 1 + log2(n) of them at most; the text's length
// bounds n.
class ExpressionProgram
{
public:
	static constexpr int kFirstRegister = 3;
	static constexpr int kSlots = 16;

	struct Instruction
	{
		Operation operation;
		std::uint8_t to, a, b; // slots; b is a where there is no second operand
		std::int32_t exponent;
		double number;
	};

	explicit ExpressionProgram(const ParsedExpression& parsed);

	// In any arithmetic: numberOf(double) makes a Value, and apply(operation, exponent, a, b) computes with them.
	template <class Value, class NumberOf, class Apply>
	Value run(const Value& x, const Value& y, const Value& z, NumberOf numberOf, Apply apply) const
	{
		std::array<Value, kSlots> slots{x, y, z};
		for (const Instruction& i : instructions_)
			slots[i.to] = i.operation == Operation::number ? numberOf(i.number)
			                                               : apply(i.operation, i.exponent, slots[i.a], slots[i.b]);
		return slots[result_];
	}

	double value(double x, double y, double z) const;

	// Many points, 64 of them by each instruction: the same bits as value().
	void values(const double* x, const double* y, const double* z, double* out, std::size_t count) const;

private:
	std::vector<Instruction> instructions_;
	std::uint8_t result_;
};

} // namespace vp::surface
