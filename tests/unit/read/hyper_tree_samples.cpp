#include "hyper_tree_samples.h"

#include <vtkHyperTreeGrid.h>
#include <vtkNew.h>
#include <vtkRandomHyperTreeGridSource.h>
#include <vtkXMLHyperTreeGridWriter.h>

std::size_t writeTrees(const std::string& path)
{
	vtkNew<vtkRandomHyperTreeGridSource> source;
	source->SetDimensions(4, 3, 5);
	source->SetOutputBounds(0.0, 3.0, 0.0, 2.0, 0.0, 4.0);
	source->SetSeed(7);
	source->SetMaxDepth(4);
	source->SetSplitFraction(0.4);
	vtkNew<vtkXMLHyperTreeGridWriter> writer;
	writer->SetInputConnection(source->GetOutputPort());
	writer->SetFileName(path.c_str());
	writer->Write();
	return static_cast<std::size_t>(
	    vtkHyperTreeGrid::SafeDownCast(source->GetOutputDataObject(0))->GetNumberOfLeaves());
}
