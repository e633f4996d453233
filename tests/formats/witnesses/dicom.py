#!/usr/bin/env python3
"""DICOM files in many spellings, written and read by pydicom, and read by vprobe.

usage: dicom.py VPROBE [FIRST-SEED COUNT]

Series of single pictures, enhanced images, RT dose, nuclear medicine, float maps and segmentations, with frames in any
order. The values (after pydicom's modality LUT) and places of the points that vprobe converts are compared with those
of the pictures, one by one. A few are held against dcm2niix and nibabel too, by place: dcm2niix turns rows round.
Seeds make the files, so a failure repeats. VPROBE_LONG asks for 500. Exit code 77 where pydicom or VTK's module is
missing; dcm2niix and gdcmconv (which packs) are left out where they are missing.

Where vprobe follows the standard and not pydicom: bits outside of BitsStored are no part of a value, and dose is
multiplied by DoseGridScaling.
"""
import json
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import warnings

try:
    import numpy
    import pydicom
    from pydicom.dataset import Dataset, FileMetaDataset
    from pydicom.pixel_data_handlers.util import apply_modality_lut
    from pydicom.sequence import Sequence
    from pydicom.uid import (DeflatedExplicitVRLittleEndian, ExplicitVRBigEndian, ExplicitVRLittleEndian,
                             ImplicitVRLittleEndian, RLELossless, generate_uid)
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLGenericDataObjectReader
except ImportError as error:
    print(f'left out: {error}')
    sys.exit(77)

from common import how_many

VPROBE = sys.argv[1]
PLAIN = [ImplicitVRLittleEndian, ExplicitVRLittleEndian, ExplicitVRBigEndian, DeflatedExplicitVRLittleEndian]
PACKED = {'gdcmconv --jpeg': ('u1', 'u2'), 'gdcmconv --jpegls': ('u1', 'u2', 'i2'), 'gdcmconv --j2k': ('u1', 'u2', 'i2')}
CT, ENHANCED_CT, ENHANCED_MR = (f'1.2.840.10008.5.1.4.1.1.{kind}' for kind in ('2', '2.1', '4.1'))
DOSE, NUCLEAR, FLOAT_MAP = (f'1.2.840.10008.5.1.4.1.1.{kind}' for kind in ('481.2', '20', '30'))
SEGMENTATION, ULTRASOUND = (f'1.2.840.10008.5.1.4.1.1.{kind}' for kind in ('66.4', '3.1'))


def item(**values):
    made = Dataset()
    for name, value in values.items():
        setattr(made, name, value)
    return made


def short(number):
    """As text of at most 16 bytes."""
    return f'{number:.10g}'


class Picture:
    """One frame as it is meant: its values and where its first pixel lies; key tells apart what is in one place."""

    def __init__(self, stored, values, origin, key=0):
        self.stored, self.values, self.origin, self.key = stored, values, numpy.array(origin), key


