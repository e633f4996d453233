vec3 fromArray(float a[3])
{
	return vec3(a[0], a[1], a[2]);
}

// An array that is indexed by constants only stays in registers. pick() takes an entry from it by a variable index.
#define VP_PICK(type) \
	type pick(type a[8], uint v) \
	{ \
		const bool odd = (v & 1u) != 0u; \
		const bool upper = (v & 2u) != 0u; \
		const type low = upper ? (odd ? a[3] : a[2]) : (odd ? a[1] : a[0]); \
		const type high = upper ? (odd ? a[7] : a[6]) : (odd ? a[5] : a[4]); \
		return (v & 4u) != 0u ? high : low; \
	}
