#include "read/manifest.h"
#include "read/protocol.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <numeric>

#include <sys/stat.h>
#include <unistd.h>

using namespace vp;
using namespace vp::read;
using nlohmann::json;
namespace fs = std::filesystem;

namespace
{

// A folder with a file of 24 floats 0, 1, 2 …, and a manifest of an image of 4 x 3 x 2 points whose array stays in it.
class StoredArray : public testing::Test
{
protected:
	StoredArray()
	{
		fs::create_directories(folder_ / "elsewhere");
		input_ = (folder_ / "values.mhd").string();
		for (const fs::path& file : {fs::path(input_), folder_ / "values.raw", folder_ / "elsewhere/values.raw"})
			writeValues(file);
		place_ = {{"file", input_}, {"part", {4, 2, 1}}, {"swaps", false}, {"offset", 0}};
	}
	~StoredArray() override { fs::remove_all(folder_); }

	static void writeValues(const fs::path& file)
	{
		std::vector<float> values(24);
		std::iota(values.begin(), values.end(), 0.0f);
		std::ofstream(file, std::ios::binary).write(reinterpret_cast<const char*>(values.data()), 96);
	}

	template <class T>
	json array(const char* type, const std::vector<T>& values)
	{
		bytes_.resize((bytes_.size() + 63) / 64 * 64);
		const std::size_t offset = bytes_.size();
		bytes_.resize(offset + values.size() * sizeof(T));
		std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
		return {{"type", type}, {"offset", offset}, {"bytes", values.size() * sizeof(T)}};
	}

	// The same array in chunks of 4 x 2 x 2: two of 64 bytes, of which the second reaches beyond the array.
	void takeChunks(const std::vector<std::uint64_t>& offsets)
	{
		place_.erase("offset");
		place_["part"] = {4, 2, 2};
		place_["offsets"] = array("uint64", offsets);
		place_["fill"] = array<std::uint8_t>("uint8", {0, 0, 128, 63}); // 1.0f
	}

	Result<CheckedInput> check()
	{
		json field = {{"name", "f"}, {"association", "point"}, {"components", 1}, {"type", "float32"}};
		field["stored"] = place_;
		json block = {{"name", ""}, {"kind", kind_}, {"points", {4, 3, 2}}};
		block["origin"] = {0.0, 0.0, 0.0};
		block["spacing"] = {1.0, 1.0, 1.0};
		block["arrays"] = json::array({field});
		if (kind_ == "curvilinear")
			block["coordinates"] = array("float32", std::vector<float>(72, 0.5f));
		const json manifest = {{"version", kProtocolVersion},
		                       {"times", json::array()},
		                       {"left_out", 0},
		                       {"warnings", json::array()},
		                       {"blocks", json::array({block})}};
		const auto copy = std::make_shared<std::vector<std::byte>>(bytes_);
		const SharedBytes shared = {copy, {copy->data(), copy->size()}};
		return checkManifest(manifest.dump(), shared, shared, input_, follow_);
	}

	double valueAt(std::size_t point)
	{
		const auto checked = check();
		EXPECT_TRUE(checked) << checked.error().message;
		return checked ? checked->blocks.at(0).fields.at(0).value(point, 0) : -1.0;
	}

	void expectRefused(const char* what)
	{
		const auto checked = check();
		EXPECT_FALSE(checked) << what;
		EXPECT_TRUE(checked || checked.error().kind == ErrorKind::input) << what;
	}

	const fs::path folder_ = fs::path(testing::TempDir()) / ("stored_array." + std::to_string(getpid()));
	std::string input_;
	std::string follow_;
	std::string kind_ = "image";
	json place_;

private:
	std::vector<std::byte> bytes_;
};

} // namespace

