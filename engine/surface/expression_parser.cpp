#include "surface/expression_parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

namespace vp::surface
{

namespace
{

constexpr int kNone = -1; // no node: the reason is in error_

bool isDigit(char c)
{
	return c >= '0' && c <= '9';
}

bool isNameStart(char c)
{
	return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

bool isSpace(char c)
{
	return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

std::string knownNames()
{
	std::string names = "x, y, z, pi, e, ";
	for (const NamedFunction& function : kNamedFunctions)
		names += fmt::format("{}{}", function.name, &function == &kNamedFunctions.back() ? "" : ", ");
	return names;
}

// Recursive descent:
//   equation = sum [ "=" sum ]
//   sum      = product { ("+" | "-") product }
//   product  = signed { ("*" | "/") signed }
//   signed   = ("-" | "+") signed | power
//   power    = primary [ "^" signed ]
//   primary  = number | name | function "(" sum { "," sum } ")" | "(" sum ")"
class Parser
{
public:
	explicit Parser(std::string_view text) : text_(text) {}

	Result<ParsedExpression> parse()
	{
		const int root = equation();
		if (root == kNone)
			return *error_;
		if (tree_.isNumber(root))
			return Error{ErrorKind::usage, "column 1: the expression is constant: it needs x, y or z"};
		return ParsedExpression{std::move(tree_), root};
	}

private:
	int equation()
	{
		if (text_.size() > kMaxExpressionText)
			return fail(kMaxExpressionText, fmt::format("an expression has {} characters at most", kMaxExpressionText));
		skipSpace();
		int root = sum();
		if (root == kNone)
			return kNone;
		if (const std::size_t at = at_; take('='))
		{
			const int right = sum();
			if (right == kNone)
				return kNone;
			root = applied(at, Operation::subtract, root, right);
		}
		if (root == kNone || at_ == text_.size())
			return root;
		if (text_[at_] == '=')
			return fail(at_, "an equation has one \"=\"");
		if (text_[at_] == ')')
			return fail(at_, "there is no \"(\" for this \")\"");
		return fail(at_, fmt::format("expected an operator, not {}", tokenHere()));
	}

	int sum()
	{
		int left = product();
		while (left != kNone)
		{
			const std::size_t at = at_;
			const bool adds = take('+');
			if (!adds && !take('-'))
				break;
			const int right = product();
			left = right == kNone ? kNone : applied(at, adds ? Operation::add : Operation::subtract, left, right);
		}
		return left;
	}

	int product()
	{
		int left = signedPower();
		while (left != kNone)
		{
			const std::size_t at = at_;
			const bool multiplies = take('*');
			if (!multiplies && !take('/'))
				break;
			if (multiplies && at_ == at + 1 && peek() == '*')
				return fail(at, "powers are written with \"^\", not with \"**\"");
			const int right = signedPower();
			left =
			    right == kNone ? kNone : applied(at, multiplies ? Operation::multiply : Operation::divide, left, right);
		}
		return left;
	}

	int signedPower()
	{
		const Nesting nesting(depth_);
		if (depth_ > kMaxExpressionNesting)
			return fail(at_, fmt::format("nested deeper than {} levels", kMaxExpressionNesting));
		const std::size_t at = at_;
		if (take('+'))
			return signedPower();
		if (!take('-'))
			return power();
		const int operand = signedPower();
		return operand == kNone ? kNone : applied(at, Operation::negate, operand);
	}

	int power()
	{
		const int base = primary();
		const std::size_t at = at_;
		if (base == kNone || !take('^'))
			return base;
		const int exponent = signedPower();
		return exponent == kNone ? kNone : applied(at, Operation::pow, base, exponent);
	}

	int primary()
	{
		const char c = peek();
		if (isDigit(c) || c == '.')
			return number();
		if (isNameStart(c))
			return named();
		const std::size_t at = at_;
		if (!take('('))
			return failOperand();
		const int inner = sum();
		return inner == kNone || !closes(at) ? kNone : inner;
	}

	int number()
	{
		double value = 0.0;
		const char* const first = text_.data() + at_;
		const auto [end, error] = std::from_chars(first, text_.data() + text_.size(), value);
		if (error == std::errc::result_out_of_range)
			return fail(at_, fmt::format("{} is out of the range of double precision", quoted(at_, end - first)));
		if (error != std::errc())
			return failOperand();
		advance(static_cast<std::size_t>(end - first));
		return tree_.number(value);
	}

	int named()
	{
		const std::size_t at = at_;
		const std::string_view name = nameHere();
		advance(name.size());
		if (name == "x" || name == "y" || name == "z")
			return tree_.variable(name == "x" ? Operation::x : name == "y" ? Operation::y : Operation::z);
		if (name == "pi")
			return tree_.number(std::numbers::pi);
		if (name == "e")
			return tree_.number(std::numbers::e);
		const auto* function = std::ranges::find(kNamedFunctions, name, &NamedFunction::name);
		if (function == kNamedFunctions.end())
			return fail(at, fmt::format("unknown name {}; there are {}", quoted(at, name.size()), knownNames()));
		return call(*function, at);
	}

	// "(" to ")". Of more than two arguments: min(min(a, b), c).
	int call(const NamedFunction& function, std::size_t at)
	{
		const std::size_t opens = at_;
		if (!take('('))
			return fail(at_, fmt::format("expected \"(\" after \"{}\"", function.name));
		int result = sum();
		int arguments = 1;
		for (; result != kNone && take(','); ++arguments)
		{
			const int next = sum();
			if (next == kNone)
				return kNone;
			if (function.arguments() > 1)
				result = applied(at, function.operation, result, next);
		}
		if (result == kNone || !closes(opens))
			return kNone;
		if (arguments < function.arguments() || (arguments > function.arguments() && !function.or_more))
			return fail(at, fmt::format("{} takes {}{} argument{}, not {}", function.name, function.arguments(),
			                            function.or_more ? " or more" : "", function.arguments() == 1 ? "" : "s",
			                            arguments));
		return function.arguments() == 1 ? applied(at, function.operation, result) : result;
	}

	// A folded constant must be a finite number.
	int applied(std::size_t at, Operation operation, int a, int b = kNone)
	{
		const int node = tree_.apply(operation, a, b);
		if (tree_.isNumber(node) && !std::isfinite(tree_.nodes()[node].number))
			return fail(at, "this has no finite value");
		return node;
	}

	bool closes(std::size_t opening)
	{
		if (take(')'))
			return true;
		fail(at_, at_ == text_.size() ? fmt::format("expected \")\" for the \"(\" in column {}", column(opening))
		                              : fmt::format("expected an operator or \")\", not {}", tokenHere()));
		return false;
	}

	int failOperand()
	{
		const char* const wanted = "expected a number, a variable, a function or \"(\"";
		if (last_ != '\0')
			return fail(at_, fmt::format("{} after \"{}\"", wanted, last_));
		return fail(at_, wanted);
	}

	int fail(std::size_t at, const std::string& reason)
	{
		if (!error_)
			error_ = Error{ErrorKind::usage, fmt::format("column {}: {}", column(at), reason)};
		return kNone;
	}

	// From 1, in characters: the bytes within a character of UTF-8 do not count.
	std::size_t column(std::size_t at) const
	{
		const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; };
		return 1 + static_cast<std::size_t>(std::count_if(text_.begin(), text_.begin() + at, begins));
	}

	char peek() const { return at_ < text_.size() ? text_[at_] : '\0'; }

	void skipSpace()
	{
		while (at_ < text_.size() && isSpace(text_[at_]))
			++at_;
	}

	void advance(std::size_t characters)
	{
		at_ += characters;
		skipSpace();
	}

	bool take(char c)
	{
		if (peek() != c || at_ == text_.size())
			return false;
		last_ = c;
		advance(1);
		return true;
	}

	std::string_view nameHere() const
	{
		std::size_t end = at_;
		while (end < text_.size() && (isNameStart(text_[end]) || isDigit(text_[end])))
			++end;
		return text_.substr(at_, end - at_);
	}

	// For a message: one line whatever is in the text.
	std::string quoted(std::size_t at, std::size_t length) const
	{
		constexpr std::size_t kShown = 32;
		return fmt::format("\"{}{}\"", text_.substr(at, std::min(length, kShown)), length > kShown ? "..." : "");
	}

	std::string tokenHere() const
	{
		const char c = peek();
		if (isNameStart(c))
			return quoted(at_, nameHere().size());
		if (c > ' ' && c <= '~')
			return quoted(at_, 1);
		return fmt::format("the byte 0x{:02X}", static_cast<unsigned char>(c));
	}

	struct Nesting
	{
		explicit Nesting(int& level) : depth(level) { ++depth; }
		~Nesting() { --depth; }
		int& depth;
	};

	std::string_view text_;
	std::size_t at_ = 0;
	char last_ = '\0'; // taken: an operator, "(", "," or "="
	int depth_ = 0;
	ExpressionTree tree_;
	std::optional<Error> error_;
};

} // namespace

Result<ParsedExpression> parseExpression(std::string_view text)
{
	return Parser(text).parse();
}

} // namespace vp::surface
