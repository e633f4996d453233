// All formats, in the order in which they are recognized. Each row is one format:
//
// VP_FORMAT(NAME, ENDINGS, WHAT, READ, BY, FILES, SIGN, PROGRAM, ROOM, FUNCTION)
//
// NAME is what --format takes. WHAT it is, what is READ of it, and BY what, stand in vprobe info --formats. FILES:
// alone, or linked to others, or with files beside it, or all of its folder. The reader's sandbox opens the folder of
// the input for all but the first. SIGN says whether a FileHead (apps/vprobe-read/checks/file_head.h) is one of the
// format. PROGRAM reads it by read FUNCTION() of ROOM: base is vprobe-read, more is vprobe-read-more. ROOM is a folder
// of apps/vprobe-read/formats, and the namespace of its code.

VP_FORMAT("raw", "", "raw volume, of the size and type that you give", "one array", "vprobe", alone, false, base,
          volumes, Raw)
VP_FORMAT("vtk-legacy", ".vtk", "VTK legacy, text and binary", "every kind of grid", "VTK", alone,
          head.starts("# vtk DataFile"), base, vtk, Legacy)
VP_FORMAT("vtk-xml", ".vti .vtr .vts .vtu .htg", "VTK XML", "every kind of grid; hidden cells; times; units",
          "vprobe, VTK", alone, head.isXmlOfVtk() && !head.namesFiles(), base, formats, AnyXml)
VP_FORMAT("vtk-xml-index", ".pvti .pvtr .pvts .pvtu .vtm .vthb .vth .pvd", "VTK XML that names other files",
          "pieces, blocks, AMR levels, times", "VTK", beside, head.isXmlOfVtk(), base, formats, AnyXml)
VP_FORMAT("openfoam", ".foam .openfoam", "OpenFOAM case, by a file in its folder", "regions; polyhedra; patches; times",
          "vprobe", folder, head.ends({".foam", ".openfoam"}), base, codes, Foam)
VP_FORMAT("nrrd", ".nrrd .nhdr", "NRRD", "orientation; components; times; units", "teem", beside, head.starts("NRRD"),
          base, volumes, Nrrd)
VP_FORMAT("nifti", ".nii .nii.gz .hdr", "NIfTI-1 and -2", "orientation; times; units; rescaled values", "VTK", beside,
          head.isNifti(), base, wrapped, Nifti)
VP_FORMAT("series", ".series", "ParaView's JSON list of files over time", "times", "vprobe", beside,
          head.ends({".series"}) && head.has("{"), base, vtk, Series)
VP_FORMAT("ensight", ".case .encas", "EnSight 6 and Gold, text and binary", "parts; polyhedra; times", "vprobe", beside,
          head.has("GEOMETRY") && head.has("FORMAT"), base, meshes, EnSight)
VP_FORMAT("cgns", ".cgns", "CGNS, ADF and HDF5", "bases and zones; polyhedra; times", "VTK", linked,
          head.isBefore("ADF Database", 32) || head.holds("CGNSLibraryVersion"), more, wrapped, Cgns)
VP_FORMAT("vtkhdf", ".vtkhdf .hdf", "VTKHDF 1 and 2",
          "image data and unstructured grids, also several; polyhedra; times", "vprobe, HDF5", linked,
          head.holds("VTKHDF"), more, vtk, Hdf)
VP_FORMAT("exodus", ".ex2 .e .exo .exii .g", "Exodus II, netCDF and HDF5",
          "element blocks; side sets; displacements; times", "VTK", alone,
          head.holds("num_nodes") && head.holds("num_dim"), more, wrapped, Exodus)
VP_FORMAT("metaimage", ".mhd .mha", "MetaImage, raw, text and compressed", "orientation; components; times; units",
          "vprobe", beside, head.ends({".mhd", ".mha"}) && head.has("NDims"), base, volumes, MetaImage)
VP_FORMAT("plot3d", ".xyz .x .g .p3d .bin", "PLOT3D, text and binary, with its solution",
          "grids; iblank; solution and function files", "VTK", beside, head.ends({".xyz", ".x", ".g", ".p3d", ".bin"}),
          more, wrapped, Plot3d)