TEST_F(StoredArray, IsReadWhereItIsAskedFor)
{
	EXPECT_EQ(valueAt(0), 0.0);
	EXPECT_EQ(valueAt(23), 23.0);
	takeChunks({0, 32}); // so that both lie within 96 bytes
	EXPECT_EQ(valueAt(0), 0.0);
	EXPECT_EQ(valueAt(8), 8.0);   // (0, 2, 0), the first of the second chunk
	EXPECT_EQ(valueAt(12), 8.0);  // (0, 0, 1): behind the 8 values of the first layer of its chunk
	EXPECT_EQ(valueAt(20), 16.0); // (0, 2, 1): the same in the second chunk, which begins with 8
	place_["swaps"] = true;
	EXPECT_NE(valueAt(8), 8.0);
}

TEST_F(StoredArray, HasItsFillValueWhereNothingWasWritten)
{
	takeChunks({0, ~std::uint64_t(0)});
	EXPECT_EQ(valueAt(7), 7.0);
	EXPECT_EQ(valueAt(8), 1.0);
}

TEST_F(StoredArray, MustLieWithinItsFile)
{
	place_["offset"] = 4;
	expectRefused("one value too far");
	place_["offset"] = ~std::uint64_t(0);
	expectRefused("an offset that overflows");
	takeChunks({0, 33});
	expectRefused("a chunk that ends behind the file");
	takeChunks({0});
	expectRefused("too few chunks");
	takeChunks({0, 1, 2});
	expectRefused("too many chunks");
}

TEST_F(StoredArray, MustHavePartsThatCanBe)
{
	for (const json& part : {json{4, 0, 1}, json{3, 2, 1}, json{4, 2, 2}, json{4, 2}, json{4, 2, -1}, json("all"),
	                         json{4, 1u << 31, 1u << 31}})
	{
		place_["part"] = part;
		expectRefused(part.dump().c_str());
	}
	takeChunks({0, 32});
	place_["part"] = {1u << 20, 1u << 20, 1};
	expectRefused("chunks larger than there may be");
}

TEST_F(StoredArray, IsFoundByReadersThatAreKnown)
{
	place_.erase("offset");
	place_["part"] = {4, 2, 2};
	for (const char* reader : {"hdf5 0 /f", "tiff 0 0", "zarr "})
	{
		place_["reader"] = reader;
		EXPECT_TRUE(check()) << reader; // which is not started before somebody asks for a value
	}
	for (const std::string& reader : {std::string("hdf50 0 /f"), std::string("hdf5"), std::string("n5 0"),
	                                  std::string(), std::string("hdf5 0 /f\0", 10)})
	{
		place_["reader"] = reader;
		expectRefused(reader.c_str());
	}
}

TEST_F(StoredArray, MustBeOfALatticeWithStraightAxes)
{
	kind_ = "curvilinear";
	expectRefused("a curvilinear grid");
}

TEST_F(StoredArray, MayLieInFilesThatTheReaderMayReadAlone)
{
	place_["file"] = (folder_ / "values.raw").string();
	EXPECT_EQ(valueAt(5), 5.0);
	place_["file"] = (folder_ / "elsewhere/../elsewhere/values.raw").string();
	EXPECT_EQ(valueAt(5), 5.0);
	const fs::path outside = folder_.string() + ".outside";
	writeValues(outside);
	for (const std::string& name : {outside.string(), (folder_ / "absent.raw").string(), std::string("/etc/passwd"),
	                                (folder_ / "elsewhere").string()})
	{
		place_["file"] = name;
		expectRefused(name.c_str());
	}
	fs::create_symlink(outside, folder_ / "link.raw");
	place_["file"] = (folder_ / "link.raw").string();
	expectRefused("a link that leads outside");
	follow_ = outside.parent_path().string();
	EXPECT_EQ(valueAt(5), 5.0) << "the user has opened that folder";
	follow_.clear();
	fs::remove(outside);
	ASSERT_EQ(mkfifo((folder_ / "pipe").c_str(), 0600), 0);
	place_["file"] = (folder_ / "pipe").string();
	expectRefused("a pipe, which would wait");
	// A format whose files name no others has its own file alone.
	input_ = (folder_ / "values.npy").string();
	writeValues(input_);
	place_["file"] = (folder_ / "values.raw").string();
	expectRefused("a file beside one that names no others");
}
