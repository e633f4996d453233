// Feeds the program's own parsers with seeds and with damaged seeds. A crash names the seed and the case to repeat it.
#include "damage.h"
#include "parsers.h"
#include "probe/path_file.h"
#include "probe/presets.h"
#include "probe/probe_file.h"
#include "program_run.h"
#include "read/child.h"
#include "sample_files.h"
#include "view/state_file.h"

#include <fmt/format.h>

#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include <unistd.h>

namespace
{

std::string seed(char which, std::string contents)
{
	contents.insert(contents.begin(), which);
	return contents;
}

// Returns what the reader hands over of a file, as an input.
std::string manifestSeed(const std::string& file)
{
	const auto handed = vp::read::runReader(file, {}, *vp::read::inputLimits(file, ""));
	if (!handed)
		throw std::runtime_error(handed.error().message);
	const auto text = [](std::span<const std::byte> bytes)
	{ return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()); };
	const auto size = static_cast<std::uint32_t>(handed->arrays.bytes.size());
	std::string head(4, '\0');
	std::memcpy(head.data(), &size, 4);
	return seed('M', handed->manifest + '\0' + head + text(handed->arrays.bytes) + text(handed->cells.bytes));
}

// Text and bytes: places, corners, patches and fields.
std::vector<std::string> foamSeeds()
{
	const auto file = [](const std::string& format, const std::string& type, const std::string& body)
	{
		return "F/* x */ FoamFile\n{\n version 2.0;\n format " + format +
		       ";\n arch \"LSB;label=32;scalar=64\";\n class " + type + ";\n object grad(T);\n}\n// x\n" + body;
	};
	const std::string eight(8, '\x3f'), four("\0\0\0\0", 4), three("\3\0\0\0", 4), low("\1\0\0\0", 4);
	const std::string patches =
	    "boundaryField\n{\n a { type fixedValue; value uniform 2.5; }\n \"b.*\" { type empty; }\n"
	    " c { type zeroGradient; }\n d { $e; value $f; }\n";
	const std::string macros =
	    "#inputMode merge\nv 7;\nd { w $..v; e { x $:d.w; } }\n#ifeq $v 7\nT uniform ${v};\n#else\n#remove v\n#endif\n"
	    "#include \"none\"\n#includeIfPresent \"a\"\ninternalField $T;\nreferenceLevel 1;\nboundaryField\n{\n"
	    " wall { $:d; type noSlip; }\n \"(a|b).*\" { type fixedValue; value uniform #calc \"1+2\"; }\n"
	    " c #codeStream { code #{ return 1; #}; };\n g $wall;\n}\n";
	return {file("ascii", "vectorField", "2\n(\n(1 2.5 -3e5)\n(nan 0 1e400)\n)\n"),
	        file("binary", "vectorField", "1(" + eight + eight + eight + ")"),
	        file("ascii", "faceList", "2 (3(0 1 2) 4(0 1 2 3))"),
	        file("binary", "faceCompactList", "2(" + four + three + ")3(" + four + low + three + ")"),
	        file("ascii", "labelList", "3 ( 0 1 2 )"),
	        file("ascii", "labelList", "3{0}"),
	        file("ascii", "polyBoundaryMesh", "1 ( a { type wall; inGroups 1(wall); nFaces 3; startFace 4; } )"),
	        file("ascii", "volScalarField",
	             "dimensions [0 0 0 1 0 0 0];\ninternalField nonuniform List<scalar> 2(3 5);\n" + patches + "}\n"),
	        file("ascii", "volVectorField", "internalField nonuniform List<vector> 2{(3 5 7)};\n" + patches + "}\n"),
	        file("ascii", "volScalarField", macros),
	        file("binary", "pointScalarField",
	             "internalField nonuniform List<scalar> 1(" + eight + ");\n" + patches +
	                 " g { type h; x nonuniform List<scalar> 1(" + eight + "); value nonuniform List<scalar> 1(" +
	                 eight + "); }\n}\n")};
}