class Spelling:
    """What one input holds, apart from how it is written."""

    def __init__(self, seed):
        self.random = random.Random(f'dicom {seed}')
        self.numbers = numpy.random.default_rng(self.random.randrange(1 << 30))
        pick = self.random.choice
        self.columns, self.rows, self.slices = (self.random.randint(2, 6) for _ in range(3))
        self.spacing = numpy.array([pick([0.5, 1.0, 1.25]), pick([0.75, 2.0])])  # of rows, of columns
        self.axes = self.make_axes()
        self.normal = numpy.cross(self.axes[0], self.axes[1])
        self.origin = numpy.round(self.numbers.uniform(-100, 100, 3), 3)
        self.step = pick([1.0, 2.5, 0.3])
        self.offsets = self.step * numpy.arange(self.slices)
        self.type = pick(['u1', 'u2', 'i2', 'u2', 'i2'])
        self.syntax = pick(PLAIN + [RLELossless])
        self.pack, self.is_plain = None, False  # plain: as dcm2niix keeps it in one volume
        self.stored_bits = self.high_bit = int(self.type[1]) * 8
        if self.type != 'u1' and self.random.random() < 0.4:
            self.stored_bits = self.high_bit = 12
            if self.syntax != RLELossless and self.random.random() < 0.3:
                self.high_bit = pick([12, 14, 16])
        self.high_bit -= 1

    def make_axes(self):
        kind = self.random.choice(['axial', 'axial', 'sagittal', 'flipped', 'oblique'])
        if kind == 'oblique':
            turned, _ = numpy.linalg.qr(self.numbers.normal(size=(3, 3)))
            row, column = numpy.round(turned[0], 8), numpy.round(turned[1], 8)
            return numpy.array([row, column])
        return numpy.array({'axial': [[1, 0, 0], [0, 1, 0]], 'sagittal': [[0, 1, 0], [0, 0, -1]],
                            'flipped': [[-1, 0, 0], [0, 1, 0]]}[kind], float)

    def make_values(self):
        """Values within the bits that are stored."""
        low, high = (-(1 << self.stored_bits - 1), (1 << self.stored_bits - 1) - 1) if self.type[0] == 'i' else \
            (0, (1 << self.stored_bits) - 1)
        return self.numbers.integers(low, high + 1, (self.rows, self.columns))

    def bits_of(self, values):
        """As they are stored: in their bits, with others' bits around them."""
        bits = int(self.type[1]) * 8
        mask = (1 << self.stored_bits) - 1
        shift = self.high_bit + 1 - self.stored_bits
        words = (values & mask) << shift
        if self.stored_bits < bits and self.syntax != RLELossless and self.pack is None:
            rest = ((1 << bits) - 1) & ~(mask << shift)
            words |= self.numbers.integers(0, 1 << bits, values.shape) & rest
        elif self.type[0] == 'i':
            words = values & ((1 << bits) - 1)
        return words.astype('u' + self.type[1])

    def place(self, offset):
        return self.origin + offset * self.normal

    def dataset(self, kind, modality):
        data = Dataset()
        data.SOPClassUID, data.SOPInstanceUID = kind, generate_uid()
        data.SeriesInstanceUID, data.StudyInstanceUID = generate_uid(), generate_uid()
        data.PatientID, data.PatientName, data.Modality = '1', 'A', modality
        data.StudyDate, data.StudyTime, data.SeriesNumber = '20200101', '120000', 1
        data.Rows, data.Columns, data.SamplesPerPixel = self.rows, self.columns, 1
        data.PhotometricInterpretation = self.random.choice(['MONOCHROME2', 'MONOCHROME2', 'MONOCHROME1'])
        data.BitsAllocated = int(self.type[1]) * 8
        data.BitsStored, data.HighBit = self.stored_bits, self.high_bit
        data.PixelRepresentation = int(self.type[0] == 'i')
        data.InstanceNumber = 1
        return data

    def put_place(self, data, origin):
        data.PixelSpacing = [short(distance) for distance in self.spacing]
        data.ImageOrientationPatient = [short(x) for x in self.axes.ravel()]
        data.ImagePositionPatient = [short(x) for x in origin]

    def save(self, data, stored, path):
        """stored: words of all frames."""
        big = self.syntax == ExplicitVRBigEndian
        data.is_little_endian, data.is_implicit_VR = not big, self.syntax == ImplicitVRLittleEndian
        data.file_meta = FileMetaDataset()
        data.file_meta.MediaStorageSOPClassUID = data.SOPClassUID
        data.file_meta.MediaStorageSOPInstanceUID = data.SOPInstanceUID
        words = stored.astype(stored.dtype.newbyteorder('>' if big else '<')).tobytes()
        data.add_new(0x7fe00010, 'OB' if stored.itemsize == 1 and not data.is_implicit_VR else 'OW',
                     words + b'\0' * (len(words) % 2))
        plain = ExplicitVRLittleEndian if self.syntax == RLELossless else self.syntax
        data.file_meta.TransferSyntaxUID = plain
        if self.syntax == RLELossless:
            data.compress(RLELossless)
        data.save_as(path, write_like_original=False)
        if self.pack:
            subprocess.run([*self.pack.split(), path, path], check=True, capture_output=True)


