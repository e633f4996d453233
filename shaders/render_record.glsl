// Polygon records read as texels, five of four words each: software reads those faster than a storage buffer.
layout(binding = 0) uniform usamplerBuffer records;

const int kRecordTexels = 5;

// Its cell and the number of its vertices.
uvec2 recordHead(int record)
{
	const uvec4 texel = texelFetch(records, record * kRecordTexels);
	return uvec2(texel.x, texel.y & kRecordVertices);
}

// kHiddenRecordEdge << i: the edge from vertex i to the next one is not drawn.
uint hiddenEdges(int record)
{
	return texelFetch(records, record * kRecordTexels).y;
}

// (u, v) of a vertex.
vec2 recordPlace(int record, uint vertex)
{
	const uvec4 texel = texelFetch(records, record * kRecordTexels + int((vertex + 1u) >> 1));
	return uintBitsToFloat((vertex & 1u) == 0u ? texel.zw : texel.xy);
}