// Zones of points, of bricks that share and lack variables, and of polyhedra; a drawing between.
std::vector<std::string> tecplotSeeds()
{
	const std::string head = "VARIABLES = \"X\" \"Y\", \"Z\"\n \"V\"\n";
	const std::string cube = "0 1 1 0 0 1 1 0\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n";
	return {"D" + head + "ZONE I=2, J=1 K=1 F=POINT SOLUTIONTIME=1 STRANDID=1\n0 0 0 nan\n1 1.0-100 0 1D2\n",
	        "D" + head +
	            "TEXT T=\"a\" X=1\nZONE N=8 E=1 ZONETYPE=FEBRICK DATAPACKING=BLOCK VARLOCATION=([4]=CELLCENTERED)\n" +
	            cube +
	            "7\n1 2 3 4 5 6 7 8\nGEOMETRY T=LINE\n1\n2\n0 0\n1 1\nZONE N=8 E=1 ET=BRICK F=FEBLOCK "
	            "VARSHARELIST=([1-3]=1) PASSIVEVARLIST=[4] CONNECTIVITYSHAREZONE=1\n",
	        "D" + head +
	            "ZONE NODES=8 ELEMENTS=1 FACES=6 TOTALNUMFACENODES=24 ZONETYPE=FEPOLYHEDRON "
	            "VARLOCATION=(3*NODAL,CELLCENTERED)\n" +
	            cube + "7\n4 4 4 4 4 4\n1 4 3 2 5 6 7 8 1 2 6 5 2 3 7 6 3 4 8 7 4 1 5 8\n1 1 1 1 1 1\n0 0 0 0 0 0\n"};
}

// Settings, states, probes, paths and color maps, each with most of what it may have.
std::vector<std::string> jsonSeeds()
{
	using namespace vp;
	std::vector<std::string> seeds = {
	    "Orange 0 5\nlog true\ncolormap viridis\nnormal 0 0 1\nwindow 2 3\n",
	    "Osurface sphere:1.5\nthreshold -1 1\nopacity_points 0 0 1 1\nlines 5\nwindow_level 400 40\niso 0.5\n",
	    "Oprobe paddlewheel\nvanes 5\npath spin\nframes 30\ncamera 30,45\nsize 640x480\n",
	    R"(K{"Name":"a","ColorSpace":"Lab","NanColor":[1,0,0],"RGBPoints":[0,1,0,0,0.5,0,1,0,1,0,0,1],"Points":[0,0.5,0.5,0,1,1,0.5,0]})",
	    R"(K[{"Name":"b","IndexedColors":[1,0,0,0,1,0],"Annotations":["1","one","2","two"]}])",
	    R"(A{"path":"revolve","vanes":6})",
	    R"(J{"version":1,"input":{"files":["a.vtu"]},"probe":{"normal":[0,0,1]}})"};
	seeds.push_back(seed('B', probe::probeText(probe::trihedral({}))));
	view::ViewSpec spec;
	seeds.push_back(seed('J', view::stateText(spec, "state.json")));
	spec.input.files = {"a.vtu", "demo:shell"};
	spec.probe.own = probe::ProbeFile{probe::trihedral({}), true};
	spec.sweep.own.emplace().kind = probe::PathKind::spin;
	seeds.push_back(seed('J', view::stateText(spec, "state.json")));
	seeds.push_back(seed('A', probe::pathText(*spec.sweep.own)));
	return seeds;
}