VP_FORMAT("npy", ".npy", "NumPy array of three axes, or four with components", "one array", "vprobe", alone,
          head.starts("\x93NUMPY"), base, volumes, Npy)
VP_FORMAT("npz", ".npz", "NumPy archive, stored or deflated", "arrays of one shape", "vprobe", alone,
          head.ends({".npz"}) && head.starts("PK"), base, volumes, Npz)
VP_FORMAT("gmsh", ".msh", "Gmsh mesh, versions 1, 2 and 4, text and binary",
          "elements up to order 2; physical groups; node and element data; times", "vprobe", alone,
          head.starts("$MeshFormat") || head.starts("$NOD") || (head.starts("$Comments") && head.has("$MeshFormat")),
          base, meshes, Gmsh)
VP_FORMAT("zarr", ".zarr", "Zarr versions 2 and 3, a folder, of the CF conventions or OME-Zarr",
          "axes by their attributes; missing and packed values; packed chunks; shards; channels; times; units",
          "vprobe", folder,
          head.isFolder() && (head.holdsFile(".zgroup") || head.holdsFile(".zarray") || head.holdsFile("zarr.json")),
          more, volumes, Zarr)
VP_FORMAT("n5", ".n5", "N5, a folder: a data set, or a group with levels s0, s1 ...",
          "levels; packed blocks; spacing; units", "vprobe", folder,
          (head.isFolder() && head.holdsFile("attributes.json")) || (head.ends({"attributes.json"}) && head.has("{")),
          more, volumes, N5)
VP_FORMAT("slices", "", "volume in slices: TIFF or PNG files of a folder, or of a pattern in quotes: 'slices/*.tif'",
          "one array; spacing; units", "libtiff, VTK", folder, head.isOfSlices(), base, volumes, Slices)
VP_FORMAT("amrex", "", "AMReX and BoxLib plot files, a folder", "AMR levels; values at cells; time", "vprobe", folder,
          head.isFolder() && head.holdsFile("Header") && head.holdsFile("Level_0/Cell_H"), base, codes, Amrex)
// Before TIFF: a file may be both, with a TIFF header in the room that DICOM leaves.
VP_FORMAT("dicom", ".dcm .ima", "DICOM: a file of many frames, or a series, by its folder or one file",
          "orientation; rescaled values; times", "GDCM", beside, head.at(128, "DICM") || head.isFolder(), more, volumes,
          Dicom)
VP_FORMAT("mrc", ".mrc .map .ccp4 .rec .st", "MRC and CCP4 map", "order of axes; origin; stacks as times; units",
          "vprobe", alone, head.at(208, "MAP"), base, volumes, Mrc)
VP_FORMAT("tiff", ".tif .tiff", "TIFF stack, also of ImageJ and OME-TIFF", "channels; times; spacing; units", "libtiff",
          beside,
          head.starts("II*") || head.starts(std::string_view("MM\0*", 4)) || head.starts("II+") ||
              head.starts(std::string_view("MM\0+", 4)),
          base, volumes, Tiff)
VP_FORMAT("minc", ".mnc", "MINC 1 and 2", "orientation; rescaled values; times; units", "vprobe, HDF5, netCDF", alone,
          head.holds("minc-2.0") || (head.isNetcdf() && head.holds("image") && head.holds("zspace")), more, volumes,
          Minc)
VP_FORMAT("cam", "", "netCDF of the atmosphere model CAM, with the file of its quads", "layers between quads; times",
          "vprobe, netCDF", beside, head.holds("ncol") && head.holds("lev") && head.holds("lat"), more, codes, Cam)
VP_FORMAT("mpas", "", "netCDF of the models MPAS, over the cells of their mesh", "layers of prisms; times",
          "vprobe, netCDF", alone, head.holds("nCells") && head.holds("verticesOnCell") && head.holds("nVertLevels"),
          more, codes, Mpas)
VP_FORMAT("slac", ".ncdf", "SLAC meshes of accelerators (netCDF), with a file of modes",
          "volumes of tetrahedra; modes at points; time", "VTK, netCDF", beside,
          head.holds("tetrahedron_exterior") || head.holds("tetrahedron_interior"), more, codes, Slac)
