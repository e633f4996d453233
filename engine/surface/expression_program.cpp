#include "surface/expression_program.h"

#include <algorithm>
#include <cassert>

namespace vp::surface
{

namespace
{

constexpr std::size_t kBatch = 64;

static_assert(kMaxExpressionText <= 1 << (ExpressionProgram::kSlots - ExpressionProgram::kFirstRegister - 1));

bool isVariable(const ExpressionNode& node)
{
	return node.operation <= Operation::z;
}

// Registers that each node needs.
std::vector<std::uint8_t> registerNeeds(const std::vector<ExpressionNode>& nodes)
{
	std::vector<std::uint8_t> needs;
	for (const ExpressionNode& node : nodes)
	{
		const std::uint8_t a = node.a < 0 ? 0 : needs[node.a];
		const std::uint8_t b = node.b < 0 ? 0 : needs[node.b];
		const std::uint8_t both = a == b && node.b >= 0 ? a + 1 : std::max(a, b);
		needs.push_back(isVariable(node) ? 0 : std::max<std::uint8_t>(both, 1));
	}
	return needs;
}

using Batch = std::array<double, kBatch>;

// integerPower() of many, in its order.
void integerPowers(const double* a, int exponent, double* to, std::size_t count)
{
	Batch base;
	std::copy_n(a, count, base.begin());
	std::fill_n(to, count, 1.0);
	for (int left = std::abs(exponent); left > 0; left >>= 1)
	{
		if (left & 1)
			for (std::size_t i = 0; i < count; ++i)
				to[i] *= base[i];
		for (std::size_t i = 0; i < count; ++i)
			base[i] *= base[i];
	}
	if (exponent < 0)
		for (std::size_t i = 0; i < count; ++i)
			to[i] = 1.0 / to[i];
}

// `to` overlaps no operand: the loops are vectorised.
void applyToMany(const ExpressionProgram::Instruction& instruction, const double* a, const double* b, double* to,
                 std::size_t count)
{
	if (instruction.operation == Operation::number)
		std::fill_n(to, count, instruction.number);
	else if (instruction.operation == Operation::integer_power)
		integerPowers(a, instruction.exponent, to, count);
	else
		withOperation(instruction.operation, instruction.exponent,
		              [&](auto f)
		              {
			              for (std::size_t i = 0; i < count; ++i)
				              to[i] = f(a[i], b[i]);
		              });
}

} // namespace

ExpressionProgram::ExpressionProgram(const ParsedExpression& parsed)
{
	const std::vector<ExpressionNode>& nodes = parsed.tree.nodes();
	const std::vector<std::uint8_t> needs = registerNeeds(nodes);
	const auto slotOf = [&](int node, int next)
	{ return static_cast<std::uint8_t>(isVariable(nodes[node]) ? static_cast<int>(nodes[node].operation) : next); };

	// From the last instruction to the first: what is computed into which register, then the same for its operands.
	struct Wanted
	{
		int node;
		int to;
	};
	std::vector<Wanted> wanted{{parsed.root, kFirstRegister}};
	result_ = slotOf(parsed.root, kFirstRegister);
	while (!wanted.empty())
	{
		const auto [at, to] = wanted.back();
		wanted.pop_back();
		const ExpressionNode& node = nodes[at];
		if (isVariable(node))
			continue;
		assert(to < kSlots);
		Instruction made{node.operation, static_cast<std::uint8_t>(to), 0, 0, node.exponent, node.number};
		if (node.b >= 0)
		{
			const bool a_first = needs[node.a] >= needs[node.b];
			const int first = a_first ? node.a : node.b;
			const int second = a_first ? node.b : node.a;
			const int to_second = isVariable(nodes[first]) ? to : to + 1;
			wanted.push_back({first, to});
			wanted.push_back({second, to_second});
			made.a = a_first ? slotOf(first, to) : slotOf(second, to_second);
			made.b = a_first ? slotOf(second, to_second) : slotOf(first, to);
		}
		else if (node.a >= 0)
		{
			wanted.push_back({node.a, to});
			made.a = made.b = slotOf(node.a, to);
		}
		instructions_.push_back(made);
	}
	std::reverse(instructions_.begin(), instructions_.end());
}

double ExpressionProgram::value(double x, double y, double z) const
{
	return run<double>(
	    x, y, z, [](double number) { return number; },
	    [](Operation operation, int exponent, double a, double b)
	    { return withOperation(operation, exponent, [=](auto f) { return f(a, b); }); });
}

void ExpressionProgram::values(const double* x, const double* y, const double* z, double* out, std::size_t count) const
{
	// One more than there are registers: what is computed goes there, then takes the place of what was in its register.
	std::array<Batch, kSlots - kFirstRegister + 1> room;
	std::array<double*, kSlots> registers{};
	for (int r = kFirstRegister; r < kSlots; ++r)
		registers[r] = room[r - kFirstRegister].data();
	double* spare = room.back().data();
	for (std::size_t begin = 0; begin < count; begin += kBatch)
	{
		const std::size_t here = std::min(kBatch, count - begin);
		const std::array<const double*, kFirstRegister> variables{x + begin, y + begin, z + begin};
		const auto slot = [&](int s) { return s < kFirstRegister ? variables[s] : registers[s]; };
		for (const Instruction& i : instructions_)
		{
			applyToMany(i, slot(i.a), slot(i.b), spare, here);
			std::swap(spare, registers[i.to]);
		}
		std::copy_n(slot(result_), here, out + begin);
	}
}

} // namespace vp::surface