std::vector<std::string> makeSeeds()
{
	std::vector<std::string> seeds = {"Tlast",
	                                  "T#3",
	                                  "T-2.5e-3",
	                                  "Ciso",
	                                  "C30,45",
	                                  "Ii=12.5",
	                                  "Ik=2..1e2",
	                                  "C1 2 3, 4 5 6, 0 0 1",
	                                  "Sx*x + y*y = 0.25*z",
	                                  "S-x^-3^2 * (sin(pi*y) - atan2(z, e)) / max(x, y, 1e-3)",
	                                  "Ssqrt(abs(ln(x) - pow(y, z))) + cosh(asin(x/7)) - hypot(tan(y), cbrt(z))"};
	const TemporaryFolder folder;
	for (const SampleFile& sample : sampleFiles())
	{
		const std::string file = folder / sample.name;
		sample.write(file);
		if (sample.name.starts_with("binary") || sample.name == "blocks.vtm")
			seeds.push_back(manifestSeed(file));
		const std::string ending = std::filesystem::path(file).extension().string();
		if (ending.starts_with(".vt") && ending != ".vtk")
			seeds.push_back(seed('X', fuzz::contentsOf(file)));
		else if (ending == ".vtk")
			seeds.push_back(seed('L', fuzz::contentsOf(file)));
		else if (ending == ".mhd" || ending == ".mha")
			seeds.push_back(seed('H', fuzz::contentsOf(file)));
		else if (ending == ".ex2")
			seeds.push_back(seed('N', fuzz::contentsOf(file)));
		else if (ending == ".xyz" || ending == ".x" || ending == ".bin" || ending == ".g" || ending == ".p3d")
			seeds.push_back(seed('P', fuzz::contentsOf(file)));
		else if (ending == ".case")
			seeds.push_back(
			    seed('E', fuzz::contentsOf(file) +
			                  "time set: 1\nnumber of steps: 1\nfilename start number: 0\ntime values: 0.5\n"));
	}
	for (auto& all : {foamSeeds(), tecplotSeeds(), jsonSeeds()})
		for (const std::string& each : all)
			seeds.push_back(each);
	seeds.push_back(seed('G', fuzz::contentsOf(folder / "gold.geo")));
	seeds.push_back(seed('V', fuzz::contentsOf(folder / "gold.f")));
	return seeds;
}

// Written by the signal's handler, so prepared before each input.
std::string at_hand;

void nameTheInput(int signal)
{
	[[maybe_unused]] const ssize_t written = write(STDERR_FILENO, at_hand.data(), at_hand.size());
	std::signal(signal, SIG_DFL);
	raise(signal);
}

void feed(const std::string& input, const std::string& name)
{
	at_hand = name;
	// Copied, so that reading past the end shows under a sanitizer.
	const std::vector<std::uint8_t> bytes(input.begin(), input.end());
	feedParser(bytes.data(), bytes.size());
}

void writeSeeds(const std::vector<std::string>& seeds, const std::string& folder)
{
	std::filesystem::create_directories(folder);
	for (std::size_t s = 0; s < seeds.size(); ++s)
		writeContents(fmt::format("{}/{}", folder, s), seeds[s]);
}

} // namespace

int main(int argc, char** argv)
{
	const std::string option = argc == 3 ? argv[1] : "";
	const std::string_view value = argc == 3 ? argv[2] : "";
	std::size_t first = 0;
	std::size_t end = 5000;
	if (option == "--case")
	{
		std::from_chars(value.data(), value.data() + value.size(), first);
		end = first + 1;
	}
	else if (option == "--cases")
		std::from_chars(value.data(), value.data() + value.size(), end);
	else if (argc != 1 && option != "--write-seeds")
	{
		fmt::print(stderr, "usage: fuzz_parsers [--cases N | --case NUMBER | --write-seeds FOLDER]\n");
		return 1;
	}
	for (const int signal : {SIGABRT, SIGSEGV, SIGBUS, SIGFPE, SIGILL})
		std::signal(signal, nameTheInput);

	const std::vector<std::string> seeds = makeSeeds();
	if (option == "--write-seeds")
		return writeSeeds(seeds, argv[2]), 0;
	for (std::size_t s = 0; s < seeds.size(); ++s)
		feed(seeds[s], fmt::format("FAILED: seed {}, undamaged\n", s));
	for (std::size_t number = first; number < end; ++number)
	{
		fuzz::Random random(1, number);
		std::string input = seeds[number % seeds.size()];
		const char which = input[0];
		const std::string done = fuzz::damage(input, random);
		if (input.empty())
			continue;
		input[0] = which;
		feed(input, fmt::format("FAILED: seed {} damaged ({}); again: fuzz_parsers --case {}\n", number % seeds.size(),
		                        done, number));
	}
	fmt::print("{} seeds and {} damaged ones\n", seeds.size(), end - first);
}