def make_series(spelling, folder):
    """Files of single pictures, in any order; perhaps several in one place, and those of another series."""
    s, pick, chance = spelling, spelling.random.choice, spelling.random.random
    packings = [pack for pack, types in PACKED.items() if s.type in types and s.high_bit + 1 == s.stored_bits]
    if packings and chance() < 0.25 and shutil.which('gdcmconv'):
        s.pack, s.syntax = pick(packings), ExplicitVRLittleEndian
        s.columns, s.rows = s.columns + 32, s.rows + 32  # JPEG 2000 halves them five times
        if s.stored_bits not in (8, 16):
            s.stored_bits = s.high_bit = 16
            s.high_bit -= 1
    lean = 0 if s.is_plain else pick([0, 0, 0.3])  # of a gantry
    rescale = pick(['none', 'one', 'intercept'] if s.is_plain else ['none', 'one', 'intercept', 'each', 'whole', 'table'])
    told = pick([None, None, None, 'TemporalPositionIdentifier', 'AcquisitionNumber', 'EchoTime', 'TriggerTime', 'number'])
    keys = range(pick([2, 3])) if told else [0]
    series, frame_of_reference = generate_uid(), generate_uid()
    pictures, names = [], [f'{i:03}.dcm' for i in range(len(keys) * s.slices)]
    s.random.shuffle(names)
    numbers = list(range(1, len(names) + 1))
    table = s.numbers.integers(0, 1 << 16, 64)
    for key in keys:
        for k in range(s.slices):
            data = s.dataset(CT, 'CT')
            data.SeriesInstanceUID, data.FrameOfReferenceUID = series, frame_of_reference
            at = len(pictures)
            data.InstanceNumber = numbers[at] if told == 'number' else numbers[-1 - at] if key else 7
            if s.is_plain:
                data.InstanceNumber = k + 1
            data.AcquisitionTime = f'1200{key:02}.{k:03}'
            if told and told != 'number':
                setattr(data, told, str(5 * key + 1))
            origin = numpy.round(s.place(s.offsets[k]) + lean * s.offsets[k] * s.axes[1], 6)
            s.put_place(data, origin)
            values = s.make_values()
            if rescale == 'one':
                data.RescaleSlope, data.RescaleIntercept = '0.5', '-100.25'
            elif rescale == 'intercept':
                data.RescaleSlope, data.RescaleIntercept = '1', '-1024'
            elif rescale == 'each':
                data.RescaleSlope, data.RescaleIntercept = short(s.numbers.uniform(0.1, 3)), short(s.numbers.uniform(-9, 9))
            elif rescale == 'whole':
                data.RescaleSlope, data.RescaleIntercept = str(k % 3 + 1), str(10 * k)
            elif rescale == 'table':
                first = pick([0, 3])
                data.ModalityLUTSequence = Sequence([item(ModalityLUTType='US')])
                data.ModalityLUTSequence[0].add_new(0x00283002, 'SS' if s.type[0] == 'i' else 'US', [64, first, 16])
                data.ModalityLUTSequence[0].add_new(0x00283006, 'US', [int(x) for x in table])
            stored = s.bits_of(values)
            path = folder / names[at]
            s.save(data, stored, path)
            read = pydicom.dcmread(path)
            if not s.pack and s.stored_bits == int(s.type[1]) * 8:
                assert (read.pixel_array == values).all()
            pictures.append(Picture(stored, apply_modality_lut(values, read).astype(float),
                                    [float(x) for x in read.ImagePositionPatient], key))
    if chance() < 0.3:
        other = s.dataset(CT, 'CT')
        s.put_place(other, s.origin)
        s.save(other, s.bits_of(s.make_values()), folder / 'other.dcm')
    if chance() < 0.3:
        (folder / 'notes.txt').write_text('no picture')
    return (folder if chance() < 0.5 else folder / names[0]), pictures


