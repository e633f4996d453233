#!/usr/bin/env python3
"""Mutants of a small program: each is found, does what it says, and leaves alone what the compiler evaluates."""
import os
import pathlib
import subprocess
import sys
import tempfile

import sites

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = '''#include <cstdio>
#include <vector>

namespace
{
constexpr int kSize = 3;
template <int n, bool (*isGood)(int)>
int count(const std::vector<int>& all)
{
	int found = 0;
	for (const int one : all)
		if (isGood(one))
			found += n;
	return found;
}

struct List
{
	int numbers[4]; // "5 < 6" and [7] in words are none
	std::vector<int> all;
	void note(int number);
};

void List::note(int number)
{
	all.push_back(number);
}

bool isSmall(int number)
{
	return number < kSize;
}

} // namespace

int main()
{
	List list{{1, 2, 3, 4}, {}};
	for (std::size_t i = 0; i < 3; ++i)
		list.note(list.numbers[i]);
	const bool same = list.all.size() == 3;
	std::printf("%d %d %d", count<1, isSmall>(list.all), same, list.numbers[0]);
}
'''
EXPECTED = {  # output by kind, detail and line
    ('compare', '<', 31): '3 1 1', ('compare', '<', 39): '2 0 1', ('compare', '==', 41): '2 0 1',
    ('constant', '3 one more', 41): '2 0 1', ('index', '[i]', 40): '1 1 1', ('index', '[0]', 42): '2 1 2',
    ('drop', 'all.push_back()', 26): '0 0 1', ('drop', 'list.note()', 40): '0 0 1'}


def main():
    source = sites.Source('program.cpp', PROGRAM)
    found = list(source.sites())
    numbered = list(enumerate(found, 1))
    failures = [f'{kind} {detail} in line {line} is not found' for kind, detail, line in EXPECTED
                if (kind, detail, line) not in {(s.kind, s.detail, s.line) for s in found}]
    failures += [f'{s.kind} {s.detail} in line {s.line} is to be left alone' for s in found if s.line in (6, 7, 20)]
    if [site.key for site in source.sites()] != [site.key for site in found]:
        failures.append('the keys are others when the sites are listed again')
    changed = sites.Source('program.cpp', PROGRAM.replace('all.push_back(number)', 'all.push_back(number + 0)')).sites()
    keys = [{site.key for site in these if site.line == 26} for these in (found, changed)]
    if not keys[0] or keys[0] & keys[1]:
        failures.append('a change of a function does not change the keys of its mutants')
    with tempfile.TemporaryDirectory() as folder:
        mutated = pathlib.Path(folder, 'mutated.cpp')
        mutated.write_text(sites.mutated(PROGRAM, numbered))
        program = pathlib.Path(folder, 'mutated')
        subprocess.run([os.environ.get('CXX', 'c++'), '-std=c++20', '-w', '-include', HERE / 'mutant.h', mutated, '-o',
                        program], check=True)

        def output(number, **more):
            return subprocess.run([program], env=dict(os.environ, VPROBE_MUTANT=str(number), **more), text=True,
                                  stdout=subprocess.PIPE).stdout

        marks = pathlib.Path(folder, 'marks')
        if output(0, VPROBE_MUTANTS_REACHED=str(marks)) != '2 1 1':
            failures.append('without a mutant, the program is another one')
        reached = marks.read_bytes()
        for number, site in numbered:
            place = (site.kind, site.detail, site.line)
            if place in EXPECTED and output(number) != EXPECTED[place]:
                failures.append(f'{place}: {output(number)}, not {EXPECTED[place]}')
            if place in EXPECTED and not reached[number]:
                failures.append(f'{place} is not marked as reached')
    for failure in failures:
        print(failure)
    return 1 if failures else 0


if __name__ == '__main__':
    sys.exit(main())
