"""The report of the tests by pytest, which names those that were skipped."""
import os
import pathlib
import xml.sax.saxutils

outcomes = {}


def pytest_runtest_logreport(report):
    name = report.nodeid.split('/')[-1].replace('.py::', '.').replace('::', '.')
    verdict, seconds = outcomes.get(name, ('completed', 0.0))
    if report.failed:
        verdict = 'failed'
    elif report.skipped:
        verdict = 'skipped'
    outcomes[name] = verdict, seconds + report.duration


def pytest_collectreport(report):
    if report.skipped:  # a whole file, for want of a package
        outcomes[report.nodeid.split('/')[-1].removesuffix('.py') + '.all'] = 'skipped', 0.0


def pytest_sessionfinish():
    """The report that tests/run.sh counts, as GoogleTest's programs write it."""
    file = os.environ.get('VPROBE_GTEST_XML')
    if not file:
        return
    pathlib.Path(file).parent.mkdir(parents=True, exist_ok=True)
    with open(file, 'w', encoding='utf-8') as report:
        for name, (verdict, seconds) in outcomes.items():
            room, test = name.split('.', 1)
            quoted = xml.sax.saxutils.quoteattr(test)
            result = 'skipped' if verdict == 'skipped' else 'completed'
            report.write(f'<testcase name={quoted} classname="{room}" time="{seconds:.3f}" result="{result}">\n')
            if verdict == 'failed':
                report.write('<failure />\n')
            report.write('</testcase>\n')