def make_enhanced(spelling, path):
    """Frames in functional groups, of their own or shared, in any order."""
    s, pick, chance = spelling, spelling.random.choice, spelling.random.random
    if chance() < 0.25 and s.slices > 2 and not s.is_plain:
        s.offsets = numpy.cumsum(s.numbers.uniform(0.5, 3, s.slices))
    told = pick([None, None, 'TemporalPositionIndex', 'echo', 'dimension'])
    keys = range(pick([2, 3])) if told else [0]
    wanted = [(key, k) for key in keys for k in range(s.slices)]
    s.random.shuffle(wanted)
    data = s.dataset(ENHANCED_CT if told != 'echo' else ENHANCED_MR, 'CT' if told != 'echo' else 'MR')
    data.NumberOfFrames = len(wanted)
    shared, frames, pictures, words = Dataset(), [], [], []
    measures = item(PixelSpacing=[short(x) for x in s.spacing], SliceThickness='9')
    turn = item(ImageOrientationPatient=[short(x) for x in s.axes.ravel()])
    rescale = pick(['none', 'shared'] if s.is_plain else ['none', 'shared', 'each', 'whole'])
    one = item(RescaleSlope='2', RescaleIntercept='-3.5', RescaleType='US')
    if rescale == 'shared':
        shared.PixelValueTransformationSequence = Sequence([one])
    own_axes, own_measures = chance() < 0.3, chance() < 0.3
    if not own_axes:
        shared.PlaneOrientationSequence = Sequence([turn])
    if not own_measures:
        shared.PixelMeasuresSequence = Sequence([measures])
    data.DimensionIndexSequence = Sequence([item(DimensionIndexPointer=0x00209057, FunctionalGroupPointer=0x00209111)])
    if told:
        data.DimensionIndexSequence.append(item(DimensionIndexPointer={
            'TemporalPositionIndex': 0x00209128, 'echo': 0x00189082, 'dimension': 0x00089007}[told]))
    for key, k in wanted:
        frame = Dataset()
        content = item(StackID='1', InStackPositionNumber=k + 1)
        content.DimensionIndexValues = [k + 1, key + 1] if told else k + 1
        if told == 'TemporalPositionIndex':
            content.TemporalPositionIndex = key + 1
        if told == 'echo':
            frame.MREchoSequence = Sequence([item(EffectiveEchoTime=10.0 + 5 * key)])
        frame.FrameContentSequence = Sequence([content])
        origin = [short(x) for x in s.place(s.offsets[k])]
        frame.PlanePositionSequence = Sequence([item(ImagePositionPatient=origin)])
        slope, intercept = 1.0, 0.0
        if rescale == 'each':
            slope, intercept = (float(short(x)) for x in s.numbers.uniform(-2, 2, 2))
        elif rescale == 'whole':
            slope, intercept = float(pick([1, 2])), float(pick([0, -50]))
        if rescale in ('each', 'whole'):
            frame.PixelValueTransformationSequence = Sequence(
                [item(RescaleSlope=short(slope), RescaleIntercept=short(intercept), RescaleType='US')])
        if own_axes:
            frame.PlaneOrientationSequence = Sequence([turn])
        if own_measures:
            frame.PixelMeasuresSequence = Sequence([measures])
        frames.append(frame)
        values = s.make_values()
        words.append(s.bits_of(values))
        pictures.append(Picture(words[-1], values, [float(x) for x in origin], key))
    data.SharedFunctionalGroupsSequence = Sequence([shared])
    data.PerFrameFunctionalGroupsSequence = Sequence(frames)
    s.save(data, numpy.array(words), path)
    read = pydicom.dcmread(path)
    for f, picture in enumerate(pictures):
        for groups in (read.PerFrameFunctionalGroupsSequence[f], read.SharedFunctionalGroupsSequence[0]):
            if 'PixelValueTransformationSequence' in groups:
                picture.values = apply_modality_lut(picture.values, groups.PixelValueTransformationSequence[0])
                break
    return path, pictures


def make_dose(spelling, path):
    s, pick = spelling, spelling.random.choice
    s.type = pick(['u2', 'u4'])
    s.stored_bits = int(s.type[1]) * 8
    s.high_bit = s.stored_bits - 1
    if s.syntax == RLELossless:
        s.syntax = ExplicitVRLittleEndian
    if pick([True, False]) and s.slices > 2:
        s.offsets = numpy.cumsum(s.numbers.integers(1, 4, s.slices)).astype(float)
    s.offsets = (s.offsets - s.offsets[0]) * pick([1, -1])
    data = s.dataset(DOSE, 'RTDOSE')
    data.NumberOfFrames, data.FrameIncrementPointer = s.slices, 0x3004000c
    data.DoseUnits, data.DoseType, data.DoseSummationType = 'GY', 'PHYSICAL', 'PLAN'
    scaling = pick(['0.001', '1', '1.2345e-5'])
    data.DoseGridScaling = scaling
    s.put_place(data, s.origin)
    is_axial = abs(abs(s.normal[2]) - 1) < 1e-9
    absolute = is_axial and pick([True, False])
    offsets = s.origin[2] + s.offsets * s.normal[2] if absolute else s.offsets
    data.GridFrameOffsetVector = [short(x) for x in offsets]
    words = numpy.array([s.make_values() for _ in range(s.slices)]).astype(s.type)
    s.save(data, words, path)
    read = pydicom.dcmread(path).pixel_array
    return path, [Picture(words[k], read[k].astype(float) * float(scaling), s.place(s.offsets[k]))
                  for k in range(s.slices)]


