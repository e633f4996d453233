#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shared/render_types.h"

// Lists the marked triangles of a surface in their order, as indices of their corners: of equal depths the first counts, so the order
// must not depend on threads. One group takes them all, a thread a run of words.
layout(local_size_x = kKeptGroupSize) in;
layout(binding = 0) uniform usamplerBuffer kept; // which software reads right in a loop, unlike a storage buffer
layout(binding = 1, scalar) writeonly buffer Indices
{
	uint indices[];
};
layout(binding = 2, scalar) writeonly buffer Draws
{
	IndexedDraw draws[];
};
layout(push_constant, scalar) uniform Push
{
	SurfaceCullPush push;
};

shared uint counts[kKeptGroupSize];

void main()
{
	const uint thread = gl_LocalInvocationID.x;
	const uint words = (push.count + 31u) / 32u;
	const uint each = (words + kKeptGroupSize - 1u) / kKeptGroupSize;
	const uint begin = min(thread * each, words);
	const uint end = min(begin + each, words);
	uint count = 0u;
	for (uint w = begin; w < end; ++w)
		count += uint(bitCount(texelFetch(kept, int(push.first_word + w)).x));
	counts[thread] = count;
	barrier();
	uint place = 0u;
	for (uint i = 0u; i < kKeptGroupSize; ++i)
		place += i < thread ? counts[i] : 0u;
	if (thread == kKeptGroupSize - 1u)
		draws[push.draw] = IndexedDraw(3u * (place + count), 1u, push.first_index, 0u, 0u);
	for (uint w = begin; w < end; ++w)
	{
		uint bits = texelFetch(kept, int(push.first_word + w)).x;
		while (bits != 0u)
		{
			const uint corner = 3u * (32u * w + uint(findLSB(bits)));
			const uint to = push.first_index + 3u * place;
			indices[to] = corner;
			indices[to + 1u] = corner + 1u;
			indices[to + 2u] = corner + 2u;
			bits &= bits - 1u;
			++place;
		}
	}
}
