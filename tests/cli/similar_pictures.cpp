#include "similar_pictures.h"

#include "png_pixels.h"

#include <cstdlib>
#include <vector>

namespace cli
{

testing::AssertionResult areSimilar(const std::string& path, const std::string& other_path)
{
	constexpr int kApart = 2;
	const Pixels a = readPixels(path);
	const Pixels b = readPixels(other_path);
	if (a.rgba.empty() || a.width != b.width || a.rgba.size() != b.rgba.size())
		return testing::AssertionFailure() << path << " and " << other_path << ": not of one size";
	std::size_t apart = 0;
	for (std::size_t i = 0; i < a.rgba.size(); i += 4)
	{
		bool is_apart = false;
		for (std::size_t c = i; c < i + 4; ++c)
			is_apart = is_apart || std::abs(a.rgba[c] - b.rgba[c]) > kApart;
		apart += is_apart;
	}
	const std::size_t pixels = a.rgba.size() / 4;
	if (apart * 1000 <= pixels)
		return testing::AssertionSuccess();
	return testing::AssertionFailure() << path << " and " << other_path << ": " << apart << " of " << pixels
	                                   << " pixels are apart";
}

} // namespace cli
