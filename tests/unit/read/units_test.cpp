#include "read/read.h"
#include "sample_files.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkXMLImageDataWriter.h>

#include <algorithm>

using namespace vp;

namespace
{

grid::Block onlyBlockOf(const std::string& path)
{
	const auto set = read::readInputs({path}, {}, nullptr);
	EXPECT_TRUE(set) << (set ? "" : set.error().message);
	return set ? set->blocks.at(0) : grid::Block{};
}

void writeNrrdAbout(const std::string& path, const std::string& about)
{
	writeContents(path, "NRRD0005\ntype: float\ndimension: 3\nsizes: 2 2 2\nencoding: ascii\n" + about +
	                        "\n\n1 2 3 4 5 6 7 8\n");
}

} // namespace

TEST(Units, OfArraysComeFromVtksLabel)
{
	const TemporaryFolder folder;
	vtkNew<vtkImageData> image;
	image->SetDimensions(2, 2, 2);
	for (const char* name : {"T", "n"})
	{
		vtkNew<vtkDoubleArray> array;
		array->SetName(name);
		array->SetNumberOfValues(8);
		array->Fill(1.0);
		if (*name == 'T')
			array->GetInformation()->Set(vtkDataArray::UNITS_LABEL(), "K");
		image->GetPointData()->AddArray(array);
	}
	vtkNew<vtkXMLImageDataWriter> writer;
	writer->SetFileName((folder / "a.vti").c_str());
	writer->SetInputData(image);
	writer->Write();
	const grid::Block block = onlyBlockOf(folder / "a.vti");
	ASSERT_EQ(block.fields.size(), 2u);
	for (const grid::Field& field : block.fields)
		EXPECT_EQ(field.units, field.name == "T" ? "K" : "");
	EXPECT_EQ(block.length_units, "");
}

TEST(Units, OfLengthsComeFromNrrd)
{
	const TemporaryFolder folder;
	const std::string in_space = "space dimension: 3\nspace directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)";
	writeNrrdAbout(folder / "a.nrrd", in_space + "\nspace units: \"mm\" \"mm\" \"mm\"");
	EXPECT_EQ(onlyBlockOf(folder / "a.nrrd").length_units, "mm");
	writeNrrdAbout(folder / "b.nrrd", in_space + "\nspace units: \"mm\" \"mm\" \"m\"");
	EXPECT_EQ(onlyBlockOf(folder / "b.nrrd").length_units, "mm"); // lengths along z are converted
	EXPECT_EQ(onlyBlockOf(folder / "b.nrrd").bounds.hi, Vec3(1, 1, 1000));
	writeNrrdAbout(folder / "c.nrrd", "spacings: 1 1 1\nunits: \"cm\" \"cm\" \"cm\"");
	EXPECT_EQ(onlyBlockOf(folder / "c.nrrd").length_units, "cm");
	writeNrrdAbout(folder / "d.nrrd", in_space);
	EXPECT_EQ(onlyBlockOf(folder / "d.nrrd").length_units, "");
}

TEST(Units, OfLengthsComeFromNifti)
{
	const TemporaryFolder folder;
	const auto& samples = sampleFiles();
	const auto sample = std::ranges::find(samples, "turned.nii", &SampleFile::name);
	ASSERT_NE(sample, samples.end());
	const std::string path = folder / "a.nii";
	sample->write(path);
	std::string bytes = contentsOf(path);
	constexpr std::size_t kCode = 123; // xyzt_units of NIfTI-1's header
	constexpr char kSeconds = 8;
	for (const auto& [code, name] : {std::pair(0, ""), std::pair(1, "m"), std::pair(2, "mm"), std::pair(3, "µm")})
	{
		bytes.at(kCode) = static_cast<char>(code | kSeconds);
		writeContents(path, bytes);
		EXPECT_EQ(onlyBlockOf(path).length_units, name);
	}
}

TEST(Units, OfOtherFormats)
{
	const auto& samples = sampleFiles();
	// The array that has them, or none where they are those of lengths.
	for (const auto& [name, array, units] : {std::array{"fields.med", "f", "K"},
	                                         {"binary_ucd.inp", "f", "K"},
	                                         {"two.mnc", "", "mm"},
	                                         {"packed.slc", "", "mm"},
	                                         {"four.nc", "f", "K"}})
	{
		const TemporaryFolder folder;
		const auto sample = std::ranges::find(samples, name, &SampleFile::name);
		ASSERT_NE(sample, samples.end()) << name;
		sample->write(folder / name);
		const grid::Block block = onlyBlockOf(folder / name);
		if (*array == '\0')
		{
			EXPECT_EQ(block.length_units, units) << name;
		}
		for (const grid::Field& field : block.fields)
			if (field.name == array)
			{
				EXPECT_EQ(field.units, units) << name;
			}
	}
}