def make_nuclear(spelling, path):
    s, pick = spelling, spelling.random.choice
    told = pick([None, 'EnergyWindowVector', 'TimeSlotVector', 'DetectorVector'])
    keys = [0, 1] if told else [0]
    sign = pick([1, -1])
    wanted = [(key, k) for key in keys for k in range(s.slices)]
    s.random.shuffle(wanted)
    data = s.dataset(NUCLEAR, 'NM')
    data.ImageType = ['ORIGINAL', 'PRIMARY', 'RECON GATED TOMO' if told else 'RECON TOMO', 'EMISSION']
    data.NumberOfFrames = len(wanted)
    data.PixelSpacing = [short(x) for x in s.spacing]
    data.SpacingBetweenSlices, data.SliceThickness = short(sign * s.step), '7'
    data.SliceVector = [k + 1 for _, k in wanted]
    data.FrameIncrementPointer = 0x00540080
    if told:
        setattr(data, told, [key + 1 for key, _ in wanted])
        tag = pydicom.datadict.tag_for_keyword(told)
        data.FrameIncrementPointer = [tag, 0x00540080]
    places = item(ImagePositionPatient=[short(x) for x in s.origin],
                  ImageOrientationPatient=[short(x) for x in s.axes.ravel()])
    data.DetectorInformationSequence = Sequence([places])
    values = [s.make_values() for _ in wanted]
    words = numpy.array([s.bits_of(each) for each in values])
    s.save(data, words, path)
    return path, [Picture(words[f], values[f].astype(float), s.place(sign * s.offsets[k]), key)
                  for f, (key, k) in enumerate(wanted)]


def make_map(spelling, path):
    """Float pixels, or segments of one bit, in functional groups."""
    s, pick = spelling, spelling.random.choice
    s.syntax = pick(PLAIN)
    is_map = pick([True, False])
    data = s.dataset(FLOAT_MAP if is_map else SEGMENTATION, 'OT' if is_map else 'SEG')
    order = s.random.sample(range(s.slices), s.slices)
    data.NumberOfFrames = s.slices
    shape = (s.slices, s.rows, s.columns)
    if is_map:
        kind = pick(['f4', 'f8'])
        del data.BitsStored, data.HighBit, data.PixelRepresentation
        data.BitsAllocated = int(kind[1]) * 8
        values = s.numbers.normal(size=shape).astype(kind)
    else:
        data.BitsAllocated, data.BitsStored, data.HighBit, data.PixelRepresentation = 1, 1, 0, 0
        data.SegmentationType = 'BINARY'
        values = s.numbers.integers(0, 2, shape)
    data.SharedFunctionalGroupsSequence = Sequence([item(
        PlaneOrientationSequence=Sequence([item(ImageOrientationPatient=[short(x) for x in s.axes.ravel()])]),
        PixelMeasuresSequence=Sequence([item(PixelSpacing=[short(x) for x in s.spacing], SliceThickness='1')]))])
    origins = [[short(x) for x in s.place(s.offsets[k])] for k in order]
    data.PerFrameFunctionalGroupsSequence = Sequence(
        [item(PlanePositionSequence=Sequence([item(ImagePositionPatient=origin)])) for origin in origins])
    words = numpy.packbits(values.astype('u1').ravel(), bitorder='little')
    s.save(data, words, path)
    if is_map:
        big = s.syntax == ExplicitVRBigEndian
        del data.PixelData
        bytes_ = values.astype(('>' if big else '<') + kind).tobytes()
        data.add_new(0x7fe00008 if kind == 'f4' else 0x7fe00009, 'OF' if kind == 'f4' else 'OD', bytes_)
        data.save_as(path, write_like_original=False)
    read = pydicom.dcmread(path).pixel_array
    assert (read == values).all()
    return path, [Picture(None, read[f].astype(float), [float(x) for x in origins[f]]) for f in range(s.slices)]


def convert(path, folder, time):
    out = folder / 'out.vtm'
    done = subprocess.run([VPROBE, 'convert', path, '-o', out, '--time', time], capture_output=True, encoding='utf-8')
    assert done.returncode == 0, done.stderr
    reader = vtkXMLGenericDataObjectReader()
    reader.SetFileName(str(next((folder / 'out').iterdir())))
    reader.Update()
    data = reader.GetOutput()
    points = numpy.array([data.GetPoint(i) for i in range(data.GetNumberOfPoints())])
    return points, vtk_to_numpy(data.GetPointData().GetArray('DICOM')), data.GetClassName(), done.stderr


