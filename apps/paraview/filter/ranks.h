#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

class vtkMultiProcessController;

namespace vprobe_paraview
{

// What the ranks of a server tell each other. Each call is collective: all ranks make it, in the same order.
class Ranks
{
public:
	explicit Ranks(vtkMultiProcessController* controller) : controller_(controller) {}

	int count() const;
	bool isFirst() const;
	std::uint64_t sum(std::uint64_t value) const;
	double largest(double value) const;
	// low x, high x, low y ...; of nothing the low is above the high.
	std::array<double, 6> unionOf(std::array<double, 6> bounds) const;
	// The text of the first rank that has one, with its number where not all have one.
	std::string first(const std::string& text) const;

private:
	std::vector<double> reduce(std::vector<double> values, int operation) const;

	vtkMultiProcessController* controller_;
};

} // namespace vprobe_paraview
