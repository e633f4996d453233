// The vertices of a cell of any kind. What includes this has kCells, the array `cells`, a `sheet` with the lattice and the
// starts of the case tables, and says what a vertex is:
//   void fetchPoint(uint v, uint id)                                     vertex v of the cell is point `id`
//   AxisShare fetchShare(uint axis, uint index)                          of a coordinate of an axis (kCellsAxes)
//   void setCorner(uint v, uint id, AxisShare x, AxisShare y, AxisShare z)  the point of three coordinates

// With inverse = floor((2^32 - 1) / divisor) the product is at most one too small. Software devices divide slowly.
uint divide(uint value, uint divisor, uint inverse)
{
	uint high, low;
	umulExtended(value, inverse, high, low);
	return value - high * divisor >= divisor ? high + 1u : high;
}

// Fetches the cell's vertices. Returns where its shape's cases start, and the number of vertices; 0 for a polyhedron.
uint fetchCell(uint cell, out uint case_start)
{
	case_start = sheet.table_start[3];
	if (kCells == kCellsAxes || kCells == kCellsLattice)
	{
		const uint row = divide(cell, sheet.cells_i, sheet.inverse_i);
		const uint i = cell - row * sheet.cells_i;
		const uint k = divide(row, sheet.cells_j, sheet.inverse_j);
		const uint j = row - k * sheet.cells_j;
		const uint p = k * sheet.points_layer + j * sheet.points_i + i;
		const uint next_row = sheet.points_i;
		const uint next_layer = sheet.points_layer;
		if (kCells == kCellsAxes)
		{
			const AxisShare x0 = fetchShare(0u, i), x1 = fetchShare(0u, i + 1u);
			const AxisShare y0 = fetchShare(1u, j), y1 = fetchShare(1u, j + 1u);
			const AxisShare z0 = fetchShare(2u, k), z1 = fetchShare(2u, k + 1u);
			setCorner(0u, p, x0, y0, z0);
			setCorner(1u, p + 1u, x1, y0, z0);
			setCorner(2u, p + 1u + next_row, x1, y1, z0);
			setCorner(3u, p + next_row, x0, y1, z0);
			setCorner(4u, p + next_layer, x0, y0, z1);
			setCorner(5u, p + 1u + next_layer, x1, y0, z1);
			setCorner(6u, p + 1u + next_row + next_layer, x1, y1, z1);
			setCorner(7u, p + next_row + next_layer, x0, y1, z1);
		}
		else
		{
			fetchPoint(0u, p);
			fetchPoint(1u, p + 1u);
			fetchPoint(2u, p + 1u + next_row);
			fetchPoint(3u, p + next_row);
			fetchPoint(4u, p + next_layer);
			fetchPoint(5u, p + 1u + next_layer);
			fetchPoint(6u, p + 1u + next_row + next_layer);
			fetchPoint(7u, p + next_row + next_layer);
		}
		return 8u;
	}
	if (kCells == kCellsRecord4)
	{
		const uvec4 ids = VP_WORDS(cells, cell);
		case_start = sheet.table_start[0];
		fetchPoint(0u, ids.x);
		fetchPoint(1u, ids.y);
		fetchPoint(2u, ids.z);
		fetchPoint(3u, ids.w);
		return 4u;
	}
	const uvec4 first = VP_WORDS(cells, 2u * cell);
	const uvec4 second = VP_WORDS(cells, 2u * cell + 1u);
	const uint shape = second.w >= kShapeMark ? second.w - kShapeMark : 3u;
	if (shape > 3u)
		return 0u;
	case_start = sheet.table_start[shape];
	const uint vertices = shape == 3u ? 8u : 4u + shape; // tetrahedron, pyramid, wedge
	fetchPoint(0u, first.x);
	fetchPoint(1u, first.y);
	fetchPoint(2u, first.z);
	fetchPoint(3u, first.w);
	if (vertices > 4u)
		fetchPoint(4u, second.x);
	if (vertices > 5u)
		fetchPoint(5u, second.y);
	if (vertices > 6u)
	{
		fetchPoint(6u, second.z);
		fetchPoint(7u, second.w);
	}
	return vertices;
}
