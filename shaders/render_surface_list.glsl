// Blends a pixel's list of surface fragments, the nearest first. Fragments are taken from the list in batches. A batch
// has the nearest fragments behind the batch before, so a list of any length is sorted. Fragments of equal depth are
// sorted by their surface's number and then by color. So the order in which the device made them has no effect.

const uint kBatch = 4u;
const float kOpaque = 1.0 - 1.0 / 4096.0; // nothing behind can be seen

// A fragment: its place and the bits of its depth, which sort like positive floats; its color; its order. Without a fragment the
// depth is 0.
uvec4 batch[kBatch];
uint batch_left;
uint list_head;
uvec4 list_end; // the nearest fragment of opaque surfaces

// There are no branches, since software executes both sides.
bool isBefore(uvec4 a, uvec4 b)
{
	const uint by_color = uint(a.z < b.z) | (uint(a.z == b.z) & uint(a.x < b.x));
	const uint by_order = uint(a.w < b.w) | (uint(a.w == b.w) & by_color);
	return (uint(a.y > b.y) | (uint(a.y == b.y) & by_order)) != 0u;
}

// Moves the farther ones back. Indices are constant, so the batch is registers.
void insert(uvec4 found)
{
	for (uint i = 0u; i < kBatch; ++i)
	{
		const bool swap = isBefore(found, batch[i]);
		const uvec4 farther = swap ? batch[i] : found;
		batch[i] = swap ? found : batch[i];
		found = farther;
	}
}

// The nearest fragments behind `last`: those before it are blended already.
void fetchBatch(uvec4 last)
{
	for (uint i = 0u; i < kBatch; ++i)
		batch[i] = uvec4(0u);
	batch_left = kBatch;
	for (uint place = list_head; place != 0u;)
	{
		const uvec4 f = texelFetch(fragments, int(place - 1u));
		const uvec4 found = uvec4(place, f.yzw);
		place = f.x;
		insert(isBefore(last, found) ? found : uvec4(0u));
	}
	if ((kFeatures & kComposeOpaque) != 0u)
		insert(isBefore(last, list_end) ? list_end : uvec4(0u));
}

void beginList(ivec2 pixel)
{
	list_head = imageLoad(heads, pixel).x;
	list_end = uvec4(0u);
	if ((kFeatures & kComposeOpaque) != 0u)
	{
		const uvec2 nearest = texelFetch(opaque, pixel, 0).xy;
		list_end = uvec4(0u, floatBitsToUint(texelFetch(opaque_depths, pixel, 0).x), nearest.x, nearest.y << 16 | 0xFFFFu);
	}
	fetchBatch(uvec4(0u, 0xFFFFFFFFu, 0u, 0u)); // nearer than all
}

// Blends fragments that are nearer than `depth`, and the line at its place.
void surfacesDownTo(float depth)
{
	while (front.a < kOpaque)
	{
		const uvec4 f = batch[0];
		const float here = uintBitsToFloat(f.y);
		if (here <= depth || f.y == 0u)
			return;
		lineDownTo(here);
		under(vec3(f.z & 1023u, f.z >> 10 & 1023u, f.z >> 20 & 1023u) / 1023.0, float(f.w & 0xFFFFu) / 65535.0);
		for (uint i = 0u; i + 1u < kBatch; ++i)
			batch[i] = batch[i + 1u];
		batch[kBatch - 1u] = uvec4(0u);
		if (--batch_left == 0u)
			fetchBatch(f);
	}
}
