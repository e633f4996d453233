"""The report of the tests by pytest, which names those that were skipped."""
import os
import pathlib
import xml.sax.saxutils

outcomes = {}


def name_of(node):
    """The file's name without ending, and the test's, which may hold slashes and dots."""
    file, _, test = node.partition('::')
    return pathlib.PurePath(file).stem, test.replace('::', '.') or 'all'


def pytest_runtest_logreport(report):
    name = name_of(report.nodeid)
    verdict, seconds = outcomes.get(name, ('completed', 0.0))
    if report.failed:
        verdict = 'failed'
    elif report.skipped:
        verdict = 'skipped'
    outcomes[name] = verdict, seconds + report.duration


def pytest_collectreport(report):
    if report.skipped:  # a whole file, for want of a package
        outcomes[name_of(report.nodeid)] = 'skipped', 0.0


def pytest_sessionfinish():
    """The report that tests/run.sh counts, as GoogleTest's programs write it."""
    file = os.environ.get('VPROBE_GTEST_XML')
    if not file:
        return
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    with open(file, 'w', encoding='utf-8') as report:
        for (room, test), (verdict, seconds) in outcomes.items():
            quoted = xml.sax.saxutils.quoteattr(test)
            result = 'skipped' if verdict == 'skipped' else 'completed'
            report.write(f'<testcase name={quoted} classname="{room}" time="{seconds:.3f}" result="{result}">\n')
            if verdict == 'failed':
                report.write('<failure />\n')
            report.write('</testcase>\n')
