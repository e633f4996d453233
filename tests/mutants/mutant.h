// Included before every source file of the mutated copy (mutants.py). VPROBE_MUTANT=N turns mutant N on, and
// VPROBE_MUTANTS_REACHED=FILE marks in a file, a byte each, which mutants a run has come by.
#pragma once
#if __cplusplus > 201703L // CMake tries the compiler with an older language

#include <cstdlib>
#include <type_traits>

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

namespace vp_mutants
{

constexpr unsigned long kMaxMutants = 4096;

inline unsigned char* reachedMarks()
{
	static unsigned char nobody_asks[kMaxMutants];
	const char* name = std::getenv("VPROBE_MUTANTS_REACHED");
	const int file = name ? open(name, O_RDWR | O_CREAT | O_CLOEXEC, 0666) : -1;
	if (file < 0 || ftruncate(file, kMaxMutants) != 0)
		return nobody_asks;
	void* mapped = mmap(nullptr, kMaxMutants, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
	close(file);
	return mapped == MAP_FAILED ? nobody_asks : static_cast<unsigned char*>(mapped);
}

inline int chosenMutant()
{
	const char* number = std::getenv("VPROBE_MUTANT");
	return number ? std::atoi(number) : 0;
}

// They come first in every file, so tables that are made at the start are mutated too.
inline const int chosen = chosenMutant();
inline unsigned char* const reached = reachedMarks();

// The compiler evaluates some at once; those stay as they are.
constexpr bool mutant(int n)
{
	if (std::is_constant_evaluated())
		return false;
	reached[n] = 1;
	return chosen == n;
}

// A comparison `a < b` becomes `a < Less(17) > b`: so no one needs to find where its sides begin and end.
template <class Operator, class A>
struct LeftSide
{
	const A& a;
	int n;
};

#define VP_MUTATED(Name, first, second, op, turned)                                                                    \
	struct Name                                                                                                        \
	{                                                                                                                  \
		constexpr explicit Name(int number) : n(number) {}                                                             \
		int n;                                                                                                         \
	};                                                                                                                 \
	template <class A>                                                                                                 \
	constexpr LeftSide<Name, A> operator first(const A& a, Name name)                                                  \
	{                                                                                                                  \
		return {a, name.n};                                                                                            \
	}                                                                                                                  \
	template <class A, class B>                                                                                        \
	constexpr auto operator second(const LeftSide<Name, A>& left, const B& b)                                          \
	{                                                                                                                  \
		return mutant(left.n) ? left.a turned b : left.a op b;                                                         \
	}

VP_MUTATED(Less, <, >, <, <=)
VP_MUTATED(LessOrSame, <, >, <=, <)
VP_MUTATED(More, <, >, >, >=)
VP_MUTATED(MoreOrSame, <, >, >=, >)
VP_MUTATED(Same, ==, ==, ==, !=)
VP_MUTATED(Other, ==, ==, !=, ==)
#undef VP_MUTATED

} // namespace vp_mutants

#endif