def compare(spelling, path, pictures, folder):
    s = spelling
    keys = sorted({picture.key for picture in pictures})
    index = s.random.randrange(len(keys))
    points, values, kind, notes = convert(path, folder, f'#{index}')
    chosen = sorted((p for p in pictures if p.key == keys[index]), key=lambda p: p.origin @ s.normal)
    ys, xs = numpy.meshgrid(numpy.arange(s.rows) * s.spacing[0], numpy.arange(s.columns) * s.spacing[1], indexing='ij')
    plane = xs.reshape(-1, 1) * s.axes[0] + ys.reshape(-1, 1) * s.axes[1]
    places = numpy.concatenate([p.origin + plane for p in chosen])
    assert points.shape == places.shape, (points.shape, places.shape, notes)
    off = numpy.abs(points - places).max()
    assert off < 2e-5 + 0.01 * s.step * (kind == 'vtkImageData' and s.step < 1e-3), f'places are off by {off} ({kind})'
    wanted = numpy.concatenate([p.values.ravel() for p in chosen])
    near = numpy.isclose(values.astype(float), wanted, rtol=1e-12, atol=1e-12)
    assert near.all(), ('values', values[~near][:4], wanted[~near][:4], values.dtype)


def compare_with_dcm2niix(path, folder):
    """Values at places, whatever the order."""
    import nibabel
    out = folder / 'nifti'
    out.mkdir()
    subprocess.run(['dcm2niix', '-b', 'n', '-z', 'n', '-o', out, path], capture_output=True)
    made = [nibabel.load(file) for file in out.iterdir()]
    assert len(made) == 1, f'dcm2niix made {len(made)} volumes'
    data = made[0].get_fdata()
    indices = numpy.indices(data.shape).reshape(3, -1).T
    places = indices @ made[0].affine[:3, :3].T + made[0].affine[:3, 3]
    places[:, :2] *= -1  # from left and back to right and front
    points, values, _, _ = convert(path, folder, 'last')
    assert len(points) == len(places), (len(points), data.shape)
    for point, value in zip(points, values):
        distances = numpy.abs(places - point).max(axis=1)
        nearest = distances.argmin()
        assert distances[nearest] < 1e-3, ('dcm2niix has nothing at', point)
        assert abs(data.ravel()[nearest] - value) <= 1e-5 * max(1, abs(value)), (point, data.ravel()[nearest], value)


KINDS = [make_series, make_enhanced, make_dose, make_nuclear, make_map]


def try_seed(seed, folder):
    spelling = Spelling(seed)
    make = KINDS[seed % len(KINDS)]
    target = folder / 'input'
    if make is make_series:
        target.mkdir()
    else:
        target = folder / 'input.dcm'
    path, pictures = make(spelling, target)
    (folder / 'made').mkdir()
    compare(spelling, path, pictures, folder / 'made')
    return path


def niix_sample(folder):
    """A plain series and an enhanced image, in any order, which dcm2niix reads too."""
    for make, name in ((make_series, 'series'), (make_enhanced, 'enhanced')):
        for seed in range(1000):
            spelling = Spelling(f'niix {seed}')
            spelling.syntax, spelling.type, spelling.stored_bits, spelling.high_bit = ExplicitVRLittleEndian, 'i2', 16, 15
            spelling.columns = spelling.rows = 6
            spelling.slices = 4
            spelling.offsets = spelling.step * numpy.arange(4)
            spelling.is_plain = True
            target = folder / f'{name}-{seed}'
            target.mkdir()
            _, pictures = make(spelling, target if make is make_series else target / 'enhanced.dcm')
            if spelling.pack is None and len({p.key for p in pictures}) == 1 and not (target / 'other.dcm').exists():
                break
        (folder / name).mkdir()
        compare_with_dcm2niix(target, folder / name)


def plain_spelling():
    """Three pictures of 5 by 4 pixels, 1 apart, along the axes from 0 on."""
    s = Spelling('by hand')
    s.rows, s.columns, s.slices, s.type, s.stored_bits, s.high_bit = 4, 5, 3, 'u2', 16, 15
    s.syntax, s.axes, s.normal, s.spacing = ExplicitVRLittleEndian, numpy.eye(3)[:2], numpy.eye(3)[2], numpy.ones(2)
    s.origin = numpy.zeros(3)
    return s


