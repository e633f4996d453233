"""Progress and abort: both reach the filter while the library works on a thread of its own.
usage: pvbatch progress.py"""
import paraview.simple as simple
from shared import area_of, check, counts_of, finish, load

load(globals())
half = 40
image = simple.Wavelet(WholeExtent=[-half, half] * 3)
probe = VolumeProbe(Input=simple.Tetrahedralize(Input=image))  # noqa: F821, from the plugin
probe.Origin, probe.Normal = (0, 0, 0), (0.3, 0.5, 0.8)
area = area_of(probe)  # the second cut builds the neighbors of 2.5 million cells, which takes a while
heard = []
aborts = [True]


def listen(caller, event):
    heard.append(caller.GetProgressText() or '')
    if aborts[0]:
        caller.SetAbortExecute(1)


filter_itself = probe.SMProxy.GetClientSideObject()
observer = filter_itself.AddObserver('ProgressEvent', listen)
probe.Origin = (1, 0, 0)
probe.UpdatePipeline()
texts = {text for text in heard if text}
check(len(texts) > 0, f'{len(heard)} reports of progress: {sorted(texts)}')
check(counts_of(probe)[1] == 0, 'aborted before the neighbors were there')
aborts[0] = False
filter_itself.SetAbortExecute(0)
probe.Origin = (2, 0, 0)
check(area_of(probe) > 0.5 * area and counts_of(probe)[:2] == [1, 1], f'the filter works on: {counts_of(probe)}')
finish()
