#include "ranks.h"

#include <vtkCommunicator.h>
#include <vtkMultiProcessController.h>

namespace vprobe_paraview
{

int Ranks::count() const
{
	return controller_ ? controller_->GetNumberOfProcesses() : 1;
}

bool Ranks::isFirst() const
{
	return !controller_ || controller_->GetLocalProcessId() == 0;
}

std::vector<double> Ranks::reduce(std::vector<double> values, int operation) const
{
	if (count() == 1)
		return values;
	std::vector<double> reduced(values.size());
	controller_->AllReduce(values.data(), reduced.data(), static_cast<vtkIdType>(values.size()), operation);
	return reduced;
}

std::uint64_t Ranks::sum(std::uint64_t value) const
{
	return static_cast<std::uint64_t>(reduce({static_cast<double>(value)}, vtkCommunicator::SUM_OP)[0]);
}

double Ranks::largest(double value) const
{
	return reduce({value}, vtkCommunicator::MAX_OP)[0];
}

std::array<double, 6> Ranks::unionOf(std::array<double, 6> bounds) const
{
	// The largest of the high corners and of the low ones with the other sign.
	std::vector<double> corners;
	for (std::size_t a = 0; a < 3; ++a)
		corners.insert(corners.end(), {-bounds[2 * a], bounds[2 * a + 1]});
	corners = reduce(std::move(corners), vtkCommunicator::MAX_OP);
	for (std::size_t a = 0; a < 3; ++a)
	{
		bounds[2 * a] = -corners[2 * a];
		bounds[2 * a + 1] = corners[2 * a + 1];
	}
	return bounds;
}

std::string Ranks::first(const std::string& text) const
{
	if (count() == 1)
		return text;
	const double own = text.empty() ? count() : controller_->GetLocalProcessId();
	const int speaker = static_cast<int>(reduce({own}, vtkCommunicator::MIN_OP)[0]);
	if (speaker == count())
		return {};
	int length = static_cast<int>(text.size());
	controller_->Broadcast(&length, 1, speaker);
	std::string told(static_cast<std::size_t>(length), '\0');
	if (controller_->GetLocalProcessId() == speaker)
		told = text;
	controller_->Broadcast(told.data(), length, speaker);
	const bool is_everywhere = sum(text.empty() ? 0 : 1) == static_cast<std::uint64_t>(count());
	return (is_everywhere ? "" : "rank " + std::to_string(speaker) + ": ") + told;
}

} // namespace vprobe_paraview