def write_frames(path, kind, modality, values, **attributes):
    """A file of many frames; each frame has one value."""
    s = plain_spelling()
    data = s.dataset(kind, modality)
    data.NumberOfFrames, data.PixelSpacing = len(values), [1, 1]
    for name, value in attributes.items():
        setattr(data, name, value)
    s.save(data, numpy.repeat(numpy.array(values, 'u2'), 20).reshape(-1, 4, 5), path)
    return path


def frame(z, stack='1', axes=(1, 0, 0, 0, 1, 0), **groups):
    made = item(PlanePositionSequence=Sequence([item(ImagePositionPatient=[0, 0, z])]),
                PlaneOrientationSequence=Sequence([item(ImageOrientationPatient=list(axes))]),
                FrameContentSequence=Sequence([item(StackID=stack)]))
    for name, value in groups.items():
        setattr(made, name, Sequence([item(**value)]))
    return made


def write_enhanced(path, values, frames):
    shared = item(PixelMeasuresSequence=Sequence([item(PixelSpacing=[1, 1])]))
    return write_frames(path, ENHANCED_MR, 'MR', values, SharedFunctionalGroupsSequence=Sequence([shared]),
                        PerFrameFunctionalGroupsSequence=Sequence(frames))


def figures(path, *options):
    """Of a sheet across the frames: area, mean and what is told; or the exit code and the line."""
    done = subprocess.run([VPROBE, 'slice', path, '--normal', 'x', '--origin', '2', '2', '0.5', '--stats', '-', *options],
                          capture_output=True, encoding='utf-8')
    if done.returncode:
        return done.returncode, done.stderr
    sheet = json.loads(done.stdout)['sheets'][0]
    return round(sheet['area'], 9), round(sheet['mean'], 9), done.stderr


def by_hand(folder):
    """Frames of one value each, 3 mm wide: the area is 3 times their distance, the mean by the trapezoids."""
    def one(name):
        return folder / f'{name}.dcm'

    area, mean, _ = figures(write_enhanced(one('shuffled'), [30, 10, 20], [frame(6), frame(0), frame(2)]))
    assert (area, mean) == (18, round((2 * 15 + 4 * 25) / 6, 9)), (area, mean)
    slopes = [{'PixelValueTransformationSequence': {'RescaleSlope': str(k), 'RescaleIntercept': '1'}} for k in (1, 2, 4)]
    area, mean, _ = figures(write_enhanced(one('slopes'), [10, 10, 10], [frame(k, **slopes[k]) for k in range(3)]))
    assert (area, mean) == (6, 1 + (15 + 30) / 2), (area, mean)
    dose = {'GridFrameOffsetVector': [0, -1, -3], 'FrameIncrementPointer': 0x3004000c, 'DoseGridScaling': '0.5',
            'ImagePositionPatient': [0, 0, 4], 'ImageOrientationPatient': [1, 0, 0, 0, 1, 0]}
    area, mean, _ = figures(write_frames(one('dose'), DOSE, 'RTDOSE', [2, 4, 8], **dose))
    assert (area, mean) == (9, round((1.5 + 2 * 3) / 3, 9)), (area, mean)
    area, mean, _ = figures(write_frames(one('absolute'), DOSE, 'RTDOSE', [2, 4, 8],
                                         **dose | {'GridFrameOffsetVector': [4, 3, 1]}))
    assert (area, mean) == (9, round((1.5 + 2 * 3) / 3, 9)), (area, mean)

    heart = write_enhanced(one('heart'), [1, 1, 5, 5], [
        frame(z, CardiacSynchronizationSequence={'NominalCardiacTriggerDelayTime': float(t)})
        for t in (0, 250) for z in (0, 2)])
    about = json.loads(subprocess.run([VPROBE, 'info', heart, '--json'], capture_output=True, encoding='utf-8').stdout)
    assert about['times'] == [0, 0.25] and about['time_units'] == 's', about
    assert figures(heart, '--time', '0.05')[:2] == (6, 1) and figures(heart, '--time', '0.25')[:2] == (6, 5)
    echoes = write_enhanced(one('echoes'), [1, 5, 1, 5], [frame(z, MREchoSequence={'EffectiveEchoTime': float(echo)})
                                                          for z in (0, 2) for echo in (10, 20)])
    area, mean, told = figures(echoes, '--time', '#0')
    assert (area, mean) == (6, 1) and 'differ in echo time' in told, (area, mean, told)
    stacks = write_enhanced(one('stacks'), [1, 3, 9, 9, 9], [frame(0, 'a'), frame(1, 'a')] + [
        frame(z, 'b', (1, 0, 0, 0, 0, 1)) for z in (0, 1)] + [frame(2, 'a')])
    area, mean, told = figures(stacks)
    assert (area, mean) == (6, 4) and 'largest of 2 stacks' in told, (area, mean, told)

    for path, words in [
            (write_enhanced(one('ragged'), [1, 2, 3], [frame(0), frame(0), frame(1)]), 'not equally many'),
            (write_enhanced(one('turned'), [1, 2], [frame(0), frame(1, axes=(0, 1, 0, 0, 0, 1))]), 'several directions'),
            (write_frames(one('film'), ULTRASOUND, 'US', [1, 2], FrameTime='40', FrameIncrementPointer=0x00181063),
             'times of one picture'),
            (write_frames(one('views'), NUCLEAR, 'NM', [1, 2], ImageType='ORIGINAL\\PRIMARY\\TOMO',
                          AngularViewVector=[1, 2], FrameIncrementPointer=0x00540090), 'projections'),
            (write_frames(one('palette'), CT, 'OT', [1, 2], PhotometricInterpretation='PALETTE COLOR'), 'palette')]:
        code, line = figures(path)[:2]
        assert code == 2 and words in line and line.count('\n') == 1, (path, code, line)
    damaged_packing(folder)