VP_FORMAT("netcdf", ".nc .nc4 .cdf", "netCDF, classic and netCDF-4, of the CF conventions",
          "axes by their attributes; missing and packed values; times; units", "vprobe, netCDF", linked,
          head.isNetcdf() || head.holds("_NCProperties") || head.holds("Conventions"), more, volumes, Netcdf)
VP_FORMAT("med", ".med .rmed", "MED 3 and 4 (Salome, Code_Aster)",
          "meshes of linear cells; fields at nodes and cells; families; times; units", "vprobe, HDF5", alone,
          head.holds("ENS_MAA"), more, meshes, Med)
VP_FORMAT("tecplot", ".tec .tp .plt .dat", "Tecplot, text", "ordered and finite-element zones; values at cells; times",
          "vprobe", alone, head.isTecplot(), base, meshes, Tecplot)
VP_FORMAT("avs-ucd", ".inp .avs .ucd", "AVS UCD, text", "linear cells; node and cell data; units", "vprobe", alone,
          head.isUcd(), base, meshes, Ucd)
VP_FORMAT("avs-ucd-binary", ".inp .avs .ucd", "AVS UCD, binary", "linear cells; node and cell data; units", "vprobe",
          alone, head.isBinaryUcd(), base, meshes, UcdBinary)
VP_FORMAT("gambit", ".neu", "GAMBIT neutral file", "linear elements; groups", "vprobe", alone,
          head.has("** GAMBIT NEUTRAL FILE") || (head.has("CONTROL INFO") && head.has("NUMNP")), base, meshes, Gambit)
VP_FORMAT("fluent", ".cas .cas.gz .msh", "Fluent case and mesh, text and binary, with its data file",
          "cell zones; polyhedra; values at cells", "vprobe", beside,
          head.isFluent() || (head.starts("\x1f\x8b") && head.ends({".cas.gz", ".msh.gz"})), base, codes, Fluent)
VP_FORMAT("slc", ".slc", "VolVis volume, plain and packed", "one array; units", "vprobe", alone, head.isSlc(), base,
          volumes, Slc)
VP_FORMAT("segy", ".sgy .segy", "SEG-Y, revisions 0 to 2", "inlines and crosslines; missing traces hidden", "vprobe",
          alone, head.isSegy(), base, volumes, Segy)
VP_FORMAT("ls-dyna", "d3plot", "LS-DYNA d3plot, with the files of its states",
          "solids and thick shells; deleted elements hidden; times", "vprobe", beside, head.isD3plot(), base, codes,
          Lsdyna)
VP_FORMAT("fluent-hdf5", ".cas.h5", "Fluent case in HDF5, with its data file", "cell zones; polyhedra; values at cells",
          "vprobe, HDF5", beside, head.holds("meshes") && head.holds("settings"), more, codes, FluentHdf5)
VP_FORMAT("converge", ".h5", "CONVERGE CFD results (HDF5)", "streams; polyhedra; values at cells; time", "vprobe, HDF5",
          alone, head.holds("BOUNDARIES") && head.holdsLike("STREAM_"), more, codes, Converge)
VP_FORMAT("flash", "", "FLASH plot and checkpoint files (HDF5)", "leaf blocks of AMR; values at cells; time",
          "vprobe, HDF5", alone, head.holds("gid") && head.holds("unknown names"), more, codes, Flash)
VP_FORMAT("velodyne", ".xamr", "Velodyne results (HDF5)", "leaf boxes of AMR; values at cells; time", "vprobe, HDF5",
          alone, head.holds("AMR"), more, codes, Velodyne)
VP_FORMAT("enzo", ".hierarchy", "Enzo data, with the HDF5 files of its grids", "AMR levels; values at cells; time",
          "vprobe, HDF5", beside, head.has("GridStartIndex") && head.has("GridLeftEdge"), more, codes, Enzo)
VP_FORMAT("mfix", ".res", "MFIX case, with its files of values", "boxes and sectors; blanked cells; times; units",
          "vprobe", beside, head.starts("RES = "), base, codes, Mfix)
VP_FORMAT("xdmf", ".xdmf .xmf", "XDMF 2 and 3, with HDF5, binary and inline data",
          "lattices and unstructured grids; polyhedra; collections in space and time", "vprobe, HDF5", beside,
          head.has("<Xdmf"), more, meshes, Xdmf)