def damaged_packing(folder):
    """A frame that ends early is no zeros."""
    s = plain_spelling()
    s.syntax = RLELossless
    path = folder / 'packed.dcm'
    data = s.dataset(CT, 'CT')
    data.NumberOfFrames, data.PixelSpacing, data.SpacingBetweenSlices = 2, [1, 1], '1'
    s.save(data, numpy.arange(40, dtype='u2').reshape(2, 4, 5) * 999, path)
    assert figures(path)[0] == 3
    read = pydicom.dcmread(path)
    frames = list(pydicom.encaps.generate_pixel_data_frame(read.PixelData, 2))
    read.PixelData = pydicom.encaps.encapsulate([frames[0], frames[1][:80]])
    read.save_as(path)
    code, line = figures(path)[:2]
    assert code == 2 and 'do not unpack' in line, (code, line)
    if not shutil.which('gdcmconv'):
        return
    s.syntax, s.rows, s.columns = ExplicitVRLittleEndian, 8, 8  # gdcmconv crashes at smaller ones
    data.Rows = data.Columns = 8
    s.save(data, numpy.arange(128, dtype='u2').reshape(2, 8, 8) * 99, path)
    subprocess.run(['gdcmconv', '--j2k', path, path], check=True, capture_output=True)
    assert figures(path)[0] == 7, figures(path)
    read = pydicom.dcmread(path)
    frames = list(pydicom.encaps.generate_pixel_data_frame(read.PixelData, 2))
    short, other = frames[1][:-20], frames[1].replace((8).to_bytes(4, 'big'), (9).to_bytes(4, 'big'), 1)
    for damaged in (short, short + b'\xff\xd9', other):  # cut, its end in the middle, another size
        read.PixelData = pydicom.encaps.encapsulate([frames[0], damaged])
        read.save_as(path)
        code, line = figures(path)[:2]
        assert code == 2 and 'do not unpack' in line, (code, line)


def main():
    warnings.simplefilter('ignore')
    first, count = (int(word) for word in sys.argv[2:4]) if len(sys.argv) > 3 else \
        (1, how_many())
    failed = 0
    for seed in range(first, first + count):
        with tempfile.TemporaryDirectory(prefix='vprobe-dicom-') as folder:
            try:
                try_seed(seed, pathlib.Path(folder))
            except AssertionError as error:
                failed += 1
                print(f'seed {seed} ({KINDS[seed % len(KINDS)].__name__}): FAILED: {error}')
    with tempfile.TemporaryDirectory(prefix='vprobe-dicom-') as folder:
        by_hand(pathlib.Path(folder))
    print(f'{count - failed} of {count} files as their writers meant them')
    if shutil.which('dcm2niix'):
        with tempfile.TemporaryDirectory(prefix='vprobe-dicom-') as folder:
            niix_sample(pathlib.Path(folder))
        print('places and values as dcm2niix has them')
    return 1 if failed else 0


if __name__ == '__main__':
    sys.exit(main())
